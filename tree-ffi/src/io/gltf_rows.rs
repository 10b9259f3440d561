//! What goes into glTF files besides a mesh: levels, instances, columns of the caller's own.

use super::per_vertex;
use crate::border::{Result, Versioned, get, read_rows, slice, tree_str, vec3s};
use crate::control::{limits, tree_control};
use crate::mesh::{ask_for_copies, copy_size, tree_mesh};
use ::tree_mesh::Mesh;
use ::tree_mesh::io::gltf::{Attribute, Instances, Level};
use glam::{Quat, Vec3};
use tree_model::tree_core::{Control, Limits, Resource};

/// Most levels of a file.
const MAX_LEVELS: usize = 256;
/// Most rows of instances or attributes of a level.
const ROWS_MAX: usize = 1 << 16;

/// Most numbers of one attribute for a vertex.
const VALUES_PER_VERTEX: u64 = 4;

/// What the rows of one call hold together. The same mesh or column may be given many times: it is copied
/// as often, so the sum is what the limits are for.
struct Sum<'a> {
    limits: &'a Limits,
    triangles: u64,
    places: u64,
    values: u64,
}

impl Sum<'_> {
    fn add_mesh(&mut self, mesh: &Mesh) -> Result<()> {
        self.triangles = self.triangles.saturating_add(copy_size(mesh));
        Ok(self.limits.check(Resource::Triangles, self.triangles)?)
    }

    fn add_places(&mut self, n: usize) -> Result<()> {
        self.places = self.places.saturating_add(n as u64);
        Ok(self.limits.check(Resource::Leaves, self.places)?)
    }

    /// Numbers, and a name; each counts as one at least.
    fn add_values(&mut self, n: usize, name: &str) -> Result<()> {
        let all = n.saturating_add(name.len() / size_of::<f32>()).max(1);
        self.values = self.values.saturating_add(all as u64);
        let limits = per_vertex(self.limits, VALUES_PER_VERTEX);
        Ok(limits.check(Resource::Triangles, self.values)?)
    }
}

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

/// A caller's column, not copied yet.
struct AttributeRow<'a> {
    surface: usize,
    name: &'a str,
    components: usize,
    values: &'a [f32],
}

impl AttributeRow<'_> {
    fn copy(&self) -> Attribute {
        Attribute {
            surface: self.surface,
            name: self.name.to_owned(),
            components: self.components,
            values: self.values.to_vec(),
        }
    }
}

impl tree_gltf_attribute {
    unsafe fn rust<'a>(&self, sum: &mut Sum<'_>, name: &str) -> Result<AttributeRow<'a>> {
        let field = format!("{name}.values");
        let own_name = unsafe { self.name.get(&format!("{name}.name")) }?;
        sum.add_values(self.n_values, own_name)?;
        let limits = per_vertex(sum.limits, VALUES_PER_VERTEX);
        let values =
            unsafe { slice(self.values, self.n_values, &limits, Resource::Triangles, &field) }?;
        Ok(AttributeRow {
            surface: self.surface,
            name: own_name,
            components: self.components,
            values,
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

/// A caller's mesh and places, not copied yet.
struct InstancesRow<'a> {
    name: &'a str,
    mesh: &'a Mesh,
    translations: &'a [Vec3],
    rotations: &'a [[f32; 4]],
    scales: &'a [Vec3],
}

impl InstancesRow<'_> {
    fn copy(&self) -> Instances {
        Instances {
            name: self.name.to_owned(),
            mesh: self.mesh.clone(),
            translations: self.translations.to_vec(),
            rotations: self.rotations.iter().map(|&turn| Quat::from_array(turn)).collect(),
            scales: self.scales.to_vec(),
        }
    }
}

