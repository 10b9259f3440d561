//! Leaves in columns.

use crate::border::{Result, Versioned, slice, vec3s};
use crate::mesh::column;
use glam::Quat;
use tree_model::tree_core::{Foliage, Leaf, Limits, Resource};

/// Leaves in columns, a row for each blade (leaflet, needle): as input, or as a view of a tree's.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_foliage {
    /// `sizeof(tree_foliage)`.
    pub struct_size: usize,
    /// Number of rows.
    pub n_leaves: usize,
    /// One for each leaf: the skeleton's node that bears it.
    pub nodes: *const u32,
    /// Three floats for each leaf: the base of the blade, in metres.
    pub positions: *const f32,
    /// Four floats for each leaf: the quaternion x, y, z, w that turns the leaf's own frame (midrib
    /// along +Y, upper face to +Z) into the tree's.
    pub rotations: *const f32,
    /// One for each leaf: length from base to apex in metres, 0 or more.
    pub sizes: *const f32,
    /// One for each leaf: its kind, an index into the species' leaf kinds.
    pub kinds: *const u16,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_foliage {
    const NAME: &'static str = "tree_foliage";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_leaves: 0,
            nodes: std::ptr::null(),
            positions: std::ptr::null(),
            rotations: std::ptr::null(),
            sizes: std::ptr::null(),
            kinds: std::ptr::null(),
        }
    }
}

impl tree_foliage {
    pub(crate) fn of(foliage: &Foliage) -> Self {
        Self {
            n_leaves: foliage.len(),
            nodes: column(foliage.nodes()),
            positions: column(foliage.positions()).cast(),
            rotations: column(foliage.rotations()).cast(),
            sizes: column(foliage.sizes()),
            kinds: column(foliage.kinds()),
            ..Self::default_value()
        }
    }

    /// A checked copy.
    pub(crate) unsafe fn rust(&self, limits: &Limits) -> Result<Foliage> {
        let (n, leaves) = (self.n_leaves, Resource::Leaves);
        let nodes = unsafe { slice(self.nodes, n, limits, leaves, "foliage.nodes") }?;
        let positions = unsafe { vec3s(self.positions, n, limits, leaves, "foliage.positions") }?;
        let rotations: &[[f32; 4]] =
            unsafe { slice(self.rotations.cast(), n, limits, leaves, "foliage.rotations") }?;
        let sizes = unsafe { slice(self.sizes, n, limits, leaves, "foliage.sizes") }?;
        let kinds = unsafe { slice(self.kinds, n, limits, leaves, "foliage.kinds") }?;
        let mut foliage = Foliage::with_capacity(n);
        for i in 0..n {
            foliage.push(Leaf {
                node: nodes[i],
                position: positions[i],
                rotation: Quat::from_array(rotations[i]),
                size: sizes[i],
                kind: kinds[i],
            })?;
        }
        Ok(foliage)
    }
}
