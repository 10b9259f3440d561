//! Trees from photographs by particle flow (Neubert 2012): density, direction fields, particles, finish, and
//! sessions that do all of it.

mod density;
mod field;
mod finish;
mod flow;
mod grid;
mod keep;
mod session;
mod view;

pub use density::*;
pub use field::*;
pub use finish::*;
pub use flow::*;
pub use grid::*;
pub(crate) use keep::Kept;
pub use session::*;
pub use view::*;
