//! The form of a leaf: one blade, or leaflets and needles in the order of the textbook.
//!
//! A compound leaf is laid out once in its own frame (petiole's end at the origin, rachis along +Y,
//! upper face +Z, lengths in lengths of a full leaflet) and then put on the tree as often as asked for.

use super::arrangement::GOLDEN_ANGLE;
use super::vector::to_the_right;
use crate::error::{Result, check};
use glam::{Quat, Vec3};
use std::f32::consts::{PI, TAU};

/// What one leaf consists of. Each leaflet and each needle becomes one [`Leaf`](tree_core::Leaf).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LeafForm {
    /// One blade. Oak, beech, linden.
    #[default]
    Simple,
    /// Leaflets along a rachis. Ash, walnut, rowan; palms with feathers.
    Pinnate(Pinnate),
    /// Leaflets from one point, like fingers. Horse chestnut; palms with fans.
    Palmate(Palmate),
    /// A few needles from one sheath, evenly round its axis. Pines: 2, 3 or 5.
    Fascicle {
        /// Needles, 1 to 16.
        needles: u32,
        /// Angle between a needle and the axis, 0 to π/2.
        spread: f32,
    },
    /// Many needles on a short shoot (brachyblast), from its axis to all sides. Larch, cedar.
    Rosette {
        /// Needles, 1 to 128.
        needles: u32,
        /// Angle between the outermost needles and the axis, 0 to π.
        spread: f32,
    },
}

/// A pinnate leaf. Lengths in lengths of its largest leaflet, angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Pinnate {
    /// Pairs of leaflets, 1 to 100. Default 4.
    pub pairs: u32,
    /// Whether a leaflet ends the rachis (imparipinnate). Default true.
    pub odd: bool,
    /// Length of the rachis above the petiole, 0 to 1000. Default 2.
    pub rachis: f32,
    /// How far the rachis bends back over its length, -π to π. Default 0.4.
    pub droop: f32,
    /// Angle between rachis and leaflets at its base and at its tip, 0 to π. Default 1.2 and 0.8.
    pub angle: [f32; 2],
    /// Size of the leaflets at base, middle and tip, 0.01 to 1. Default 0.75, 1, 0.8.
    pub profile: [f32; 3],
    /// How far leaflets are raised out of the leaf's plane, -π/2 (hanging) to π/2. Default 0.
    pub fold: f32,
    /// Length of a leaflet's stalk, 0 to 2. Default 0.03.
    pub petiolule: f32,
    /// Pairs of leaflets on each pinna of a leaf that is pinnate twice, up to 50; 0, the default, is
    /// pinnate once.
    pub pinna_pairs: u32,
    /// Length of the longest pinna as a share of the rachis, 0.01 to 2. Default 0.5.
    pub pinna: f32,
}

impl Default for Pinnate {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Pinnate {
    /// The default of every field, for constants.
    pub const DEFAULT: Self = Self {
        pairs: 4,
        odd: true,
        rachis: 2.0,
        droop: 0.4,
        angle: [1.2, 0.8],
        profile: [0.75, 1.0, 0.8],
        fold: 0.0,
        petiolule: 0.03,
        pinna_pairs: 0,
        pinna: 0.5,
    };
}

/// A palmate leaf. Angles in radians.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Palmate {
    /// Leaflets, 2 to 64. Default 7.
    pub leaflets: u32,
    /// Angle from the first leaflet to the last, 0 to 2π. Default 4.
    pub spread: f32,
    /// Size of the outermost leaflets against the middle one, 0.01 to 1. Default 0.55.
    pub outer: f32,
    /// Angle by which leaflets hang below the leaf's plane, -π/2 to π/2. Default 0.2.
    pub droop: f32,
}

impl Default for Palmate {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl Palmate {
    /// The default of every field, for constants.
    pub const DEFAULT: Self = Self { leaflets: 7, spread: 4.0, outer: 0.55, droop: 0.2 };
}

impl LeafForm {
    /// Blades of one leaf, which is rows of the foliage.
    #[must_use]
    pub fn n_leaflets(&self) -> u32 {
        match *self {
            Self::Simple => 1,
            Self::Pinnate(leaf) => leaf.n_leaflets(),
            Self::Palmate(leaf) => leaf.leaflets,
            Self::Fascicle { needles, .. } | Self::Rosette { needles, .. } => needles,
        }
    }

