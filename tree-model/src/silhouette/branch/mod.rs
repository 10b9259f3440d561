//! Branches in the plane: where they leave their parent, and their shape (Wither et al. 2009, sections 3.2 and 3.3).
//!
//! 1. [`BranchingAngles`]: the angle at which branches leave, along their parent.
//! 2. [`infer`]: of a bump's centre and tangent, the shortest Hermite curve that leaves the parent at that angle.
//! 3. [`Shape`]: the form of a branch and its outline in the frame of its span, which carries it to other branches.

mod angles;
mod infer;
mod shape;

pub use angles::BranchingAngles;
pub use infer::{InferParams, Inferred, base_of, infer};
pub use shape::{Shape, Span};
