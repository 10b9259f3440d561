//! Collision capsules.

use crate::border::{
    Failure, Handle, Result, Versioned, call, floats, foresee, free, get, init, out, out_value,
    read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use crate::skeleton::{continuation, continuation_of, tree_continuation};
use ::tree_mesh::collide::{self, Capsule, CapsuleParams, CapsuleReport};
use std::mem::offset_of;

/// A cylinder with round ends.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_capsule {
    /// Middle of one end, in metres.
    pub a: [f32; 3],
    /// Middle of the other end.
    pub b: [f32; 3],
    /// Radius in metres.
    pub radius: f32,
}

// One is viewed as the other.
const _: () = {
    assert!(size_of::<tree_capsule>() == size_of::<Capsule>());
    assert!(align_of::<tree_capsule>() == align_of::<Capsule>());
    assert!(offset_of!(tree_capsule, a) == offset_of!(Capsule, a));
    assert!(offset_of!(tree_capsule, b) == offset_of!(Capsule, b));
    assert!(offset_of!(tree_capsule, radius) == offset_of!(Capsule, radius));
};

/// Collision capsules of a tree.
pub struct tree_capsules(Vec<Capsule>);

impl Handle for tree_capsules {
    const NAME: &'static str = "tree_capsules";
}

/// How capsules are made. Begin with `tree_capsule_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_capsule_params {
    /// `sizeof(tree_capsule_params)`.
    pub struct_size: usize,
    /// Most capsules, 1 to 4096. Default 32.
    pub max_count: u32,
    /// Wood thinner than this is passed over, in metres, 0 to 10. Default 0.05. When nothing is as
    /// thick, half the radius of the thickest wood is taken instead, so that saplings collide as well.
    pub min_radius: f32,
    /// Share of the volume of the other wood that must lie inside, 0 to 1. Default 0.95.
    pub share: f32,
    /// Which child goes on at a fork. Default `TREE_CONTINUATION_THICKEST`.
    pub continuation: tree_continuation,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_capsule_params {
    const NAME: &'static str = "tree_capsule_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = CapsuleParams::default();
        Self {
            struct_size: size_of::<Self>(),
            max_count: default.max_count,
            min_radius: default.min_radius,
            share: default.share,
            continuation: continuation_of(default.continuation),
        }
    }
}

impl tree_capsule_params {
    fn rust(&self) -> Result<CapsuleParams> {
        Ok(CapsuleParams {
            max_count: self.max_count,
            min_radius: self.min_radius,
            share: self.share,
            continuation: continuation(self.continuation, "params.continuation")?,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_capsule_params_init(
    params: *mut tree_capsule_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// How well capsules fit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_capsule_report {
    /// `sizeof(tree_capsule_report)`.
    pub struct_size: usize,
    /// Number of capsules.
    pub n_capsules: u64,
    /// Volume of the wood above the radius, in cubic metres: the sum of its frusta.
    pub volume: f64,
    /// Share of that volume that lies in a capsule, 0 to 1, as measured; 1 when there is no wood.
    pub held: f64,
    /// Volume of the capsules, those that overlap counted twice, over that of the wood they hold; 1 would
    /// be perfect. 0 when there is no wood.
    pub bulk: f64,
    /// The radius above which wood counted, in metres.
    pub min_radius: f32,
    /// Whether `held` reaches the share asked for.
    pub is_enough: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_capsule_report {
    const NAME: &'static str = "tree_capsule_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(0, &CapsuleReport::default())
    }
}

impl tree_capsule_report {
    fn of(n_capsules: usize, report: &CapsuleReport) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_capsules: n_capsules as u64,
            volume: report.volume,
            held: report.held,
            bulk: report.bulk,
            min_radius: report.min_radius,
            is_enough: report.is_enough.into(),
        }
    }
}

/// Makes capsules of a skeleton's thick wood: few, and with nearly all of it inside. However few are
/// allowed, the share asked for holds; what suffers is how tight they are, and the report says how tight.
/// `params`, `control` and `report` may be NULL. Free the capsules with `tree_capsules_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_capsules(
    skeleton: *const tree_skeleton,
    params: *const tree_capsule_params,
    control: *const tree_control,
    report: *mut tree_capsule_report,
    capsules: *mut *mut tree_capsules,
) -> tree_status {
    call(|| {
        let place = unsafe { out(capsules, "capsules") }?;
        unsafe { foresee(report, "report") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust()?;
        let made =
            unsafe { run(control, |control| Ok(collide::capsules(skeleton, &params, control)?)) }?;
        let found = tree_capsule_report::of(made.capsules.len(), &made.report);
        unsafe { view(report, "report", &found) }?;
        place.put(tree_capsules(made.capsules));
        Ok(())
    })
}

/// Views the capsules: where they begin, NULL for none, and how many there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_capsules_view(
    capsules: *const tree_capsules,
    rows: *mut *const tree_capsule,
    n: *mut usize,
) -> tree_status {
    call(|| {
        let capsules = &unsafe { get(capsules, "capsules") }?.0;
        unsafe { out_value(rows, column(capsules).cast(), "rows") }?;
        unsafe { out_value(n, capsules.len(), "n") }
    })
}

fn rust(capsule: &tree_capsule) -> Capsule {
    Capsule { a: capsule.a.into(), b: capsule.b.into(), radius: capsule.radius }
}

/// Whether a point of three floats lies inside a capsule or on its border.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_capsule_contains(
    capsule: *const tree_capsule,
    point: *const f32,
    inside: *mut u32,
) -> tree_status {
    call(|| {
        let capsule = rust(&unsafe { value(capsule, "capsule") }?);
        let point = unsafe { floats::<3>(point, "point") }?;
        unsafe { out_value(inside, capsule.contains(point.into()).into(), "inside") }
    })
}

/// Volume of a capsule in cubic metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_capsule_volume(
    capsule: *const tree_capsule,
    volume: *mut f64,
) -> tree_status {
    call(|| {
        let capsule = rust(&unsafe { value(capsule, "capsule") }?);
        unsafe { out_value(volume, capsule.volume(), "volume") }
    })
}

/// A caller's row.
unsafe fn value(capsule: *const tree_capsule, argument: &str) -> Result<tree_capsule> {
    if capsule.is_null() {
        return Err(Failure::null(argument));
    }
    // SAFETY: not NULL, and there by contract; numbers only.
    Ok(unsafe { capsule.read_unaligned() })
}

/// Frees capsules.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_capsules_free(capsules: *mut tree_capsules) -> tree_status {
    call(|| unsafe { free(capsules, "capsules") })
}
