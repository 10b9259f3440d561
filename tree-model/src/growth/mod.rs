//! Trees that organise themselves: buds compete for light or space, and what they win decides which of
//! them grow, after Wojciech Palubicki et al., *Self-organizing tree models for image synthesis* (2009).
//!
//! A tree is made of metamers: an internode, and at its upper end a node with axillary buds; a terminal
//! bud ends each axis. Each iteration (a year) does five things (Fig. 3):
//!
//! 1. Every bud senses its surroundings (4.1): how much light is left below the shadows of all metamers
//!    ([`Shadow`]), or whether free markers lie in sight ([`Space`]), and in which direction. Obstacles
//!    hide a part of the sky.
//! 2. What the buds found flows down to the base and comes back as vigour, shared out at every fork
//!    ([`Allocation`], 4.2): by the extended Borchert-Honda model or by priorities.
//! 3. A bud with a vigour v of at least 1 makes a shoot of ⌊v⌋ metamers. Each turns from where it would go
//!    towards the light and up or down (4.3).
//! 4. Branches that find too little light for their size are shed (4.4).
//! 5. Radii follow from the pipe model (4.5), at the end, and leaves from [`foliage`](crate::foliage).
//!
//! [`GrowthParams::grow`] makes one tree, [`grow_stand`] several that compete, and a [`Simulation`] goes
//! year by year. The age of every segment is kept ([`Grown::ages`]).
//!
//! Departures, and why:
//! * Shadows are sums of whole numbers, so that taking one away leaves exactly what was before.
//! * Only leafy metamers cast shadow ([`Habit::leaf_life`]); in the paper all do.
//! * Markers are not strewn beforehand: a cell gets its own when a bud first looks there, from a stream
//!   of its own. The space has no end, and what is out of sight costs nothing.
//! * The light may come from the side: shadow pyramids lean away from it.
//! * Buds die after some years ([`Habit::bud_life`]), as those in bark do.
//! * All buds sense and grow by what stood before the iteration, so neither their order nor that of the
//!   trees matters but for the ties between markers.
//! * Radii do not remember branches that were shed.
//! * Leaves saturate: of a sky half hidden by an obstacle they still use five sixths.
//! * Beyond the paper: obstacles, whorls of buds, plagiotropism, several species in one stand.

mod allocation;
mod finish;
mod habit;
mod lattice;
mod light;
mod markers;
mod params;
mod presets;
mod shoot;
mod simulation;
mod sky;
mod stem;
mod surroundings;
#[cfg(test)]
mod tests;

pub use allocation::Allocation;
pub use finish::{Grown, GrowthReport, YearReport};
pub use habit::{Habit, Tropisms};
pub use light::Shadow;
pub use markers::Space;
pub use params::{GrowthParams, MAX_ITERATIONS, MAX_PLANTS};
pub use presets::{PRESETS, Preset};
pub use simulation::{Plant, Simulation, grow_stand};
pub use surroundings::{Environment, World};

use crate::{ModelError, Modeler};
use tree_core::{Control, Seed, Tree};

impl Modeler for GrowthParams {
    fn model(&self, seed: Seed, control: &Control) -> Result<Tree, ModelError> {
        self.grow(seed, control).map(|grown| grown.tree)
    }
}
