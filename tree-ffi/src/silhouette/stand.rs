//! A whole stand from one outline for each tree.

use super::params::{silhouette_of, tree_silhouette_params};
use super::session::{tree_silhouette_play_report, tree_silhouette_session};
use super::{tree_outline_drawing, tree_silhouette_grown};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, foresee, free, get, init, out,
    read, read_or_default, slice, tree_status, tree_str, view, write,
};
use crate::control::{run, tree_control};
use crate::photo::tree_lines;
use crate::tree::tree_tree;
use std::ptr::null;
use tree_model::silhouette::stand::{Lending, Perspective, Stand, StandParams, StandTree};
use tree_model::tree_core::{Control, Limits, Resource, Seed};

/// How distances are read from a drawing: one of the `TREE_PERSPECTIVE_` constants.
pub type tree_perspective = u32;
/// The horizon follows from ground points and sizes; trees drawn on about one height stand on one line. The default.
pub const TREE_PERSPECTIVE_ESTIMATED: u32 = 0;
/// The horizon is given.
pub const TREE_PERSPECTIVE_HORIZON: u32 = 1;
/// There is none: all trees stand on one line, their sizes are as drawn.
pub const TREE_PERSPECTIVE_FLAT: u32 = 2;

/// In place of a tree's number: no tree.
pub const TREE_NO_TREE: u32 = 0xffff_ffff;

/// How a drawing becomes a stand. Begin with `tree_stand_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stand_params {
    /// `sizeof(tree_stand_params)`.
    pub struct_size: usize,
    /// Of each tree; `height` is that of the tallest. NULL, the default, for `tree_silhouette_params_init`.
    pub silhouette: *const tree_silhouette_params,
    /// Number of rows of `lendings`. Default 0.
    pub n_lendings: usize,
    /// Who borrows from whom, where that is not to be the detailed tree with the most similar crown: two numbers each,
    /// places in the drawing from 0: the tree that borrows, and the one that lends, `TREE_NO_TREE` for nobody. The last row
    /// for a tree counts.
    pub lendings: *const u32,
    /// How distances are read. Default `TREE_PERSPECTIVE_ESTIMATED`.
    pub perspective: tree_perspective,
    /// For `TREE_PERSPECTIVE_HORIZON` the height of the horizon in the drawing: y in its units, downwards, -1e6 to 1e6.
    pub horizon: f32,
    /// Angle under which the width of all trees is seen in the drawing, in radians, 0.05 to 2.5: what turns sizes into
    /// distances. Default 0.9, as in a photograph. Unused without perspective.
    pub fov: f32,
    /// Without perspective: how far trees stand off their line, as a share of their mean distance, 0 to 10. Default 0.4.
    pub jitter: f32,
    /// Borrowed branches and leaves are scaled as the crowns are, but at most by this factor up or down, 1 to 100.
    /// Default 3.
    pub scaling: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_stand_params {
    const NAME: &'static str = "tree_stand_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let default = StandParams::default();
        Self {
            struct_size: size_of::<Self>(),
            silhouette: null(),
            n_lendings: 0,
            lendings: null(),
            perspective: TREE_PERSPECTIVE_ESTIMATED,
            horizon: 0.0,
            fov: default.fov,
            jitter: default.jitter,
            scaling: default.scaling,
            reserved: 0,
        }
    }
}

