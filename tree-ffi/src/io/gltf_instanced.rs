//! Trees as bark and instanced leaves.

use super::tree_gltf_instances;
use crate::border::{
    Handle, Versioned, call, free, free_owned, get, get_opt, out_value, out2, register_owned,
    tree_status, tree_str,
};
use crate::control::{run, tree_control};
use crate::look::{or_built_in, tree_look};
use crate::mesh::{column, mesh_params, tree_mesh, tree_mesh_params};
use crate::tree::tree_tree;
use ::tree_mesh::io::gltf::{self, Instances};

/// Leaves of a tree, one small mesh for each kind and where its copies stand.
pub struct tree_gltf_leaves {
    /// What `rows` points into; the meshes are in handles of their own.
    _held: Vec<Instances>,
    rows: Vec<tree_gltf_instances>,
}

// SAFETY: points into what the same object holds and nothing changes.
unsafe impl Send for tree_gltf_leaves {}
// SAFETY: as above.
unsafe impl Sync for tree_gltf_leaves {}

impl Handle for tree_gltf_leaves {
    const NAME: &'static str = "tree_gltf_leaves";
}

impl tree_gltf_leaves {
    fn new(leaves: Vec<Instances>) -> Self {
        let mut all = Self { _held: leaves, rows: Vec::new() };
        for kind in &mut all._held {
            let mesh = tree_mesh::new(std::mem::take(&mut kind.mesh));
            let mesh = register_owned::<_, Self>(mesh);
            all.rows.push(tree_gltf_instances {
                name: tree_str::of(&kind.name),
                mesh,
                n: kind.translations.len(),
                translations: column(&kind.translations).cast(),
                rotations: column(&kind.rotations).cast(),
                scales: column(&kind.scales).cast(),
                ..tree_gltf_instances::default_value()
            });
        }
        all
    }
}

impl Drop for tree_gltf_leaves {
    fn drop(&mut self) {
        for row in &self.rows {
            // SAFETY: of `new`, and not freed since: only its owner can.
            unsafe { free_owned(row.mesh.cast_mut()) };
        }
    }
}

/// Builds a tree with one mesh for each kind of leaf instead of a copy for each leaf. Normals of
/// instanced leaves are those of the leaf itself: the parameters cannot turn them towards the outside of
/// the crown. `look`, `params` and `control` are as in `tree_mesh_build`. Free the bark with
/// `tree_mesh_free` and the leaves with `tree_gltf_leaves_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_mesh_build_instanced(
    tree: *const tree_tree,
    look: *const tree_look,
    params: *const tree_mesh_params,
    control: *const tree_control,
    bark: *mut *mut tree_mesh,
    leaves: *mut *mut tree_gltf_leaves,
) -> tree_status {
    call(|| {
        let (bark_place, leaves_place) = unsafe { out2((bark, "bark"), (leaves, "leaves")) }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let params = unsafe { mesh_params(params) }?;
        let look = unsafe { get_opt(look, "look") }?.map(tree_look::rust);
        let made = unsafe {
            run(control, |control| {
                let look = or_built_in(look, tree.species())?;
                Ok(gltf::instanced(tree, &look, &params, control)?)
            })
        }?;
        leaves_place.put(tree_gltf_leaves::new(made.leaves));
        bark_place.put(tree_mesh::new(made.mesh));
        Ok(())
    })
}

/// Views the leaves, as a `tree_gltf_level` takes them: where they begin, NULL for none, and how many
/// kinds there are. Their meshes belong to the leaves and are freed with them; `tree_mesh_free` of
/// one is `TREE_ERROR_ORDER`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_leaves_view(
    leaves: *const tree_gltf_leaves,
    rows: *mut *const tree_gltf_instances,
    n: *mut usize,
) -> tree_status {
    call(|| {
        let leaves = &unsafe { get(leaves, "leaves") }?.rows;
        unsafe { out_value(rows, column(leaves), "rows") }?;
        unsafe { out_value(n, leaves.len(), "n") }
    })
}

/// Frees leaves, and their meshes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_gltf_leaves_free(leaves: *mut tree_gltf_leaves) -> tree_status {
    call(|| unsafe { free(leaves, "leaves") })
}
