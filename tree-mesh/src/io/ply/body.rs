//! The body: numbers of elements, whatever their sort and order of bytes.

use super::header::{Element, Format, Kind, Property};
use super::malformed;
use crate::error::Result;

/// Longest number as text.
const WORD_MAX: usize = 64;

/// The bytes behind the header, read from front to back.
pub(super) struct Body<'a> {
    rest: &'a [u8],
    format: Format,
}

impl<'a> Body<'a> {
    pub(super) fn new(bytes: &'a [u8], format: Format) -> Self {
        Self { rest: bytes, format }
    }

    /// Checks that the rows of an element can be there, before memory is taken for them.
    ///
    /// # Errors
    /// [`MeshError::Malformed`](crate::MeshError::Malformed).
    pub(super) fn check(&self, element: &Element) -> Result<()> {
        let needed = element.n_rows.saturating_mul(element.row_min(self.format));
        // The last number of a text needs nothing behind it.
        if needed <= self.rest.len() as u64 + 1 {
            return Ok(());
        }
        Err(malformed(
            format!("element {}", element.name),
            format!(
                "{} rows need at least {needed} bytes, {} are there",
                element.n_rows,
                self.rest.len()
            ),
        ))
    }

    /// Passes over all rows of an element.
    pub(super) fn skip(&mut self, element: &Element) -> Result<()> {
        self.check(element)?;
        if element.properties.is_empty() {
            return Ok(());
        }
        for row in 0..element.n_rows {
            for property in &element.properties {
                self.skip_property(property).ok_or_else(|| at(element, row))?;
            }
        }
        Ok(())
    }

    /// Passes over one number or list.
    pub(super) fn skip_property(&mut self, property: &Property) -> Option<()> {
        let Some(count) = property.count else {
            return self.number(property.kind).map(|_| ());
        };
        let n = self.count(count, property.kind)?;
        if self.format == Format::Text {
            for _ in 0..n {
                self.number(property.kind)?;
            }
            return Some(());
        }
        let bytes = usize::try_from(n.checked_mul(property.kind.size())?).ok()?;
        self.rest = self.rest.get(bytes..)?;
        Some(())
    }

    /// The length of a list, whose items can be there.
    pub(super) fn count(&mut self, count: Kind, items: Kind) -> Option<u64> {
        let n = self.number(count)?;
        if n < 0.0 || n > f64::from(u32::MAX) || n.fract() != 0.0 {
            return None;
        }
        let n = n as u64;
        let each = if self.format == Format::Text { 2 } else { items.size() };
        (n * each <= self.rest.len() as u64 + 1).then_some(n)
    }

    /// The next number; `None` when there is none.
    pub(super) fn number(&mut self, kind: Kind) -> Option<f64> {
        let big = match self.format {
            Format::Text => return self.word(),
            Format::Big => true,
            Format::Little => false,
        };
        Some(match kind {
            Kind::I8 => f64::from(i8::from_le_bytes(self.take(big)?)),
            Kind::U8 => f64::from(u8::from_le_bytes(self.take(big)?)),
            Kind::I16 => f64::from(i16::from_le_bytes(self.take(big)?)),
            Kind::U16 => f64::from(u16::from_le_bytes(self.take(big)?)),
            Kind::I32 => f64::from(i32::from_le_bytes(self.take(big)?)),
            Kind::U32 => f64::from(u32::from_le_bytes(self.take(big)?)),
            Kind::F32 => f64::from(f32::from_le_bytes(self.take(big)?)),
            Kind::F64 => f64::from_le_bytes(self.take(big)?),
        })
    }

    /// The next bytes, in little-endian order.
    fn take<const N: usize>(&mut self, big: bool) -> Option<[u8; N]> {
        let (&first, rest) = self.rest.split_first_chunk::<N>()?;
        self.rest = rest;
        let mut bytes = first;
        if big {
            bytes.reverse();
        }
        Some(bytes)
    }

    fn word(&mut self) -> Option<f64> {
        let start = self.rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        let rest = self.rest.get(start..)?;
        let window = rest.get(..WORD_MAX).unwrap_or(rest);
        let end = window.iter().position(u8::is_ascii_whitespace).unwrap_or(window.len());
        let (word, rest) = rest.split_at_checked(end)?;
        self.rest = rest;
        std::str::from_utf8(word).ok()?.parse().ok()
    }
}

/// The error for a row that cannot be read.
pub(super) fn at(element: &Element, row: u64) -> crate::error::MeshError {
    malformed(
        format!("element {}, row {row}", element.name),
        "the file ends, or this is no number or length",
    )
}
