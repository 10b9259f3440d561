//! What a species brings along.

use super::preset::default_habit;
use crate::border::{Failure, Result, Versioned, call, init, read, tree_status};
use crate::foliage::{Arrangement, tree_leaf_params, tree_phyllotaxis};
use crate::tree::tree_species;
use tree_model::growth::{Allocation, Habit, Tropisms};
use tree_model::tree_core::allometry::PipeModel;

/// How vigour is shared out at forks, which decides whether a tree has one trunk or many limbs: one of the
/// `TREE_ALLOCATION_` constants.
pub type tree_allocation = u32;
/// The extended Borchert-Honda model: main axis and laterals get shares λ Qₘ : (1 - λ) Qₗ for the light Q behind each.
/// The default.
pub const TREE_ALLOCATION_BORCHERT_HONDA: u32 = 0;
/// The priority model: buds and branches of each axis are ranked by mean light, the terminal bud first, and get shares by
/// light times weight.
pub const TREE_ALLOCATION_PRIORITY: u32 = 1;

/// Which way axes turn: weights against the direction in which an axis would go on by itself, which has 1. Each metamer
/// turns by them.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_growth_tropisms {
    /// Towards most light or space, -10 to 10. Default 0.25.
    pub photo: f32,
    /// Upwards, -10 to 10; negative: hanging. Default 0.12.
    pub gravi: f32,
    /// Towards the horizontal, 0 to 10. Default 0.
    pub plagio: f32,
}

impl tree_growth_tropisms {
    fn of(Tropisms { photo, gravi, plagio }: Tropisms) -> Self {
        Self { photo, gravi, plagio }
    }

    fn rust(self) -> Tropisms {
        Tropisms { photo: self.photo, gravi: self.gravi, plagio: self.plagio }
    }
}

/// The species' part of a growing tree. Lengths in metres, angles in radians, times in iterations (years, usually). Begin
/// with `tree_growth_habit_init`, or with a copy of a preset's own. What those point at belongs to the library, lives
/// for ever and is not to be written.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_growth_habit {
    /// `sizeof(tree_growth_habit)`.
    pub struct_size: usize,
    /// Leaves; NULL for a bare tree. Default: those of `tree_leaf_params_init`.
    pub leaves: *const tree_leaf_params,
    /// Name, bark, and the kinds that `leaves->kind` counts; NULL for an oak's. Default: an oak's.
    pub species: *const tree_species,
    /// Length of an internode at whole vigour, 0.001 to 100; one of vigour v in a shoot of n metamers is v / n times as
    /// long. Default 0.12.
    pub internode: f32,
    /// How axillary buds stand. Default `TREE_PHYLLOTAXIS_SPIRAL`.
    pub buds: tree_phyllotaxis,
    /// Spiral: angle from one bud to the next, -2π to 2π. Default the golden angle, 2.39996.
    pub divergence: f32,
    /// Whorled: buds at a node, 3 to 64. No default: 0, which is refused.
    pub whorl: u32,
    /// Only so many of a shoot's topmost metamers bear axillary buds, 1 to 64; 1 with whorled buds makes tiers of branches.
    /// Default 64: all.
    pub bud_zone: u32,
    /// Iterations after which an axillary bud that has not grown is dead, 0 to 10,000. Default 6.
    pub bud_life: u32,
    /// Angle between an internode and the buds at its end, 0 to π. Default 0.8.
    pub angle: f32,
    /// Standard deviation of branching and divergence angles, 0 to 1. Default 0.12.
    pub jitter: f32,
    /// Highest order of an axis, 0 (only the trunk) to 255. Default 12.
    pub max_order: u32,
    /// Most metamers a bud makes in one iteration, 1 to 64. Default 6.
    pub max_shoot: u32,
    /// How vigour is shared out. Default `TREE_ALLOCATION_BORCHERT_HONDA`.
    pub allocation: tree_allocation,
    /// Borchert-Honda: λ of a seedling, 0 to 1; above 0.5 the main axis is favoured, below the laterals. 0.46 to 0.54 span
    /// shrubs to poplars. Default 0.5.
    pub lambda: f32,
    /// Borchert-Honda: λ of an old tree, 0 to 1; lower than `lambda` for a crown that opens with age. Default 0.5.
    pub lambda_late: f32,
    /// Borchert-Honda: iterations in which λ goes from one to the other, 0 to 10,000. Default 0.
    pub lambda_turning: u32,
    /// Priority: weight of the first rank, 0 to 1000. Default 0.
    pub priority_first: f32,
    /// Priority: weight of the last ranks, 0 to 1000. Default 0.
    pub priority_last: f32,
    /// Priority: share of the ranks over which the weight falls from one to the other, 0 to 1. Default 0.
    pub priority_fall: f32,
    /// Vigour at the base per light that all buds found, 0 to 100. Default 2.
    pub vigour: f32,
    /// Which way the trunk turns.
    pub trunk: tree_growth_tropisms,
    /// Which way all other axes turn.
    pub branches: tree_growth_tropisms,
    /// A branch with less light per metamer than this is shed, 0 (never) to 100. Default 0.12.
    pub shedding: f32,
    /// Youngest age at which a branch can be shed, 0 to 10,000. Default 2.
    pub shedding_age: u32,
    /// For how long a metamer has leaves and casts shadow, 1 to 10,000. Default 3.
    pub leaf_life: u32,
    /// Radii, by the pipe model: Δ in r₀^Δ = Σ rᵢ^Δ, 1 to 10. Default 2.49.
    pub radii_exponent: f32,
    /// Radii: that of every tip in metres, 1e-6 to 100. Default 0.002.
    pub radii_tip: f32,
    /// Radii: how much they grow per metre towards the base, 0 to 1. Default 0.002.
    pub radii_taper: f32,
    /// Radii: that of the root node in metres, 1e-6 to 100. Default 0: the tips decide.
    pub radii_trunk: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_growth_habit {
    const NAME: &'static str = "tree_growth_habit";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        default_habit()
    }
}

