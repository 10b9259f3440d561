//! Level of detail by measured pruning (Neubert 2012, chapters 6 and 7): elements, masks and their quality,
//! tables, hulls, orders, and scenes.

mod distance;
mod elements;
mod hull;
mod mask;
mod metaballs;
mod order;
mod order_params;
mod rules;
mod score;
mod select;
mod select_frame;
mod select_model;
mod select_write;
mod subject;
mod table;
mod take;
mod views;

pub use distance::*;
pub use elements::*;
pub use hull::*;
pub use mask::*;
pub use metaballs::*;
pub use order::*;
pub use order_params::*;
pub use rules::*;
pub use score::*;
pub use select::*;
pub use select_frame::*;
pub use select_model::*;
pub use select_write::*;
pub use subject::*;
pub use table::*;
pub use views::*;
