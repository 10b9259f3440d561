//! What the sketch leaves out, grown by its own pattern.

use super::branches::tree_sketch_branches;
use super::omega::{omega, tree_sketch_omega};
use super::tree_crown;
use crate::border::{
    Versioned, call, foresee, get, get_opt, init, out, read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::volume::tree_volume;
use tree_model::sketch::propagate::{PropagateParams, PropagateReport, propagate};
use tree_model::tree_core::{Control, Seed};

/// How a sketch is filled up with branches. Begin with `tree_sketch_propagate_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_propagate_params {
    /// `sizeof(tree_sketch_propagate_params)`.
    pub struct_size: usize,
    /// Generations of new segments where no crown is drawn, 0 (none) to 32. Default 5, as in the thesis.
    pub generations: u32,
    /// Most generations where a crown is drawn: its surface mostly ends growth before, 0 to 32. Default 7.
    pub generations_in_crown: u32,
    /// A sketched segment longer than this many times its natural length gets new laterals, 1 to 1e6. Default 1.5;
    /// 1e6 for none.
    pub long_from: f32,
    /// Longest natural length of a segment from fork to fork, as a share of the tree's height, 1e-3 to 1. Default
    /// 0.045. Smaller gives more laterals along sketched branches.
    pub internode: f32,
    /// Segments shorter than this share of the tree's height do not grow, 1e-4 to 1. Default 0.009.
    pub shortest: f32,
    /// Share of a trunk without drawn branches that stays bare where no crown is drawn, 0 to 1. Default 0.25.
    pub bare: f32,
    /// Whether a trunk with drawn branches gets new laterals below the first of them too. Default 0.
    pub below_first: u32,
    /// Highest Gravelius order of new axes, 0 to 32. Default 8. A palm has 1: its fronds do not branch.
    pub orders: u32,
    /// Most segments, sketched and new, 1 to 100 million. Default 20,000. The last generation is thinned evenly where
    /// there would be more.
    pub max_segments: u32,
    /// How far each new segment turns down: so many times straight down is added to its direction, -1 to 1. Negative
    /// turns up. Default 0.
    pub gravitropism: f32,
    /// Random deviation of angles from those of the block, in radians, 0 to π. Default 0.12.
    pub jitter: f32,
    /// Distance in metres that new segments keep from obstacles, 0 to 1e6. Default 0.1.
    pub clearance: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_propagate_params {
    const NAME: &'static str = "tree_sketch_propagate_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PropagateParams::default())
    }
}

impl tree_sketch_propagate_params {
    pub(super) fn of(params: &PropagateParams) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            generations: params.generations,
            generations_in_crown: params.generations_in_crown,
            long_from: params.long,
            internode: params.internode,
            shortest: params.shortest,
            bare: params.bare,
            below_first: params.below_first.into(),
            orders: params.orders,
            max_segments: params.max_segments,
            gravitropism: params.gravitropism,
            jitter: params.jitter,
            clearance: params.clearance,
        }
    }

    pub(super) fn rust(&self) -> PropagateParams {
        PropagateParams {
            generations: self.generations,
            generations_in_crown: self.generations_in_crown,
            long: self.long_from,
            internode: self.internode,
            shortest: self.shortest,
            bare: self.bare,
            below_first: self.below_first != 0,
            orders: self.orders,
            max_segments: self.max_segments,
            gravitropism: self.gravitropism,
            jitter: self.jitter,
            clearance: self.clearance,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_propagate_params_init(
    params: *mut tree_sketch_propagate_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What propagation did. Numbers count segments unless they say otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_sketch_propagate_report {
    /// `sizeof(tree_sketch_propagate_report)`.
    pub struct_size: usize,
    /// New ones.
    pub n_new: u64,
    /// Sketched ones so long that they got new laterals.
    pub n_long: u64,
    /// New forks along those.
    pub n_forks: u64,
    /// Open ends and forks of the sketch that lie outside the crown, where nothing grew.
    pub n_ends_outside: u64,
    /// Those that end at the crown's surface.
    pub n_touched: u64,
    /// Left out because the surface left too little of them.
    pub n_outside: u64,
    /// Left out because they would have been shorter than `shortest`.
    pub n_too_short: u64,
    /// Turned aside from an obstacle or the ground.
    pub n_turned_aside: u64,
    /// Shortened because of an obstacle or the ground.
    pub n_shortened: u64,
    /// Left out because of an obstacle or the ground.
    pub n_blocked: u64,
    /// Left out because there would have been more than `max_segments`.
    pub n_over_cap: u64,
    /// The last generation in which any grew.
    pub generations: u32,
    /// Replication blocks taken from the sketch.
    pub n_blocks: u32,
    /// Replication blocks drawn from Ω because the sketch has few of their order.
    pub n_blocks_from_omega: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_sketch_propagate_report {
    const NAME: &'static str = "tree_sketch_propagate_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&PropagateReport::default())
    }
}

impl tree_sketch_propagate_report {
    pub(super) fn of(report: &PropagateReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_new: report.n_new,
            n_long: report.n_long,
            n_forks: report.n_forks,
            n_ends_outside: report.n_ends_outside,
            n_touched: report.n_touched,
            n_outside: report.n_outside,
            n_too_short: report.n_too_short,
            n_turned_aside: report.n_turned_aside,
            n_shortened: report.n_shortened,
            n_blocked: report.n_blocked,
            n_over_cap: report.n_over_cap,
            generations: report.generations,
            n_blocks: report.n_blocks,
            n_blocks_from_omega: report.n_blocks_from_omega,
            reserved: 0,
        }
    }
}

/// Fills a sketch up with branches after the pattern of its own (Neubert 2012, section 4.7): its forks are taken as
/// replication blocks, which are attached to its open ends generation by generation, and along branches that are
/// long without forks.
///
/// With a `crown` growth stays inside it; with NULL it goes on for `generations`. New segments keep `clearance` away
/// from `obstacles`, a volume or NULL for none; sketched ones stay as they are. `omega`, `params`, `control` and
/// `report` may be NULL. The sketched segments keep their numbers, the new follow. Free them with
/// `tree_sketch_branches_free`. `TREE_ERROR_PARAMETER` names what is out of range, `TREE_ERROR_INVALID` says so for
/// branches that have grown already.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_sketch_branches_propagate(
    branches: *const tree_sketch_branches,
    omega: *const tree_sketch_omega,
    crown: *const tree_crown,
    obstacles: *const tree_volume,
    params: *const tree_sketch_propagate_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_sketch_propagate_report,
    grown: *mut *mut tree_sketch_branches,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grown, "grown") }?;
        unsafe { foresee(report, "report") }?;
        let branches = unsafe { get(branches, "branches") }?.sketched()?;
        let omega = unsafe { self::omega(omega) }?;
        let crown = unsafe { get_opt(crown, "crown") }?.map(tree_crown::rust);
        let obstacles = unsafe { get_opt(obstacles, "obstacles") }?.map(tree_volume::rust);
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let body = |control: &Control| {
            Ok(propagate(branches, &omega, crown, obstacles, &params, Seed(seed), control)?)
        };
        let made = unsafe { run(control, body) }?;
        let told = tree_sketch_propagate_report::of(&made.report);
        unsafe { view(report, "report", &told) }?;
        place.put(tree_sketch_branches::new(made));
        Ok(())
    })
}
