//! Meshes that move, as a skin with key frames.

use super::bytes::tree_bytes;
use super::gltf::{read_options, tree_glb_options};
use crate::border::{
    self, Result, Versioned, call, get, init, out, read, slice, tree_status, vec3s,
};
use crate::control::{run, tree_control};
use crate::mesh::tree_mesh;
use ::tree_mesh::Mesh;
use ::tree_mesh::io::gltf::{JointPose, Motion, to_glb_moving, write_glb_moving};
use glam::{Quat, Vec3};
use std::ffi::c_char;
use tree_model::tree_core::{Limits, Resource};

/// How a mesh moves: each vertex with one joint, each joint from frame to frame. Begin with `tree_glb_motion_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_glb_motion {
    /// `sizeof(tree_glb_motion)`.
    pub struct_size: usize,
    /// `n_joints` points: where each joint is in the mesh as it stands, in metres.
    pub joints: *const f32,
    /// 1 to 65,536.
    pub n_joints: usize,
    /// `n_vertices` numbers: the joint of each vertex, of all surfaces one after the other.
    pub vertex_joints: *const u16,
    /// Vertices of all surfaces of the mesh.
    pub n_vertices: usize,
    /// `n_frames` seconds, from 0 on, ascending.
    pub times: *const f32,
    /// At least 1.
    pub n_frames: usize,
    /// `n_frames` times `n_joints` points: where each joint is then.
    pub positions: *const f32,
    /// As many unit quaternions x, y, z, w; NULL for none turned.
    pub rotations: *const f32,
    /// As many factors, 0 or more; NULL for 1.
    pub scales: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_glb_motion {
    const NAME: &'static str = "tree_glb_motion";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let none = std::ptr::null();
        Self {
            struct_size: size_of::<Self>(),
            joints: none,
            n_joints: 0,
            vertex_joints: std::ptr::null(),
            n_vertices: 0,
            times: none,
            n_frames: 0,
            positions: none,
            rotations: none,
            scales: none,
        }
    }
}

impl tree_glb_motion {
    unsafe fn rust(&self, mesh: &Mesh) -> Result<Motion> {
        let limits = &Limits::default();
        let joints =
            unsafe { vec3s(self.joints, self.n_joints, limits, Resource::Nodes, "motion.joints") }?;
        let vertices = unsafe {
            let n = self.n_vertices;
            slice(self.vertex_joints, n, limits, Resource::Triangles, "motion.vertex_joints")
        }?;
        let times =
            unsafe { slice(self.times, self.n_frames, limits, Resource::Nodes, "motion.times") }?;
        let n = self.n_frames.saturating_mul(self.n_joints);
        let positions =
            unsafe { vec3s(self.positions, n, limits, Resource::Nodes, "motion.positions") }?;
        let mut poses: Vec<JointPose> = positions
            .iter()
            .map(|&position| JointPose { position, rotation: Quat::IDENTITY, scale: 1.0 })
            .collect();
        if !self.rotations.is_null() {
            let rows: &[[f32; 4]] = unsafe {
                slice(self.rotations.cast(), n, limits, Resource::Nodes, "motion.rotations")
            }?;
            poses
                .iter_mut()
                .zip(rows)
                .for_each(|(pose, row)| pose.rotation = Quat::from_array(*row));
        }
        if !self.scales.is_null() {
            let rows = unsafe { slice(self.scales, n, limits, Resource::Nodes, "motion.scales") }?;
            poses.iter_mut().zip(rows).for_each(|(pose, &scale)| pose.scale = scale);
        }
        let frames = poses.chunks(self.n_joints.max(1)).map(<[JointPose]>::to_vec).collect();
        let joints: Vec<Vec3> = joints.to_vec();
        Ok(Motion { joints, surfaces: shared_out(mesh, vertices), times: times.to_vec(), frames })
    }
}

/// The joints of each surface; too few or too many vertices show in their numbers.
fn shared_out(mesh: &Mesh, mut vertices: &[u16]) -> Vec<Vec<u16>> {
    let n_surfaces = mesh.surfaces.len();
    let mut surfaces = Vec::with_capacity(n_surfaces);
    for (number, surface) in mesh.surfaces.iter().enumerate() {
        let n = if number + 1 == n_surfaces { vertices.len() } else { surface.positions.len() };
        let (own, rest) = vertices.split_at(n.min(vertices.len()));
        surfaces.push(own.to_vec());
        vertices = rest;
    }
    surfaces
}

/// Makes `motion`, of `size` bytes, one without joints and frames.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_glb_motion_init(
    motion: *mut tree_glb_motion,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(motion, size) })
}

/// Writes a mesh that moves to a GLB file, whole or not at all: a skin and one animation, linear between frames; joints that stay
/// have no channels. Path, `options` and `control` as in `tree_mesh_write_glb`; positions are not quantised. `TREE_ERROR_INVALID` where
/// motion and mesh do not fit together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_write_glb_moving(
    mesh: *const tree_mesh,
    motion: *const tree_glb_motion,
    path: *const c_char,
    path_len: usize,
    options: *const tree_glb_options,
    control: *const tree_control,
) -> tree_status {
    call(|| {
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let motion = unsafe { read(motion, "motion")?.rust(mesh) }?;
        let path = unsafe { border::path(path, path_len, "path") }?;
        let options = unsafe { read_options(options) }?;
        unsafe {
            run(control, |control| {
                control.check()?;
                Ok(write_glb_moving(mesh, &motion, path, &options)?)
            })
        }
    })
}

/// A mesh that moves as a GLB file in memory, as `tree_mesh_write_glb_moving` writes it. Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_to_glb_moving(
    mesh: *const tree_mesh,
    motion: *const tree_glb_motion,
    options: *const tree_glb_options,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let motion = unsafe { read(motion, "motion")?.rust(mesh) }?;
        let options = unsafe { read_options(options) }?;
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                Ok(to_glb_moving(mesh, &motion, &options)?)
            })
        }?;
        place.put(tree_bytes::new(made));
        Ok(())
    })
}
