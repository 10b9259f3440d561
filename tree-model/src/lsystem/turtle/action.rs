//! What each symbol tells the turtle.

use crate::lsystem::Symbols;

/// What a module does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// Nothing is known about the symbol.
    Skip,
    Push,
    Pop,
    /// `F`, `f` and `G`: whether wood is drawn, and whether a polygon gets a corner.
    Move {
        draw: bool,
        corner: bool,
    },
    /// `+ -`, `& ^` and `\ /`: the second of each turns the other way.
    Yaw(Way),
    Pitch(Way),
    Roll(Way),
    Around,
    Level,
    Thinner,
    Thicker,
    Elasticity,
    Color,
    Cut,
    Leaf,
    Open,
    Close,
    Corner,
}

/// Sense of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    On,
    Back,
}

/// The action of a kind and its number of parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    pub(super) action: Action,
    pub(super) arity: u8,
}

/// One row for each kind.
pub(super) fn table(symbols: &Symbols) -> Vec<Row> {
    let row = |index: usize| {
        let kind = crate::lsystem::Kind(index as u16);
        let (name, arity) = symbols.get(kind).unwrap_or_default();
        Row { action: action(name), arity: arity as u8 }
    };
    (0..symbols.len()).map(row).collect()
}

fn action(name: &str) -> Action {
    use Action::{Pitch, Roll, Yaw};
    match name {
        "[" => Action::Push,
        "]" => Action::Pop,
        "F" => Action::Move { draw: true, corner: true },
        "f" => Action::Move { draw: false, corner: true },
        "G" => Action::Move { draw: true, corner: false },
        "+" => Yaw(Way::On),
        // Papers are set with a minus sign; programs take a hyphen.
        "-" | "\u{2212}" => Yaw(Way::Back),
        "&" => Pitch(Way::On),
        "^" | "\u{2227}" => Pitch(Way::Back),
        "\\" => Roll(Way::On),
        "/" => Roll(Way::Back),
        "|" => Action::Around,
        "$" => Action::Level,
        "!" => Action::Thinner,
        "#" => Action::Thicker,
        "_" => Action::Elasticity,
        "'" => Action::Color,
        "%" => Action::Cut,
        "~" => Action::Leaf,
        "{" => Action::Open,
        "}" => Action::Close,
        "." => Action::Corner,
        _ => Action::Skip,
    }
}
