//! Finishing: meshes made of meshes, smoother, rougher, darker, welded.

use super::{ask_for_copies, tree_mesh};
use crate::border::{Result, Versioned, call, get, init, out, read_or_default, tree_status};
use crate::control::{run, tree_control};
use ::tree_mesh::displace::{DisplaceParams, displace};
use ::tree_mesh::occlusion::{OcclusionParams, bake};
use ::tree_mesh::subdivide::{SubdivideParams, subdivide};
use ::tree_mesh::topology::weld;
use ::tree_mesh::{Mesh, Surface};
use tree_model::tree_core::Seed;

/// A copy of `mesh` with another surface `number`.
fn with_surface(mesh: &Mesh, number: usize, new: Surface) -> Mesh {
    let before = mesh.surfaces.iter().take(number).cloned();
    let after = mesh.surfaces.iter().skip(number + 1).cloned();
    Mesh {
        surfaces: before.chain(std::iter::once(new)).chain(after).collect(),
        materials: mesh.materials.clone(),
        branches: mesh.branches.clone(),
    }
}

/// How a surface is subdivided. Begin with `tree_subdivide_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_subdivide_params {
    /// `sizeof(tree_subdivide_params)`.
    pub struct_size: usize,
    /// How often each triangle becomes four, 0 to 8. Default 2.
    pub levels: u32,
    /// Angle between normals in radians above which an edge is a crease, 0 to π. Default 1.
    pub crease: f32,
    /// Rounds in which the limit surface is brought to the old points, 0 (Loop's own, which shrinks) to
    /// 20. Default 1. More is for coarse meshes: where rings stand much closer than they are wide, as at
    /// the joints of a fine mesh, each round overshoots and the surface can fold. Fine meshes shrink
    /// little: 0 or 1 is enough.
    pub fit: u32,
    /// Not used; 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_subdivide_params {
    const NAME: &'static str = "tree_subdivide_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let SubdivideParams { levels, crease, fit } = SubdivideParams::default();
        Self { struct_size: size_of::<Self>(), levels, crease, fit, reserved: 0 }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_subdivide_params_init(
    params: *mut tree_subdivide_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes a mesh whose surface `number` is finer and rounder: Loop subdivision with creases kept. A closed
/// surface stays closed. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params`
/// may be NULL. Free the mesh with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_subdivide(
    mesh: *const tree_mesh,
    number: usize,
    params: *const tree_subdivide_params,
    control: *const tree_control,
    subdivided: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(subdivided, "subdivided") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let params =
            SubdivideParams { levels: params.levels, crease: params.crease, fit: params.fit };
        let surface = mesh.surface(number)?;
        let made = unsafe {
            run(control, |control| {
                ask_for_copies([mesh], 1)?;
                let new = subdivide(surface, &params, control)?;
                Ok(with_surface(mesh, number, new))
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// How bark is displaced. Lengths in metres. Begin with `tree_displace_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_displace_params {
    /// `sizeof(tree_displace_params)`.
    pub struct_size: usize,
    /// Height of the highest ridges and depth of the deepest furrows, 0 to 10 m; most points move less
    /// than half as far. Default 1 cm.
    pub amplitude: f32,
    /// Wavelength across the branch, 0.1 mm to 100 m. Default 8 cm.
    pub scale: f32,
    /// How many times longer the relief is along the branch, 1 to 20. Default 3.
    pub stretch: f32,
    /// Layers of noise, each of half the wavelength and half the height, 1 to 8. Default 3. The cost grows
    /// with it.
    pub octaves: u32,
    /// Largest share of the local radius by which a point moves, 0 to 0.5. Default 0.15.
    pub share: f32,
    /// The local radius where the mesh has no branches, 0 to 1000 m. Default 10 cm.
    pub radius: f32,
    /// Whether points on the ground keep their height, so that the tree stands as it stood. Default yes.
    pub has_ground: u32,
    /// With `has_ground`: points at or below this height keep theirs. Default 1 mm.
    pub ground: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_displace_params {
    const NAME: &'static str = "tree_displace_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = DisplaceParams::default();
        Self {
            struct_size: size_of::<Self>(),
            amplitude: default.amplitude,
            scale: default.scale,
            stretch: default.stretch,
            octaves: default.octaves,
            share: default.share,
            radius: default.radius,
            has_ground: default.ground.is_some().into(),
            ground: default.ground.unwrap_or(0.0),
        }
    }
}

impl tree_displace_params {
    fn rust(&self, seed: u64) -> DisplaceParams {
        DisplaceParams {
            amplitude: self.amplitude,
            scale: self.scale,
            stretch: self.stretch,
            octaves: self.octaves,
            share: self.share,
            radius: self.radius,
            ground: (self.has_ground != 0).then_some(self.ground),
            seed: Seed(seed),
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_displace_params_init(
    params: *mut tree_displace_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes a mesh whose surface `number` has relief: points moved in and out by noise, normals and tangents
/// tilted with them. A closed surface stays closed. The surface should be finer than `scale`: subdivide it
/// first. Everything else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `params` may be NULL.
/// Free the mesh with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_displace(
    mesh: *const tree_mesh,
    number: usize,
    params: *const tree_displace_params,
    seed: u64,
    control: *const tree_control,
    displaced: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(displaced, "displaced") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust(seed);
        ask_for_copies([mesh], 2)?;
        let mut surface = mesh.surface(number)?.clone();
        let made = unsafe {
            run(control, move |control| {
                displace(&mut surface, &mesh.branches, &params, control)?;
                Ok(with_surface(mesh, number, surface))
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// How ambient occlusion is computed. Begin with `tree_occlusion_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_occlusion_params {
    /// `sizeof(tree_occlusion_params)`.
    pub struct_size: usize,
    /// Cells along the longest side of the tree, 4 to 512. Default 64. Cost grows with its third power.
    pub cells: u32,
    /// Directions that light comes from, 6 to 1024. Default 48. Cost grows with it.
    pub directions: u32,
    /// Share of the light that a leaf keeps back, 0 to 1. Default 0.5: leaves let light pass, and their
    /// cards are not full.
    pub leaf_opacity: f32,
    /// Light from below the horizon as a share of that from above, 0.01 (dark ground) to 1. Default 0.5:
    /// what looks to the sky counts more than what looks to the ground.
    pub ground: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_occlusion_params {
    const NAME: &'static str = "tree_occlusion_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let OcclusionParams { cells, directions, leaf_opacity, ground } =
            OcclusionParams::default();
        Self { struct_size: size_of::<Self>(), cells, directions, leaf_opacity, ground }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_occlusion_params_init(
    params: *mut tree_occlusion_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Makes a copy of a mesh whose surfaces have the column `occlusion`: 1 where all light arrives, 0 where
/// none does. The cells count against the limit `voxels`. `params` may be NULL. Free the mesh with
/// `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_bake_occlusion(
    mesh: *const tree_mesh,
    params: *const tree_occlusion_params,
    control: *const tree_control,
    baked: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(baked, "baked") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?;
        let params = OcclusionParams {
            cells: params.cells,
            directions: params.directions,
            leaf_opacity: params.leaf_opacity,
            ground: params.ground,
        };
        // Before the copy is made.
        params.validate()?;
        let made = unsafe {
            run(control, |control| -> Result<Mesh> {
                ask_for_copies([mesh], 1)?;
                let mut made = mesh.clone();
                bake(&mut made, &params, control)?;
                Ok(made)
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}

/// Makes a mesh whose surface `number` has one vertex for each point: for volumes, printers and other
/// programs that take copies at seams for holes. Triangles that have two corners at one point are left
/// out, and so are vertices without triangles. Normals are the means of the copies' normals, texture
/// coordinates those of the first copy, so textures are torn at seams; tangents are dropped. Everything
/// else is copied. Only bark, not leaves: `TREE_ERROR_INVALID`. `control` may be NULL; only its pool
/// matters. Free the mesh with `tree_mesh_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_weld(
    mesh: *const tree_mesh,
    number: usize,
    control: *const tree_control,
    welded: *mut *mut tree_mesh,
) -> tree_status {
    call(|| {
        let place = unsafe { out(welded, "welded") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let surface = mesh.surface(number)?;
        let made = unsafe {
            run(control, |_| {
                ask_for_copies([mesh], 3)?;
                Ok(with_surface(mesh, number, weld(surface)?))
            })
        }?;
        place.put(tree_mesh::new(made));
        Ok(())
    })
}
