//! Trees to measure templates by, and what a person would draw of a tree.

use super::crown::tree_sketch_outline_params;
use super::drawing::{at, tree_drawing};
use crate::border::{
    Result, Versioned, call, get, init, out, out_value, read, read_or_default, text, tree_status,
    tree_str,
};
use crate::control::{run, tree_control};
use crate::skeleton::{continuation, continuation_of, tree_continuation};
use crate::tree::tree_tree;
use std::ffi::c_char;
use tree_model::sketch::crown::outline_of;
use tree_model::sketch::template::{
    EXEMPLARS, Exemplar, MainBranchParams, crown_points, main_branches, project,
};
use tree_model::tree_core::Seed;

/// The seed of the trees that the built-in templates were measured by.
pub const TREE_EXEMPLAR_SEED: u64 = 1;

/// Number of exemplars: trees of clearly different habit, one for each built-in template.
#[unsafe(no_mangle)]
pub extern "C" fn tree_exemplar_count() -> usize {
    EXEMPLARS.len()
}

/// Name of an exemplar, such as `oak`, what the tree looks like, in a few words, and the name of the species whose
/// leaves suit it. `index` is below `tree_exemplar_count`; `title` and `species` may be NULL. The texts are valid for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_exemplar_name(
    index: usize,
    name: *mut tree_str,
    title: *mut tree_str,
    species: *mut tree_str,
) -> tree_status {
    call(|| {
        let found = at(&EXEMPLARS, index, "exemplars")?;
        unsafe { out_value(name, tree_str::of(found.name()), "name") }?;
        for (place, text, argument) in
            [(title, found.title(), "title"), (species, found.species(), "species")]
        {
            if !place.is_null() {
                unsafe { out_value(place, tree_str::of(text), argument) }?;
            }
        }
        Ok(())
    })
}

/// Grows one tree of the exemplar called `name` (`len` bytes, or `TREE_NUL_TERMINATED`), with leaves on cards. The same
/// seed gives the same bits. `control` may be NULL. Free the tree with `tree_tree_free`. `TREE_ERROR_UNKNOWN_NAME` lists
/// the names there are.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_exemplar_grow(
    name: *const c_char,
    len: usize,
    seed: u64,
    control: *const tree_control,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let place = unsafe { out(tree, "tree") }?;
        let exemplar = Exemplar::find(unsafe { text(name, len, "name") }?)?;
        let body = |control: &_| Ok(exemplar.tree(Seed(seed), control)?);
        place.put(tree_tree::new(unsafe { run(control, body) }?));
        Ok(())
    })
}

/// Which branches of a tree a person would draw. Begin with `tree_main_branch_params_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_main_branch_params {
    /// `sizeof(tree_main_branch_params)`.
    pub struct_size: usize,
    /// Least length of axes of order 1 as a share of the longest of them, 0 to 1. Default 0.3.
    pub least: f32,
    /// Least length of axes of order 2 as a share of their parent's, 0 to 1. Default 0.35.
    pub least_second: f32,
    /// Most axes, 1 to 1000. Default 36.
    pub most: u32,
    /// Forks closer than this on an axis, as a share of the tree's extent, are taken for one, 0 to 0.5. Default
    /// 0.025.
    pub gather: f32,
    /// What continues an axis at a fork. Default `TREE_CONTINUATION_THICKEST`.
    pub continuation: tree_continuation,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers only.
unsafe impl Versioned for tree_main_branch_params {
    const NAME: &'static str = "tree_main_branch_params";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        let MainBranchParams { least, least_second, most, gather, continuation } =
            MainBranchParams::default();
        Self {
            struct_size: size_of::<Self>(),
            least,
            least_second,
            most,
            gather,
            continuation: continuation_of(continuation),
            reserved: 0,
        }
    }
}

impl tree_main_branch_params {
    pub(crate) fn rust(&self) -> Result<MainBranchParams> {
        Ok(MainBranchParams {
            least: self.least,
            least_second: self.least_second,
            most: self.most,
            gather: self.gather,
            continuation: continuation(self.continuation, "main.continuation")?,
        })
    }
}

/// Makes `params`, of `size` bytes, the default.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_main_branch_params_init(
    params: *mut tree_main_branch_params,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(params, size) })
}

/// Checks every range: `TREE_ERROR_PARAMETER` names the first field out of range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_main_branch_params_check(
    params: *const tree_main_branch_params,
) -> tree_status {
    call(|| Ok(unsafe { read(params, "params") }?.rust()?.validate()?))
}

/// The drawing that a person would make of a tree, in metres, y down: a stroke for each main branch, the trunk first, as
/// an eye sees them that looks level from afar and stands at `yaw` radians round the trunk (0 on +Z, a quarter turn on
/// +X), and `with_crown` the outline of its leaves. `main`, `outline` and `control` may be NULL. Free the drawing with
/// `tree_drawing_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_drawing_of_tree(
    tree: *const tree_tree,
    yaw: f32,
    with_crown: u32,
    main: *const tree_main_branch_params,
    outline: *const tree_sketch_outline_params,
    control: *const tree_control,
    drawing: *mut *mut tree_drawing,
) -> tree_status {
    call(|| {
        let place = unsafe { out(drawing, "drawing") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let main = unsafe { read_or_default(main, "main") }?.rust()?;
        let outline = unsafe { read_or_default(outline, "outline") }?.rust();
        outline.validate()?;
        let body = |_: &_| {
            let branches = main_branches(tree.skeleton(), &main)?;
            let crown = if with_crown == 0 {
                Vec::new()
            } else {
                outline_of(&crown_points(tree, yaw), &outline)
            };
            Ok(project(&branches, yaw, &crown))
        };
        place.put(tree_drawing::new(unsafe { run(control, body) }?));
        Ok(())
    })
}
