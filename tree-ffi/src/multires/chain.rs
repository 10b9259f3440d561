//! Multiresolution chains.

use super::paths::tree_multi_paths;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, TREE_ERROR_TEXT, Versioned, bytes, call, free,
    get, out, slice, tree_status, write,
};
use crate::control::{limits, run, tree_control};
use crate::io::tree_bytes;
use crate::memory::ask;
use crate::mesh::column;
use std::ffi::c_char;
use std::ptr::null;
use tree_lod::multires::{Item, MultiChain};
use tree_model::tree_core::{Control, Resource};

/// About how many bytes an item takes, and its text beyond its module's name.
const BYTES_AN_ITEM: u64 = 32;

/// What an item of a multi-chain is: one of the `TREE_ITEM_` constants.
pub type tree_item = u8;

/// A module of the plain chain; its value is its place there.
pub const TREE_ITEM_MODULE: u8 = 0;
/// `SAVE`: the turtle keeps its state under this number.
pub const TREE_ITEM_SAVE: u8 = 1;
/// `RESTORE`: the turtle goes back to the state of this number, and a level begins.
pub const TREE_ITEM_RESTORE: u8 = 2;

/// The modules of a chain, most relevant branches first. Its first levels are a prefix, and each prefix that ends with a
/// level is drawn by a turtle that knows `SAVE` and `RESTORE`.
pub struct tree_multi_chain {
    chain: MultiChain,
    kinds: Vec<tree_item>,
    values: Vec<u32>,
    ends: Vec<u32>,
}

impl Handle for tree_multi_chain {
    const NAME: &'static str = "tree_multi_chain";
}

impl tree_multi_chain {
    fn new(chain: MultiChain) -> Self {
        let of = |item: &Item| match *item {
            Item::Module(place) => (TREE_ITEM_MODULE, place),
            Item::Save(state) => (TREE_ITEM_SAVE, state),
            Item::Restore(state) => (TREE_ITEM_RESTORE, state),
        };
        let (kinds, values) = chain.items().iter().map(of).unzip();
        let ends = (1..=chain.n_levels()).map(|n| chain.prefix(n).len() as u32).collect();
        Self { chain, kinds, values, ends }
    }
}

/// Writes paths one after another as a chain. States have numbers from 0 on, and only those that are needed are saved.
/// `control` may be NULL; of it only a cancellation before the work begins matters. Free the chain with
/// `tree_multi_chain_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_chain_new(
    paths: *const tree_multi_paths,
    control: *const tree_control,
    chain: *mut *mut tree_multi_chain,
) -> tree_status {
    call(|| {
        let place = unsafe { out(chain, "chain") }?;
        let (adt, paths) = unsafe { get(paths, "paths") }?.rust();
        let made = unsafe {
            run(control, |control| {
                control.check()?;
                let n_modules: usize = (0..adt.len() as u32).map(|b| adt.modules(b).len()).sum();
                ask(BYTES_AN_ITEM.saturating_mul((n_modules + 2 * adt.len()) as u64))?;
                Ok(tree_multi_chain::new(MultiChain::new(adt, paths)?))
            })
        }?;
        place.put(made);
        Ok(())
    })
}

/// A multi-chain in columns.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_multi_chain_columns {
    /// `sizeof(tree_multi_chain_columns)`.
    pub struct_size: usize,
    /// Number of items.
    pub n_items: usize,
    /// One for each item: a `TREE_ITEM_` constant.
    pub kinds: *const tree_item,
    /// One for each item: the place of a module in the plain chain, or the number of a state.
    pub values: *const u32,
    /// Number of levels, at least 1.
    pub n_levels: usize,
    /// One for each level: the item it ends before. The first `k` levels are the items before `ends[k - 1]`; level `i`
    /// alone begins at `ends[i - 1]`, level 0 at 0.
    pub ends: *const u32,
    /// Number of states that a turtle has to keep at once.
    pub n_states: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_multi_chain_columns {
    const NAME: &'static str = "tree_multi_chain_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_items: 0,
            kinds: null(),
            values: null(),
            n_levels: 0,
            ends: null(),
            n_states: 0,
            reserved: 0,
        }
    }
}

