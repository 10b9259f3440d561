//! Words of a grammar's text: patterns with formal parameters, and successors with expressions.

use super::rules::Successor;
use crate::error::Result;
use crate::lsystem::Symbols;
use crate::lsystem::expr::{self, Expr, Scope};
use crate::lsystem::text::Cursor;

/// A module of a predecessor or a context.
pub(super) struct Formal<'a> {
    pub(super) name: &'a str,
    pub(super) at: usize,
    /// Names of its parameters and where they stand.
    pub(super) params: Vec<(&'a str, usize)>,
}

/// Reads modules with formal parameters up to what is none. Brackets are modules without parameters, and
/// `*` alone is no module.
pub(super) fn formals<'a>(cursor: &mut Cursor<'a>, symbols: &Symbols) -> Result<Vec<Formal<'a>>> {
    let mut modules = Vec::new();
    if cursor.eat("*") {
        return Ok(modules);
    }
    while !matches!(cursor.peek(), None | Some('<' | '>' | ':')) {
        let at = cursor.at();
        let Some(name) = cursor.symbol(symbols)? else { break };
        let mut params = Vec::new();
        if cursor.eat("(") {
            loop {
                cursor.peek();
                let at = cursor.at();
                match cursor.name() {
                    Some(param) => params.push((param, at)),
                    None if cursor.peek().is_some_and(|c| c.is_ascii_digit()) => {
                        let hint = "name the parameter, and compare it in a condition";
                        return Err(cursor.error("a number in a predecessor", hint));
                    }
                    None => return Err(cursor.unexpected("the name of a formal parameter")),
                }
                if !cursor.eat(",") {
                    break;
                }
            }
            cursor.expect(")")?;
        }
        modules.push(Formal { name, at, params });
    }
    Ok(modules)
}

/// A module of an axiom or successor, for the comparison of numbers of parameters.
pub(super) struct Use {
    pub(super) kind: crate::lsystem::Kind,
    pub(super) at: usize,
}

/// Reads modules with expressions up to a colon or the end.
pub(super) fn successor(
    cursor: &mut Cursor<'_>,
    symbols: &mut Symbols,
    scope: &mut Scope<'_>,
    uses: &mut Vec<Use>,
) -> Result<Successor> {
    let mut word = Successor::default();
    loop {
        if cursor.eat("ε") {
            continue;
        }
        if matches!(cursor.peek(), None | Some(':')) {
            return Ok(word);
        }
        let at = cursor.at();
        let Some(name) = cursor.symbol(symbols)? else { return Ok(word) };
        let params = arguments(cursor, scope)?;
        let kind = intern(cursor, at, symbols, name, params.len())?;
        uses.push(Use { kind, at });
        word.push(kind, params);
    }
}

fn arguments(cursor: &mut Cursor<'_>, scope: &mut Scope<'_>) -> Result<Vec<Expr>> {
    let mut params = Vec::new();
    if !cursor.eat("(") {
        return Ok(params);
    }
    loop {
        params.push(expr::parse(cursor, scope)?);
        if !cursor.eat(",") {
            break;
        }
    }
    cursor.expect(")")?;
    Ok(params)
}

/// The kind of a module that stands at `at`.
pub(super) fn intern(
    cursor: &Cursor<'_>,
    at: usize,
    symbols: &mut Symbols,
    name: &str,
    n_params: usize,
) -> Result<crate::lsystem::Kind> {
    if matches!(name, "[" | "]") && n_params > 0 {
        return Err(cursor.error_at(at, "a bracket takes no parameters", ""));
    }
    symbols.intern(name, n_params).map_err(|error| cursor.error_at(at, error.to_string(), ""))
}
