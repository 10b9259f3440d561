//! A few unique twigs, set down many times.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, Versioned, call, free, get, get_opt, init, out,
    out_value, read_or_default, tree_status, view, write,
};
use crate::control::{run, tree_control};
use crate::look::tree_look;
use crate::mesh::{column, mesh_params, tree_mesh, tree_mesh_params};
use crate::tree::tree_tree;
use ::tree_mesh::Look;
use ::tree_mesh::instance::{InstancedTree, Twig, TwigParams, TwigReport, twigs};
use glam::Quat;
use std::borrow::Cow;
use std::sync::Arc;
use tree_model::tree_core::Seed;

const _: () = assert!(size_of::<Quat>() == 16 && align_of::<Quat>() == 4);

/// A tree as a base mesh and a few unique twigs, set down many times: at a tenth of its memory and less.
pub struct tree_twigs(Arc<InstancedTree>);

impl Handle for tree_twigs {
    const NAME: &'static str = "tree_twigs";
}

impl tree_twigs {
    #[allow(dead_code, reason = "until files of twigs are written")]
    pub(crate) fn rust(&self) -> &InstancedTree {
        &self.0
    }
}

/// How a tree is divided into twigs. Begin with `tree_twig_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_twig_params {
    /// `sizeof(tree_twig_params)`.
    pub struct_size: usize,
    /// Most unique twigs, 1 to 1000. Default 30.
    pub twigs_max: u32,
    /// How many times smaller than the flattened tree the result should be, 1 to 1000. Default 11: ten,
    /// and some room. The truest way that reaches it is taken. Small trees may not reach it: see `ratio`
    /// of `tree_twig_report`.
    pub ratio: f32,
    /// Length of twigs in metres along the longest path in them, 0.001 to 1000. Default 0: it is chosen.
    pub reach: f32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_twig_params {
    const NAME: &'static str = "tree_twig_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let TwigParams { twigs_max, ratio, reach, seed: _ } = TwigParams::default();
        let struct_size = size_of::<Self>();
        Self { struct_size, twigs_max, ratio, reach: reach.unwrap_or(0.0), reserved: 0 }
    }
}

impl tree_twig_params {
    fn rust(&self, seed: u64) -> TwigParams {
        TwigParams {
            twigs_max: self.twigs_max,
            ratio: self.ratio,
            // NaN is not 0, and refused with the other ranges.
            reach: (self.reach != 0.0).then_some(self.reach),
            seed: Seed(seed),
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twig_params_init(
    params: *mut tree_twig_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// What an instanced tree weighs and how near it comes.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_twig_report {
    /// `sizeof(tree_twig_report)`.
    pub struct_size: usize,
    /// Unique twigs.
    pub n_twigs: u64,
    /// Instances of all twigs.
    pub n_instances: u64,
    /// Bytes of the columns of base and twigs, and of the instances.
    pub bytes: u64,
    /// Bytes of the columns of the flattened tree.
    pub bytes_flat: u64,
    /// Leaves of the tree.
    pub n_leaves: u64,
    /// Leaves of the instanced tree.
    pub n_leaves_instanced: u64,
    /// `bytes_flat / bytes`.
    pub ratio: f32,
    /// Length that twigs were limited to, in metres.
    pub reach: f32,
    /// How far middle and spread of a subtree's leaves are off those of the twig that stands for it, in
    /// metres: root mean square over all leaves.
    pub deviation: f32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_twig_report {
    const NAME: &'static str = "tree_twig_report";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&TwigReport::default())
    }
}

impl tree_twig_report {
    fn of(report: &TwigReport) -> Self {
        let (n_leaves, n_leaves_instanced) = report.n_leaves;
        Self {
            struct_size: size_of::<Self>(),
            n_twigs: report.n_twigs as u64,
            n_instances: report.n_instances as u64,
            bytes: report.bytes,
            bytes_flat: report.bytes_flat,
            n_leaves,
            n_leaves_instanced,
            ratio: report.ratio,
            reach: report.reach,
            deviation: report.deviation,
            reserved: 0,
        }
    }
}

/// Divides a tree into a base mesh and instances of at most `twigs_max` unique twigs. Light-map
/// coordinates are left out, since instances share their vertices. `look` may be NULL: the built-in
/// textures that the tree's species names. `mesh_params`, `params` and `report` may be NULL. Free the twigs
/// with `tree_twigs_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_build(
    tree: *const tree_tree,
    look: *const tree_look,
    mesh_params: *const tree_mesh_params,
    params: *const tree_twig_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_twig_report,
    twigs: *mut *mut tree_twigs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(twigs, "twigs") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let mesh_params = unsafe { self::mesh_params(mesh_params) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust(seed);
        let made = unsafe {
            run(control, |control| {
                let look = match look {
                    Some(look) => Cow::Borrowed(look),
                    None => Cow::Owned(Look::built_in(tree.species())?),
                };
                Ok(self::twigs(tree, &look, &mesh_params, &params, control)?)
            })
        }?;
        unsafe { view(report, "report", &tree_twig_report::of(&made.report)) }?;
        place.put(tree_twigs(Arc::new(made)));
        Ok(())
    })
}

/// Number of unique twigs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_count(
    twigs: *const tree_twigs,
    n_twigs: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(twigs, "twigs") }?.rust().twigs.len();
        unsafe { out_value(n_twigs, n, "n_twigs") }
    })
}

