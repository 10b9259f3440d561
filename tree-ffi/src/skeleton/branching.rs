//! How a skeleton branches, in the figures that botanists and foresters measure.

use super::axes::{continuation, tree_continuation};
use super::tree_skeleton;
use crate::border::{
    Failure, TREE_ERROR_PARAMETER, Versioned, call, fill, get, out_value, tree_status, write,
};
use tree_model::tree_core::branching::{
    LateralAngle, Run, Runs, Strahler, lateral_angles, pipe_exponent, pipe_exponents,
};

/// How a skeleton branches.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_branching_report {
    /// `sizeof(tree_branching_report)`.
    pub struct_size: usize,
    /// The Horton-Strahler order of the root, which no other exceeds; at least 1.
    pub n_orders: u32,
    /// Unbranched runs, at least 1.
    pub n_runs: u32,
    /// How many times more branches there are of an order than of the next higher one: trees have about 3 to 5.
    /// 0 where all is of order 1.
    pub bifurcation_ratio: f64,
    /// How many times longer the branches of an order are than those of the next lower one; 0 where fewer than two
    /// orders have a length.
    pub length_ratio: f64,
    /// The median of what `tree_skeleton_pipe_exponents` gives, of two in the middle the higher: infinite where most
    /// forks have none. 0 of a skeleton without forks.
    pub pipe_exponent: f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_branching_report {
    const NAME: &'static str = "tree_branching_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_orders: 0,
            n_runs: 0,
            bifurcation_ratio: 0.0,
            length_ratio: 0.0,
            pipe_exponent: 0.0,
        }
    }
}

/// Measures how a skeleton branches: Horton-Strahler orders, unbranched runs, the exponent of the pipe model read off
/// the radii. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_branching(
    skeleton: *const tree_skeleton,
    report: *mut tree_branching_report,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let orders = Strahler::of(skeleton);
        let found = tree_branching_report {
            n_orders: orders.highest(),
            n_runs: Runs::of(skeleton).as_slice().len() as u32,
            bifurcation_ratio: orders.bifurcation_ratio().unwrap_or(0.0),
            length_ratio: orders.length_ratio().unwrap_or(0.0),
            pipe_exponent: pipe_exponent(skeleton).unwrap_or(0.0),
            ..tree_branching_report::default_value()
        };
        unsafe { write(report, "report", &found) }
    })
}

/// The Horton-Strahler order of each node, from 1 up: that of the segment below it. `orders` has room for `capacity`
/// numbers, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_strahler_orders(
    skeleton: *const tree_skeleton,
    orders: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = Strahler::of(unsafe { get(skeleton, "skeleton") }?.rust());
        unsafe { fill(orders, capacity, found.orders(), "orders") }
    })
}

/// The branches of a Horton-Strahler order.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_strahler_order {
    /// How many there are; one of the highest order.
    pub n_branches: u64,
    /// Their mean length in metres. 0 for the highest order where the root itself is the fork.
    pub mean_length: f64,
}

/// The branches of order 1, 2 and so on, a row for each order, and the number of orders into `n_rows`. `rows` has room
/// for `capacity` rows: 33 are enough, and as many as there are nodes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_strahler_counts(
    skeleton: *const tree_skeleton,
    rows: *mut tree_strahler_order,
    capacity: usize,
    n_rows: *mut usize,
) -> tree_status {
    call(|| {
        let found = Strahler::of(unsafe { get(skeleton, "skeleton") }?.rust());
        let both = found.counts().iter().zip(found.mean_lengths());
        let found: Vec<_> = both
            .map(|(&n, &mean_length)| tree_strahler_order { n_branches: n.into(), mean_length })
            .collect();
        unsafe { fill(rows, capacity, &found, "rows") }?;
        unsafe { out_value(n_rows, found.len(), "n_rows") }
    })
}

/// An unbranched run: what lies between two forks, or a fork and a tip.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_unbranched_run {
    /// The run below; `TREE_NO_PARENT` for run 0.
    pub parent: u32,
    /// Its upper end: a fork or a tip.
    pub end: u32,
    /// 1 where it ends in a tip.
    pub is_tip: u32,
    /// Its segments, the one above the fork included: at least 1, but for a root that is a fork or a tip.
    pub n_segments: u32,
    /// Length from the fork below to the end, in metres.
    pub length: f64,
    /// Mean radius in metres, weighted by length; radii of 0 are left out, as they are not known. 0 where none is. A run
    /// without length has the radius of its end.
    pub radius: f64,
}

