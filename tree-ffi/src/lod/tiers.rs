//! Triangles that elements are drawn with.

use super::elements::tree_elements;
use super::take::few;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, free, get, init, out,
    out_value, read, read_or_default, read_rows, slice, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::mesh::{column, tree_mesh};
use std::ptr::null;
use tree_lod::outline::{OutlineParams, Tier, tiers};
use tree_model::tree_core::{Limits, Resource};

/// Most tiers that a caller brings; also more shares than are allowed, so that Rust says how many are.
pub(super) const TIERS_MAX: usize = 64;

/// Triangles that elements are drawn with: the full model first, then with fewer and fewer triangles of nearly the
/// same outlines. All are of the model's own vertices.
pub struct tree_tiers(Vec<Tier>);

impl Handle for tree_tiers {
    const NAME: &'static str = "tree_tiers";
}

impl tree_tiers {
    pub(super) fn rust(&self) -> &[Tier] {
        &self.0
    }

    pub(super) fn row(&self, number: usize) -> Result<&Tier> {
        self.0.get(number).ok_or_else(|| {
            let text = format!("tier is {number}, but there are {}", self.0.len());
            Failure::new(TREE_ERROR_PARAMETER, text)
        })
    }
}

/// How outlines become simpler. Begin with `tree_tiers_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_tiers_params {
    /// `sizeof(tree_tiers_params)`.
    pub struct_size: usize,
    /// Share of its triangles that an element has in each tier after the first, falling, 0 to 1. Every element keeps
    /// a triangle, or two where a picture with a mask lies on it. NULL, the default: 1/2, 1/4, 1/8, 1/16.
    pub shares: *const f32,
    /// Number of shares, at most 16; 0 for the default.
    pub n_shares: usize,
    /// How far lengths of elements may differ, in lengths of a square of the same area, for them to share one answer,
    /// 0 to 1. Default 0.08.
    pub alike: f32,
    /// Largest share of the triangles of the tier before that a tier may have; others are not worth their memory and
    /// are left out. 0 to 1. Default 0.9.
    pub worth: f32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_tiers_params {
    const NAME: &'static str = "tree_tiers_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let OutlineParams { alike, worth, .. } = OutlineParams::default();
        Self { struct_size: size_of::<Self>(), shares: null(), n_shares: 0, alike, worth }
    }
}

impl tree_tiers_params {
    unsafe fn rust(&self) -> Result<OutlineParams> {
        let shares = unsafe { few(self.shares, self.n_shares, TIERS_MAX, "params.shares") }?;
        let mut params = OutlineParams::default();
        (params.alike, params.worth) = (self.alike, self.worth);
        if !shares.is_empty() {
            params.shares = shares.to_vec();
        }
        Ok(params)
    }

    /// The default for NULL.
    pub(super) unsafe fn read(params: *const Self, argument: &str) -> Result<OutlineParams> {
        unsafe { read_or_default(params, argument)?.rust() }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_params_init(
    params: *mut tree_tiers_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every field of `params`; `TREE_ERROR_PARAMETER` names the first that is out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_params_check(params: *const tree_tiers_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust() }?.validate()?))
}

/// Makes the tiers of a model: its elements, and the same with fewer and fewer triangles. No element has more
/// triangles in a later tier than in an earlier one. It takes 5 to 10 ms for each distinct shape of 16 triangles.
/// `params` and `control` may be NULL; `triangles` of its limits caps those of all tiers together. Free the tiers
/// with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of this mesh.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_of_mesh(
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    params: *const tree_tiers_params,
    control: *const tree_control,
    tiers: *mut *mut tree_tiers,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tiers, "tiers") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        let params = unsafe { tree_tiers_params::read(params, "params") }?;
        let body = |control: &_| Ok(self::tiers(mesh, elements, &params, control)?);
        place.put(tree_tiers(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// The full model as the only tier. Free it with `tree_tiers_free`. `TREE_ERROR_INVALID` when the elements are not of
/// this mesh.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_full(
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    tiers: *mut *mut tree_tiers,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tiers, "tiers") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        elements.check(mesh)?;
        place.put(tree_tiers(vec![Tier::full(mesh, elements)]));
        Ok(())
    })
}

