//! Triangles sorted into wood and leaves.

use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, Versioned, call, free, get, out, read_or_default,
    slice, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::column;
use crate::mesh::tree_mesh;
use crate::skeleton::tree_skeleton;
use crate::skeletonize::params::tree_skeletonize_params;
use crate::skeletonize::part::{parts_of_mesh, read_parts, tree_hint, tree_mesh_part};
use glam::{Vec2, Vec3};
use std::sync::Arc;
use tree_model::skeletonize::stages::Separation;
use tree_model::skeletonize::{Class, Part};
use tree_model::tree_core::{Limits, Resource};

/// What a component of a mesh is: one of the `TREE_CLASS_` constants.
pub type tree_class = u32;
/// Bark.
pub const TREE_CLASS_WOOD: u32 = 0;
/// A card or a small thin surface: one leaf.
pub const TREE_CLASS_LEAF: u32 = 1;
/// A closed body of leaves.
pub const TREE_CLASS_BLOB: u32 = 2;
/// Not looked at.
pub const TREE_CLASS_IGNORED: u32 = 3;

fn of_class(class: Class) -> tree_class {
    match class {
        Class::Wood => TREE_CLASS_WOOD,
        Class::Leaf => TREE_CLASS_LEAF,
        Class::Blob => TREE_CLASS_BLOB,
        Class::Ignored => TREE_CLASS_IGNORED,
    }
}

fn class(found: tree_class, index: usize) -> Result<Class> {
    match found {
        TREE_CLASS_WOOD => Ok(Class::Wood),
        TREE_CLASS_LEAF => Ok(Class::Leaf),
        TREE_CLASS_BLOB => Ok(Class::Blob),
        TREE_CLASS_IGNORED => Ok(Class::Ignored),
        other => Err(Failure::not_one_of(&format!("classes[{index}]"), other, "TREE_CLASS_")),
    }
}

/// The triangles of a mesh, welded and sorted into connected components, each of which is wood, a leaf, a
/// body of leaves or nothing. It holds copies of the parts.
pub struct tree_separation {
    // Before what it borrows, so that it goes first.
    separation: Separation<'static>,
    classes: Vec<tree_class>,
    kept: Arc<Kept>,
}

/// What separations borrow, and the triangles of components as compressed rows.
struct Kept {
    _parts: Vec<Part<'static>>,
    _columns: Vec<Columns>,
    starts: Vec<u64>,
    sources: Vec<[u32; 2]>,
}

/// Copies of a part's columns.
struct Columns {
    positions: Vec<Vec3>,
    uvs: Vec<Vec2>,
    indices: Vec<u32>,
    name: String,
}

impl Handle for tree_separation {
    const NAME: &'static str = "tree_separation";
}

/// The same reference, for as long as its owner is kept.
///
/// # Safety
/// Whoever holds the result holds the owner, which neither moves nor changes what `value` points at.
unsafe fn lengthen<T: ?Sized>(value: &T) -> &'static T {
    // SAFETY: by contract.
    unsafe { &*std::ptr::from_ref(value) }
}

impl tree_separation {
    unsafe fn new(
        parts: &[Part<'_>],
        params: *const tree_skeletonize_params,
        control: *const tree_control,
    ) -> Result<Self> {
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let columns: Vec<Columns> = parts.iter().map(Columns::of).collect();
        let own = parts.iter().zip(&columns).map(|(part, columns)| unsafe { columns.part(part) });
        let own: Vec<Part<'static>> = own.collect();
        // SAFETY: the handle keeps what the separation borrows, in vectors that never change.
        let borrowed = unsafe { lengthen(own.as_slice()) };
        let separation =
            unsafe { run(control, |control| Ok(Separation::new(borrowed, &params, control)?)) }?;
        let (starts, sources) = rows(&separation);
        let kept = Arc::new(Kept { _parts: own, _columns: columns, starts, sources });
        Ok(Self::of(separation, kept))
    }

    fn of(separation: Separation<'static>, kept: Arc<Kept>) -> Self {
        let classes = separation.classes.iter().map(|&class| of_class(class)).collect();
        Self { separation, classes, kept }
    }

    pub(super) fn rust(&self) -> &Separation<'static> {
        &self.separation
    }
}

impl Columns {
    fn of(part: &Part<'_>) -> Self {
        Self {
            positions: part.positions.to_vec(),
            uvs: part.uvs.to_vec(),
            indices: part.indices.to_vec(),
            name: part.name.to_owned(),
        }
    }

