//! One production: `label: left < predecessor > right : condition -(weight)-> successor : weight`.

use super::modules::{self, Formal, Use};
use super::rules::{Item, MOST_RULES, Rule, Successor};
use super::settings::{Section, Settings};
use crate::error::Result;
use crate::lsystem::expr::{self, Expr, Scope};
use crate::lsystem::text::{Cursor, Source, find_arrow};
use crate::lsystem::{Kind, Symbols};
use std::ops::Range;

/// Branches within branches of a right context, at most: they are matched by recursion.
const DEEPEST_CONTEXT: usize = 16;
/// Parameters of a predecessor and its contexts together, at most.
const MOST_FORMALS: usize = 1024;

/// Reads the axiom and the productions, one after another.
pub(super) struct Reader<'a> {
    source: &'a Source<'a>,
    settings: &'a Settings,
    symbols: Symbols,
    uses: Vec<Use>,
    predecessors: Vec<(Kind, String)>,
    draws: u32,
}

/// What stands before the arrow.
struct Head<'a> {
    name: String,
    kind: Kind,
    left: Vec<Kind>,
    right: Vec<Item>,
    params: Vec<(&'a str, u16)>,
    condition: Option<Expr>,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: &'a Source<'a>, settings: &'a Settings, symbols: Symbols) -> Self {
        Self { source, settings, symbols, uses: Vec::new(), predecessors: Vec::new(), draws: 0 }
    }

    pub(super) fn into_symbols(self) -> Symbols {
        self.symbols
    }

    /// Compares numbers of parameters, once all is read.
    pub(super) fn check_arities(&self) -> Result<()> {
        super::arity::check(self.source, &self.symbols, self.predecessors.iter(), &self.uses)
    }

    pub(super) fn axiom(&mut self, part: Range<usize>) -> Result<Successor> {
        let mut cursor = Cursor::new(self.source, part);
        let word = self.successor(&mut cursor, &[])?;
        cursor.finish()?;
        if word.kinds.is_empty() {
            return Err(cursor.error("the axiom is empty", "write the word to begin with"));
        }
        Ok(word)
    }

    pub(super) fn production(&mut self, part: Range<usize>, section: Section) -> Result<Rule> {
        let mut cursor = Cursor::new(self.source, part);
        let (start, line) = (cursor.at(), cursor.line(cursor.at()));
        let (arrow, n) = find_arrow(cursor.rest()).unwrap_or_default();
        if self.predecessors.len() >= MOST_RULES {
            return Err(cursor.error(format!("more than {MOST_RULES} productions"), ""));
        }
        let head = cursor.until(start + arrow);
        let cut = weight_before_arrow(head.rest());
        let head_part = head.until(cut.map_or(start + arrow, |cut| start + cut.head));
        let number = self.predecessors.len() + 1;
        let Head { name, kind, left, right, params, condition } = self.head(head_part, number)?;
        if section != Section::Productions && !(left.is_empty() && right.is_empty()) {
            return Err(cursor.error("a context outside the productions", "leave it out"));
        }
        let mut weight = None;
        if let Some(cut) = cut {
            let mut weight_part = Cursor::new(self.source, start + cut.from..start + cut.to);
            weight = Some(self.expression(&mut weight_part, &params)?);
            weight_part.finish()?;
        }
        cursor.go(start + arrow + n);
        let successor = self.successor(&mut cursor, &params)?;
        if cursor.peek() == Some(':') {
            if weight.is_some() {
                return Err(cursor.error("a second probability", "keep one"));
            }
            cursor.eat(":");
            weight = Some(self.expression(&mut cursor, &params)?);
        }
        cursor.finish()?;
        let n_own = self.symbols.arity(kind);
        let rule = Rule {
            name,
            line,
            kind,
            gathers: params.len() > n_own,
            left,
            right,
            condition,
            weight,
            successor,
        };
        self.predecessors.push(super::arity::entry(&rule));
        Ok(rule)
    }

    fn head(&mut self, mut cursor: Cursor<'a>, number: usize) -> Result<Head<'a>> {
        let colons = colons(cursor.rest());
        let start = cursor.at();
        let mut name = format!("production {number}");
        let pattern_end = match colons[..] {
            [] => None,
            [one] if self.is_label(&cursor, one) => {
                name = label(&mut cursor, start + one);
                None
            }
            [one] => Some(start + one),
            [one, two] => {
                name = label(&mut cursor, start + one);
                Some(start + two)
            }
            [_, _, three, ..] => {
                let problem = "a third ':' before the arrow";
                let hint = "a label, a predecessor and a condition are divided by ':'";
                return Err(cursor.error_at(start + three, problem, hint));
            }
        };
        let mut pattern = pattern_end.map_or_else(|| cursor.clone(), |end| cursor.until(end));
        let (kind, left, right, params) = self.pattern(&mut pattern)?;
        let mut condition = None;
        if let Some(end) = pattern_end {
            cursor.go(end + 1);
            if !cursor.eat("*") && !cursor.is_done() {
                condition = Some(self.expression(&mut cursor, &params)?);
            }
            cursor.finish()?;
        }
        Ok(Head { name, kind, left, right, params, condition })
    }

    /// Whether the only colon before the arrow ends a label and does not begin a condition. It ends a
    /// label if a single word stands before it, unless that is a symbol and a condition follows.
    fn is_label(&mut self, cursor: &Cursor<'a>, colon: usize) -> bool {
        let (before, after) = cursor.rest().split_at(colon);
        let before = before.trim();
        if before.is_empty() || !before.chars().all(|c| c.is_alphanumeric() || "_.'".contains(c)) {
            return false;
        }
        if self.symbols.first_name(before) != Some(before) {
            return true;
        }
        let mut condition = cursor.clone();
        condition.go(cursor.at() + colon + 1);
        if matches!(after.trim_start_matches(':').trim(), "" | "*") {
            return false;
        }
        self.expression(&mut condition, &[]).is_err() || !condition.is_done()
    }

    /// Reads `left < predecessor > right`.
    #[expect(clippy::type_complexity, reason = "taken apart at once")]
    fn pattern(
        &mut self,
        cursor: &mut Cursor<'a>,
    ) -> Result<(Kind, Vec<Kind>, Vec<Item>, Vec<(&'a str, u16)>)> {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        cursor.peek();
        let start = cursor.at();
        let mut strict = modules::formals(cursor, &self.symbols)?;
        if cursor.eat("<") {
            left = strict;
            strict = modules::formals(cursor, &self.symbols)?;
        }
        if cursor.eat(">") {
            right = modules::formals(cursor, &self.symbols)?;
        }
        cursor.finish()?;
        let own = match &strict[..] {
            [own] if !matches!(own.name, "[" | "]") => own,
            [own] => return Err(cursor.error_at(own.at, "a bracket cannot be replaced", "")),
            [] => return Err(cursor.error_at(start, "the production has no predecessor", "")),
            [_, second, ..] => {
                let problem = "a production replaces one module, here are more";
                let hint = "name contexts with '<' and '>', and symbols of several characters in '#symbols'";
                return Err(cursor.error_at(second.at, problem, hint));
            }
        };
        if let Some(bracket) = left.iter().find(|module| matches!(module.name, "[" | "]")) {
            let hint = "the left context is the way back to the root; branches lie on the right";
            return Err(cursor.error_at(bracket.at, "a bracket in a left context", hint));
        }
        // The nearest module comes first.
        left.reverse();
        let params = self.slots(cursor, std::iter::once(own).chain(&left).chain(&right))?;
        let kind = self.kind(cursor, own)?;
        let left = left.iter().map(|module| self.context(cursor, module)).collect::<Result<_>>()?;
        let right = self.items(cursor, &right)?;
        Ok((kind, left, right, params))
    }

    /// Numbers the formal parameters: the module's own, then those of its contexts.
    fn slots<'f>(
        &self,
        cursor: &Cursor<'_>,
        modules: impl Iterator<Item = &'f Formal<'a>>,
    ) -> Result<Vec<(&'a str, u16)>>
    where
        'a: 'f,
    {
        let all: Vec<(&str, usize)> = modules.flat_map(|module| &module.params).copied().collect();
        let mut sorted = all.clone();
        sorted.sort_unstable();
        let twice = sorted.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1]);
        if let Some((name, at)) = twice.min_by_key(|&(_, at)| at) {
            let problem = format!("the formal parameter '{name}' stands here twice");
            return Err(cursor.error_at(at, problem, "give each a name of its own"));
        }
        if let Some(&(_, at)) = all.get(MOST_FORMALS) {
            return Err(cursor.error_at(at, format!("more than {MOST_FORMALS} parameters"), ""));
        }
        Ok(all.into_iter().zip(0..).map(|((name, _), slot)| (name, slot)).collect())
    }

    fn kind(&mut self, cursor: &Cursor<'_>, module: &Formal<'_>) -> Result<Kind> {
        modules::intern(cursor, module.at, &mut self.symbols, module.name, module.params.len())
    }

    fn context(&mut self, cursor: &Cursor<'_>, module: &Formal<'_>) -> Result<Kind> {
        if !self.settings.sees(module.name) {
            let problem = format!("contexts ignore '{}', so this can never match", module.name);
            return Err(cursor.error_at(module.at, problem, "see 'ignore' and 'consider'"));
        }
        self.kind(cursor, module)
    }

    fn items(&mut self, cursor: &Cursor<'_>, modules: &[Formal<'_>]) -> Result<Vec<Item>> {
        let (mut items, mut open) = (Vec::with_capacity(modules.len()), Vec::new());
        for module in modules {
            match module.name {
                "[" if open.len() == DEEPEST_CONTEXT => {
                    let problem =
                        format!("a context with brackets more than {DEEPEST_CONTEXT} deep");
                    return Err(cursor.error_at(module.at, problem, ""));
                }
                "[" => {
                    open.push(items.len());
                    items.push(Item::Open(0));
                }
                "]" => {
                    if let Some(start) = open.pop() {
                        items[start] = Item::Open(items.len() - start - 1);
                    }
                    items.push(Item::Close);
                }
                _ => items.push(Item::Module(self.context(cursor, module)?)),
            }
        }
        Ok(items)
    }

    fn expression(&mut self, cursor: &mut Cursor<'_>, params: &[(&str, u16)]) -> Result<Expr> {
        let constants = &self.settings.constants;
        expr::parse(cursor, &mut Scope { constants, params, draws: &mut self.draws })
    }

    fn successor(&mut self, cursor: &mut Cursor<'_>, params: &[(&str, u16)]) -> Result<Successor> {
        let constants = &self.settings.constants;
        let mut scope = Scope { constants, params, draws: &mut self.draws };
        modules::successor(cursor, &mut self.symbols, &mut scope, &mut self.uses)
    }
}

