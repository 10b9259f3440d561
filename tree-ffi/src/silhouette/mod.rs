//! Trees from outlines: what is drawn is read and closed, branches are inferred of it, arranged round their parents, and
//! grown into trees.

mod arrange;
mod branch;
mod bump;
mod drawn;
mod grow;
mod leaf_outline;
mod line;
mod measure;
mod outline;
mod params;
mod place;
mod plan;
mod read;
mod revolve;
mod session;
mod stand;
mod sub;

pub use arrange::*;
pub use branch::*;
pub use bump::*;
pub use drawn::*;
pub use grow::*;
pub use leaf_outline::*;
pub use line::*;
pub use measure::*;
pub use outline::*;
pub use params::*;
pub use place::*;
pub use plan::*;
pub use read::*;
pub use revolve::*;
pub use session::*;
pub use stand::*;
pub use sub::*;
