//! Twigs and leaves on the youngest shoots of any skeleton, in the order that phyllotaxis gives them
//! (Neubert 2012, section 5.4).
//!
//! Twigs, [`grow_twigs`]:
//! 1. The skeleton is split into axes; of each, the part within [`TwigParams::bearing`] of a tip bears
//!    twigs, at even distances, in the order of a [`Phyllotaxis`].
//! 2. Each twig is planned as a chain of internodes, [monopodial or sympodial](Branching) (Fig. 5.8),
//!    with laterals for up to three levels, and gets radii by the pipe model.
//! 3. It is set on the tree from base to tip, where each internode bends under the weight of what is
//!    beyond it, and turns by gravitropism and phototropism (Fig. 5.9).
//!
//! Leaves, [`grow_leaves`]:
//! 1. Places are found as for twigs.
//! 2. Each petiole leaves the shoot at the pitch angle; the blade at its end hangs by its droop and
//!    turns its upper face to the light (section 5.4.1).
//! 3. A [compound](LeafForm) leaf spreads its leaflets, a fascicle its needles.
//!
//! Both can follow a density field. Departure: in the thesis leaves turn away from a point inside the
//! crown; here they turn to a light that shines from far, as the text before the equation says.
//!
//! Axes draw from streams of their own and run in parallel; cost is linear in what is there and what
//! is grown.

mod arrangement;
mod blade;
mod form;
mod grow;
mod params;
mod sites;
mod species;
mod twig;
mod vector;

pub(crate) use arrangement::GOLDEN_ANGLE;
pub use arrangement::Phyllotaxis;
pub use form::{LeafForm, Palmate, Pinnate};
pub use grow::{
    LeafReport, Leaves, StalkedLeaves, grow_leaves, grow_leaves_and_report, grow_leaves_in,
    grow_leaves_with_stalks,
};
pub use params::LeafParams;
pub use sites::{DENSITY_CAP, DensityField};
pub use species::{SPECIES, SpeciesPreset};
pub use twig::{Branching, TwigParams, TwigReport, Twigs, grow_twigs, grow_twigs_in, refine};

#[cfg(test)]
mod tests;
