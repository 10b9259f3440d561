//! The turtle's way along a word: one pass, without recursion.

use super::action::{self, Action, Row, Way};
use super::frame::{Frame, Turn, Turns};
use super::params::TurtleParams;
use super::polygon::Outline;
use super::report::TurtleReport;
use crate::error::{ModelError, Result};
use crate::glam::DVec3;
use crate::lsystem::{Symbols, Word};
use tree_core::{Control, Resource};

/// How far the turtle may go from its start, in units: beyond it f64 no longer resolves an internode.
const REACH: f64 = 1e12;
/// Widest wood, in units.
const WIDTH_MAX: f64 = 1e12;
/// Modules between two looks at the cancel flag.
const CHECK_EVERY: usize = 1 << 14;

/// What a bracket saves.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) position: DVec3,
    pub(super) frame: Frame,
    pub(super) width: f64,
    elasticity: f64,
    pub(super) color: u32,
    /// The node that stands where the turtle last drew.
    pub(super) node: u32,
    /// Whether the turtle left that node without drawing.
    pub(super) away: bool,
}

/// What takes the turtle's drawing. `module` is the module at work, for errors.
pub(super) trait Sink {
    /// Wood from the turtle's position to `to`; answers with the node at its end.
    fn wood(&mut self, module: usize, turtle: &State, to: DVec3) -> Result<u32>;
    /// A leaf at the turtle's position.
    fn leaf(&mut self, module: usize, turtle: &State, size: f64, kind: f64) -> Result<()>;
    /// A closed polygon.
    fn polygon(&mut self, turtle: &State, outline: Outline) -> Result<()>;
    /// The word set a width.
    fn width(&mut self, width: f64);
}

/// Everything the walk holds.
struct Turtle<'a, S> {
    params: &'a TurtleParams,
    control: &'a Control,
    sink: &'a mut S,
    report: TurtleReport,
    turns: Turns,
    default_turn: Turn,
    state: State,
    /// Saved states, with the module of their bracket.
    stack: Vec<(usize, State)>,
    outlines: Vec<Outline>,
    /// Brackets open since a `%`; 0 when nothing is cut.
    cut: usize,
    tropism: DVec3,
}

/// Walks along a word.
pub(super) fn walk<S: Sink>(
    word: &Word,
    symbols: &Symbols,
    params: &TurtleParams,
    control: &Control,
    sink: &mut S,
) -> Result<TurtleReport> {
    params.validate()?;
    let table = action::table(symbols);
    let mut turtle = Turtle::new(params, control, sink);
    let mut unknown = vec![0_usize; table.len()];
    let (mut at, all) = (0, word.params());
    for (module, &kind) in word.kinds().iter().enumerate() {
        let fail = |problem: &str| ModelError::Word { module, problem: problem.into() };
        let row = table.get(usize::from(kind.0)).ok_or_else(|| fail("its kind is unknown"))?;
        let end = at + usize::from(row.arity);
        let given = all.get(at..end).ok_or_else(|| fail("the word lacks parameters for it"))?;
        at = end;
        if module % CHECK_EVERY == 0 {
            control.check()?;
        }
        if row.action == Action::Skip {
            unknown[usize::from(kind.0)] += 1;
        }
        turtle.step(module, *row, given)?;
    }
    turtle.finish()?;
    let mut report = turtle.report;
    report.modules = word.len();
    let met = (0_u16..).zip(&unknown).filter(|&(_, &n)| n > 0);
    let named = met.filter_map(|(i, &n)| Some((symbols.get(crate::lsystem::Kind(i))?.0, n)));
    for (name, n) in named {
        match report.skipped.iter_mut().find(|(known, _)| known == name) {
            Some((_, count)) => *count += n,
            None => report.skipped.push((name.to_owned(), n)),
        }
    }
    Ok(report)
}

impl<'a, S: Sink> Turtle<'a, S> {
    fn new(params: &'a TurtleParams, control: &'a Control, sink: &'a mut S) -> Self {
        let state = State {
            position: DVec3::ZERO,
            frame: Frame::START,
            width: params.width,
            elasticity: params.elasticity,
            color: 0,
            node: 0,
            away: false,
        };
        Self {
            params,
            control,
            sink,
            report: TurtleReport::default(),
            turns: Turns::new(),
            default_turn: Turn::degrees(params.angle),
            state,
            stack: Vec::new(),
            outlines: Vec::new(),
            cut: 0,
            tropism: params.tropism.as_dvec3(),
        }
    }

    fn step(&mut self, module: usize, row: Row, given: &[f64]) -> Result<()> {
        if self.cut > 0 && !self.uncut(row.action) {
            return Ok(());
        }
        match row.action {
            Action::Skip => {}
            Action::Push => return self.push(module),
            Action::Pop => return self.pop(module),
            Action::Move { draw, corner } => return self.advance(module, given, draw, corner),
            Action::Yaw(way) => {
                let turn = self.turn(given, way);
                self.state.frame.yaw(turn);
            }
            Action::Pitch(way) => {
                let turn = self.turn(given, way);
                self.state.frame.pitch(turn);
            }
            Action::Roll(way) => {
                let turn = self.turn(given, way);
                self.state.frame.roll(turn);
            }
            Action::Around => self.state.frame.around(),
            Action::Level => self.state.frame.level(),
            Action::Thinner => return self.set_width(module, given, self.params.width_ratio),
            Action::Thicker => return self.set_width(module, given, 1.0 / self.params.width_ratio),
            Action::Elasticity => return self.set_elasticity(module, given),
            Action::Color => self.set_color(given),
            Action::Cut => {
                self.cut = 1;
                self.report.cut += 1;
            }
            Action::Leaf => return self.leaf(module, given),
            Action::Open => {
                let base = self.state.position;
                self.outlines.push(Outline { module, base, corners: Vec::new() });
            }
            Action::Close => return self.close(module),
            Action::Corner => self.corner(module)?,
        }
        Ok(())
    }

