//! Connected pieces of wood, and one skeleton of them all.

use super::separation::tree_separation;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, call, fill, free, get, out, out_value,
    read_or_default, slice, tree_status,
};
use crate::control::{limits, run, tree_control};
use crate::skeleton::tree_skeleton;
use crate::skeletonize::params::tree_skeletonize_params;
use bytemuck::{Pod, Zeroable};
use tree_model::skeletonize::stages::{Piece, link};
use tree_model::tree_core::{Control, Resource};

/// Connected pieces of wood, each followed from its base.
pub struct tree_pieces(Vec<Piece>);

impl Handle for tree_pieces {
    const NAME: &'static str = "tree_pieces";
}

/// What one piece of wood stands for.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct tree_piece {
    /// Area of its surface, in squares of the mesh's own unit.
    pub area: f32,
    /// Bumps of the bark dropped.
    pub n_bumps: u32,
    /// Branches cut where they had grown together.
    pub n_cut: u32,
}

/// The second stage: follows every connected piece of wood from its base, in parallel. `params` and
/// `control` may be NULL. Free the pieces with `tree_pieces_free`. `TREE_ERROR_NO_RESULT` where there is
/// no wood.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_separation_follow(
    separation: *const tree_separation,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    pieces: *mut *mut tree_pieces,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pieces, "pieces") }?;
        let separation = unsafe { get(separation, "separation") }?.rust();
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let found = unsafe { run(control, |control| Ok(separation.follow(&params, control)?)) }?;
        place.put(tree_pieces(found));
        Ok(())
    })
}

/// Makes pieces of `n_pieces` skeletons, which are copied, and of what they stand for: for pieces that were
/// changed, or come from elsewhere. `control` may be NULL; `nodes` of its limits caps those of all
/// skeletons together.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pieces_new(
    skeletons: *const *const tree_skeleton,
    rows: *const tree_piece,
    n_pieces: usize,
    control: *const tree_control,
    pieces: *mut *mut tree_pieces,
) -> tree_status {
    call(|| {
        let place = unsafe { out(pieces, "pieces") }?;
        let limits = unsafe { limits(control) }?;
        let rows = unsafe { slice(rows, n_pieces, &limits, Resource::Nodes, "rows") }?;
        if skeletons.is_null() && n_pieces > 0 {
            return Err(Failure::null("skeletons"));
        }
        let mut n_nodes = 0_u64;
        let mut given = Vec::with_capacity(n_pieces);
        for (i, row) in rows.iter().enumerate() {
            // SAFETY: within the caller's array.
            let skeleton = unsafe { skeletons.add(i).read_unaligned() };
            let skeleton = unsafe { get(skeleton, &format!("skeletons[{i}]")) }?.rust();
            // One skeleton may be given many times: its copies are what counts.
            n_nodes = n_nodes.saturating_add(skeleton.len() as u64);
            limits.check(Resource::Nodes, n_nodes)?;
            given.push((skeleton, row));
        }
        let copy = |control: &Control| {
            let copied = given.iter().map(|&(skeleton, row)| {
                control.check()?;
                let (n_bumps, n_cut) = (row.n_bumps as usize, row.n_cut as usize);
                Ok(Piece { skeleton: skeleton.clone(), area: row.area, n_bumps, n_cut })
            });
            copied.collect::<Result<_>>()
        };
        place.put(tree_pieces(unsafe { run(control, copy) }?));
        Ok(())
    })
}

/// Number of pieces.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pieces_count(
    pieces: *const tree_pieces,
    n_pieces: *mut usize,
) -> tree_status {
    call(|| {
        let n = unsafe { get(pieces, "pieces") }?.0.len();
        unsafe { out_value(n_pieces, n, "n_pieces") }
    })
}

/// One piece, `index` below their number: its skeleton, copied, in units of the mesh's longest side, and
/// what it stands for (NULL if not wanted). Free the skeleton with `tree_skeleton_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pieces_piece(
    pieces: *const tree_pieces,
    index: usize,
    row: *mut tree_piece,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let pieces = &unsafe { get(pieces, "pieces") }?.0;
        let Some(piece) = pieces.get(index) else {
            let text = format!("index is {index}, but there are {} pieces", pieces.len());
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        if !row.is_null() {
            let (n_bumps, n_cut) = (piece.n_bumps as u32, piece.n_cut as u32);
            unsafe { out_value(row, tree_piece { area: piece.area, n_bumps, n_cut }, "row") }?;
        }
        place.put(tree_skeleton::own(piece.skeleton.clone()));
        Ok(())
    })
}

/// The third stage: links pieces over gaps of at most `params.bridge` to one skeleton, seen from its lowest
/// thick end. `reached`, NULL or with room for `capacity` bytes (one for each piece), says whether it is part of it. Free
/// the skeleton with `tree_skeleton_free`. `TREE_ERROR_NO_RESULT` without pieces.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pieces_link(
    pieces: *const tree_pieces,
    params: *const tree_skeletonize_params,
    control: *const tree_control,
    reached: *mut u8,
    capacity: usize,
    skeleton: *mut *mut tree_skeleton,
) -> tree_status {
    call(|| {
        let place = unsafe { out(skeleton, "skeleton") }?;
        let pieces = &unsafe { get(pieces, "pieces") }?.0;
        let params = unsafe { read_or_default(params, "params") }?.rust();
        let linked = unsafe { run(control, |control| Ok(link(pieces, &params, control)?)) }?;
        if !reached.is_null() {
            let bytes: Vec<u8> = linked.reached.iter().map(|&reached| reached.into()).collect();
            unsafe { fill(reached, capacity, &bytes, "reached") }?;
        }
        place.put(tree_skeleton::own(linked.skeleton));
        Ok(())
    })
}

/// Frees pieces.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_pieces_free(pieces: *mut tree_pieces) -> tree_status {
    call(|| unsafe { free(pieces, "pieces") })
}
