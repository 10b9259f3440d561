//! From a skeleton back to a word.

use super::tree_word;
use super::word::Past;
use crate::border::{Result, Versioned, call, get, init, out, read_or_default, tree_status};
use crate::control::{limits, run, tree_control};
use crate::skeleton::{continuation, continuation_of, tree_continuation, tree_skeleton};
use crate::tree::{tree_foliage, tree_tree};
use tree_model::lsystem::of_skeleton::{ChainParams, chain};
use tree_model::tree_core::{Foliage, Skeleton};

/// How a skeleton becomes a word. Begin with `tree_chain_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_chain_params {
    /// `sizeof(tree_chain_params)`.
    pub struct_size: usize,
    /// How far a node may be from its place, as a share of the tree's extent, 0 to 0.01: numbers are rounded to
    /// as few decimals as this allows. 0 writes all digits. Default 1e-5.
    pub tolerance: f64,
    /// Which child goes on at a fork; the others are in brackets. Default `TREE_CONTINUATION_THICKEST`.
    pub continuation: tree_continuation,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_chain_params {
    const NAME: &'static str = "tree_chain_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let ChainParams { continuation, tolerance } = ChainParams::default();
        Self {
            struct_size: size_of::<Self>(),
            tolerance,
            continuation: continuation_of(continuation),
            reserved: 0,
        }
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_chain_params_init(
    params: *mut tree_chain_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

unsafe fn write(
    skeleton: &Skeleton,
    foliage: &Foliage,
    params: *const tree_chain_params,
    control: *const tree_control,
) -> Result<tree_word> {
    let params = unsafe { read_or_default(params, "params") }?;
    let params = ChainParams {
        continuation: continuation(params.continuation, "params.continuation")?,
        tolerance: params.tolerance,
    };
    let written =
        unsafe { run(control, |control| Ok(chain(skeleton, foliage, &params, control)?)) }?;
    let past = Past { growth: Vec::new(), nodes: written.nodes, leaves: written.leaves };
    Ok(tree_word::own(written.word, written.symbols, past))
}

/// Writes a skeleton as a word in metres from its base, with leaves in columns, or NULL for none: an internode is
/// turns `+(a)` `&(b)`, a diameter `!(w)` and a length `F(l)`, as far as they change; what leaves the axis at a node
/// is in brackets, and so is each leaf, `~(size,kind)`. `tree_word_interpret` with `tree_chain_turtle` draws it.
/// `tree_word_past` says which node and leaf is which. `params` and `control` may be NULL. `TREE_ERROR_INVALID`
/// for a leaf on a node that is not there, `TREE_ERROR_LIMIT` for a word of many more modules than
/// `tree_limits.modules`, which is looked at from time to time. Free the word with `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_skeleton_to_word(
    skeleton: *const tree_skeleton,
    foliage: *const tree_foliage,
    params: *const tree_chain_params,
    control: *const tree_control,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let foliage = unsafe { read_or_default(foliage, "foliage") }?;
        let foliage = unsafe { foliage.rust(&limits(control)?) }?;
        place.put(unsafe { write(skeleton, &foliage, params, control) }?);
        Ok(())
    })
}

/// Writes a tree, wood and leaves, as a word. Otherwise as `tree_skeleton_to_word`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_tree_to_word(
    tree: *const tree_tree,
    params: *const tree_chain_params,
    control: *const tree_control,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        place.put(unsafe { write(tree.skeleton(), tree.foliage(), params, control) }?);
        Ok(())
    })
}
