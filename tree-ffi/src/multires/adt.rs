//! The tree of branches.

use super::there;
use crate::border::{
    Failure, Handle, Result, Versioned, call, free, get, out, out_value, read, slice, tree_status,
    write,
};
use crate::control::{limits, run, tree_control};
use crate::memory::ask;
use crate::mesh::column;
use crate::skeleton::tree_skeleton;
use crate::tree::tree_tree;
use std::ptr::null;
use std::sync::Arc;
use tree_lod::multires::{Adt, Token};
use tree_model::tree_core::{Limits, Resource};

/// About how many bytes a module and its branch take while branches are found.
const BYTES_A_MODULE: u64 = 80;

/// The branches of a chain of modules or of a skeleton, with their modules, lengths and children (the paper's *tree
/// abstract data type*). Branch 0 is the root, and parents come before their children.
pub struct tree_adt(Arc<Adt>);

impl Handle for tree_adt {
    const NAME: &'static str = "tree_adt";
}

impl tree_adt {
    pub(super) fn rust(&self) -> &Arc<Adt> {
        &self.0
    }
}

/// What a module of a bracketed chain is: one of the `TREE_TOKEN_` constants.
pub type tree_token = u8;

/// Any module that is no bracket, with the length that it draws.
pub const TREE_TOKEN_MODULE: u8 = 0;
/// `[`: a branch begins.
pub const TREE_TOKEN_PUSH: u8 = 1;
/// `]`: it ends.
pub const TREE_TOKEN_POP: u8 = 2;

/// A bracketed chain of modules, as far as its branches are concerned.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_token_columns {
    /// `sizeof(tree_token_columns)`.
    pub struct_size: usize,
    /// Number of modules, brackets included.
    pub n_tokens: usize,
    /// One for each: a `TREE_TOKEN_` constant.
    pub kinds: *const tree_token,
    /// One for each: the length that it draws, finite and 0 or more; 0 for all that do not advance. Those of brackets
    /// are not looked at.
    pub lengths: *const f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_token_columns {
    const NAME: &'static str = "tree_token_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self { struct_size: size_of::<Self>(), n_tokens: 0, kinds: null(), lengths: null() }
    }
}

impl tree_token_columns {
    unsafe fn rust<'a>(&self, limits: &Limits) -> Result<(&'a [u8], &'a [f64])> {
        let (n, modules) = (self.n_tokens, Resource::Modules);
        let kinds = unsafe { slice(self.kinds, n, limits, modules, "columns.kinds") }?;
        let lengths = unsafe { slice(self.lengths, n, limits, modules, "columns.lengths") }?;
        match kinds.iter().position(|&kind| kind > TREE_TOKEN_POP) {
            None => Ok((kinds, lengths)),
            Some(at) => {
                let name = format!("columns.kinds[{at}]");
                Err(Failure::not_one_of(&name, kinds[at].into(), "TREE_TOKEN_"))
            }
        }
    }
}

/// Finds the branches of a chain: one for each pair of brackets, and one for what is in none. Modules are named by
/// their places in the chain, from 0 on, brackets counted. `control` may be NULL; `modules` of its limits caps the
/// chain. Free the branches with `tree_adt_free`. `TREE_ERROR_INVALID` for brackets that do not match and for lengths
/// that are negative or not finite, and says at which module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_of_tokens(
    columns: *const tree_token_columns,
    control: *const tree_control,
    adt: *mut *mut tree_adt,
) -> tree_status {
    call(|| {
        let place = unsafe { out(adt, "adt") }?;
        let limits = unsafe { limits(control) }?;
        let (kinds, lengths) = unsafe { read(columns, "columns")?.rust(&limits) }?;
        let token = |(&kind, &length): (&u8, &f64)| match kind {
            TREE_TOKEN_PUSH => Token::Push,
            TREE_TOKEN_POP => Token::Pop,
            _ => Token::Module(length),
        };
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask(BYTES_A_MODULE.saturating_mul(kinds.len() as u64))?;
                Ok(Adt::of_tokens(kinds.iter().zip(lengths).map(token))?)
            })
        }?;
        place.put(tree_adt(Arc::new(made)));
        Ok(())
    })
}

