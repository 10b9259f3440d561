//! Trees from outlines: what is drawn is read and closed, branches are inferred of it, arranged round their parents, and
//! grown into trees.

mod branch;
mod bump;
mod grow;
mod leaf_outline;
mod line;
mod outline;
mod params;
mod place;
mod plan;
mod read;
mod revolve;
mod session;
mod stand;
mod sub;

pub use branch::*;
pub use bump::*;
pub use grow::*;
pub use leaf_outline::*;
pub use line::*;
pub use outline::*;
pub use params::*;
pub use place::*;
pub use plan::*;
pub use read::*;
pub use revolve::*;
pub use session::*;
pub use stand::*;
pub use sub::*;