impl tree_gltf_instances {
    unsafe fn rust<'a>(&self, sum: &mut Sum<'_>, name: &str) -> Result<InstancesRow<'a>> {
        let (n, leaves, limits) = (self.n, Resource::Leaves, sum.limits);
        sum.add_places(n)?;
        let field = |field: &str| format!("{name}.{field}");
        let rotations =
            unsafe { slice(self.rotations.cast(), n, limits, leaves, &field("rotations")) }?;
        let translations =
            unsafe { vec3s(self.translations, n, limits, leaves, &field("translations")) }?;
        let scales = unsafe { vec3s(self.scales, n, limits, leaves, &field("scales")) }?;
        let mesh = unsafe { get(self.mesh, &field("mesh")) }?.rust();
        sum.add_mesh(mesh)?;
        let name = unsafe { self.name.get(&field("name")) }?;
        sum.add_values(0, name)?;
        Ok(InstancesRow { name, mesh, translations, rotations, scales })
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
    /// 0.
    pub reserved: u32,
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
            reserved: 0,
        }
    }
}

/// A caller's levels, read and not copied yet.
pub(super) struct GltfLevels<'a>(Vec<GltfLevel<'a>>);

struct GltfLevel<'a> {
    mesh: Option<&'a Mesh>,
    instances: Vec<InstancesRow<'a>>,
    attributes: Vec<AttributeRow<'a>>,
    coverage: f32,
}

/// Copies of what a level has besides its mesh.
struct Copies {
    instances: Vec<Instances>,
    attributes: Vec<Attribute>,
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
        let rows = unsafe { read_rows(levels, n_levels, MAX_LEVELS, "levels") }?;
        let mut sum = Sum { limits: &limits, triangles: 0, places: 0, values: 0 };
        let level = |(number, row): (usize, &tree_gltf_level)| unsafe {
            row.rust(&mut sum, &format!("levels[{number}]"))
        };
        Ok(Self(rows.iter().enumerate().map(level).collect::<Result<_>>()?))
    }

    /// Does with the levels what `write` says.
    pub(super) fn with<R>(
        &self,
        control: &Control,
        write: impl FnOnce(&[Level<'_>]) -> Result<R>,
    ) -> Result<R> {
        let meshes = self.0.iter().flat_map(|level| {
            level.mesh.into_iter().chain(level.instances.iter().map(|row| row.mesh))
        });
        ask_for_copies(meshes, 4)?;
        let empty = Mesh::default();
        let copies: Vec<Copies> =
            self.0.iter().map(|level| level.copy(control)).collect::<Result<_>>()?;
        let levels = self.0.iter().zip(&copies).map(|(level, copies)| Level {
            mesh: level.mesh.unwrap_or(&empty),
            instances: &copies.instances,
            attributes: &copies.attributes,
            coverage: level.coverage,
        });
        control.check()?;
        write(&levels.collect::<Vec<_>>())
    }
}

impl GltfLevel<'_> {
    fn copy(&self, control: &Control) -> Result<Copies> {
        let instances = self.instances.iter().map(|row| control.check().map(|()| row.copy()));
        let attributes = self.attributes.iter().map(|row| control.check().map(|()| row.copy()));
        Ok(Copies {
            instances: instances.collect::<std::result::Result<_, _>>()?,
            attributes: attributes.collect::<std::result::Result<_, _>>()?,
        })
    }
}

impl tree_gltf_level {
    unsafe fn rust<'a>(&self, sum: &mut Sum<'_>, name: &str) -> Result<GltfLevel<'a>> {
        let field = |field: &str| format!("{name}.{field}");
        let mesh = if self.mesh.is_null() && self.n_instances > 0 {
            None
        } else {
            Some(unsafe { get(self.mesh, &field("mesh")) }?.rust())
        };
        let name = field("instances");
        let rows = unsafe { read_rows(self.instances, self.n_instances, ROWS_MAX, &name) }?;
        let row = |(i, row): (usize, &tree_gltf_instances)| unsafe {
            row.rust(sum, &format!("{name}[{i}]"))
        };
        let instances = rows.iter().enumerate().map(row).collect::<Result<_>>()?;
        let name = field("attributes");
        let rows = unsafe { read_rows(self.attributes, self.n_attributes, ROWS_MAX, &name) }?;
        let row = |(i, row): (usize, &tree_gltf_attribute)| unsafe {
            row.rust(sum, &format!("{name}[{i}]"))
        };
        let attributes = rows.iter().enumerate().map(row).collect::<Result<_>>()?;
        Ok(GltfLevel { mesh, instances, attributes, coverage: self.coverage })
    }
}
