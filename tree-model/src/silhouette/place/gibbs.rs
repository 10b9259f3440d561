//! The Gibbs process (section 5.4).
