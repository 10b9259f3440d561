//! Operations and functions.

use tree_core::Seed;

/// One step of an expression: it takes values from the top of a stack and leaves one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Op {
    Value(f64),
    Param(u16),
    /// Number of the derivation, from 1.
    Step,
    /// Number of derivations asked for.
    Steps,
    Unary(Unary),
    Binary(Binary),
    /// A random number; the second is the number of the draw within the grammar.
    Draw(Draw, u32),
    /// Jumps with 0 when the top is 0, or else takes it away.
    And(u32),
    /// Jumps with 1 when the top is not 0, or else takes it away.
    Or(u32),
    /// Takes the top away, and jumps when it was 0.
    If(u32),
    Jump(u32),
    /// Makes 1 of all that is not 0.
    Truth,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unary {
    Neg,
    Not,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Sqrt,
    Abs,
    Floor,
    Ceil,
    Round,
    Sign,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Mod,
    Pow,
    Lt,
    Le,
    Gt,
    Ge,
    Eq,
    Ne,
    Min,
    Max,
    Atan2,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Draw {
    /// Uniform in [0, 1).
    Rand,
    /// Uniform in [0, x).
    Ran,
    /// Normal with mean and standard deviation.
    Nran,
}

/// What a name before parentheses calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Unary(Unary),
    Binary(Binary),
    Draw(Draw),
    If,
}

impl Function {
    pub(crate) fn n_arguments(self) -> u8 {
        match self {
            Self::Draw(Draw::Rand) => 0,
            Self::Unary(_) | Self::Draw(Draw::Ran) => 1,
            Self::Binary(_) | Self::Draw(Draw::Nran) => 2,
            Self::If => 3,
        }
    }
}

/// The functions by name.
pub(crate) const FUNCTIONS: [(&str, Function); 27] = [
    ("sin", Function::Unary(Unary::Sin)),
    ("cos", Function::Unary(Unary::Cos)),
    ("tan", Function::Unary(Unary::Tan)),
    ("asin", Function::Unary(Unary::Asin)),
    ("acos", Function::Unary(Unary::Acos)),
    ("atan", Function::Unary(Unary::Atan)),
    ("atan2", Function::Binary(Binary::Atan2)),
    ("exp", Function::Unary(Unary::Exp)),
    ("log", Function::Unary(Unary::Log)),
    ("ln", Function::Unary(Unary::Log)),
    ("sqrt", Function::Unary(Unary::Sqrt)),
    ("abs", Function::Unary(Unary::Abs)),
    ("fabs", Function::Unary(Unary::Abs)),
    ("floor", Function::Unary(Unary::Floor)),
    ("ceil", Function::Unary(Unary::Ceil)),
    ("round", Function::Unary(Unary::Round)),
    ("sign", Function::Unary(Unary::Sign)),
    ("sgn", Function::Unary(Unary::Sign)),
    ("min", Function::Binary(Binary::Min)),
    ("max", Function::Binary(Binary::Max)),
    ("pow", Function::Binary(Binary::Pow)),
    ("mod", Function::Binary(Binary::Mod)),
    ("ran", Function::Draw(Draw::Ran)),
    ("nran", Function::Draw(Draw::Nran)),
    ("rand", Function::Draw(Draw::Rand)),
    ("if", Function::If),
    ("cond", Function::If),
];

/// The function of this name.
pub(crate) fn function(name: &str) -> Option<Function> {
    FUNCTIONS.iter().find(|(known, _)| *known == name).map(|&(_, function)| function)
}

impl Unary {
    pub(crate) fn apply(self, x: f64) -> f64 {
        match self {
            Self::Neg => -x,
            Self::Not => truth(x == 0.0),
            Self::Sin => sin_degrees(x),
            Self::Cos => sin_degrees(x % 360.0 + 90.0),
            Self::Tan => {
                let cos = sin_degrees(x % 360.0 + 90.0);
                sin_degrees(x) / cos
            }
            Self::Asin => libm::asin(x).to_degrees(),
            Self::Acos => libm::acos(x).to_degrees(),
            Self::Atan => libm::atan(x).to_degrees(),
            Self::Exp => libm::exp(x),
            Self::Log => libm::log(x),
            Self::Sqrt => x.sqrt(),
            Self::Abs => x.abs(),
            Self::Floor => x.floor(),
            Self::Ceil => x.ceil(),
            Self::Round => x.round(),
            Self::Sign => truth(x > 0.0) - truth(x < 0.0),
        }
    }
}

impl Binary {
    #[inline]
    pub(crate) fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
            Self::Mod => a % b,
            Self::Pow => libm::pow(a, b),
            Self::Lt => truth(a < b),
            Self::Le => truth(a <= b),
            Self::Gt => truth(a > b),
            Self::Ge => truth(a >= b),
            Self::Eq => truth(a == b),
            Self::Ne => truth(a != b),
            // f64::min leaves open which of two zeros it gives.
            Self::Min => {
                if b < a {
                    b
                } else {
                    a
                }
            }
            Self::Max => {
                if b > a {
                    b
                } else {
                    a
                }
            }
            Self::Atan2 => libm::atan2(a, b).to_degrees(),
        }
    }

    /// What the operation is called in messages.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Sub => "-",
            Self::Mul => "*",
            Self::Div => "/",
            Self::Mod => "%",
            Self::Pow => "^",
            Self::Lt => "<",
            Self::Le => "<=",
            Self::Gt => ">",
            Self::Ge => ">=",
            Self::Eq => "==",
            Self::Ne => "!=",
            Self::Min => "min",
            Self::Max => "max",
            Self::Atan2 => "atan2",
        }
    }
}

impl Draw {
    /// The number of this stream. `a` and `b` are the arguments, 0 where there are fewer.
    pub(crate) fn apply(self, a: f64, b: f64, stream: Seed) -> f64 {
        match self {
            Self::Rand => unit(stream),
            Self::Ran => a * unit(stream),
            Self::Nran => {
                // Box and Muller 1958. 1 - u lies in (0, 1]: its logarithm is finite.
                let radius = (-2.0 * libm::log(1.0 - unit(stream.child(0)))).sqrt();
                a + b * radius * sin_degrees(360.0 * unit(stream.child(1)))
            }
        }
    }
}

/// A number in [0, 1) with the 53 bits that an f64 holds.
#[inline]
pub(crate) fn unit(stream: Seed) -> f64 {
    (stream.0 >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
}

/// The sine of degrees, exact at whole quarters of a turn.
fn sin_degrees(x: f64) -> f64 {
    let x = x % 360.0;
    if x % 90.0 == 0.0 {
        match (x / 90.0) as i32 {
            1 | -3 => 1.0,
            3 | -1 => -1.0,
            _ => 0.0,
        }
    } else {
        libm::sin(x.to_radians())
    }
}

fn truth(is: bool) -> f64 {
    if is { 1.0 } else { 0.0 }
}
