//! Trees from photographs by particle flow.
