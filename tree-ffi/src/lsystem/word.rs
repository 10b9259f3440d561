//! Words: strings of modules with parameters, in columns.

use super::alphabet::Alphabet;
use super::place::{clear, noted, tree_grammar_report};
use super::tree_grammar;
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_INVALID, Versioned, call, free, get, out, read, slice,
    tree_status, write,
};
use crate::control::{limits, tree_control};
use crate::io::tree_bytes;
use crate::memory;
use crate::mesh::column;
use crate::sketch::{ask_to_parse, document};
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::ModelError;
use tree_model::lsystem::{Grammar, Kind, Symbols, Word};
use tree_model::tree_core::Resource;

/// A string of modules with their parameters, such as `F(1)[+(30)F(0.5)]`, and the alphabet of their kinds.
pub struct tree_word {
    word: Word,
    alphabet: Alphabet,
    past: Past,
}

/// What a word came from.
#[derive(Default)]
pub(super) struct Past {
    /// Modules of the axiom, and of the word after each step.
    pub(super) growth: Vec<u64>,
    /// The node of the skeleton for each node the word draws.
    pub(super) nodes: Vec<u32>,
    /// The leaf of the foliage for each leaf the word draws.
    pub(super) leaves: Vec<u32>,
}

impl Handle for tree_word {
    const NAME: &'static str = "tree_word";
}

impl tree_word {
    pub(super) fn of_grammar(word: Word, grammar: &Arc<Grammar>) -> Self {
        Self::new(word, Alphabet::Grammar(grammar.clone()), Past::default())
    }

    pub(super) fn own(word: Word, symbols: Symbols, past: Past) -> Self {
        Self::new(word, Alphabet::Own(Arc::new(symbols)), past)
    }

    pub(super) fn derived(word: Word, grammar: &Arc<Grammar>, growth: Vec<u64>) -> Self {
        let past = Past { growth, ..Past::default() };
        Self::new(word, Alphabet::Grammar(grammar.clone()), past)
    }

    fn new(word: Word, alphabet: Alphabet, past: Past) -> Self {
        Self { word, alphabet, past }
    }

    pub(super) fn rust(&self) -> &Word {
        &self.word
    }

    pub(super) fn symbols(&self) -> &Symbols {
        self.alphabet.symbols()
    }

    /// The word, whose kinds must mean to the grammar what they mean here.
    pub(super) fn of(&self, grammar: &Grammar) -> Result<&Word> {
        let same = std::ptr::eq(self.symbols(), grammar.symbols());
        if same || self.symbols() == grammar.symbols() {
            return Ok(&self.word);
        }
        let text = "word has another alphabet than grammar: write it with tree_word_to_text, and read \
                    that with tree_grammar_word";
        Err(Failure::new(TREE_ERROR_INVALID, text))
    }
}

/// A word in columns: as input, or as a view of a `tree_word`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_word_columns {
    /// `sizeof(tree_word_columns)`.
    pub struct_size: usize,
    /// Number of modules.
    pub n_modules: usize,
    /// One for each module: its kind, which says its symbol and number of parameters (`tree_word_kind`).
    pub kinds: *const u16,
    /// Number of parameters of all modules together.
    pub n_params: usize,
    /// The parameters of all modules, one after another.
    pub params: *const f64,
    /// Number of kinds in the alphabet. Not used as input.
    pub n_kinds: usize,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_word_columns {
    const NAME: &'static str = "tree_word_columns";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_modules: 0,
            kinds: std::ptr::null(),
            n_params: 0,
            params: std::ptr::null(),
            n_kinds: 0,
        }
    }
}

/// What a word came from. Columns that do not apply are NULL.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_word_history {
    /// `sizeof(tree_word_history)`.
    pub struct_size: usize,
    /// Derived words: number of steps, and 1. Else 0.
    pub n_growth: usize,
    /// Number of modules of the axiom, and then of the word after each step.
    pub growth: *const u64,
    /// Words of skeletons: number of nodes that the word draws. Else 0.
    pub n_nodes: usize,
    /// For each of these, in the order of the word, the node of the skeleton it stands for.
    pub nodes: *const u32,
    /// Words of skeletons: number of leaves that the word draws. Else 0.
    pub n_leaves: usize,
    /// For each of these, in the order of the word, the leaf of the foliage it stands for.
    pub leaves: *const u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_word_history {
    const NAME: &'static str = "tree_word_history";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            n_growth: 0,
            growth: std::ptr::null(),
            n_nodes: 0,
            nodes: std::ptr::null(),
            n_leaves: 0,
            leaves: std::ptr::null(),
        }
    }
}

/// Reads a word without a grammar: a symbol is one character, its parameters are numbers in parentheses, divided
/// by commas. `text` has `len` bytes or `TREE_NUL_TERMINATED`. Brackets need not pair; `tree_word_check` looks.
/// `control` may be NULL; only its limits matter. `report` may be NULL; it says which module is wrong, with
/// `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_from_text(
    text: *const c_char,
    len: usize,
    control: *const tree_control,
    report: *mut tree_grammar_report,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        unsafe { clear(report) }?;
        let text = unsafe { document(text, len, &limits(control)?, "text") }?;
        ask_to_parse(text)?;
        let mut symbols = Symbols::default();
        let read = unsafe { noted(Word::parse(text, &mut symbols), report) }?;
        place.put(tree_word::own(read, symbols, Past::default()));
        Ok(())
    })
}