    /// Checks all ranges.
    pub(super) fn validate(&self) -> Result<()> {
        match *self {
            Self::Simple => Ok(()),
            Self::Pinnate(leaf) => leaf.validate(),
            Self::Palmate(leaf) => {
                check("leaves.form.leaflets", leaf.leaflets, 2, 64)?;
                check("leaves.form.spread", leaf.spread, 0.0, TAU)?;
                check("leaves.form.outer", leaf.outer, 0.01_f32, 1.0)?;
                check("leaves.form.droop", leaf.droop, -PI / 2.0, PI / 2.0)
            }
            Self::Fascicle { needles, spread } => {
                check("leaves.form.needles", needles, 1, 16)?;
                check("leaves.form.spread", spread, 0.0, PI / 2.0)
            }
            Self::Rosette { needles, spread } => {
                check("leaves.form.needles", needles, 1, 128)?;
                check("leaves.form.spread", spread, 0.0, PI)
            }
        }
    }

    /// Lays out the leaflets and the stalks that bear them.
    pub(super) fn layout(&self) -> Layout {
        let mut layout = Layout::default();
        match *self {
            Self::Simple => layout.add(Leaflet::WHOLE),
            Self::Pinnate(leaf) => leaf.lay(&mut layout),
            Self::Palmate(leaf) => {
                for i in 0..leaf.leaflets {
                    let side = 2.0 * i as f32 / (leaf.leaflets - 1).max(1) as f32 - 1.0;
                    let fan = to_the_right(0.5 * leaf.spread * side);
                    let rotation = fan * Quat::from_rotation_x(-leaf.droop);
                    let size = 1.0 - (1.0 - leaf.outer) * side.abs();
                    layout.add(Leaflet { rotation, size, ..Leaflet::WHOLE });
                }
            }
            Self::Fascicle { needles, spread } => {
                for i in 0..needles {
                    let rotation = needle(TAU * i as f32 / needles as f32, spread);
                    layout.add(Leaflet { rotation, ..Leaflet::WHOLE });
                }
            }
            Self::Rosette { needles, spread } => {
                for i in 0..needles {
                    // Even over the disc that the shoot's end is: outer needles are more.
                    let out = ((i as f32 + 0.5) / needles as f32).sqrt();
                    let rotation = needle(GOLDEN_ANGLE * i as f32, spread * out);
                    // The youngest, in the middle, are the shortest.
                    layout.add(Leaflet { rotation, size: 0.7 + 0.3 * out, ..Leaflet::WHOLE });
                }
            }
        }
        layout
    }
}

/// A needle that leans by `tilt` away from +Y, its upper face towards the axis.
fn needle(azimuth: f32, tilt: f32) -> Quat {
    Quat::from_rotation_y(azimuth) * Quat::from_rotation_x(tilt) * Quat::from_rotation_y(PI)
}

/// Where the leaflets of a leaf are, in the leaf's frame, and what bears them.
#[derive(Clone, Debug)]
pub(super) struct Layout {
    pub(super) leaflets: Vec<Leaflet>,
    /// The petiole's end, then the rachis; every one after the one that bears it.
    pub(super) stalks: Vec<Stalk>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Leaflet {
    pub(super) offset: Vec3,
    pub(super) rotation: Quat,
    pub(super) size: f32,
    /// Index of the stalk's node that bears it.
    pub(super) stalk: u32,
}

impl Leaflet {
    const WHOLE: Self = Self { offset: Vec3::ZERO, rotation: Quat::IDENTITY, size: 1.0, stalk: 0 };
}

/// A node of a petiole or rachis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stalk {
    /// The node below; `None` for the petiole's end, which the shoot bears.
    pub(super) below: Option<u32>,
    pub(super) offset: Vec3,
    /// Radius as a share of the petiole's.
    pub(super) radius: f32,
}

impl Default for Layout {
    fn default() -> Self {
        let petiole = Stalk { below: None, offset: Vec3::ZERO, radius: 1.0 };
        Self { leaflets: Vec::new(), stalks: vec![petiole] }
    }
}

impl Layout {
    fn add(&mut self, leaflet: Leaflet) {
        self.leaflets.push(leaflet);
    }

    /// Adds a node above `below` and returns its index; where it would have no length, `below`.
    fn stalk(&mut self, below: u32, offset: Vec3, radius: f32) -> u32 {
        if self.stalks[below as usize].offset.distance_squared(offset) < 1e-12 {
            return below;
        }
        self.stalks.push(Stalk { below: Some(below), offset, radius });
        self.stalks.len() as u32 - 1
    }
}

/// Radius of a rachis at its tip as a share of that at its base.
const RACHIS_TIP: f32 = 0.45;
/// Radius of a pinna's rachis as a share of that of the rachis where it leaves.
const PINNA_RADIUS: f32 = 0.6;

impl Pinnate {
    fn n_leaflets(&self) -> u32 {
        let places = 2 * self.pairs.min(100) + u32::from(self.odd);
        if self.pinna_pairs == 0 { places } else { places * (2 * self.pinna_pairs.min(50) + 1) }
    }