impl tree_unbranched_run {
    fn of(run: &Run) -> Self {
        let Run { parent, end, is_tip, n_segments, length, radius } = *run;
        Self { parent, end, is_tip: is_tip.into(), n_segments, length, radius }
    }
}

/// All unbranched runs, those below first, and their number into `n_runs`. Run 0 starts at the root and has no length
/// where the root is a fork. `runs` has room for `capacity` rows: as many as there are nodes are enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_runs(
    skeleton: *const tree_skeleton,
    runs: *mut tree_unbranched_run,
    capacity: usize,
    n_runs: *mut usize,
) -> tree_status {
    call(|| {
        let found = Runs::of(unsafe { get(skeleton, "skeleton") }?.rust());
        let found: Vec<_> = found.as_slice().iter().map(tree_unbranched_run::of).collect();
        unsafe { fill(runs, capacity, &found, "runs") }?;
        unsafe { out_value(n_runs, found.len(), "n_runs") }
    })
}

/// The run that each node lies on, a number of `tree_skeleton_runs`; a fork lies on the run below it. `run_of` has room
/// for `capacity` numbers, at least one for each node.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_run_of(
    skeleton: *const tree_skeleton,
    run_of: *mut u32,
    capacity: usize,
) -> tree_status {
    call(|| {
        let found = Runs::of(unsafe { get(skeleton, "skeleton") }?.rust());
        unsafe { fill(run_of, capacity, found.run_of(), "run_of") }
    })
}

/// The exponent of the pipe model at each fork that has one, r^e = r1^e + r2^e + ..., as the radii are, in the order of
/// the runs below, and their number into `n_exponents`. Infinite where a branch is as thick as the run below it or
/// thicker. Forks at which a radius is 0, or a branch is a tip of one segment, are left out. `exponents` has room for
/// `capacity` numbers: as many as there are nodes are enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_pipe_exponents(
    skeleton: *const tree_skeleton,
    exponents: *mut f64,
    capacity: usize,
    n_exponents: *mut usize,
) -> tree_status {
    call(|| {
        let found = pipe_exponents(unsafe { get(skeleton, "skeleton") }?.rust());
        unsafe { fill(exponents, capacity, &found, "exponents") }?;
        unsafe { out_value(n_exponents, found.len(), "n_exponents") }
    })
}

/// How far a lateral turns away from its parent axis.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct tree_lateral_angle {
    /// First node of the lateral, the one above the fork.
    pub node: u32,
    /// Between the axis below the fork and the lateral, in radians from 0 to pi.
    pub angle: f32,
}

impl tree_lateral_angle {
    fn of(lateral: &LateralAngle) -> Self {
        let LateralAngle { node, angle } = *lateral;
        Self { node, angle }
    }
}

/// The angle of every lateral, in the order of axes, and their number into `n_laterals`; `rule` says what is axis and
/// what lateral. Both directions are chords of `reach` metres, 0 or more: of the axis below the fork, and along the
/// lateral. With a reach of 0 they are the segments next to the fork; measured skeletons are rough there and want a
/// reach of a few diameters. Laterals at the root, and those without length, are left out. `laterals` has room for
/// `capacity` rows: as many as there are nodes are enough.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_lateral_angles(
    skeleton: *const tree_skeleton,
    rule: tree_continuation,
    reach: f32,
    laterals: *mut tree_lateral_angle,
    capacity: usize,
    n_laterals: *mut usize,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let rule = continuation(rule, "rule")?;
        if !(reach >= 0.0 && reach.is_finite()) {
            let text = format!("reach is {reach}, 0 or more metres are wanted");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        }
        let found = lateral_angles(skeleton, rule, reach);
        let found: Vec<_> = found.iter().map(tree_lateral_angle::of).collect();
        unsafe { fill(laterals, capacity, &found, "laterals") }?;
        unsafe { out_value(n_laterals, found.len(), "n_laterals") }
    })
}
