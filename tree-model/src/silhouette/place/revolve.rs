//! The pseudo-surface of revolution between outlines (section 5.6).
