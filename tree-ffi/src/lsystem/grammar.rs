//! Grammars: texts, ready to be derived.

use super::place::{clear, noted, tree_grammar_report};
use crate::border::{
    Failure, Handle, Result, TREE_ERROR_PARAMETER, Versioned, call, free, get, out, out_value,
    path, text, tree_status, tree_str, write,
};
use crate::control::{limits, tree_control};
use crate::sketch::{ask_to_parse, document};
use std::ffi::c_char;
use std::sync::Arc;
use tree_model::lsystem::Grammar;
use tree_model::tree_core::{Limits, file};

/// An L-system's grammar: alphabet, axiom, productions, and rules of decomposition and interpretation.
pub struct tree_grammar(Arc<Grammar>);

impl Handle for tree_grammar {
    const NAME: &'static str = "tree_grammar";
}

impl tree_grammar {
    pub(super) fn new(grammar: Grammar) -> Self {
        Self(Arc::new(grammar))
    }

    pub(super) fn rust(&self) -> &Arc<Grammar> {
        &self.0
    }
}

/// What a grammar says beside its productions.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_grammar_info {
    /// `sizeof(tree_grammar_info)`.
    pub struct_size: usize,
    /// The text it was read from.
    pub text: tree_str,
    /// Angle of turns without a parameter in degrees (`angle:`). 90 where the text does not say.
    pub angle: f64,
    /// Seed that the text proposes (`seed:`). 0 where it does not.
    pub seed: u64,
    /// Number of productions, without those of decomposition and interpretation.
    pub n_productions: usize,
    /// Number of named constants: `tree_grammar_constant`.
    pub n_constants: usize,
    /// Number of kinds of modules: `tree_grammar_kind`.
    pub n_kinds: usize,
    /// Number of derivations that the text asks for (`steps:`), 0 to 1,000,000. 0 where it does not.
    pub steps: u32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_grammar_info {
    const NAME: &'static str = "tree_grammar_info";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            text: tree_str::EMPTY,
            angle: 0.0,
            seed: 0,
            n_productions: 0,
            n_constants: 0,
            n_kinds: 0,
            steps: 0,
            reserved: 0,
        }
    }
}

unsafe fn parse(
    text: &str,
    limits: &Limits,
    report: *mut tree_grammar_report,
) -> Result<tree_grammar> {
    ask_to_parse(text)?;
    Ok(tree_grammar::new(unsafe { noted(Grammar::parse(text, limits), report) }?))
}

/// Reads a grammar in the notation of *The Algorithmic Beauty of Plants* and of the programs cpfg and L-studio,
/// `text` of `len` bytes or `TREE_NUL_TERMINATED`. One line is a statement:
///
/// * `#define r 0.5` or `r = 0.5`: a constant; `#symbols Apex`: symbols of more than one character;
/// * `steps: 7`, `angle: 25.7`, `seed: 3`, `#ignore +-F`, `#consider AB`: settings;
/// * `axiom: A(1)`: the word to begin with;
/// * `A(x) : x > 1 -> F(x)[+A(x*r)]A(x*r)`: a production; `B(y) < A(x) > C` gives it a context,
///   `A -(.3)-> B` or `A -> B : .3` a weight among others;
/// * `decomposition`, `interpretation`, `productions`: what follows are rules of that section.
///
/// `control` may be NULL; only its limits matter. `report` may be NULL; it says in which line and column a
/// mistake is, with `TREE_ERROR_INVALID`. Free the grammar with `tree_grammar_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_from_text(
    text: *const c_char,
    len: usize,
    control: *const tree_control,
    report: *mut tree_grammar_report,
    grammar: *mut *mut tree_grammar,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grammar, "grammar") }?;
        unsafe { clear(report) }?;
        let limits = unsafe { limits(control) }?;
        let text = unsafe { document(text, len, &limits, "text") }?;
        place.put(unsafe { parse(text, &limits, report) }?);
        Ok(())
    })
}

/// Reads a grammar from a file in UTF-8. The path, in UTF-8, has `path_len` bytes, or ends with a NUL and
/// `path_len` is `TREE_NUL_TERMINATED`. Otherwise as `tree_grammar_from_text`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_read(
    path: *const c_char,
    path_len: usize,
    control: *const tree_control,
    report: *mut tree_grammar_report,
    grammar: *mut *mut tree_grammar,
) -> tree_status {
    call(|| {
        let place = unsafe { out(grammar, "grammar") }?;
        unsafe { clear(report) }?;
        let path = unsafe { self::path(path, path_len, "path") }?;
        let limits = unsafe { limits(control) }?;
        let text = file::read_text(path, &limits)?;
        place.put(unsafe { parse(&text, &limits, report) }?);
        Ok(())
    })
}

/// Views what a grammar says. Set `info->struct_size` first.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_view(
    grammar: *const tree_grammar,
    info: *mut tree_grammar_info,
) -> tree_status {
    call(|| {
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let value = tree_grammar_info {
            text: tree_str::of(grammar.text()),
            angle: grammar.angle(),
            seed: grammar.seed().0,
            n_productions: grammar.n_productions(),
            n_constants: grammar.constants().count(),
            n_kinds: grammar.symbols().len(),
            steps: grammar.steps(),
            ..tree_grammar_info::default_value()
        };
        unsafe { write(info, "info", &value) }
    })
}

/// Name and value of a constant of the text, in the order of their names; `steps` and `angle` are among them
/// where the text sets them. `index` is below `tree_grammar_info.n_constants`. The name is valid until the
/// grammar is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_constant(
    grammar: *const tree_grammar,
    index: usize,
    name: *mut tree_str,
    value: *mut f64,
) -> tree_status {
    call(|| {
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let Some((found, number)) = grammar.constants().nth(index) else {
            let n = grammar.constants().count();
            let text = format!("index is {index}, but there are {n} constants");
            return Err(Failure::new(TREE_ERROR_PARAMETER, text));
        };
        unsafe { out_value(name, tree_str::of(found), "name") }?;
        unsafe { out_value(value, number, "value") }
    })
}

/// A copy of the grammar in which a constant of the text has another value; all that depends on it is computed
/// anew. `steps` (fractions are cut off) and `angle` can be set as well. `name` has `len` bytes or
/// `TREE_NUL_TERMINATED`. `TREE_ERROR_PARAMETER` for a value that is not finite or steps beyond 0 to 1,000,000,
/// `TREE_ERROR_INVALID` when the text has no such constant, or an expression of constants has no value then:
/// `report`, which may be NULL, says where. Words of the one grammar are words of the other. Free the copy with
/// `tree_grammar_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_with_constant(
    grammar: *const tree_grammar,
    name: *const c_char,
    len: usize,
    value: f64,
    report: *mut tree_grammar_report,
    changed: *mut *mut tree_grammar,
) -> tree_status {
    call(|| {
        let place = unsafe { out(changed, "changed") }?;
        unsafe { clear(report) }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let name = unsafe { text(name, len, "name") }?;
        ask_to_parse(grammar.text())?;
        let mut copy = Grammar::clone(grammar);
        unsafe { noted(copy.set_constant(name, value), report) }?;
        place.put(tree_grammar::new(copy));
        Ok(())
    })
}

/// Frees a grammar. Its words live on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_grammar_free(grammar: *mut tree_grammar) -> tree_status {
    call(|| unsafe { free(grammar, "grammar") })
}