/// A view of a tier.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_tier_columns {
    /// `sizeof(tree_tier_columns)`.
    pub struct_size: usize,
    /// Number of elements.
    pub n_elements: usize,
    /// Where the triangles of each element begin, and their number at the end: `n_elements + 1` rows.
    pub starts: *const u32,
    /// Three vertices of the element's surface for each triangle, in the winding of the model.
    pub triangles: *const u32,
    /// Number of triangles.
    pub n_triangles: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_tier_columns {
    const NAME: &'static str = "tree_tier_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_elements: 0,
            starts: null(),
            triangles: null(),
            n_triangles: 0,
        }
    }
}

impl tree_tier_columns {
    unsafe fn rust(&self, limits: &Limits, name: &str) -> Result<Tier> {
        let (n, rows) = (self.n_elements.saturating_add(1), Resource::Triangles);
        let starts = format!("{name}.starts");
        let starts = unsafe { slice(self.starts, n, limits, rows, &starts) }?.to_vec();
        let (first, n) = (self.triangles.cast::<[u32; 3]>(), self.n_triangles);
        let triangles = format!("{name}.triangles");
        let triangles = unsafe { slice(first, n, limits, rows, &triangles) }?.to_vec();
        Ok(Tier { starts, triangles })
    }
}

/// Tiers of your own, which are copied: the finest first, each as `tree_tiers_view` gives it. `mesh` and `elements` are
/// what they are tiers of. `control` may be NULL; `triangles` of its limits caps the triangles of each. Free the tiers
/// with `tree_tiers_free`. `TREE_ERROR_INVALID` when there are none, when `starts` does not rise from 0 to
/// `n_triangles`, has no row for each element and one more, or a surface lacks a vertex.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_from_columns(
    mesh: *const tree_mesh,
    elements: *const tree_elements,
    columns: *const tree_tier_columns,
    n_columns: usize,
    control: *const tree_control,
    tiers: *mut *mut tree_tiers,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tiers, "tiers") }?;
        let mesh = unsafe { get(mesh, "mesh") }?.rust();
        let elements = unsafe { get(elements, "elements") }?.rust();
        elements.check(mesh)?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { read_rows(columns, n_columns, TIERS_MAX, "columns") }?;
        if rows.is_empty() {
            return Err(tree_lod::LodError::Foliage("there are no tiers").into());
        }
        let mut made = Vec::with_capacity(rows.len());
        for (i, row) in rows.iter().enumerate() {
            let tier = unsafe { row.rust(&limits, &format!("columns[{i}]")) }?;
            tier.check(mesh, elements)?;
            made.push(tier);
        }
        place.put(tree_tiers(made));
        Ok(())
    })
}

/// Number of tiers, at least 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_count(
    tiers: *const tree_tiers,
    n_tiers: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(tiers, "tiers") }?.0.len();
        unsafe { out_value(n_tiers, n, "n_tiers") }
    })
}

/// Views tier `tier`; 0 is the full model. Set `columns->struct_size` first. `TREE_ERROR_PARAMETER` when there is no
/// such tier.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_view(
    tiers: *const tree_tiers,
    tier: usize,
    columns: *mut tree_tier_columns,
) -> tree_status {
    call(|| {
        let tier = unsafe { get(tiers, "tiers") }?.row(tier)?;
        let found = tree_tier_columns {
            n_elements: tier.starts.len().saturating_sub(1),
            starts: column(&tier.starts),
            triangles: column(&tier.triangles).cast(),
            n_triangles: tier.triangles.len(),
            ..tree_tier_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Frees tiers, and with them all views of them.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tiers_free(tiers: *mut tree_tiers) -> tree_status {
    call(|| unsafe { free(tiers, "tiers") })
}
