//! A polygon tree becomes a skeleton and leaves.
