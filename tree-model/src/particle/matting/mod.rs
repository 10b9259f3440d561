//! Separating a tree from what is behind it (Neubert 2012, section 3.2.1).
