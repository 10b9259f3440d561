//! How a plan becomes a tree.

use super::params::{angles_of, keep_angles};
use super::plan::tree_outline_plan;
use super::{tree_arrangement, tree_branching_angles, tree_gibbs_params};
use crate::border::{
    Result, Versioned, call, foresee, get, init, out, read_or_default, read_rows, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::particle::Kept;
use crate::tree::{tree_species, tree_tree};
use std::ptr::null;
use tree_model::silhouette::grow::{GrowParams, GrowReport, Leaves, LevelParams, grow};
use tree_model::tree_core::{Control, Seed};

/// Most levels that parameters are given for.
const MAX_LEVELS: usize = 64;

/// How the branches on axes of one level stand, and what they are like where nobody drew any. Begin with
/// `tree_silhouette_level_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_level {
    /// `sizeof(tree_silhouette_level)`.
    pub struct_size: usize,
    /// Angles where no system of the level was drawn: NULL, the default, for 1.1 at the base and 0.6 at the tip. For the
    /// trunk it is `angles` of `tree_silhouette_params` that counts.
    pub angles: *const tree_branching_angles,
    /// How they are arranged round the axis. Default `TREE_ARRANGEMENT_SPREAD`.
    pub arrangement: tree_arrangement,
    /// Branches added in space for each one in the plane, 0 to 100. Default 2.
    pub density: f32,
    /// Branches in the plane on an axis where no system of the level was drawn, 0 to 4000. Default 18.
    pub count: u32,
    /// How far branches are turned about their span from base to end, in radians, -2π to 2π: a slight spiral.
    /// Default 0, planar.
    pub spiral: f32,
    /// Variation of lengths, as a share, 0 to 0.9; angles vary by half of that in radians. Default 0.12.
    pub jitter: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_silhouette_level {
    const NAME: &'static str = "tree_silhouette_level";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::with_angles(&LevelParams::default(), null())
    }
}

impl tree_silhouette_level {
    fn with_angles(level: &LevelParams, angles: *const tree_branching_angles) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            angles,
            arrangement: tree_arrangement::of(&level.arrangement),
            density: level.density,
            count: level.count,
            spiral: level.spiral,
            jitter: level.jitter,
            reserved: 0,
        }
    }

    fn of(level: &LevelParams, kept: &mut Kept) -> Self {
        Self::with_angles(level, keep_angles(&level.angles, kept))
    }

    unsafe fn rust(&self, name: &str) -> Result<LevelParams> {
        let part = |field: &str| format!("{name}.{field}");
        let angles = unsafe { angles_of(self.angles, &part("angles")) }?;
        Ok(LevelParams {
            arrangement: self.arrangement.rust(&part("arrangement"))?,
            density: self.density,
            count: self.count,
            angles: angles.unwrap_or_else(|| LevelParams::default().angles),
            spiral: self.spiral,
            jitter: self.jitter,
        })
    }
}

/// Makes `level`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_level_init(
    level: *mut tree_silhouette_level,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(level, size) })
}

/// The leaves. NaN stands for what is to be found in the drawing. Begin with `tree_silhouette_leaves_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_leaves {
    /// `sizeof(tree_silhouette_leaves)`.
    pub struct_size: usize,
    /// How they are arranged along a branch. Default the spiral of the golden angle.
    pub arrangement: tree_arrangement,
    /// Length in metres, 1e-5 to 100. NaN, the default, for that of the drawn leaf, or else what suits the branches that
    /// bear them.
    pub length: f32,
    /// Distance of leaves along a branch in leaf lengths, all sides together, 0.001 to 100. NaN, the default, for what was
    /// drawn, or 0.3.
    pub spacing: f32,
    /// Angle to the branch, 0 to π. NaN, the default, for what was drawn, or 1.
    pub angle: f32,
    /// Share of the branch that is bare, from its base, 0 to 1. NaN, the default, for what was drawn, or 0.1.
    pub bare: f32,
    /// Petiole in leaf lengths, 0 to 10. Default 0.05.
    pub petiole: f32,
    /// How far upper faces are turned up, 0 (as they grow) to 1. Default 0.5.
    pub facing: f32,
    /// Variation of lengths, as a share, 0 to 0.9. Default 0.2.
    pub jitter: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_silhouette_leaves {
    const NAME: &'static str = "tree_silhouette_leaves";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Leaves::default())
    }
}

