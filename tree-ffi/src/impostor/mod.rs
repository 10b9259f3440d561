//! Impostors: leaves, or whole trees, as pictures (Lluch et al. 2010, §4.2): boxes along the branches, cards,
//! what is drawn at a distance, octahedral impostors, and smaller levels of pictures.

mod bearers;
mod box_params;
mod boxes;
mod card_params;
mod cards;
mod cards_draw;
mod choice;
mod directions;
mod map;
mod mips;
mod octahedral;
mod octahedral_meta;
mod octahedral_params;
mod weights;

pub use bearers::*;
pub use box_params::*;
pub use boxes::*;
pub use card_params::*;
pub use cards::*;
pub use cards_draw::*;
pub use choice::*;
pub use directions::*;
pub use map::*;
pub use mips::*;
pub use octahedral::*;
pub use octahedral_meta::*;
pub use octahedral_params::*;
pub use weights::*;
