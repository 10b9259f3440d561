//! Wind as attributes of glTF files.

use super::tree_gltf_attribute;
use crate::border::{Handle, Versioned, call, free, get, out, out_value, tree_status, tree_str};
use crate::control::{run, tree_control};
use crate::mesh::{column, tree_mesh};
use ::tree_mesh::io::gltf::Attribute;
use ::tree_mesh::pack::gltf_wind;

/// Columns for a glTF file.
pub struct tree_gltf_attributes {
    /// What `rows` points into.
    _held: Vec<Attribute>,
    rows: Vec<tree_gltf_attribute>,
}

// SAFETY: points into what the same object holds and nothing changes.
unsafe impl Send for tree_gltf_attributes {}
// SAFETY: as above.
unsafe impl Sync for tree_gltf_attributes {}

impl Handle for tree_gltf_attributes {
    const NAME: &'static str = "tree_gltf_attributes";
}

impl tree_gltf_attributes {
    fn new(held: Vec<Attribute>) -> Self {
        let row = |attribute: &Attribute| tree_gltf_attribute {
            surface: attribute.surface,
            name: tree_str::of(&attribute.name),
            components: attribute.components,
            values: column(&attribute.values),
            n_values: attribute.values.len(),
            ..tree_gltf_attribute::default_value()
        };
        Self { rows: held.iter().map(row).collect(), _held: held }
    }
}

/// The attributes `_WIND*` of all surfaces of a mesh, for a level of a glTF file: the streams of
/// `TREE_LAYOUT_GLTF_WIND` that are not glTF's own, four floats each, the missing ones 0, which every
/// reader takes. For Blender write occlusion as colour or not at all. `control` may be NULL. Free them
/// with `tree_gltf_attributes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_gltf_wind(
    mesh: *const tree_mesh,
    control: *const tree_control,
    attributes: *mut *mut tree_gltf_attributes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(attributes, "attributes") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let made = unsafe {
            run(control, |control| {
                let mut all = Vec::new();
                for surface in 0..mesh.surfaces.len() {
                    control.check()?;
                    all.extend(gltf_wind::attributes(mesh, surface)?);
                }
                Ok(all)
            })
        }?;
        place.put(tree_gltf_attributes::new(made));
        Ok(())
    })
}

/// Views the attributes, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
/// there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_attributes_view(
    attributes: *const tree_gltf_attributes,
    rows: *mut *const tree_gltf_attribute,
    n: *mut usize,
) -> tree_status {
    call(|| {
        let attributes = &unsafe { get(attributes, "attributes") }?.rows;
        unsafe { out_value(rows, column(attributes), "rows") }?;
        unsafe { out_value(n, attributes.len(), "n") }
    })
}

/// Frees attributes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_attributes_free(
    attributes: *mut tree_gltf_attributes,
) -> tree_status {
    call(|| unsafe { free(attributes, "attributes") })
}
