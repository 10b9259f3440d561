//! Kinds of modules: symbols by name and number of parameters.

use super::{tree_grammar, tree_word};
use crate::border::{
    Failure, Result, TREE_ERROR_PARAMETER, TREE_ERROR_UNKNOWN_NAME, call, get, out_value, text,
    tree_status, tree_str,
};
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::lsystem::{Grammar, Kind, Symbols};

/// Kind of the module `[`, in every alphabet: a branch begins.
pub const TREE_KIND_PUSH: u16 = 0;
/// Kind of the module `]`, in every alphabet: a branch ends.
pub const TREE_KIND_POP: u16 = 1;
const _: () = assert!(TREE_KIND_PUSH == Symbols::PUSH.0 && TREE_KIND_POP == Symbols::POP.0);

/// Whose kinds a word has.
#[derive(Clone)]
pub(super) enum Alphabet {
    Grammar(Arc<Grammar>),
    Own(Arc<Symbols>),
}

impl Alphabet {
    pub(super) fn symbols(&self) -> &Symbols {
        match self {
            Self::Grammar(grammar) => grammar.symbols(),
            Self::Own(symbols) => symbols,
        }
    }
}

unsafe fn describe(
    symbols: &Symbols,
    kind: u16,
    name: *mut tree_str,
    n_params: *mut usize,
) -> Result<()> {
    let Some((found, n)) = symbols.get(Kind(kind)) else {
        let text = format!("kind is {kind}, but there are {} kinds", symbols.len());
        return Err(Failure::new(TREE_ERROR_PARAMETER, text));
    };
    unsafe { out_value(name, tree_str::of(found), "name") }?;
    unsafe { out_value(n_params, n, "n_params") }
}

unsafe fn find(
    symbols: &Symbols,
    name: *const c_char,
    len: usize,
    n_params: usize,
    kind: *mut u16,
) -> Result<()> {
    let name = unsafe { text(name, len, "name") }?;
    let Some(Kind(found)) = symbols.find(name, n_params) else {
        let text = format!("there is no module '{name}' with {n_params} parameters");
        return Err(Failure::new(TREE_ERROR_UNKNOWN_NAME, text));
    };
    unsafe { out_value(kind, found, "kind") }
}

/// Symbol and number of parameters of a kind of module, 0 to `tree_grammar_info.n_kinds` less 1. `F(1)` and
/// `F(1,2)` are of two kinds. The name is valid until the grammar is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_kind(
    grammar: *const tree_grammar,
    kind: u16,
    name: *mut tree_str,
    n_params: *mut usize,
) -> tree_status {
    call(|| {
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        unsafe { describe(grammar.symbols(), kind, name, n_params) }
    })
}

/// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
/// `TREE_ERROR_UNKNOWN_NAME` when the grammar has no such module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_find_kind(
    grammar: *const tree_grammar,
    name: *const c_char,
    len: usize,
    n_params: usize,
    kind: *mut u16,
) -> tree_status {
    call(|| {
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        unsafe { find(grammar.symbols(), name, len, n_params, kind) }
    })
}

/// Symbol and number of parameters of a kind of module, 0 to `tree_word_columns.n_kinds` less 1. The name is
/// valid until the word is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_kind(
    word: *const tree_word,
    kind: u16,
    name: *mut tree_str,
    n_params: *mut usize,
) -> tree_status {
    call(|| {
        let word = unsafe { get(word, "word") }?;
        unsafe { describe(word.symbols(), kind, name, n_params) }
    })
}

/// The kind of the symbol `name`, of `len` bytes or `TREE_NUL_TERMINATED`, with so many parameters.
/// `TREE_ERROR_UNKNOWN_NAME` when the word's alphabet has no such module.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_find_kind(
    word: *const tree_word,
    name: *const c_char,
    len: usize,
    n_params: usize,
    kind: *mut u16,
) -> tree_status {
    call(|| {
        let word = unsafe { get(word, "word") }?;
        unsafe { find(word.symbols(), name, len, n_params, kind) }
    })
}
