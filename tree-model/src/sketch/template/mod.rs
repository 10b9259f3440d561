//! Templates (draft).

mod exemplars;

pub use exemplars::{EXEMPLARS, Exemplar};