impl tree_silhouette_leaves {
    fn of(leaves: &Leaves) -> Self {
        let number = |found: Option<f32>| found.unwrap_or(f32::NAN);
        Self {
            struct_size: size_of::<Self>(),
            arrangement: tree_arrangement::of(&leaves.arrangement),
            length: number(leaves.length),
            spacing: number(leaves.spacing),
            angle: number(leaves.angle),
            bare: number(leaves.bare),
            petiole: leaves.petiole,
            facing: leaves.facing,
            jitter: leaves.jitter,
        }
    }

    fn rust(&self, name: &str) -> Result<Leaves> {
        let number = |found: f32| (!found.is_nan()).then_some(found);
        Ok(Leaves {
            arrangement: self.arrangement.rust(&format!("{name}.arrangement"))?,
            length: number(self.length),
            spacing: number(self.spacing),
            angle: number(self.angle),
            bare: number(self.bare),
            petiole: self.petiole,
            facing: self.facing,
            jitter: self.jitter,
        })
    }
}

/// Makes `leaves`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_leaves_init(
    leaves: *mut tree_silhouette_leaves,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(leaves, size) })
}

/// How a plan becomes a tree. Begin with `tree_silhouette_grow_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_grow_params {
    /// `sizeof(tree_silhouette_grow_params)`.
    pub struct_size: usize,
    /// Number of levels of axes that parameters are given for, at most 64. Default 0: all as by default.
    pub n_levels: usize,
    /// Levels of axes that bear branches: the trunk first. Levels beyond are as the last.
    pub levels: *const tree_silhouette_level,
    /// The leaves. NULL, the default, for `tree_silhouette_leaves_init`.
    pub leaves: *const tree_silhouette_leaves,
    /// Names of the tree, its bark and its leaf, which is kind 0. NULL, the default, for an oak with clusters of leaves.
    pub species: *const tree_species,
    /// The search for azimuths. NULL is the default.
    pub gibbs: *const tree_gibbs_params,
    /// 0 for a bare tree. Default 1.
    pub has_leaves: u32,
    /// Levels of branches on the trunk, 1 to 8. 0, the default, for those drawn, but two at least where no leaf tells.
    pub depth: u32,
    /// How far a sketched branch may stand off the drawing's plane, in radians, 0 to below π/2. Default π/4.
    pub domain: f32,
    /// Radius of the trunk in metres, 1e-6 to 100. 0, the default, for `slenderness` times the height.
    pub trunk_radius: f32,
    /// Radius of the trunk as a share of the height, 1e-4 to 0.2. Default 0.018.
    pub slenderness: f32,
    /// How radii add up at forks: Δ of the pipe model, 1 to 10. Default Murray's.
    pub exponent: f32,
    /// Whether twigs and leaves that would be seen outside the outlines are left out. Default 1.
    pub fence: u32,
    /// How full the outlines are made: leaf area in front of every cell of them over the cell's, 0 (what grows) to 10.
    /// Default 1.6.
    pub fill: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_silhouette_grow_params {
    const NAME: &'static str = "tree_silhouette_grow_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::numbers(&GrowParams::default())
    }
}

