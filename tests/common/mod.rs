//! Shared by the scenario tests; `examples/evaluate` takes `skeletons` too.

pub(crate) mod skeletons;
