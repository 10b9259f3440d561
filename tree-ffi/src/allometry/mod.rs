//! How thick branches are.
