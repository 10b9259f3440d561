//! A few unique twigs, set down many times.

mod params;

pub use params::*;

use crate::border::{
    Failure, Handle, Result, Shared, TREE_ERROR_INVALID, Versioned, call, foresee, free, get,
    get_opt, out, out_value, read_or_default, read_rows, slice, tree_status, vec3s, view, write,
};
use crate::control::{limits, run, tree_control};
use crate::look::{or_built_in, tree_look};
use crate::mesh::{column, copy_size, mesh_params, tree_mesh, tree_mesh_params};
use crate::tree::tree_tree;
use ::tree_mesh::Mesh;
use ::tree_mesh::instance::{InstancedTree, Twig, twigs};
use glam::{Quat, Vec3};
use tree_model::tree_core::{Limits, Resource};

/// Most twigs of a caller's.
const TWIGS_MAX: usize = 1 << 16;

const _: () = assert!(size_of::<Quat>() == 16 && align_of::<Quat>() == 4);

/// A tree as a base mesh and a few unique twigs, set down many times: at a tenth of its memory and less.
pub struct tree_twigs(Shared<InstancedTree>);

impl Handle for tree_twigs {
    const NAME: &'static str = "tree_twigs";
}

impl tree_twigs {
    pub(crate) fn rust(&self) -> &InstancedTree {
        self.0.get()
    }
}

/// Divides a tree into a base mesh and instances of at most `max_twigs` unique twigs. Light-map
/// coordinates are left out, since instances share their vertices. `look` may be NULL: the built-in
/// textures that the tree's species names. `mesh_params`, `params` and `report` may be NULL. Free the twigs
/// with `tree_twigs_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_build(
    tree: *const tree_tree,
    look: *const tree_look,
    mesh_params: *const tree_mesh_params,
    params: *const tree_instancing_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_instancing_report,
    twigs: *mut *mut tree_twigs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(twigs, "twigs") }?;
        unsafe { foresee(report, "report") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let mesh_params = unsafe { self::mesh_params(mesh_params) }?;
        let params = unsafe { read_or_default(params, "params") }?.rust(seed);
        let made = unsafe {
            run(control, |control| {
                let look = or_built_in(look, tree.species())?;
                Ok(self::twigs(tree, &look, &mesh_params, &params, control)?)
            })
        }?;
        unsafe { view(report, "report", &tree_instancing_report::of(&made.report)) }?;
        place.put(tree_twigs(Shared::new(made)));
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
pub unsafe extern "C" fn tree_twigs_measure(
    twigs: *const tree_twigs,
    report: *mut tree_instancing_report,
) -> tree_status {
    call(|| {
        let report_of = unsafe { get(twigs, "twigs") }?.rust().report;
        unsafe { write(report, "report", &tree_instancing_report::of(&report_of)) }
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
        place.put(tree_mesh::part(unsafe { get(twigs, "twigs") }?.0.part(|tree| &tree.base)));
        Ok(())
    })
}

fn twig_of(twigs: &tree_twigs, number: usize) -> Result<&Twig> {
    twigs.rust().twigs.get(number).ok_or_else(|| no_twig(twigs, number))
}

fn no_twig(twigs: &tree_twigs, number: usize) -> Failure {
    let n = twigs.rust().twigs.len();
    Failure::new(TREE_ERROR_INVALID, format!("number is {number}, there are {n} twigs"))
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
        let mesh = twigs.0.part_if(|tree| tree.twigs.get(number).map(|twig| &twig.mesh));
        place.put(tree_mesh::part(mesh.ok_or_else(|| no_twig(twigs, number))?));
        Ok(())
    })
}

/// All places where a twig stands, in columns as glTF's `EXT_mesh_gpu_instancing` has them: as input, or as a
/// view.
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

    /// Borrows the caller's columns of row `i`.
    unsafe fn rust<'a>(&self, mesh: &'a Mesh, limits: &Limits, i: usize) -> Result<Row<'a>> {
        let part = |name: &str| format!("instances[{i}].{name}");
        let (n, rows) = (self.n_instances, Resource::Leaves);
        let translations =
            unsafe { vec3s(self.translations, n, limits, rows, &part("translations")) }?;
        let rotations =
            unsafe { slice(self.rotations.cast(), n, limits, rows, &part("rotations")) }?;
        let scales = unsafe { vec3s(self.scales, n, limits, rows, &part("scales")) }?;
        let branches = unsafe { slice(self.branches, n, limits, rows, &part("branches")) }?;
        Ok(Row { mesh, translations, rotations, scales, branches })
    }
}

/// A caller's twig, not copied yet.
struct Row<'a> {
    mesh: &'a Mesh,
    translations: &'a [Vec3],
    rotations: &'a [[f32; 4]],
    scales: &'a [Vec3],
    branches: &'a [u32],
}

impl Row<'_> {
    fn copy(&self) -> Twig {
        Twig {
            mesh: self.mesh.clone(),
            translations: self.translations.to_vec(),
            rotations: self.rotations.iter().copied().map(Quat::from_array).collect(),
            scales: self.scales.to_vec(),
            branches: self.branches.to_vec(),
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

/// Makes twigs of parts of your own: a base mesh, and for each of `n_twigs` twigs its mesh, with as many
/// surfaces as the base, and where it stands. All is copied but the textures, and checked; scales must be
/// the same along all axes. The report has the sizes; `reach` and `deviation` are 0 in it. `control` may
/// be NULL; of its limits `triangles` caps those of all meshes together, and `leaves` the instances. Free
/// the twigs with `tree_twigs_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_from_parts(
    base: *const tree_mesh,
    meshes: *const *const tree_mesh,
    instances: *const tree_twig_instances,
    n_twigs: usize,
    control: *const tree_control,
    twigs: *mut *mut tree_twigs,
) -> tree_status {
    call(|| {
        let place = unsafe { out(twigs, "twigs") }?;
        let limits = unsafe { limits(control) }?;
        let base = unsafe { get(base, "base") }?.rust();
        let rows = unsafe { read_rows(instances, n_twigs, TWIGS_MAX, "instances") }?;
        if n_twigs > 0 && meshes.is_null() {
            return Err(Failure::null("meshes"));
        }
        // The same mesh and the same places may be given many times: their copies are what counts.
        let (mut triangles, mut places) = (copy_size(base), 0_u64);
        let mut parts = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            // SAFETY: within the caller's array.
            let mesh = unsafe { meshes.add(i).read_unaligned() };
            let mesh = unsafe { get(mesh, &format!("meshes[{i}]")) }?.rust();
            triangles = triangles.saturating_add(copy_size(mesh));
            limits.check(Resource::Triangles, triangles)?;
            places = places.saturating_add(row.n_instances as u64);
            limits.check(Resource::Leaves, places)?;
            parts.push(unsafe { row.rust(mesh, &limits, i) }?);
        }
        let made = unsafe {
            run(control, |control| {
                let copy = |row: &Row<'_>| control.check().map(|()| row.copy());
                let parts = parts.iter().map(copy).collect::<std::result::Result<_, _>>()?;
                Ok(InstancedTree::of_parts(base.clone(), parts)?)
            })
        }?;
        place.put(tree_twigs(Shared::new(made)));
        Ok(())
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

/// Frees twigs. Meshes that were asked of them live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_twigs_free(twigs: *mut tree_twigs) -> tree_status {
    call(|| unsafe { free(twigs, "twigs") })
}
