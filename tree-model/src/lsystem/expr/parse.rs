//! From text to operations, with explicit stacks: nothing recurses.

use super::Expr;
use super::ops::{Binary, Draw, FUNCTIONS, Function, Op, Unary, function};
use crate::error::Result;
use crate::lsystem::text::{Cursor, did_you_mean};
use std::collections::BTreeMap;

/// Open parentheses and waiting operators of one expression, at most. Deeper ones are machine-made.
const MOST_DEPTH: usize = 256;

/// Names in a hint, at most.
const MOST_PROPOSED: usize = 8;

/// What names mean in an expression.
pub(crate) struct Scope<'a> {
    /// Constants by name.
    pub(crate) constants: &'a BTreeMap<String, f64>,
    /// Parameters by name, with their places in the frame.
    pub(crate) params: &'a [(&'a str, u16)],
    /// How many random numbers the grammar draws so far.
    pub(crate) draws: &'a mut u32,
}

/// Number of the derivation at work, from 1 (Lluch et al. 2010).
const STEP: &str = "itNum";
/// Number of derivations asked for (Lluch et al. 2010).
const STEPS: &str = "maxIt";

/// What waits on the stack of operators.
enum Pending {
    Prefix(Unary, u8),
    Infix(Binary, u8),
    /// `&&` or `||` with the place of its jump.
    Logic(usize, u8),
    Paren,
    Call {
        function: Function,
        at: usize,
        n_arguments: u8,
        jump: usize,
    },
}

/// Strength of prefix minus: weaker than `^`, so -2^2 is -4.
const PREFIX: u8 = 8;
/// Strength of the word `not`: weaker than a comparison.
const NOT: u8 = 3;

/// Operators between operands, longer ones first, with their strengths.
const INFIX: [(&str, Binary, u8); 18] = [
    ("<=", Binary::Le, 5),
    (">=", Binary::Ge, 5),
    ("==", Binary::Eq, 4),
    ("!=", Binary::Ne, 4),
    ("<", Binary::Lt, 5),
    (">", Binary::Gt, 5),
    ("=", Binary::Eq, 4),
    ("≤", Binary::Le, 5),
    ("≥", Binary::Ge, 5),
    ("≠", Binary::Ne, 4),
    ("+", Binary::Add, 6),
    ("-", Binary::Sub, 6),
    ("−", Binary::Sub, 6),
    ("*", Binary::Mul, 7),
    ("/", Binary::Div, 7),
    ("%", Binary::Mod, 7),
    ("^", Binary::Pow, 9),
    ("∧", Binary::Pow, 9),
];

/// Reads an expression up to what cannot belong to it: a comma or parenthesis that it did not open, a
/// colon, or the end.
pub(crate) fn parse(cursor: &mut Cursor<'_>, scope: &mut Scope<'_>) -> Result<Expr> {
    let mut yard = Yard { ops: Vec::new(), fixed: 0, pending: Vec::new() };
    loop {
        while !yard.operand(cursor, scope)? {}
        loop {
            if cursor.peek() == Some(')') && yard.has_open() {
                cursor.eat(")");
                yard.close(cursor, scope)?;
            } else if cursor.peek() == Some(',') && yard.has_open() {
                yard.argument(cursor)?;
                break;
            } else if yard.operator(cursor)? {
                break;
            } else {
                return yard.finish(cursor);
            }
        }
    }
}

/// A hint for a name that has no meaning.
fn known(name: &str, scope: &Scope<'_>) -> String {
    let params = scope.params.iter().map(|&(param, _)| param);
    let constants = scope.constants.keys().map(String::as_str);
    let hint = did_you_mean(name, params.clone().chain(constants.clone()).chain([STEP, STEPS]));
    let names: Vec<&str> = params.chain(constants).take(MOST_PROPOSED).collect();
    if !hint.is_empty() {
        hint
    } else if names.is_empty() {
        "there are no constants and no formal parameters here".into()
    } else {
        format!("known are {}", names.join(", "))
    }
}

struct Yard {
    ops: Vec<Op>,
    /// Operations before this one are the target of a jump, and are not folded.
    fixed: usize,
    pending: Vec<Pending>,
}