/// What the twigs weigh and how near they come. Set `report->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_report(
    twigs: *const tree_twigs,
    report: *mut tree_twig_report,
) -> tree_status {
    call(|| {
        let report_of = unsafe { get(twigs, "twigs") }?.rust().report;
        unsafe { write(report, "report", &tree_twig_report::of(&report_of)) }
    })
}

/// The base mesh: wood and leaves that are not part of a twig, surfaces as `tree_mesh_build` makes them.
/// Not copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_base(
    twigs: *const tree_twigs,
    base: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(base, "base") }?;
        place.put(tree_mesh::base_of(unsafe { get(twigs, "twigs") }?.0.clone()));
        Ok(())
    })
}

fn twig_of(twigs: &tree_twigs, number: usize) -> Result<&Twig> {
    let all = &twigs.rust().twigs;
    all.get(number).ok_or_else(|| {
        let n = all.len();
        Failure::new(TREE_ERROR_INVALID, format!("number is {number}, there are {n} twigs"))
    })
}

/// The mesh of twig `number`, its base at the origin; surfaces and materials as in the base mesh. Not
/// copied; the mesh keeps the twigs alive. Free it with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_mesh(
    twigs: *const tree_twigs,
    number: usize,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let twigs = unsafe { get(twigs, "twigs") }?;
        twig_of(twigs, number)?;
        place.put(tree_mesh::twig_of(twigs.0.clone(), number));
        Ok(())
    })
}

/// All places where a twig stands, in columns as glTF's `EXT_mesh_gpu_instancing` has them: a view.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_twig_instances {
    /// `sizeof(tree_twig_instances)`.
    pub struct_size: usize,
    /// Number of instances.
    pub n_instances: usize,
    /// Three floats for each instance: where its base is, in metres.
    pub translations: *const f32,
    /// Four floats for each instance: its turn, a unit quaternion x, y, z, w.
    pub rotations: *const f32,
    /// Three floats for each instance: factor on its size, the same along all axes.
    pub scales: *const f32,
    /// One for each instance: the branch of the base mesh that bears it.
    pub branches: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_twig_instances {
    const NAME: &'static str = "tree_twig_instances";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Twig::default())
    }
}

impl tree_twig_instances {
    fn of(twig: &Twig) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_instances: twig.translations.len(),
            translations: column(&twig.translations).cast(),
            rotations: column(&twig.rotations).cast(),
            scales: column(&twig.scales).cast(),
            branches: column(&twig.branches),
        }
    }
}

/// Views all places where twig `number` stands. Set `instances->struct_size` first. Valid until the twigs
/// are freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_instances(
    twigs: *const tree_twigs,
    number: usize,
    instances: *mut tree_twig_instances,
) -> tree_status {
    call(|| {
        let twig = twig_of(unsafe { get(twigs, "twigs") }?, number)?;
        unsafe { write(instances, "instances", &tree_twig_instances::of(twig)) }
    })
}

/// Makes one plain mesh of base and instances: surfaces as the base has them, with the instances'
/// triangles behind. Columns that not all parts have, and light-map coordinates, are left out. Every
/// instance gets branches of its own, carried by the branch it stands on. Free the mesh with
/// `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_flatten(
    twigs: *const tree_twigs,
    control: *const tree_control,
    mesh: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(mesh, "mesh") }?;
        let twigs = unsafe { get(twigs, "twigs") }?.rust();
        let flat = unsafe { run(control, |control| Ok(twigs.flatten(control)?)) }?;
        place.put(tree_mesh::new(flat));
        Ok(())
    })
}

/// Ends twigs. Meshes that were asked of them live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_free(twigs: *mut tree_twigs) -> tree_status {
    call(|| unsafe { free(twigs, "twigs") })
}