    /// Counts brackets behind a `%`; whether this module ends the cut and is read again.
    fn uncut(&mut self, action: Action) -> bool {
        match action {
            Action::Push => self.cut += 1,
            Action::Pop => self.cut -= 1,
            _ => {}
        }
        if self.cut > 0 {
            self.report.cut += 1;
        }
        self.cut == 0
    }

    #[inline]
    fn turn(&mut self, given: &[f64], way: Way) -> Turn {
        let turn = match given.first() {
            Some(&angle) => self.turns.degrees(angle),
            None => self.default_turn,
        };
        if way == Way::On { turn } else { turn.back() }
    }

    fn push(&mut self, module: usize) -> Result<()> {
        self.stack.push((module, self.state));
        let depth = self.stack.len();
        if depth > self.report.depth {
            self.report.depth = depth;
            // A saved state is about as large as a node while it is meshed.
            self.control.limits.check(Resource::Nodes, depth as u64)?;
        }
        Ok(())
    }

    fn pop(&mut self, module: usize) -> Result<()> {
        let problem = || "']' without a '[' before it".into();
        let (_, state) =
            self.stack.pop().ok_or_else(|| ModelError::Word { module, problem: problem() })?;
        self.state = state;
        Ok(())
    }

    #[inline]
    fn advance(&mut self, module: usize, given: &[f64], draw: bool, corner: bool) -> Result<()> {
        let length = given.first().copied().unwrap_or(self.params.step);
        let to = self.state.position + length * self.state.frame.heading;
        // A NaN is in no range. Asked of each coordinate, since a maximum may pass over one.
        let reach = -REACH..=REACH;
        if !(reach.contains(&to.x) && reach.contains(&to.y) && reach.contains(&to.z)) {
            let problem = format!(
                "a step of {length} leads to {to}; coordinates up to {REACH:e} units are allowed"
            );
            return Err(ModelError::Word { module, problem });
        }
        if !self.outlines.is_empty() {
            // Braces hold outlines, not wood.
            self.state.position = to;
            self.state.away = true;
            if corner {
                self.corner(module)?;
            }
        } else if draw {
            self.draw(module, length, to)?;
        } else {
            self.state.away |= length != 0.0;
            self.state.position = to;
        }
        Ok(())
    }

    fn draw(&mut self, module: usize, length: f64, to: DVec3) -> Result<()> {
        if length == 0.0 {
            self.report.merged += 1;
            return Ok(());
        }
        if self.state.away {
            self.report.gaps += 1;
        }
        self.state.node = self.sink.wood(module, &self.state, to)?;
        self.state.position = to;
        self.state.away = false;
        if self.state.elasticity != 0.0 {
            self.state.frame.bend(self.tropism, self.state.elasticity);
        }
        Ok(())
    }

    fn set_width(&mut self, module: usize, given: &[f64], ratio: f64) -> Result<()> {
        let width = given.first().copied().unwrap_or(self.state.width * ratio);
        if !(0.0..=WIDTH_MAX).contains(&width) {
            let problem = format!("the width is {width}, allowed is 0 to {WIDTH_MAX:e} units");
            return Err(ModelError::Word { module, problem });
        }
        self.state.width = width;
        self.report.widths = true;
        self.sink.width(width);
        Ok(())
    }

    fn set_elasticity(&mut self, module: usize, given: &[f64]) -> Result<()> {
        let found = given.first().copied().unwrap_or(self.params.elasticity);
        if !(-10.0..=10.0).contains(&found) {
            let problem = format!("the elasticity is {found}, allowed is -10 to 10");
            return Err(ModelError::Word { module, problem });
        }
        self.state.elasticity = found;
        Ok(())
    }

    fn set_color(&mut self, given: &[f64]) {
        self.state.color = match given.first() {
            // Conversions saturate: negative numbers are colour 0.
            Some(&color) => color as u32,
            None => self.state.color.saturating_add(1),
        };
    }

    fn leaf(&mut self, module: usize, given: &[f64]) -> Result<()> {
        let size = given.first().copied().unwrap_or(self.params.leaf_size);
        if !(0.0..=REACH).contains(&size) {
            let problem = format!("the leaf's size is {size}, allowed is 0 to {REACH:e} units");
            return Err(ModelError::Word { module, problem });
        }
        let kind = given.get(1).copied().unwrap_or(0.0);
        self.sink.leaf(module, &self.state, size, kind)
    }

    fn corner(&mut self, module: usize) -> Result<()> {
        let problem = || "'.' outside of '{' and '}'".into();
        let outline = self
            .outlines
            .last_mut()
            .ok_or_else(|| ModelError::Word { module, problem: problem() })?;
        outline.corners.push(self.state.position);
        Ok(())
    }

    fn close(&mut self, module: usize) -> Result<()> {
        let problem = || "'}' without a '{' before it".into();
        let outline =
            self.outlines.pop().ok_or_else(|| ModelError::Word { module, problem: problem() })?;
        if outline.corners.len() < 3 {
            self.report.thin_polygons += 1;
            return Ok(());
        }
        self.sink.polygon(&self.state, outline)
    }

    fn finish(&self) -> Result<()> {
        let fail =
            |module, problem: &str| Err(ModelError::Word { module, problem: problem.into() });
        if let Some(outline) = self.outlines.last() {
            return fail(outline.module, "'{' without a '}' after it");
        }
        match self.stack.last() {
            Some(&(module, _)) => fail(module, "'[' without a ']' after it"),
            None => Ok(()),
        }
    }
}
