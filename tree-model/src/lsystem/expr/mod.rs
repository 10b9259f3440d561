//! Expressions: read once, compiled to a flat list of operations, evaluated for each module.
//!
//! A parser with explicit stacks (Dijkstra's shunting yard) emits operations in the order in which they
//! run; constants are folded on the way. `&&`, `||` and `if` jump over what they do not need, so
//! `x != 0 && 1/x > 2` divides by no zero. The commonest shapes (a number, a parameter, a parameter with a
//! number, two parameters) are evaluated without the list.
//!
//! Every operation must give a finite number: anything else is a fault that names the operation.

mod eval;
mod ops;
mod parse;

#[cfg(test)]
mod tests;

pub(super) use eval::{Env, Fault};
pub(super) use parse::Scope;
pub(super) use parse::parse;

use ops::{Binary, Op};

/// A compiled expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Expr {
    /// A number.
    Value(f64),
    /// A parameter by its place in the frame.
    Param(u16),
    /// A parameter with a number.
    With(u16, Binary, f64),
    /// Two parameters.
    Pair(u16, Binary, u16),
    /// Anything else.
    Ops(Box<[Op]>),
}

impl Expr {
    fn new(ops: Vec<Op>) -> Self {
        match ops[..] {
            [Op::Value(value)] => Self::Value(value),
            [Op::Param(slot)] => Self::Param(slot),
            [Op::Param(slot), Op::Value(value), Op::Binary(op)] => Self::With(slot, op, value),
            [Op::Value(value), Op::Param(slot), Op::Binary(op @ (Binary::Mul | Binary::Add))] => {
                Self::With(slot, op, value)
            }
            [Op::Param(a), Op::Param(b), Op::Binary(op)] => Self::Pair(a, op, b),
            _ => Self::Ops(ops.into()),
        }
    }

    /// The value, if it is a number in every module.
    pub(super) fn constant(&self) -> Option<f64> {
        if let Self::Value(value) = self { Some(*value) } else { None }
    }
}
