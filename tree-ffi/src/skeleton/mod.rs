//! Skeletons: the branches of a tree, node by node.

mod axes;
mod branching;
mod column;
mod measure;
mod swc;

pub use axes::*;
pub use branching::*;
pub(crate) use column::column;
pub use column::*;
pub use measure::*;
pub use swc::*;

use crate::border::{
    Handle, Result, Shared, Versioned, call, fill, free, get, out, slice, tree_status, vec3s, write,
};
use crate::control::{limits, tree_control};
use glam::Vec3;
use std::sync::Arc;
use tree_model::tree_core::{Resource, Skeleton, Tree};

/// Parent of the root: no node.
pub const TREE_NO_PARENT: u32 = 0xFFFF_FFFF;

/// Branches as a rooted tree of nodes with radii.
pub struct tree_skeleton(Shared<Skeleton>);

impl Handle for tree_skeleton {
    const NAME: &'static str = "tree_skeleton";
}

impl tree_skeleton {
    pub(crate) fn own(skeleton: Skeleton) -> Self {
        Self::shared(Arc::new(skeleton))
    }

    pub(crate) fn shared(skeleton: Arc<Skeleton>) -> Self {
        Self(Shared::of(skeleton))
    }

    pub(crate) fn of(tree: Arc<Tree>) -> Self {
        Self(Shared::of(tree).part(Tree::skeleton))
    }

    /// A skeleton that is part of something.
    pub(crate) fn part(held: Shared<Skeleton>) -> Self {
        Self(held)
    }

    pub(crate) fn rust(&self) -> &Skeleton {
        self.0.get()
    }
}

/// A skeleton's columns: as input, or as a view of a `tree_skeleton`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_skeleton_columns {
    /// `sizeof(tree_skeleton_columns)`.
    pub struct_size: usize,
    /// Number of nodes, at least 1.
    pub n_nodes: usize,
    /// Three floats for each node: where it is, in metres.
    pub positions: *const f32,
    /// One for each node: radius of the wood in metres, 0 or more.
    pub radii: *const f32,
    /// One for each node: the node it stands on, or `TREE_NO_PARENT` for the root.
    pub parents: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_skeleton_columns {
    const NAME: &'static str = "tree_skeleton_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_nodes: 0,
            positions: std::ptr::null(),
            radii: std::ptr::null(),
            parents: std::ptr::null(),
        }
    }
}

impl tree_skeleton_columns {
    fn of(skeleton: &Skeleton) -> Self {
        Self {
            n_nodes: skeleton.len(),
            positions: crate::mesh::column(skeleton.positions()).cast(),
            radii: crate::mesh::column(skeleton.radii()),
            parents: crate::mesh::column(skeleton.parents()),
            ..Self::default_value()
        }
    }

    /// Copies of the three columns.
    unsafe fn copy(&self, control: *const tree_control) -> Result<(Vec<Vec3>, Vec<f32>, Vec<u32>)> {
        let limits = unsafe { limits(control) }?;
        let (n, nodes) = (self.n_nodes, Resource::Nodes);
        let positions =
            unsafe { vec3s(self.positions, n, &limits, nodes, "columns.positions") }?.to_vec();
        let radii = unsafe { slice(self.radii, n, &limits, nodes, "columns.radii") }?.to_vec();
        let parents =
            unsafe { slice(self.parents, n, &limits, nodes, "columns.parents") }?.to_vec();
        Ok((positions, radii, parents))
    }
}

/// Makes a skeleton of columns, which are copied. Node 0 is the root, parents come before their children;
/// for rows in another order there is `tree_skeleton_from_unordered`. `control` may be NULL; only its
/// limits matter. Free the skeleton with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_from_columns(
    columns: *const tree_skeleton_columns,
    control: *const tree_control,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let columns = unsafe { crate::border::read(columns, "columns") }?;
        let (positions, radii, parents) = unsafe { columns.copy(control) }?;
        place.put(tree_skeleton::own(Skeleton::from_columns(positions, radii, parents)?));
        Ok(())
    })
}

/// Makes a skeleton of columns in any order, with the one root anywhere. `rows`, NULL or with room for
/// `n_nodes` numbers, gets for each node of the skeleton its row in the columns. Otherwise as
/// `tree_skeleton_from_columns`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_from_unordered(
    columns: *const tree_skeleton_columns,
    control: *const tree_control,
    rows: *mut u32,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let columns = unsafe { crate::border::read(columns, "columns") }?;
        let (positions, radii, parents) = unsafe { columns.copy(control) }?;
        let made = Skeleton::from_unordered(positions, radii, parents)?;
        if !rows.is_null() {
            unsafe { fill(rows, columns.n_nodes, &made.rows, "rows") }?;
        }
        place.put(tree_skeleton::own(made.skeleton));
        Ok(())
    })
}

/// Views a skeleton's columns. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_view(
    skeleton: *const tree_skeleton,
    columns: *mut tree_skeleton_columns,
) -> tree_status {
    call(|| {
        let skeleton = unsafe { get(skeleton, "skeleton") }?;
        unsafe { write(columns, "columns", &tree_skeleton_columns::of(skeleton.rust())) }
    })
}

/// The box around all nodes, without their radii: its lower corner, then its upper one, in metres.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_bounds(
    skeleton: *const tree_skeleton,
    min_max: *mut [f32; 6],
) -> tree_status {
    call(|| {
        let bounds = unsafe { get(skeleton, "skeleton") }?.rust().bounds();
        let [a, b] = [bounds.min, bounds.max];
        unsafe { crate::border::out_value(min_max, [a.x, a.y, a.z, b.x, b.y, b.z], "min_max") }
    })
}

/// Frees a skeleton.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_free(skeleton: *mut tree_skeleton) -> tree_status {
    call(|| unsafe { free(skeleton, "skeleton") })
}
