//! Packed surfaces, read back as an engine would.

use super::pack::*;
use super::packed::{Content, tree_packed};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PANIC, Versioned, call, free, get, get_opt, out,
    tree_status, write,
};
use crate::mesh::{column, tree_mesh};
use ::tree_mesh::pack::{
    Packed, Unpacked, gltf_wind, godot, pivot_painter, speedtree8, speedtree9, tree_creator,
};

/// What a layout holds of each vertex, back in our axes, metres and winding.
pub struct tree_unpacked(Unpacked);

impl Handle for tree_unpacked {
    const NAME: &'static str = "tree_unpacked";
}

/// A view of a `tree_unpacked`. A column is NULL when the layout has no place for it.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_unpacked_columns {
    /// `sizeof(tree_unpacked_columns)`.
    pub struct_size: usize,
    /// Number of vertices.
    pub n_vertices: usize,
    /// Three floats for each vertex: positions in metres.
    pub positions: *const f32,
    /// Three floats for each vertex: normals.
    pub normals: *const f32,
    /// Four floats for each vertex: tangents, in the fourth the sign.
    pub tangents: *const f32,
    /// Two floats for each vertex: texture coordinates.
    pub uvs: *const f32,
    /// Two floats for each vertex: light-map coordinates.
    pub uvs2: *const f32,
    /// Three for each triangle.
    pub indices: *const u32,
    /// Number of indices.
    pub n_indices: usize,
    /// Ambient occlusion.
    pub occlusion: *const f32,
    /// The branch, its number in the table; for `TREE_LAYOUT_PIVOT_PAINTER` its element.
    pub branches: *const u32,
    /// The branch, or element, that carries it.
    pub parents: *const u32,
    /// Level of the branch.
    pub levels: *const u32,
    /// Three floats for each vertex: pivot of the branch.
    pub pivots: *const f32,
    /// Three floats for each vertex: axis of the branch.
    pub axes: *const f32,
    /// Phase of the branch.
    pub phases: *const f32,
    /// Stiffness of the branch.
    pub stiffness: *const f32,
    /// How far along the branch.
    pub reach: *const f32,
    /// How far along the leaf.
    pub flutter: *const f32,
    /// Phase of the leaf.
    pub leaf_phases: *const f32,
    /// Three floats for each vertex: where the leaf is attached.
    pub anchors: *const f32,
    /// Whether the vertex is part of a leaf: 0 or 1.
    pub is_leaf: *const u8,
    /// Two floats for each vertex: bend weights. SpeedTree 8: branch weight, 0; 9: those of branches 1
    /// and 2; Tree Creator: primary and secondary bend.
    pub weights: *const f32,
    /// Two vectors of three floats for each vertex. SpeedTree 8: swing, growth; 9: directions of
    /// branches 1 and 2.
    pub directions: *const f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_unpacked_columns {
    const NAME: &'static str = "tree_unpacked_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&Unpacked::default())
    }
}

impl tree_unpacked_columns {
    fn of(unpacked: &Unpacked) -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_vertices: unpacked.positions.len(),
            positions: column(&unpacked.positions).cast(),
            normals: column(&unpacked.normals).cast(),
            tangents: column(&unpacked.tangents).cast(),
            uvs: column(&unpacked.uvs).cast(),
            uvs2: column(&unpacked.uvs2).cast(),
            indices: column(&unpacked.indices).cast(),
            n_indices: unpacked.indices.len(),
            occlusion: column(&unpacked.occlusion).cast(),
            branches: column(&unpacked.branches).cast(),
            parents: column(&unpacked.parents).cast(),
            levels: column(&unpacked.levels).cast(),
            pivots: column(&unpacked.pivots).cast(),
            axes: column(&unpacked.axes).cast(),
            phases: column(&unpacked.phases).cast(),
            stiffness: column(&unpacked.stiffness).cast(),
            reach: column(&unpacked.reach).cast(),
            flutter: column(&unpacked.flutter).cast(),
            leaf_phases: column(&unpacked.leaf_phases).cast(),
            anchors: column(&unpacked.anchors).cast(),
            is_leaf: column(&unpacked.is_leaf).cast(),
            weights: column(&unpacked.weights).cast(),
            directions: column(&unpacked.directions).cast(),
        }
    }
}

fn unpack(packed: &tree_packed, streams: &Packed) -> Result<Unpacked> {
    Ok(match (packed.layout, &packed.pivots) {
        (TREE_LAYOUT_SPEEDTREE8, _) => speedtree8::unpack(streams),
        (TREE_LAYOUT_SPEEDTREE9, _) => speedtree9::unpack(streams),
        (TREE_LAYOUT_TREE_CREATOR, _) => tree_creator::unpack(streams),
        (TREE_LAYOUT_PIVOT_PAINTER, Some(held)) => pivot_painter::unpack(streams, &held.textures),
        (TREE_LAYOUT_GODOT | TREE_LAYOUT_GODOT_HALF, _) => godot::unpack(streams),
        (TREE_LAYOUT_GLTF_WIND, _) => gltf_wind::unpack(streams),
        (other, _) => {
            let text = format!("layout {other} cannot be read back");
            return Err(Failure::new(TREE_ERROR_PANIC, text));
        }
    })
}

/// Reads a packed surface back as an engine would, to check a shader against: it differs from what was
/// packed by the quantisation only. `mesh`, which gives the table of branches, is needed for
/// `TREE_LAYOUT_VERTEX` and may be NULL else. Free the result with `tree_unpacked_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_packed_unpack(
    packed: *const tree_packed,
    mesh: *const tree_mesh,
    unpacked: *mut *mut tree_unpacked,
) -> tree_status {
    call(|| {
        let place = unsafe { out(unpacked, "unpacked") }?;
        let packed = unsafe { get(packed, "packed") }?;
        let mesh = unsafe { get_opt(mesh, "mesh") }?;
        place.put(tree_unpacked(match &packed.content {
            Content::Streams(streams) => unpack(packed, streams)?,
            Content::Vertices(vertices) => {
                let mesh = mesh.ok_or_else(|| Failure::null("mesh"))?;
                vertices.unpack(mesh.rust())
            }
        }));
        Ok(())
    })
}

/// Views what was read back. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_unpacked_view(
    unpacked: *const tree_unpacked,
    columns: *mut tree_unpacked_columns,
) -> tree_status {
    call(|| {
        let unpacked = &unsafe { get(unpacked, "unpacked") }?.0;
        unsafe { write(columns, "columns", &tree_unpacked_columns::of(unpacked)) }
    })
}

/// Frees what was read back.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_unpacked_free(unpacked: *mut tree_unpacked) -> tree_status {
    call(|| unsafe { free(unpacked, "unpacked") })
}