impl tree_growth_habit {
    /// The habit in C's form, but for leaves and species; fields that do not matter have their defaults.
    pub(super) fn of(habit: &Habit) -> Self {
        let Arrangement { kind: buds, divergence, whorl } = Arrangement::of(habit.buds);
        let (mut lambdas, mut turning, mut priorities) = ([0.5; 2], 0, [0.0; 3]);
        let allocation = match habit.allocation {
            Allocation::BorchertHonda { lambda, late, turning: own } => {
                (lambdas, turning) = ([lambda, late], own);
                TREE_ALLOCATION_BORCHERT_HONDA
            }
            Allocation::Priority { first, last, fall } => {
                priorities = [first, last, fall];
                TREE_ALLOCATION_PRIORITY
            }
        };
        let PipeModel { exponent, tip_radius, taper, trunk_radius } = habit.radii;
        Self {
            struct_size: size_of::<Self>(),
            leaves: std::ptr::null(),
            species: std::ptr::null(),
            internode: habit.internode,
            buds,
            divergence,
            whorl,
            bud_zone: habit.bud_zone,
            bud_life: habit.bud_life,
            angle: habit.angle,
            jitter: habit.jitter,
            max_order: habit.max_order,
            max_shoot: habit.max_shoot,
            allocation,
            lambda: lambdas[0],
            lambda_late: lambdas[1],
            lambda_turning: turning,
            priority_first: priorities[0],
            priority_last: priorities[1],
            priority_fall: priorities[2],
            vigour: habit.vigour,
            trunk: tree_growth_tropisms::of(habit.trunk),
            branches: tree_growth_tropisms::of(habit.branches),
            shedding: habit.shedding,
            shedding_age: habit.shedding_age,
            leaf_life: habit.leaf_life,
            radii_exponent: exponent,
            radii_tip: tip_radius,
            radii_taper: taper,
            radii_trunk: trunk_radius.unwrap_or(0.0),
            reserved: 0,
        }
    }

    /// The habit in Rust's form, not yet checked against its ranges; `name` is what it is called by.
    pub(crate) unsafe fn rust(&self, name: &str) -> Result<Habit> {
        let part = |field: &str| format!("{name}.{field}");
        let buds = Arrangement { kind: self.buds, divergence: self.divergence, whorl: self.whorl };
        let leaves = if self.leaves.is_null() {
            None
        } else {
            Some(unsafe { read(self.leaves, &part("leaves")) }?.rust()?)
        };
        let species = if self.species.is_null() {
            Default::default()
        } else {
            unsafe { read(self.species, &part("species"))?.rust(&part("species")) }?
        };
        Ok(Habit {
            internode: self.internode,
            buds: buds.rust(&part("buds"))?,
            bud_zone: self.bud_zone,
            bud_life: self.bud_life,
            angle: self.angle,
            jitter: self.jitter,
            max_order: self.max_order,
            max_shoot: self.max_shoot,
            allocation: self.shares(&part("allocation"))?,
            vigour: self.vigour,
            trunk: self.trunk.rust(),
            branches: self.branches.rust(),
            shedding: self.shedding,
            shedding_age: self.shedding_age,
            leaf_life: self.leaf_life,
            radii: PipeModel {
                exponent: self.radii_exponent,
                tip_radius: self.radii_tip,
                taper: self.radii_taper,
                trunk_radius: (self.radii_trunk != 0.0).then_some(self.radii_trunk),
            },
            leaves,
            species,
        })
    }

    fn shares(&self, name: &str) -> Result<Allocation> {
        match self.allocation {
            TREE_ALLOCATION_BORCHERT_HONDA => Ok(Allocation::BorchertHonda {
                lambda: self.lambda,
                late: self.lambda_late,
                turning: self.lambda_turning,
            }),
            TREE_ALLOCATION_PRIORITY => Ok(Allocation::Priority {
                first: self.priority_first,
                last: self.priority_last,
                fall: self.priority_fall,
            }),
            other => Err(Failure::not_one_of(name, other, "TREE_ALLOCATION_")),
        }
    }
}

/// Makes `habit`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_habit_init(
    habit: *mut tree_growth_habit,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(habit, size) })
}