    /// `part` with these columns.
    ///
    /// # Safety
    /// As [`lengthen`].
    unsafe fn part(&self, part: &Part<'_>) -> Part<'static> {
        Part {
            positions: unsafe { lengthen(self.positions.as_slice()) },
            uvs: unsafe { lengthen(self.uvs.as_slice()) },
            indices: unsafe { lengthen(self.indices.as_slice()) },
            name: unsafe { lengthen(self.name.as_str()) },
            hint: part.hint,
            alpha_masked: part.alpha_masked,
            double_sided: part.double_sided,
        }
    }
}

/// Where the triangles of each component begin, and the triangles.
fn rows(separation: &Separation<'_>) -> (Vec<u64>, Vec<[u32; 2]>) {
    let mut starts = vec![0];
    let mut sources = Vec::new();
    for component in 0..separation.n_components() {
        sources.extend(separation.triangles(component).map(|(part, triangle)| [part, triangle]));
        starts.push(sources.len() as u64);
    }
    (starts, sources)
}

/// A view of a separation. The triangles of component `i` are rows `starts[i]` up to, but not including,
/// `starts[i + 1]`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_separation_columns {
    /// `sizeof(tree_separation_columns)`.
    pub struct_size: usize,
    /// Number of components; each lies within one part.
    pub n_components: usize,
    /// For each component what it is taken for.
    pub classes: *const tree_class,
    /// `n_components + 1` numbers.
    pub starts: *const u64,
    /// Number of triangles: all that have an area, once.
    pub n_triangles: usize,
    /// Two numbers for each triangle: its part, and which triangle of that part it is.
    pub triangles: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_separation_columns {
    const NAME: &'static str = "tree_separation_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_components: 0,
            classes: std::ptr::null(),
            starts: std::ptr::null(),
            n_triangles: 0,
            triangles: std::ptr::null(),
        }
    }
}

/// The first stage of `tree_skeletonize` by itself: welds the parts and says of each connected component
/// what it is. Arguments and errors are as there; `params.weld` counts. Free it with
/// `tree_separation_free`.
///
/// The stages, one after the other: `tree_separation_new`, `tree_separation_follow`, `tree_pieces_link`,
/// `tree_separation_leaves`, `tree_separation_outward`. Up to the last all is in units of the mesh's
/// longest side, about its middle, whatever the mesh's own unit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_new(
    parts: *const tree_mesh_part,
    n_parts: usize,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    separation: *mut *mut tree_separation,
) -> tree_status {
    call(|| {
        let place = unsafe { out(separation, "separation") }?;
        let parts = unsafe { read_parts(parts, n_parts, &limits(control)?) }?;
        place.put(unsafe { tree_separation::new(&parts, params, control) }?);
        Ok(())
    })
}

/// As `tree_separation_new`, of a mesh: see `tree_skeletonize_mesh`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_of_mesh(
    mesh: *const tree_mesh,
    hints: *const tree_hint,
    n_hints: usize,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    separation: *mut *mut tree_separation,
) -> tree_status {
    call(|| {
        let place = unsafe { out(separation, "separation") }?;
        let parts = unsafe { parts_of_mesh(mesh, hints, n_hints, &limits(control)?) }?;
        place.put(unsafe { tree_separation::new(&parts, params, control) }?);
        Ok(())
    })
}

/// Views a separation. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_view(
    separation: *const tree_separation,
    columns: *mut tree_separation_columns,
) -> tree_status {
    call(|| {
        let separation = unsafe { get(separation, "separation") }?;
        let kept = &separation.kept;
        let value = tree_separation_columns {
            n_components: separation.classes.len(),
            classes: column(&separation.classes),
            starts: column(&kept.starts),
            n_triangles: kept.sources.len(),
            triangles: column(&kept.sources).cast(),
            ..tree_separation_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// The same separation with other classes, one for each component: what a component was taken for need
/// not hold. The first one stays as it is. Free the other one too.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_with_classes(
    separation: *const tree_separation,
    classes: *const tree_class,
    n_classes: usize,
    other: *mut *mut tree_separation,
) -> tree_status {
    call(|| {
        let place = unsafe { out(other, "other") }?;
        let first = unsafe { get(separation, "separation") }?;
        let n = first.classes.len();
        if n_classes != n {
            let text = format!("n_classes is {n_classes}, but there are {n} components");
            return Err(Failure::new(TREE_ERROR_INVALID, text));
        }
        // As many as the separation itself has: no limit is needed beyond.
        let limits = Limits { triangles: u64::MAX, ..Limits::default() };
        let found = unsafe { slice(classes, n, &limits, Resource::Triangles, "classes") }?;
        let mut separation = first.separation.clone();
        separation.classes =
            found.iter().enumerate().map(|(i, &found)| class(found, i)).collect::<Result<_>>()?;
        place.put(tree_separation::of(separation, first.kept.clone()));
        Ok(())
    })
}

/// The last stage: brings a skeleton back to the units of the mesh. Free it with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_outward(
    separation: *const tree_separation,
    skeleton: *const tree_skeleton,
    outward: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(outward, "outward") }?;
        let separation = unsafe { get(separation, "separation") }?.rust();
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust().clone();
        place.put(tree_skeleton::own(separation.outward(skeleton)?));
        Ok(())
    })
}

/// Frees a separation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_free(separation: *mut tree_separation) -> tree_status {
    call(|| unsafe { free(separation, "separation") })
}