/// Takes the label, and goes behind its colon.
fn label(cursor: &mut Cursor<'_>, colon: usize) -> String {
    let label = cursor.until(colon).rest().trim().to_owned();
    cursor.go(colon + 1);
    label
}

/// Bytes of the colons outside parentheses.
fn colons(head: &str) -> Vec<usize> {
    let mut depth = 0_usize;
    let mut found = Vec::new();
    for (i, c) in head.char_indices() {
        match c {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ':' if depth == 0 => found.push(i),
            _ => {}
        }
    }
    found
}

/// A probability between two strokes, as in `F -(.33)-> F` and `F -.33-> F`: where the predecessor ends,
/// and where the expression stands.
#[derive(Clone, Copy)]
struct Cut {
    head: usize,
    from: usize,
    to: usize,
}

/// Looks for a probability at the end of what stands before the arrow. White space must stand before its
/// first stroke where there is a condition, which could end in a subtraction.
fn weight_before_arrow(head: &str) -> Option<Cut> {
    let to = head.len();
    let from = if head.ends_with(')') {
        let mut depth = 0_usize;
        head.char_indices().rev().find_map(|(i, c)| {
            depth = match c {
                ')' => depth + 1,
                '(' => depth.saturating_sub(1),
                _ => depth,
            };
            (depth == 0).then_some(i)
        })?
    } else {
        let number = head.trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        if number.len() == to {
            return None;
        }
        number.len()
    };
    let before = head[..from].strip_suffix('-')?;
    let before = before.strip_suffix('-').unwrap_or(before);
    let is_alone = before.ends_with(char::is_whitespace) || colons(head).is_empty();
    (is_alone && !before.trim().is_empty()).then_some(Cut { head: before.len(), from, to })
}
