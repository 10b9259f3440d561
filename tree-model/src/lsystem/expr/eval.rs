//! Evaluation.

use super::Expr;
use super::ops::{Binary, Op, Unary, unit};
use tree_core::Seed;

/// What an expression may ask for besides parameters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Env {
    /// Number of the derivation, from 1.
    pub(crate) step: f64,
    /// Number of derivations asked for.
    pub(crate) steps: f64,
    /// Stream of this pass over the word.
    pub(crate) stream: Seed,
    /// Index of the module in the word.
    pub(crate) module: u64,
}

impl Env {
    /// The number in [0, 1) by which this module chooses among productions.
    #[inline]
    pub(crate) fn choice(&self) -> f64 {
        unit(self.stream.child(self.module))
    }
}

/// An operation without a finite result, described.
#[derive(Debug, PartialEq)]
pub(crate) struct Fault(pub(crate) Box<str>);

impl Expr {
    /// The value with these parameters. The stack is scratch space.
    ///
    /// # Errors
    /// The first operation whose result is not finite.
    #[inline]
    pub(crate) fn eval(
        &self,
        frame: &[f64],
        env: &Env,
        stack: &mut Vec<f64>,
    ) -> Result<f64, Fault> {
        match self {
            Self::Value(value) => Ok(*value),
            Self::Param(slot) => Ok(param(frame, *slot)),
            Self::With(slot, op, value) => binary(*op, param(frame, *slot), *value),
            Self::Pair(a, op, b) => binary(*op, param(frame, *a), param(frame, *b)),
            Self::Ops(ops) => run(ops, frame, env, stack),
        }
    }
}

#[inline]
fn param(frame: &[f64], slot: u16) -> f64 {
    // Slots are given when the grammar is read, so they are there; NaN would be reported as a fault.
    frame.get(usize::from(slot)).copied().unwrap_or(f64::NAN)
}

#[inline]
fn binary(op: Binary, a: f64, b: f64) -> Result<f64, Fault> {
    let value = op.apply(a, b);
    if value.is_finite() { Ok(value) } else { Err(binary_fault(op, a, b, value)) }
}

#[cold]
fn binary_fault(op: Binary, a: f64, b: f64, value: f64) -> Fault {
    Fault(match op {
        Binary::Div | Binary::Mod if b == 0.0 => "division by zero".into(),
        Binary::Min | Binary::Max | Binary::Atan2 => {
            format!("{}({a}, {b}) is {value}", op.sign()).into()
        }
        _ => format!("{a} {} {b} is {value}", op.sign()).into(),
    })
}

#[inline]
fn unary(op: Unary, x: f64) -> Result<f64, Fault> {
    let value = op.apply(x);
    if value.is_finite() { Ok(value) } else { Err(unary_fault(op, x, value)) }
}

#[cold]
fn unary_fault(op: Unary, x: f64, value: f64) -> Fault {
    Fault(format!("{}({x}) is {value}", format!("{op:?}").to_lowercase()).into())
}

fn run(ops: &[Op], frame: &[f64], env: &Env, stack: &mut Vec<f64>) -> Result<f64, Fault> {
    stack.clear();
    let mut at = 0;
    while let Some(op) = ops.get(at) {
        at += 1;
        match *op {
            Op::Value(value) => stack.push(value),
            Op::Param(slot) => stack.push(param(frame, slot)),
            Op::Step => stack.push(env.step),
            Op::Steps => stack.push(env.steps),
            Op::Unary(op) => {
                let x = pop(stack);
                stack.push(unary(op, x)?);
            }
            Op::Binary(op) => {
                let b = pop(stack);
                let a = pop(stack);
                stack.push(binary(op, a, b)?);
            }
            Op::Draw(draw, number) => {
                let n = super::ops::Function::Draw(draw).n_arguments();
                let b = if n == 2 { pop(stack) } else { 0.0 };
                let a = if n >= 1 { pop(stack) } else { 0.0 };
                let stream = env.stream.child(env.module).child(1 + u64::from(number));
                let value = draw.apply(a, b, stream);
                if !value.is_finite() {
                    return Err(Fault(format!("a random number is {value}").into()));
                }
                stack.push(value);
            }
            Op::And(target) | Op::Or(target) => {
                let is_true = pop(stack) != 0.0;
                if is_true == matches!(op, Op::Or(_)) {
                    stack.push(if is_true { 1.0 } else { 0.0 });
                    at = target as usize;
                }
            }
            Op::If(target) => {
                if pop(stack) == 0.0 {
                    at = target as usize;
                }
            }
            Op::Jump(target) => at = target as usize,
            Op::Truth => {
                let x = pop(stack);
                stack.push(if x == 0.0 { 0.0 } else { 1.0 });
            }
        }
    }
    Ok(pop(stack))
}

#[inline]
fn pop(stack: &mut Vec<f64>) -> f64 {
    // The compiler balances the stack; NaN would be reported as a fault.
    stack.pop().unwrap_or(f64::NAN)
}
