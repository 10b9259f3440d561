//! The density of the tree in space (Neubert 2012, section 3.3).