impl tree_silhouette_grow_params {
    /// Without what is pointed at.
    fn numbers(params: &GrowParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_levels: 0,
            levels: null(),
            leaves: null(),
            species: null(),
            gibbs: null(),
            has_leaves: params.leaves.is_some().into(),
            depth: params.depth.unwrap_or(0),
            domain: params.domain,
            trunk_radius: params.trunk_radius.unwrap_or(0.0),
            slenderness: params.slenderness,
            exponent: params.exponent,
            fence: params.fence.into(),
            fill: params.fill,
        }
    }

    /// The parameters in C's form; what they point at is kept in `kept`.
    pub(super) fn of(params: &GrowParams, kept: &mut Kept) -> Self {
        let levels: Vec<_> =
            params.levels.iter().map(|level| tree_silhouette_level::of(level, kept)).collect();
        let leaves = params.leaves.as_ref().map(tree_silhouette_leaves::of);
        Self {
            n_levels: levels.len(),
            levels: kept.all(levels),
            leaves: leaves.map_or(null(), |leaves| kept.one(leaves)),
            species: kept.species(&params.species),
            gibbs: kept.one(tree_gibbs_params::of(&params.gibbs)),
            ..Self::numbers(params)
        }
    }

    /// The parameters in Rust's form, not yet checked against their ranges.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<GrowParams> {
        let part = |field: &str| format!("{name}.{field}");
        let (own, levels) = (part("leaves"), part("levels"));
        let rows = unsafe { read_rows(self.levels, self.n_levels, MAX_LEVELS, &levels) }?;
        let level = |(i, row): (usize, &tree_silhouette_level)| unsafe {
            row.rust(&format!("{levels}[{i}]"))
        };
        let leaves = unsafe { read_or_default(self.leaves, &own) }?.rust(&own)?;
        let species = if self.species.is_null() {
            GrowParams::default().species
        } else {
            let species = part("species");
            unsafe { crate::border::read(self.species, &species)?.rust(&species) }?
        };
        Ok(GrowParams {
            levels: rows.iter().enumerate().map(level).collect::<Result<_>>()?,
            depth: (self.depth != 0).then_some(self.depth),
            leaves: (self.has_leaves != 0).then_some(leaves),
            species,
            domain: self.domain,
            gibbs: unsafe { read_or_default(self.gibbs, &part("gibbs")) }?.rust(),
            trunk_radius: (self.trunk_radius != 0.0).then_some(self.trunk_radius),
            slenderness: self.slenderness,
            exponent: self.exponent,
            fence: self.fence != 0,
            fill: self.fill,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_silhouette_grow_params_init(
    params: *mut tree_silhouette_grow_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Levels of branches that `tree_silhouette_grown` counts, the trunk's included.
pub const TREE_SILHOUETTE_LEVELS: usize = 16;

/// How a plan became a tree. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_silhouette_grown {
    /// `sizeof(tree_silhouette_grown)`.
    pub struct_size: usize,
    /// Number of levels of branches, the trunk's included.
    pub n_levels: usize,
    /// Branches of every level, the trunk first; levels beyond the array count with the last.
    pub branches: [u64; TREE_SILHOUETTE_LEVELS],
    /// Of those on the trunk, how many were sketched. The others were added in space.
    pub n_sketched: u64,
    /// Leaves.
    pub n_leaves: u64,
    /// Branches without room in the outline of their parent, which were left out.
    pub n_without_room: u64,
    /// Branches and leaves left out because they would be seen outside the outlines.
    pub n_fenced: u64,
    /// Leaves added where the outlines were empty.
    pub n_filled: u64,
    /// Different patterns that were made.
    pub n_patterns: u64,
    /// Leaves and branches together: the paper's count of elements.
    pub n_elements: u64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_silhouette_grown {
    const NAME: &'static str = "tree_silhouette_grown";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&GrowReport::default())
    }
}

impl tree_silhouette_grown {
    pub(super) fn of(report: &GrowReport) -> Self {
        let mut branches = [0; TREE_SILHOUETTE_LEVELS];
        for (level, &n) in report.branches.iter().enumerate() {
            branches[level.min(TREE_SILHOUETTE_LEVELS - 1)] += n;
        }
        Self {
            struct_size: size_of::<Self>(),
            n_levels: report.branches.len(),
            branches,
            n_sketched: report.n_sketched,
            n_leaves: report.n_leaves,
            n_without_room: report.n_without_room,
            n_fenced: report.n_fenced,
            n_filled: report.n_filled,
            n_patterns: report.n_patterns,
            n_elements: report.elements(),
        }
    }
}

/// Grows a tree of a plan: the same plan, parameters and seed give the same bits for any number of threads. `params`,
/// `control` and `report` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_PARAMETER` names what is out of
/// range; `TREE_ERROR_LIMIT` comes before the memory is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_outline_plan_grow(
    plan: *const tree_outline_plan,
    params: *const tree_silhouette_grow_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_silhouette_grown,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        unsafe { foresee(report, "report") }?;
        let plan = unsafe { get(plan, "plan") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust("params") }?;
        let body = |control: &Control| Ok(grow(plan, &params, Seed(seed), control)?);
        let grown = unsafe { run(control, body) }?;
        unsafe { view(report, "report", &tree_silhouette_grown::of(&grown.report)) }?;
        place.put(tree_tree::new(grown.tree));
        Ok(())
    })
}
