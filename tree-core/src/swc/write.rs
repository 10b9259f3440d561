//! Writing: a header that says what the numbers mean, then a row a node.

use super::{SwcOptions, UpAxis};
use crate::error::{CoreError, Result};
use crate::skeleton::{Continuation, Skeleton};
use std::fmt::{Display, LowerExp};
use std::io::{self, Write};
use std::path::Path;

/// Type of a node that continues its parent's axis, and of the root.
const CONTINUES: u8 = 3;

/// Type of a node that starts a lateral.
const STARTS_LATERAL: u8 = 4;

/// A skeleton as the text of an SWC file.
///
/// Ids count from 1 in node order; types are 3 and 4 by [`Continuation::Thickest`]. With a scale
/// of 1, [`read`](super::read) brings back every position and radius to the bit (unless it is told
/// to move the root); with other scales, all but the last digit.
///
/// # Errors
/// As [`SwcOptions::validate`].
///
/// # Complexity
/// O(nodes).
pub fn write(skeleton: &Skeleton, options: &SwcOptions) -> Result<String> {
    let mut bytes = Vec::new();
    write_to(skeleton, options, &mut bytes)?;
    // Only ASCII is written, so nothing is replaced.
    Ok(String::from_utf8(bytes)
        .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()))
}

/// Writes a skeleton as SWC, as [`write()`] does. Each row is one small write: buffer `out`.
///
/// # Errors
/// As [`SwcOptions::validate`]; [`CoreError::Io`] when `out` fails, with the path `(stream)`.
pub fn write_to(skeleton: &Skeleton, options: &SwcOptions, out: &mut dyn Write) -> Result<()> {
    options.validate()?;
    write_rows(skeleton, options, out).map_err(|error| CoreError::io("(stream)", error))
}

/// Writes an SWC file that is whole or absent, see [`write_atomic`](crate::file::write_atomic).
///
/// # Errors
/// As [`SwcOptions::validate`]; [`CoreError::Io`] with the path.
pub fn write_file(path: &Path, skeleton: &Skeleton, options: &SwcOptions) -> Result<()> {
    options.validate()?;
    crate::file::write_atomic(path, |out| {
        write_rows(skeleton, options, out).map_err(|error| CoreError::io(path, error))
    })
}

fn write_rows(skeleton: &Skeleton, options: &SwcOptions, out: &mut dyn Write) -> io::Result<()> {
    let up = match options.up {
        UpAxis::Y => "Y",
        UpAxis::Z => "Z",
    };
    let scale = options.scale;
    writeln!(out, "# SWC: id type x y z radius parent; {up} up; 1 unit = {scale} m")?;
    writeln!(
        out,
        "# type {CONTINUES} = continues its parent's axis, {STARTS_LATERAL} = starts a lateral axis; radius 0 = unknown"
    )?;
    let axes = skeleton.axes(Continuation::Thickest);
    let axis_of = axes.axis_of();
    for (node, (&position, &radius)) in
        skeleton.positions().iter().zip(skeleton.radii()).enumerate()
    {
        let parent = skeleton.parent(node as u32);
        let kind = match parent {
            Some(parent) if axis_of[parent as usize] != axis_of[node] => STARTS_LATERAL,
            _ => CONTINUES,
        };
        write!(out, "{} {kind}", node + 1)?;
        for metres in options.up.from_y_up(position.to_array()) {
            write_number(out, metres, scale)?;
        }
        write_number(out, radius, scale)?;
        match parent {
            Some(parent) => writeln!(out, " {}", u64::from(parent) + 1)?,
            None => writeln!(out, " -1")?,
        }
    }
    Ok(())
}

/// A length in units of the file, with as many digits as bring it back.
fn write_number(out: &mut dyn Write, metres: f32, scale: f64) -> io::Result<()> {
    if scale == 1.0 {
        write_shortest(out, metres, f64::from(metres))
    } else {
        let units = f64::from(metres) / scale;
        write_shortest(out, units, units)
    }
}

/// The shortest text that reads back as `number`, with an exponent only where it would be long.
fn write_shortest(
    out: &mut dyn Write,
    number: impl Display + LowerExp,
    value: f64,
) -> io::Result<()> {
    if value == 0.0 || (1e-5..1e15).contains(&value.abs()) {
        write!(out, " {number}")
    } else {
        write!(out, " {number:e}")
    }
}