/// Finds the branches of a skeleton: the runs of nodes between forks. Its modules are its nodes; the length of a node is
/// that of the segment to its parent, in metres. `control` may be NULL; of it only a cancellation before the work
/// begins matters. Free the branches with `tree_adt_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_of_skeleton(
    skeleton: *const tree_skeleton,
    control: *const tree_control,
    adt: *mut *mut tree_adt,
) -> tree_status {
    call(|| {
        let place = unsafe { out(adt, "adt") }?;
        let skeleton = unsafe { get(skeleton, "skeleton") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask(BYTES_A_MODULE.saturating_mul(skeleton.len() as u64))?;
                Ok(Adt::of_skeleton(skeleton))
            })
        }?;
        place.put(tree_adt(Arc::new(made)));
        Ok(())
    })
}

/// As `tree_adt_of_skeleton` for the skeleton of a tree; its leaves count among the areas of the branches that bear
/// them, as they do for `tree_multires_new`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_of_tree(
    tree: *const tree_tree,
    control: *const tree_control,
    adt: *mut *mut tree_adt,
) -> tree_status {
    call(|| {
        let place = unsafe { out(adt, "adt") }?;
        let tree = unsafe { get(tree, "tree") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                ask(BYTES_A_MODULE.saturating_mul(tree.skeleton().len() as u64))?;
                Ok(Adt::of_tree(tree))
            })
        }?;
        place.put(tree_adt(Arc::new(made)));
        Ok(())
    })
}

/// Branches in columns.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_adt_columns {
    /// `sizeof(tree_adt_columns)`.
    pub struct_size: usize,
    /// Number of branches, at least 1.
    pub n_branches: usize,
    /// One for each branch: the branch it stems from, or `TREE_NO_PARENT` for branch 0.
    pub parents: *const u32,
    /// One for each branch: the length of its own modules together.
    pub lengths: *const f64,
    /// One for each branch: the area that its own modules show from the side, in m² for skeletons and trees; that of its
    /// own leaves is in it for trees. Lengths for chains of modules.
    pub areas: *const f64,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_adt_columns {
    const NAME: &'static str = "tree_adt_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_branches: 0,
            parents: null(),
            lengths: null(),
            areas: null(),
        }
    }
}

/// Views the branches. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_view(
    adt: *const tree_adt,
    columns: *mut tree_adt_columns,
) -> tree_status {
    call(|| {
        let adt = &unsafe { get(adt, "adt") }?.0;
        let found = tree_adt_columns {
            n_branches: adt.len(),
            parents: column(adt.parents()),
            lengths: column(adt.lengths()),
            areas: column(adt.areas()),
            ..tree_adt_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// Views the modules of a branch, in their order: places in the chain, or nodes of the skeleton. `TREE_ERROR_PARAMETER`
/// when there is no such branch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_modules(
    adt: *const tree_adt,
    branch: u32,
    modules: *mut *const u32,
    n_modules: *mut usize,
) -> tree_status {
    call(|| {
        let adt = &unsafe { get(adt, "adt") }?.0;
        there("branch", branch as usize, adt.len(), "branches")?;
        let found = adt.modules(branch);
        unsafe { out_value(modules, column(found), "modules") }?;
        unsafe { out_value(n_modules, found.len(), "n_modules") }
    })
}

/// Views the branches that stem from a branch, in the order of the chain. `TREE_ERROR_PARAMETER` when there is no such
/// branch.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_children(
    adt: *const tree_adt,
    branch: u32,
    children: *mut *const u32,
    n_children: *mut usize,
) -> tree_status {
    call(|| {
        let adt = &unsafe { get(adt, "adt") }?.0;
        there("branch", branch as usize, adt.len(), "branches")?;
        let found = adt.children(branch);
        unsafe { out_value(children, column(found), "children") }?;
        unsafe { out_value(n_children, found.len(), "n_children") }
    })
}

/// Frees the branches. Paths that were made of them stay.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_adt_free(adt: *mut tree_adt) -> tree_status {
    call(|| unsafe { free(adt, "adt") })
}
