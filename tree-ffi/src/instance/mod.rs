//! A few unique twigs, set down many times.