/// Reads a word of a grammar's modules, such as `F(1)[+F(0.5)]`. `TREE_ERROR_INVALID` also for modules that the
/// grammar does not have, and for brackets that do not pair. Otherwise as `tree_word_from_text`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_word(
    grammar: *const tree_grammar,
    text: *const c_char,
    len: usize,
    control: *const tree_control,
    report: *mut tree_grammar_report,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        unsafe { clear(report) }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let text = unsafe { document(text, len, &limits(control)?, "text") }?;
        ask_to_parse(text)?;
        let read = unsafe { noted(grammar.word(text), report) }?;
        place.put(tree_word::of_grammar(read, grammar));
        Ok(())
    })
}

/// Makes a word of a grammar's modules from columns, which are copied: kinds are those of the grammar, each
/// module has as many parameters as its kind says. `control` may be NULL; only its limits matter. `report` may
/// be NULL; it says which module is wrong, with `TREE_ERROR_INVALID`. Free the word with `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_word_from_columns(
    grammar: *const tree_grammar,
    columns: *const tree_word_columns,
    control: *const tree_control,
    report: *mut tree_grammar_report,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        unsafe { clear(report) }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let columns = unsafe { read(columns, "columns") }?;
        let limits = unsafe { limits(control) }?;
        let (n, modules) = (columns.n_modules, Resource::Modules);
        let kinds: &[u16] = unsafe { slice(columns.kinds, n, &limits, modules, "columns.kinds") }?;
        let (n, bytes) = (columns.n_params, Resource::InputBytes);
        let params: &[f64] = unsafe { slice(columns.params, n, &limits, bytes, "columns.params") }?;
        let made = unsafe { noted(of_columns(grammar.symbols(), kinds, params), report) }?;
        place.put(tree_word::of_grammar(made, grammar));
        Ok(())
    })
}

fn of_columns(
    symbols: &Symbols,
    kinds: &[u16],
    params: &[f64],
) -> std::result::Result<Word, ModelError> {
    let (mut word, mut rest) = (Word::default(), params);
    for &kind in kinds {
        // With too few parameters left, the word says what is missing.
        let own = symbols.arity(Kind(kind)).min(rest.len());
        let (first, others) = rest.split_at(own);
        word.push(symbols, Kind(kind), first)?;
        rest = others;
    }
    if !rest.is_empty() {
        let problem = format!("{} parameters are left over", rest.len());
        return Err(ModelError::Word { module: kinds.len(), problem });
    }
    word.check(symbols)?;
    Ok(word)
}

/// The word that the grammar's derivations begin with; random numbers in it come from the seed of the text.
/// Free it with `tree_word_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_axiom(
    grammar: *const tree_grammar,
    word: *mut *mut tree_word,
) -> tree_status {
    call(|| {
        let place = unsafe { out(word, "word") }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        place.put(tree_word::of_grammar(grammar.axiom().clone(), grammar));
        Ok(())
    })
}

/// Views a word. Set `columns->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_view(
    word: *const tree_word,
    columns: *mut tree_word_columns,
) -> tree_status {
    call(|| {
        let word = unsafe { get(word, "word") }?;
        let (kinds, params) = (word.word.kinds(), word.word.params());
        let value = tree_word_columns {
            n_modules: kinds.len(),
            // A kind is a number, and laid out as one.
            kinds: column(kinds).cast(),
            n_params: params.len(),
            params: column(params),
            n_kinds: word.symbols().len(),
            ..tree_word_columns::default_value()
        };
        unsafe { write(columns, "columns", &value) }
    })
}

/// Views what a word came from. Set `history->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_past(
    word: *const tree_word,
    history: *mut tree_word_history,
) -> tree_status {
    call(|| {
        let past = &unsafe { get(word, "word") }?.past;
        let value = tree_word_history {
            n_growth: past.growth.len(),
            growth: column(&past.growth),
            n_nodes: past.nodes.len(),
            nodes: column(&past.nodes),
            n_leaves: past.leaves.len(),
            leaves: column(&past.leaves),
            ..tree_word_history::default_value()
        };
        unsafe { write(history, "history", &value) }
    })
}

/// Bytes that a number takes as text, and a module beside.
const NUMBER: u64 = 20;
const MODULE: u64 = 4;

/// Writes a word as text, which `tree_word_from_text` and `tree_grammar_word` read back to the same bits (the
/// former where all symbols are of one character). Free it with `tree_bytes_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_to_text(
    word: *const tree_word,
    text: *mut *mut tree_bytes,
) -> tree_status {
    call(|| {
        let place = unsafe { out(text, "text") }?;
        let word = unsafe { get(word, "word") }?;
        let (modules, params) = (word.word.len() as u64, word.word.params().len() as u64);
        memory::ask(modules.saturating_mul(MODULE).saturating_add(params.saturating_mul(NUMBER)))?;
        place.put(tree_bytes::new(word.word.text(word.symbols()).into_bytes()));
        Ok(())
    })
}

/// Checks that every bracket of a word has its partner. `TREE_ERROR_INVALID` names the module that has none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_check(word: *const tree_word) -> tree_status {
    call(|| {
        let word = unsafe { get(word, "word") }?;
        Ok(word.word.check(word.symbols())?)
    })
}

/// Frees a word.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_free(word: *mut tree_word) -> tree_status {
    call(|| unsafe { free(word, "word") })
}