impl Yard {
    /// Reads what stands where an operand may; true when it is complete.
    fn operand(&mut self, cursor: &mut Cursor<'_>, scope: &mut Scope<'_>) -> Result<bool> {
        let next = cursor.peek();
        let at = cursor.at();
        if let Some(value) = cursor.number()? {
            self.ops.push(Op::Value(value));
            return Ok(true);
        }
        match next {
            Some('(') => {
                cursor.eat("(");
                self.push(cursor, Pending::Paren)?;
                Ok(false)
            }
            Some(c @ ('-' | '−' | '+' | '!')) => {
                cursor.go(at + c.len_utf8());
                match c {
                    '+' => {}
                    '!' => self.push(cursor, Pending::Prefix(Unary::Not, PREFIX))?,
                    _ => self.push(cursor, Pending::Prefix(Unary::Neg, PREFIX))?,
                }
                Ok(false)
            }
            _ => match cursor.name() {
                Some("not") => {
                    self.push(cursor, Pending::Prefix(Unary::Not, NOT))?;
                    Ok(false)
                }
                Some(name) => self.named(name, at, cursor, scope),
                None => Err(cursor.unexpected("a number, a name or '('")),
            },
        }
    }

    /// A parameter, a constant, or the beginning of a call.
    fn named(
        &mut self,
        name: &str,
        at: usize,
        cursor: &mut Cursor<'_>,
        scope: &mut Scope<'_>,
    ) -> Result<bool> {
        let calls = cursor.peek() == Some('(');
        if calls {
            return self.call(name, at, cursor, scope);
        }
        let param = scope.params.iter().find(|(param, _)| *param == name);
        if let Some(&(_, slot)) = param {
            self.ops.push(Op::Param(slot));
        } else if let Some(&value) = scope.constants.get(name) {
            self.ops.push(Op::Value(value));
        } else if name == STEP {
            self.ops.push(Op::Step);
        } else if name == STEPS {
            self.ops.push(Op::Steps);
        } else if name == "rand" {
            self.draw(Draw::Rand, scope);
        } else if function(name).is_some() {
            let hint = format!("write {name}(...)");
            return Err(cursor.error_at(
                at,
                format!("the function '{name}' lacks its arguments"),
                hint,
            ));
        } else {
            return Err(cursor.error_at(
                at,
                format!("nothing is named '{name}'"),
                known(name, scope),
            ));
        }
        Ok(true)
    }

    fn call(
        &mut self,
        name: &str,
        at: usize,
        cursor: &mut Cursor<'_>,
        scope: &mut Scope<'_>,
    ) -> Result<bool> {
        let Some(function) = function(name) else {
            let hint = did_you_mean(name, FUNCTIONS.iter().map(|&(known, _)| known));
            return Err(cursor.error_at(at, format!("there is no function '{name}'"), hint));
        };
        cursor.eat("(");
        if function == Function::Draw(Draw::Rand) {
            cursor.expect(")")?;
            self.draw(Draw::Rand, scope);
            return Ok(true);
        }
        self.push(cursor, Pending::Call { function, at, n_arguments: 1, jump: 0 })?;
        Ok(false)
    }

    fn push(&mut self, cursor: &Cursor<'_>, pending: Pending) -> Result<()> {
        if self.pending.len() >= MOST_DEPTH {
            let problem = format!("the expression is nested more than {MOST_DEPTH} deep");
            return Err(cursor.error(problem, "name a part of it with '#define'"));
        }
        self.pending.push(pending);
        Ok(())
    }

    fn has_open(&self) -> bool {
        let is_open = |p: &Pending| matches!(p, Pending::Paren | Pending::Call { .. });
        self.pending.iter().any(is_open)
    }

    /// Reads an operator; false when there is none.
    fn operator(&mut self, cursor: &mut Cursor<'_>) -> Result<bool> {
        cursor.peek();
        for (words, is_and, strength) in
            [(["&&", "&", "and"], true, 2), (["||", "|", "or"], false, 1)]
        {
            let Some(word) = words.into_iter().find(|word| cursor.rest().starts_with(word)) else {
                continue;
            };
            cursor.eat(word);
            self.reduce(strength);
            let jump = self.ops.len();
            self.ops.push(if is_and { Op::And(0) } else { Op::Or(0) });
            self.fixed = self.ops.len();
            self.push(cursor, Pending::Logic(jump, strength))?;
            return Ok(true);
        }
        let Some(&(sign, op, strength)) =
            INFIX.iter().find(|(sign, ..)| cursor.rest().starts_with(sign))
        else {
            return Ok(false);
        };
        cursor.eat(sign);
        // a^b^c is a^(b^c); all others group from the left.
        self.reduce(if op == Binary::Pow { strength + 1 } else { strength });
        self.push(cursor, Pending::Infix(op, strength))?;
        Ok(true)
    }