impl tree_stand_params {
    /// In Rust's form, not yet checked.
    unsafe fn rust(&self) -> Result<StandParams> {
        let perspective = match self.perspective {
            TREE_PERSPECTIVE_ESTIMATED => Perspective::Estimated,
            TREE_PERSPECTIVE_HORIZON => Perspective::Horizon(self.horizon),
            TREE_PERSPECTIVE_FLAT => Perspective::Flat,
            other => {
                let name = "params.perspective";
                return Err(Failure::not_one_of(name, other, "TREE_PERSPECTIVE_"));
            }
        };
        let (limits, name) = (Limits::default(), "params.lendings");
        let rows: &[[u32; 2]] = unsafe {
            slice(self.lendings.cast(), self.n_lendings, &limits, Resource::Nodes, name)
        }?;
        let lending = |&[tree, from]: &[u32; 2]| Lending {
            tree: tree as usize,
            from: (from != TREE_NO_TREE).then_some(from as usize),
        };
        Ok(StandParams {
            silhouette: unsafe { silhouette_of(self.silhouette, "params.silhouette") }?,
            perspective,
            fov: self.fov,
            jitter: self.jitter,
            lenders: rows.iter().map(lending).collect(),
            scaling: self.scaling,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_params_init(
    params: *mut tree_stand_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Whether all fields and parts are in range: `TREE_OK`, or the error that their use would give. Whether the trees of
/// `lendings` are there is seen when they are used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_params_check(params: *const tree_stand_params) -> tree_status {
    call(|| Ok(unsafe { read(params, "params")?.rust() }?.validate()?))
}

/// Trees that grew of one drawing: at least one.
pub struct tree_stand {
    stand: Stand,
    seed: u64,
}

impl Handle for tree_stand {
    const NAME: &'static str = "tree_stand";
}

/// Grows all trees of a drawing, one outline for each, in parallel. Trees without details borrow branches and leaf of
/// the detailed tree with the most similar crown, or of the one that `params` says. Trees that cannot be used are left
/// out, and `tree_stand_notes` says so. `params` and `control` may be NULL. Free the stand with `tree_stand_free`.
///
/// `TREE_ERROR_INVALID` when no tree can be used, and for a horizon below all of them; `TREE_ERROR_PARAMETER` names what
/// is out of range; `TREE_ERROR_LIMIT` for more nodes or leaves, all trees together, than the limits allow.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_of_drawing(
    drawing: *const tree_outline_drawing,
    params: *const tree_stand_params,
    seed: u64,
    control: *const tree_control,
    stand: *mut *mut tree_stand,
) -> tree_status {
    call(|| {
        let place = unsafe { out(stand, "stand") }?;
        let drawing = unsafe { get(drawing, "drawing") }?.rust();
        let params = unsafe { read_or_default(params, "params")?.rust() }?;
        let body =
            |control: &Control| Ok(Stand::of_drawing(drawing, &params, Seed(seed), control)?);
        place.put(tree_stand { stand: unsafe { run(control, body) }?, seed });
        Ok(())
    })
}

/// A stand as a whole: a view. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stand_whole {
    /// `sizeof(tree_stand_whole)`.
    pub struct_size: usize,
    /// Number of trees.
    pub n_trees: usize,
    /// Leaves and branches of all trees together.
    pub n_elements: u64,
    /// 1 where the drawing is in perspective, and the fields below count.
    pub has_view: u32,
    /// Distance of the drawing from the eye, in units of the drawing.
    pub focal: f32,
    /// The point of the drawing that the eye looks at: on the horizon, in units of the drawing.
    pub center: [f32; 2],
    /// The eye in metres; it looks level along -Z.
    pub eye: [f32; 3],
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_stand_whole {
    const NAME: &'static str = "tree_stand_whole";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_trees: 0,
            n_elements: 0,
            has_view: 0,
            focal: 0.0,
            center: [0.0; 2],
            eye: [0.0; 3],
            reserved: 0,
        }
    }
}

/// Views a stand as a whole.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_view(
    stand: *const tree_stand,
    whole: *mut tree_stand_whole,
) -> tree_status {
    call(|| {
        let stand = &unsafe { get(stand, "stand") }?.stand;
        let seen = stand.view.as_ref();
        let value = tree_stand_whole {
            n_trees: stand.trees.len(),
            n_elements: stand.elements(),
            has_view: seen.is_some().into(),
            focal: seen.map_or(0.0, |view| view.focal),
            center: seen.map_or([0.0; 2], |view| view.center.to_array()),
            eye: seen.map_or([0.0; 3], |view| view.eye.to_array()),
            ..tree_stand_whole::default_value()
        };
        unsafe { write(whole, "whole", &value) }
    })
}

