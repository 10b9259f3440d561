//! The materials of a mesh.

use super::tree_mesh;
use crate::border::{Failure, Result, TREE_ERROR_INVALID, call, get, out, tree_status, write};
use crate::look::{tree_material, tree_texture};
use ::tree_mesh::Material;

fn material_of(mesh: &tree_mesh, number: usize) -> Result<&Material> {
    let materials = &mesh.rust().materials;
    materials.get(number).ok_or_else(|| {
        let n = materials.len();
        let text = format!("number is {number}, the mesh has {n} materials");
        Failure::new(TREE_ERROR_INVALID, text)
    })
}

/// Views material `number` of a mesh, from 0 on; `material` of `tree_surface` says which one a surface
/// has. Set `material->struct_size` first. Valid until the mesh is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_material(
    mesh: *const tree_mesh,
    number: usize,
    material: *mut tree_material,
) -> tree_status {
    call(|| {
        let viewed = tree_material::of(material_of(unsafe { get(mesh, "mesh") }?, number)?);
        unsafe { write(material, "material", &viewed) }
    })
}

/// A handle of the texture of material `number`; the pixels are shared, and outlive the mesh. NULL, and no
/// error, where the material has none. Free it with `tree_texture_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_texture(
    mesh: *const tree_mesh,
    number: usize,
    texture: *mut *mut tree_texture,
) -> tree_status {
    call(|| {
        let place = unsafe { out(texture, "texture") }?;
        let material = material_of(unsafe { get(mesh, "mesh") }?, number)?;
        if let Some(texture) = &material.texture {
            place.put(tree_texture::shared(texture.clone()));
        }
        Ok(())
    })
}