    /// Emits what waits with at least this strength, down to the last open parenthesis.
    fn reduce(&mut self, strength: u8) {
        while let Some(top) = self.pending.last() {
            match *top {
                Pending::Prefix(op, s) if s >= strength => self.unary(op),
                Pending::Infix(op, s) if s >= strength => self.binary(op),
                Pending::Logic(jump, s) if s >= strength => {
                    self.ops.push(Op::Truth);
                    self.land(jump);
                }
                _ => return,
            }
            self.pending.pop();
        }
    }

    /// Lets the jump at this place end here.
    fn land(&mut self, jump: usize) {
        let here = self.ops.len() as u32;
        self.fixed = self.ops.len();
        if let Some(Op::And(target) | Op::Or(target) | Op::If(target) | Op::Jump(target)) =
            self.ops.get_mut(jump)
        {
            *target = here;
        }
    }

    /// A comma between arguments.
    fn argument(&mut self, cursor: &mut Cursor<'_>) -> Result<()> {
        self.reduce(0);
        let Some(Pending::Call { function, at, n_arguments, jump }) = self.pending.last_mut()
        else {
            return Err(cursor.error("',' in parentheses that belong to no function", ""));
        };
        if *n_arguments >= function.n_arguments() {
            let problem = format!("too many arguments, {} are needed", function.n_arguments());
            return Err(cursor.error_at(*at, problem, ""));
        }
        *n_arguments += 1;
        if *function == Function::If {
            let before = std::mem::replace(jump, self.ops.len());
            if *n_arguments == 2 {
                self.ops.push(Op::If(0));
                self.fixed = self.ops.len();
            } else {
                self.ops.push(Op::Jump(0));
                self.land(before);
            }
        }
        cursor.eat(",");
        Ok(())
    }

    /// A closing parenthesis.
    fn close(&mut self, cursor: &Cursor<'_>, scope: &mut Scope<'_>) -> Result<()> {
        self.reduce(0);
        let Some(Pending::Call { function, at, n_arguments, jump }) = self.pending.pop() else {
            return Ok(());
        };
        if n_arguments < function.n_arguments() {
            let problem =
                format!("{n_arguments} argument(s), {} are needed", function.n_arguments());
            return Err(cursor.error_at(at, problem, ""));
        }
        match function {
            Function::Unary(op) => self.unary(op),
            Function::Binary(op) => self.binary(op),
            Function::Draw(draw) => self.draw(draw, scope),
            Function::If => self.land(jump),
        }
        Ok(())
    }

    fn draw(&mut self, draw: Draw, scope: &mut Scope<'_>) {
        self.ops.push(Op::Draw(draw, *scope.draws));
        *scope.draws += 1;
    }

    fn unary(&mut self, op: Unary) {
        if let Some((Op::Value(value), before)) =
            self.ops.split_last_mut().map(|(l, b)| (l, b.len()))
            && before >= self.fixed
            && op.apply(*value).is_finite()
        {
            *value = op.apply(*value);
        } else {
            self.ops.push(Op::Unary(op));
        }
    }

    fn binary(&mut self, op: Binary) {
        if let [before @ .., Op::Value(a), Op::Value(b)] = &self.ops[..]
            && before.len() >= self.fixed
            && op.apply(*a, *b).is_finite()
        {
            let (n, value) = (before.len(), op.apply(*a, *b));
            self.ops.truncate(n);
            self.ops.push(Op::Value(value));
        } else {
            self.ops.push(Op::Binary(op));
        }
    }

    fn finish(mut self, cursor: &mut Cursor<'_>) -> Result<Expr> {
        self.reduce(0);
        if self.pending.is_empty() {
            return Ok(Expr::new(self.ops));
        }
        Err(cursor.unexpected("an operator or ')'"))
    }
}
