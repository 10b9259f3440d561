//! What goes into glTF files besides a mesh: levels, instances, columns of the caller's own.

use super::per_vertex;
use crate::border::{Failure, Result, Versioned, get, read_rows, slice, tree_str, vec3s};
use crate::control::{limits, tree_control};
use crate::mesh::tree_mesh;
use ::tree_mesh::Mesh;
use ::tree_mesh::io::gltf::{Attribute, Instances, Level};
use glam::Quat;
use tree_model::tree_core::{Limits, Resource};

/// Most levels of a file.
const LEVELS_MAX: usize = 256;
/// Most rows of instances or attributes of a level.
const ROWS_MAX: usize = 1 << 16;

/// A column of the caller's own, for one surface of a mesh.
///
/// Blender 5.0.1 mixes up attributes of one mesh whose names begin with `_` when they differ in their
/// number of components, and then now and then refuses the file: give all the same number there, and
/// write occlusion in another way.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_gltf_attribute {
    /// `sizeof(tree_gltf_attribute)`.
    pub struct_size: usize,
    /// Number of the surface in the mesh.
    pub surface: usize,
    /// Name in the file: `_` and then capital letters, digits and `_`, at most 64 in all.
    pub name: tree_str,
    /// Numbers per vertex, 1 to 4.
    pub components: usize,
    /// `components` finite numbers for each vertex.
    pub values: *const f32,
    /// Number of values: `components` times the number of vertices of the surface.
    pub n_values: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_gltf_attribute {
    const NAME: &'static str = "tree_gltf_attribute";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            surface: 0,
            name: tree_str::EMPTY,
            components: 0,
            values: std::ptr::null(),
            n_values: 0,
        }
    }
}

impl tree_gltf_attribute {
    unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<Attribute> {
        let field = format!("{name}.values");
        let limits = per_vertex(limits, 4);
        let values =
            unsafe { slice(self.values, self.n_values, &limits, Resource::Triangles, &field) }?;
        Ok(Attribute {
            surface: self.surface,
            name: unsafe { self.name.get(&format!("{name}.name")) }?.to_owned(),
            components: self.components,
            values: values.to_vec(),
        })
    }
}

/// A mesh and where its copies stand: scaled, turned, then moved.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_gltf_instances {
    /// `sizeof(tree_gltf_instances)`.
    pub struct_size: usize,
    /// Name of the node and the mesh.
    pub name: tree_str,
    /// What is drawn many times, with materials of its own. Copied while the file is written.
    pub mesh: *const tree_mesh,
    /// Number of copies, at least 1.
    pub n: usize,
    /// Three floats for each copy: where the origin comes to lie, in metres.
    pub translations: *const f32,
    /// Four floats for each copy: how it is turned, a unit quaternion x, y, z, w.
    pub rotations: *const f32,
    /// Three floats for each copy: factors along the axes of the mesh.
    pub scales: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_gltf_instances {
    const NAME: &'static str = "tree_gltf_instances";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            mesh: std::ptr::null(),
            n: 0,
            translations: std::ptr::null(),
            rotations: std::ptr::null(),
            scales: std::ptr::null(),
        }
    }
}

impl tree_gltf_instances {
    unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<Instances> {
        let (n, leaves) = (self.n, Resource::Leaves);
        let field = |field: &str| format!("{name}.{field}");
        let rotations: &[[f32; 4]] =
            unsafe { slice(self.rotations.cast(), n, limits, leaves, &field("rotations")) }?;
        let translations =
            unsafe { vec3s(self.translations, n, limits, leaves, &field("translations")) }?;
        let scales = unsafe { vec3s(self.scales, n, limits, leaves, &field("scales")) }?;
        Ok(Instances {
            name: unsafe { self.name.get(&field("name")) }?.to_owned(),
            mesh: unsafe { get(self.mesh, &field("mesh")) }?.rust().clone(),
            translations: translations.to_vec(),
            rotations: rotations.iter().map(|&turn| Quat::from_array(turn)).collect(),
            scales: scales.to_vec(),
        })
    }
}

/// One level of detail of a glTF file, or all of it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_gltf_level {
    /// `sizeof(tree_gltf_level)`.
    pub struct_size: usize,
    /// What is drawn once. May be NULL when there are instances.
    pub mesh: *const tree_mesh,
    /// What is drawn many times.
    pub instances: *const tree_gltf_instances,
    /// Number of `instances`, 0 to 65,536.
    pub n_instances: usize,
    /// More columns for the surfaces of `mesh`.
    pub attributes: *const tree_gltf_attribute,
    /// Number of `attributes`, 0 to 65,536.
    pub n_attributes: usize,
    /// Share of the screen's height (0 to 1) from which this level is drawn, the finest first. Not used
    /// when there is one level.
    pub coverage: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_gltf_level {
    const NAME: &'static str = "tree_gltf_level";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            mesh: std::ptr::null(),
            instances: std::ptr::null(),
            n_instances: 0,
            attributes: std::ptr::null(),
            n_attributes: 0,
            coverage: 0.0,
        }
    }
}

/// A caller's levels, read.
pub(super) struct GltfLevels<'a> {
    empty: Mesh,
    levels: Vec<GltfLevel<'a>>,
}

struct GltfLevel<'a> {
    mesh: Option<&'a Mesh>,
    instances: Vec<Instances>,
    attributes: Vec<Attribute>,
    coverage: f32,
}

impl GltfLevels<'_> {
    /// # Safety
    /// The rows are as the header says, and stay so.
    pub(super) unsafe fn read(
        levels: *const tree_gltf_level,
        n_levels: usize,
        control: *const tree_control,
    ) -> Result<Self> {
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { read_rows(levels, n_levels, LEVELS_MAX, "levels") }?;
        let levels = rows
            .iter()
            .enumerate()
            .map(|(number, row)| unsafe { row.rust(&limits, &format!("levels[{number}]")) })
            .collect::<Result<_>>()?;
        Ok(Self { empty: Mesh::default(), levels })
    }

    pub(super) fn rust(&self) -> Vec<Level<'_>> {
        self.levels
            .iter()
            .map(|level| Level {
                mesh: level.mesh.unwrap_or(&self.empty),
                instances: &level.instances,
                attributes: &level.attributes,
                coverage: level.coverage,
            })
            .collect()
    }
}

impl tree_gltf_level {
    unsafe fn rust<'a>(&self, limits: &Limits, name: &str) -> Result<GltfLevel<'a>> {
        let field = |field: &str| format!("{name}.{field}");
        let mesh = if self.mesh.is_null() && self.n_instances > 0 {
            None
        } else {
            Some(unsafe { get(self.mesh, &field("mesh")) }?.rust())
        };
        let instances = field("instances");
        let rows = unsafe { read_rows(self.instances, self.n_instances, ROWS_MAX, &instances) }?;
        let copies: u64 = rows.iter().fold(0, |sum, row| sum.saturating_add(row.n as u64));
        limits.check(Resource::Leaves, copies).map_err(Failure::from)?;
        let instances = rows
            .iter()
            .enumerate()
            .map(|(i, row)| unsafe { row.rust(limits, &format!("{instances}[{i}]")) })
            .collect::<Result<_>>()?;
        let attributes = field("attributes");
        let rows = unsafe { read_rows(self.attributes, self.n_attributes, ROWS_MAX, &attributes) }?;
        let attributes = rows
            .iter()
            .enumerate()
            .map(|(i, row)| unsafe { row.rust(limits, &format!("{attributes}[{i}]")) })
            .collect::<Result<_>>()?;
        Ok(GltfLevel { mesh, instances, attributes, coverage: self.coverage })
    }
}
