//! Productions in the form in which they run.

use crate::lsystem::expr::{Env, Expr, Fault};
use crate::lsystem::{Kind, Symbols};

/// What a module is replaced by: its kinds, and its parameters as numbers with those computed marked.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Successor {
    pub(crate) kinds: Vec<Kind>,
    /// All parameters; 0 where an expression gives the value.
    pub(crate) values: Vec<f64>,
    /// Places in `values` with their expressions.
    pub(crate) computed: Vec<(u32, Expr)>,
}

impl Successor {
    /// Adds a module.
    pub(crate) fn push(&mut self, kind: Kind, params: Vec<Expr>) {
        self.kinds.push(kind);
        for param in params {
            let value = param.constant();
            if value.is_none() {
                self.computed.push((self.values.len() as u32, param));
            }
            self.values.push(value.unwrap_or(0.0));
        }
    }

    /// Writes the parameters at the end of a column.
    #[inline]
    pub(crate) fn write_params(
        &self,
        frame: &[f64],
        env: &Env,
        stack: &mut Vec<f64>,
        column: &mut Vec<f64>,
    ) -> Result<(), Fault> {
        let start = column.len();
        column.extend_from_slice(&self.values);
        let Some(written) = column.get_mut(start..) else { return Ok(()) };
        for (place, expr) in &self.computed {
            let value = expr.eval(frame, env, stack)?;
            if let Some(slot) = written.get_mut(*place as usize) {
                *slot = value;
            }
        }
        Ok(())
    }
}

/// One part of a context.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Item {
    /// A module of this kind.
    Module(Kind),
    /// A branch with so many items before its end.
    Open(usize),
    /// The end of a branch.
    Close,
}

/// A production.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Rule {
    /// Its label, or "production 3".
    pub(crate) name: String,
    pub(crate) line: usize,
    pub(crate) kind: Kind,
    /// Left context, nearest module first.
    pub(crate) left: Vec<Kind>,
    pub(crate) right: Vec<Item>,
    /// Whether an expression uses parameters of the context.
    pub(crate) gathers: bool,
    pub(crate) condition: Option<Expr>,
    pub(crate) weight: Option<Expr>,
    pub(crate) successor: Successor,
}

impl Rule {
    pub(crate) fn has_context(&self) -> bool {
        !self.left.is_empty() || !self.right.is_empty()
    }
}

/// What happens to the modules of a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// They stay.
    Keep,
    /// This rule applies, whatever the module.
    Always(u16),
    /// The rules of this range of the order are tried.
    Choose(u32, u32),
}

/// What a reader of words needs to know about a kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) action: Action,
    /// Number of parameters.
    pub(crate) arity: u16,
    /// Modules that it becomes, where there is no choice.
    pub(crate) n_modules: u32,
    /// Parameters of those.
    pub(crate) n_params: u32,
}

/// The rules of one section.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Rules {
    rules: Vec<Rule>,
    rows: Vec<Row>,
    /// Rules by kind: those with a context first, else as in the text.
    order: Vec<u16>,
    depth: u32,
}

impl Row {
    /// The same kind where a rule applies.
    #[inline]
    fn of(self, number: u16, rule: &Rule) -> Self {
        let Successor { kinds, values, .. } = &rule.successor;
        let (n_modules, n_params) = (kinds.len() as u32, values.len() as u32);
        Self { action: Action::Always(number), n_modules, n_params, ..self }
    }
}

/// The most rules of a section; their numbers are kept in 16 bits, one of which means none.
pub(crate) const MOST_RULES: usize = 65_000;

impl Rules {
    pub(crate) fn new(rules: Vec<Rule>, symbols: &Symbols, depth: u32) -> Self {
        let mut order: Vec<u16> = (0..rules.len()).map(|i| i as u16).collect();
        order.sort_by_key(|&i| {
            let rule = &rules[usize::from(i)];
            (rule.kind, !rule.has_context())
        });
        let keep = |kind| {
            let arity = symbols.arity(Kind(kind as u16)) as u16;
            Row { action: Action::Keep, arity, n_modules: 1, n_params: arity.into() }
        };
        let mut all =
            Self { rows: (0..symbols.len()).map(keep).collect(), rules, order: Vec::new(), depth };
        let mut start = 0;
        let kind = |i: u16| all.rules.get(usize::from(i)).map(|rule| rule.kind);
        for run in order.chunk_by(|&a, &b| kind(a) == kind(b)) {
            let end = start + run.len() as u32;
            if let Some((&first, rule)) = run.first().zip(all.rules.get(usize::from(run[0]))) {
                let row = &mut all.rows[usize::from(rule.kind.0)];
                if rule.has_context() || rule.condition.is_some() || rule.weight.is_some() {
                    row.action = Action::Choose(start, end);
                } else {
                    *row = row.of(first, rule);
                }
            }
            start = end;
        }
        all.order = order;
        all
    }

    /// What is known about a kind; kinds that the symbols lack stay.
    #[inline]
    pub(crate) fn row(&self, kind: Kind) -> Row {
        const UNKNOWN: Row = Row { action: Action::Keep, arity: 0, n_modules: 1, n_params: 0 };
        self.rows.get(usize::from(kind.0)).copied().unwrap_or(UNKNOWN)
    }

    /// The row of a module for which this rule was chosen; one that is not there lets it stay.
    #[inline]
    pub(crate) fn row_of_choice(&self, choice: u16, row: Row) -> Row {
        match self.rule(choice) {
            Some(rule) => row.of(choice, rule),
            None => Row { action: Action::Keep, ..row },
        }
    }

    pub(crate) fn rules(&self) -> &[Rule] {
        &self.rules
    }

    /// How often the rules are applied to what they give.
    pub(crate) fn depth(&self) -> u32 {
        self.depth
    }

    pub(crate) fn rule(&self, rule: u16) -> Option<&Rule> {
        self.rules.get(usize::from(rule))
    }

    /// The rules to be tried, in order.
    #[inline]
    pub(crate) fn candidates(&self, start: u32, end: u32) -> &[u16] {
        self.order.get(start as usize..end as usize).unwrap_or_default()
    }

    /// Whether any rule has a context.
    pub(crate) fn have_contexts(&self) -> bool {
        self.rules.iter().any(Rule::has_context)
    }
}
