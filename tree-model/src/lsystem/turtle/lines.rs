//! The word as lines: for string pictures and curves.

use super::params::TurtleParams;
use super::polygon::Outline;
use super::walk::{Sink, State, walk};
use crate::error::Result;
use crate::glam::{DVec3, Vec3};
use crate::lsystem::{Symbols, Word};
use tree_core::{Control, Resource};

struct Lines<'a> {
    control: &'a Control,
    unit: f64,
    lines: Vec<[Vec3; 2]>,
}

/// Every `F` and `G` of a word as a line, in its order, in units times [`TurtleParams::unit`]. The turtle
/// starts at the origin and looks along +Y; `+` turns it to −X. Gaps stay open; braces draw nothing.
///
/// # Errors
/// As [`interpret`](super::interpret).
///
/// # Complexity
/// O(modules), 24 bytes a line.
pub fn lines(
    word: &Word,
    symbols: &Symbols,
    params: &TurtleParams,
    control: &Control,
) -> Result<Vec<[Vec3; 2]>> {
    let mut sink = Lines { control, unit: params.unit, lines: Vec::new() };
    walk(word, symbols, params, control, &mut sink)?;
    Ok(sink.lines)
}

impl Sink for Lines<'_> {
    fn wood(&mut self, _: usize, turtle: &State, to: DVec3) -> Result<u32> {
        self.control.limits.check(Resource::Nodes, self.lines.len() as u64 + 1)?;
        let end = |position: DVec3| (self.unit * position).as_vec3();
        self.lines.push([end(turtle.position), end(to)]);
        Ok(0)
    }

    fn leaf(&mut self, _: usize, _: &State, _: f64, _: f64) -> Result<()> {
        Ok(())
    }

    fn polygon(&mut self, _: &State, _: Outline) -> Result<()> {
        Ok(())
    }

    fn width(&mut self, _: f64) {}
}