    fn validate(&self) -> Result<()> {
        check("leaves.form.pairs", self.pairs, 1, 100)?;
        check("leaves.form.rachis", self.rachis, 0.0, 1000.0)?;
        check("leaves.form.droop", self.droop, -PI, PI)?;
        for (i, angle) in self.angle.into_iter().enumerate() {
            check(format!("leaves.form.angle[{i}]"), angle, 0.0, PI)?;
        }
        for (i, size) in self.profile.into_iter().enumerate() {
            check(format!("leaves.form.profile[{i}]"), size, 0.01_f32, 1.0)?;
        }
        check("leaves.form.fold", self.fold, -PI / 2.0, PI / 2.0)?;
        check("leaves.form.petiolule", self.petiolule, 0.0, 2.0)?;
        check("leaves.form.pinna_pairs", self.pinna_pairs, 0, 50)?;
        check("leaves.form.pinna", self.pinna, 0.01_f32, 2.0)
    }

    fn lay(&self, layout: &mut Layout) {
        let rachis = Rachis { base: Vec3::ZERO, turn: Quat::IDENTITY, length: self.rachis };
        let longest = self.pinna * self.rachis;
        self.along(&rachis, self.pairs, self.odd, 0, 1.0, layout, &mut |place, layout| {
            if self.pinna_pairs == 0 {
                layout.add(Leaflet {
                    offset: place.offset + place.turn * Vec3::Y * self.petiolule,
                    rotation: place.turn,
                    size: place.size,
                    stalk: place.stalk,
                });
                return;
            }
            let pinna =
                Rachis { base: place.offset, turn: place.turn, length: longest * place.size };
            let (pairs, stalk) = (self.pinna_pairs, place.stalk);
            let radius = PINNA_RADIUS * layout.stalks[stalk as usize].radius;
            self.along(&pinna, pairs, true, stalk, radius, layout, &mut |place, layout| {
                layout.add(Leaflet {
                    offset: place.offset + place.turn * Vec3::Y * self.petiolule,
                    rotation: place.turn,
                    size: place.size,
                    stalk: place.stalk,
                });
            });
        });
    }

    /// Visits the places along one rachis, pair by pair from the base, the end last.
    #[expect(clippy::too_many_arguments, reason = "a rachis, how it is borne and what it bears")]
    fn along(
        &self,
        rachis: &Rachis,
        pairs: u32,
        odd: bool,
        stalk: u32,
        radius: f32,
        layout: &mut Layout,
        visit: &mut dyn FnMut(Place, &mut Layout),
    ) {
        let mut stalk = stalk;
        // A leaflet at the end takes the last place; a first pair needs a stalk of its own on a pinna.
        let (first, n) = match (rachis.base == Vec3::ZERO, odd) {
            (true, true) => (0.0, pairs),
            (true, false) => (0.0, (pairs - 1).max(1)),
            (false, _) => (0.5, pairs),
        };
        for i in 0..=pairs {
            if i == pairs && !odd {
                break;
            }
            let share = if i == pairs || pairs == 1 && !odd {
                1.0
            } else {
                ((i as f32 + first) / n as f32).min(1.0)
            };
            let (offset, turn) = rachis.at(share, self.droop);
            stalk = layout.stalk(stalk, offset, radius * (1.0 - (1.0 - RACHIS_TIP) * share));
            let size = self.size_at(share);
            if i == pairs {
                visit(Place { offset, turn, size, stalk }, layout);
                break;
            }
            let angle = self.angle[0] + (self.angle[1] - self.angle[0]) * share;
            for side in [1.0, -1.0] {
                let fold = Quat::from_rotation_y(-side * self.fold);
                let turn = turn * fold * to_the_right(side * angle);
                visit(Place { offset, turn, size, stalk }, layout);
            }
        }
    }

    fn size_at(&self, share: f32) -> f32 {
        let [base, middle, tip] = self.profile;
        let (from, to, t) = if share < 0.5 {
            (base, middle, 2.0 * share)
        } else {
            (middle, tip, 2.0 * share - 1.0)
        };
        from + (to - from) * t
    }
}

/// Where a leaflet or a pinna leaves its rachis.
struct Place {
    offset: Vec3,
    turn: Quat,
    size: f32,
    stalk: u32,
}

/// A stalk that bends back evenly.
struct Rachis {
    base: Vec3,
    turn: Quat,
    length: f32,
}

impl Rachis {
    /// Place and frame at a share of the length, of an arc that turns by `droop` in all.
    fn at(&self, share: f32, droop: f32) -> (Vec3, Quat) {
        let (s, bent) = (self.length * share, droop * share);
        let arc = if bent.abs() < 1e-3 {
            Vec3::new(0.0, s, -0.5 * bent * s)
        } else {
            let radius = s / bent;
            Vec3::new(0.0, radius * libm::sinf(bent), -radius * (1.0 - libm::cosf(bent)))
        };
        (self.base + self.turn * arc, self.turn * Quat::from_rotation_x(-bent))
    }
}