/// What was noticed, a line each, for a person to read. Free the lines with `tree_lines_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_notes(
    stand: *const tree_stand,
    lines: *mut *mut tree_lines,
) -> tree_status {
    call(|| {
        let place = unsafe { out(lines, "lines") }?;
        let notes = &unsafe { get(stand, "stand") }?.stand.notes;
        place.put(tree_lines::new(notes.iter().map(ToString::to_string).collect()));
        Ok(())
    })
}

/// One tree of a stand: a view. Set `struct_size` first.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_stand_tree {
    /// `sizeof(tree_stand_tree)`.
    pub struct_size: usize,
    /// Its name in the drawing, or `tree 3` for the third where it has none.
    pub name: tree_str,
    /// Its place among the trees of the drawing, from 0.
    pub number: u32,
    /// The tree, by its place in the drawing, whose branches or leaf it borrows; `TREE_NO_TREE` where it borrows nothing.
    pub lender: u32,
    /// Where its base stands in the stand, in metres: x as in the drawing, +Z towards the viewer.
    pub position: [f32; 3],
    /// Metres for a unit of the drawing, at this tree.
    pub scale: f32,
    /// By how much what it borrows is scaled; 1 where it borrows nothing.
    pub borrowed_scale: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_stand_tree {
    const NAME: &'static str = "tree_stand_tree";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            name: tree_str::EMPTY,
            number: 0,
            lender: TREE_NO_TREE,
            position: [0.0; 3],
            scale: 1.0,
            borrowed_scale: 1.0,
            reserved: 0,
        }
    }
}

/// Tree `index` of those that stand.
fn tree_at(stand: &tree_stand, index: usize) -> Result<&StandTree> {
    stand.stand.trees.get(index).ok_or_else(|| {
        let text = format!("index is {index}, the stand has {} trees", stand.stand.trees.len());
        Failure::new(TREE_ERROR_PARAMETER, text)
    })
}

/// Views a tree of a stand, the first being number 0, in the order of the drawing. Valid until `tree_stand_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_at(
    stand: *const tree_stand,
    index: usize,
    row: *mut tree_stand_tree,
) -> tree_status {
    call(|| {
        let tree = tree_at(unsafe { get(stand, "stand") }?, index)?;
        let value = tree_stand_tree {
            name: tree_str::of(&tree.name),
            number: tree.index as u32,
            lender: tree.lender.map_or(TREE_NO_TREE, |lender| lender as u32),
            position: tree.position.to_array(),
            scale: tree.scale,
            borrowed_scale: tree.borrowed_scale,
            ..tree_stand_tree::default_value()
        };
        unsafe { write(row, "row", &value) }
    })
}

/// What grew as tree `index`, its base at the origin. `report` may be NULL. Free the tree with `tree_tree_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_grown(
    stand: *const tree_stand,
    index: usize,
    report: *mut tree_silhouette_grown,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let grown = &tree_at(unsafe { get(stand, "stand") }?, index)?.grown;
        unsafe { view(report, "report", &tree_silhouette_grown::of(&grown.report)) }?;
        place.put(tree_tree::new(grown.tree.clone()));
        Ok(())
    })
}

/// What was drawn and borrowed of tree `index`, to be looked at or drawn on: a copy, its base at the origin. `report`,
/// which may be NULL, tells what became of its strokes. Its
/// `tree_silhouette_session_seed` is the stand's, from which its own comes. Free it with `tree_silhouette_session_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_silhouette(
    stand: *const tree_stand,
    index: usize,
    report: *mut tree_silhouette_play_report,
    silhouette: *mut *mut tree_silhouette_session,
) -> tree_status {
    call(|| {
        let place = unsafe { out(silhouette, "silhouette") }?;
        unsafe { foresee(report, "report") }?;
        let stand = unsafe { get(stand, "stand") }?;
        let tree = tree_at(stand, index)?;
        unsafe { view(report, "report", &tree_silhouette_play_report::of(&tree.strokes)) }?;
        place.put(tree_silhouette_session::new(
            tree.session.clone(),
            stand.seed,
            tree.strokes.clone(),
        ));
        Ok(())
    })
}

/// Frees a stand. What it handed out lives on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_stand_free(stand: *mut tree_stand) -> tree_status {
    call(|| unsafe { free(stand, "stand") })
}
