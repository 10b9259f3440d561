//! Radii and branching angles.
