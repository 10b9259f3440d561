//! Words drawn as trees and as lines, and whole L-systems grown.

use super::derive::steps;
use super::trace::{tree_turtle_report, tree_turtle_trace};
use super::turtle::tree_turtle_params;
use super::{tree_grammar, tree_word};
use crate::border::{
    call, foresee, get, out, out_opt, out_value, read, read_or_default, tree_status, view,
};
use crate::control::{run, tree_control};
use crate::sketch::fill_some;
use crate::tree::tree_tree;
use tree_model::lsystem::turtle::{interpret, lines};
use tree_model::lsystem::{Grammar, LSystem};
use tree_model::tree_core::Seed;

/// Draws a word as a tree: a turtle reads it from left to right.
///
/// * `F(l)` draws wood of length l, `f(l)` moves without drawing, `G(l)` draws as `F` does;
/// * `+(a)` `-(a)` turn left and right by a degrees, `&(a)` `^(a)` pitch down and up, `\(a)` `/(a)` roll left and
///   right, `|` turns round, `$` rolls until the turtle's left is horizontal;
/// * `!(w)` `#(w)` set the diameter; without w it falls, or rises, by the width ratio; `_(e)` sets the elasticity;
/// * `[` `]` are a branch, which saves and restores all this; `%` cuts off the rest of one;
/// * `{` `.` `}` are a polygon, a corner where the turtle stands, and its end; in it `F` and `f` set corners;
/// * `~(s,k)` is a leaf of size s and kind k; `'(n)` is colour n, `'` the next.
///
/// Other symbols do nothing, and are counted. `turtle` may be NULL for the default, `control`, `report` and the
/// place `trace` may be NULL. `TREE_ERROR_INVALID` names the module: a bracket or brace without its partner, a
/// width or size below 0, a leaf kind that the species lacks. Free the tree with `tree_tree_free`, the trace with
/// `tree_turtle_trace_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_interpret(
    word: *const tree_word,
    turtle: *const tree_turtle_params,
    control: *const tree_control,
    report: *mut tree_turtle_report,
    trace: *mut *mut tree_turtle_trace,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let (trace, place) = unsafe { (out_opt(trace, "trace"), out(tree, "tree")) };
        let (trace, place) = (trace?, place?);
        unsafe { foresee(report, "report") }?;
        let word = unsafe { get(word, "word") }?;
        let turtle = unsafe { read_or_default(turtle, "turtle") }?;
        let species = unsafe { turtle.species("turtle") }?;
        let params = unsafe { turtle.rust("turtle") }?;
        params.validate()?;
        let drawn = unsafe {
            run(control, |control| {
                Ok(interpret(word.rust(), word.symbols(), &species, &params, control)?)
            })
        }?;
        unsafe { view(report, "report", &tree_turtle_report::of(&drawn.report)) }?;
        if let Some(trace) = trace {
            trace.put(tree_turtle_trace::new(&drawn.polygons, drawn.report));
        }
        place.put(tree_tree::new(drawn.tree));
        Ok(())
    })
}

/// Draws every `F` and `G` of a word as a line, in its order: six floats, where it begins and where it ends, in
/// units times `turtle->unit`. The turtle starts at the origin and looks along +Y; `+` turns it to -X. Gaps stay
/// open, braces draw nothing. `lines` has room for `capacity` floats; six for each module are always enough.
/// `n_lines` says how many lines there are, also when the room was too small (`TREE_ERROR_BUFFER`, nothing is
/// written). `turtle` and `control` may be NULL. Other errors are those of `tree_word_interpret`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_word_lines(
    word: *const tree_word,
    turtle: *const tree_turtle_params,
    control: *const tree_control,
    lines: *mut f32,
    capacity: usize,
    n_lines: *mut usize,
) -> tree_status {
    call(|| {
        unsafe { out_value(n_lines, 0, "n_lines") }?;
        let word = unsafe { get(word, "word") }?;
        let turtle = unsafe { read_or_default(turtle, "turtle") }?;
        let params = unsafe { turtle.rust("turtle") }?;
        params.validate()?;
        let drawn = unsafe {
            run(control, |control| Ok(self::lines(word.rust(), word.symbols(), &params, control)?))
        }?;
        unsafe { out_value(n_lines, drawn.len(), "n_lines") }?;
        let floats: &[f32] = bytemuck::cast_slice(&drawn);
        unsafe { fill_some(lines, capacity, floats, "lines") }
    })
}

/// Grows a tree of a grammar: derives the word, applies the rules of interpretation, and draws it. `steps` is the
/// number of derivations, 0 to 1,000,000, or `TREE_STEPS_OF_TEXT`. `turtle` may be NULL for that of
/// `tree_grammar_turtle`. The same grammar, parameters and `seed` give the same bits for any number of threads.
/// `control`, `report` and the places `word` and `trace` may be NULL; the word is the one that was drawn, with the
/// growth of the derivation as its past. Errors are those of `tree_grammar_derive` and `tree_word_interpret`. Free
/// the tree with `tree_tree_free`, the others with `tree_word_free` and `tree_turtle_trace_free`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_lsystem_grow(
    grammar: *const tree_grammar,
    steps: u32,
    turtle: *const tree_turtle_params,
    seed: u64,
    control: *const tree_control,
    report: *mut tree_turtle_report,
    word: *mut *mut tree_word,
    trace: *mut *mut tree_turtle_trace,
    tree: *mut *mut tree_tree,
) -> tree_status {
    call(|| {
        let (word, trace, place) =
            unsafe { (out_opt(word, "word"), out_opt(trace, "trace"), out(tree, "tree")) };
        let (word, trace, place) = (word?, trace?, place?);
        unsafe { foresee(report, "report") }?;
        let grammar = unsafe { get(grammar, "grammar") }?.rust();
        let steps = self::steps(steps)?;
        let own = Grammar::clone(grammar);
        let system = if turtle.is_null() {
            LSystem { steps, ..LSystem::new(own)? }
        } else {
            let given = unsafe { read(turtle, "turtle") }?;
            LSystem {
                grammar: own,
                steps,
                turtle: unsafe { given.rust("turtle") }?,
                species: unsafe { given.species("turtle") }?,
            }
        };
        let grown = unsafe { run(control, |control| Ok(system.grow(Seed(seed), control)?)) }?;
        let derivation = grown.report.derivation;
        let told = tree_turtle_report {
            n_steps: derivation.modules.len().saturating_sub(1) as u64,
            n_produced: derivation.n_produced(),
            ..tree_turtle_report::of(&grown.report.turtle)
        };
        unsafe { view(report, "report", &told) }?;
        if let Some(word) = word {
            word.put(tree_word::derived(grown.word, grammar, derivation.modules));
        }
        if let Some(trace) = trace {
            trace.put(tree_turtle_trace::new(&grown.polygons, grown.report.turtle));
        }
        place.put(tree_tree::new(grown.tree));
        Ok(())
    })
}