/// Views the items. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_chain_view(
    chain: *const tree_multi_chain,
    columns: *mut tree_multi_chain_columns,
) -> tree_status {
    call(|| {
        let chain = unsafe { get(chain, "chain") }?;
        let found = tree_multi_chain_columns {
            n_items: chain.kinds.len(),
            kinds: column(&chain.kinds),
            values: column(&chain.values),
            n_levels: chain.ends.len(),
            ends: column(&chain.ends),
            n_states: chain.chain.n_states(),
            ..tree_multi_chain_columns::default_value()
        };
        unsafe { write(columns, "columns", &found) }
    })
}

/// The first `n_levels` levels as text, at most all, with `SAVE(0)` and `RESTORE(0)`. `text`, in UTF-8, is the plain
/// chain of `text_len` bytes, or ends with a NUL and `text_len` is `TREE_NUL_TERMINATED`; `ends` has for each of its
/// `n_ends` modules, brackets counted, the byte before which it ends. `control` may be NULL; `input_bytes` of its
/// limits caps the text. Free the bytes, which are UTF-8, with `tree_bytes_free`.
///
/// `TREE_ERROR_INVALID` when ends fall, lie within a letter or behind the text, or a module of the chain has none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_chain_to_text(
    chain: *const tree_multi_chain,
    n_levels: usize,
    text: *const c_char,
    text_len: usize,
    ends: *const u32,
    n_ends: usize,
    control: *const tree_control,
    bytes: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(bytes, "bytes") }?;
        let chain = unsafe { get(chain, "chain") }?;
        let limits = unsafe { limits(control) }?;
        let text = unsafe { self::bytes(text.cast(), text_len, &limits, "text") }?;
        let text = std::str::from_utf8(text).map_err(|error| {
            let at = error.valid_up_to();
            Failure::new(TREE_ERROR_TEXT, format!("text is not UTF-8 from byte {at} on"))
        })?;
        let ends = unsafe { slice(ends, n_ends, &limits, Resource::Modules, "ends") }?;
        let names = names(text, ends)?;
        let body = |control: &Control| {
            control.check()?;
            ask(text.len() as u64 + BYTES_AN_ITEM.saturating_mul(chain.kinds.len() as u64))?;
            written(&chain.chain, n_levels, &names)
        };
        place.put(tree_bytes::new(unsafe { run(control, body) }?.into_bytes()));
        Ok(())
    })
}

fn names<'a>(text: &'a str, ends: &[u32]) -> Result<Vec<&'a str>> {
    let mut begin = 0;
    let name = |(i, &end): (usize, &u32)| {
        let end = end as usize;
        let name = text.get(begin..end).ok_or_else(|| {
            let text = format!("ends[{i}] falls, or is within a letter or behind the text");
            Failure::new(TREE_ERROR_INVALID, text)
        })?;
        begin = end;
        Ok(name)
    };
    ends.iter().enumerate().map(name).collect()
}

fn written(chain: &MultiChain, n_levels: usize, names: &[&str]) -> Result<String> {
    let mut missing = None;
    let text = chain.text(n_levels, |place| match names.get(place as usize) {
        Some(&name) => name.to_owned(),
        None => {
            missing = Some(place);
            String::new()
        }
    });
    match missing {
        None => Ok(text),
        Some(place) => {
            let text = format!("n_ends is {}, but the chain has a module {place}", names.len());
            Err(Failure::new(TREE_ERROR_INVALID, text))
        }
    }
}

/// Frees a chain.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_multi_chain_free(chain: *mut tree_multi_chain) -> tree_status {
    call(|| unsafe { free(chain, "chain") })
}
