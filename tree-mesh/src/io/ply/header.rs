//! The header: which elements follow, how many, and what numbers each has.

use super::malformed;
use crate::error::Result;

/// Most elements, and most properties of one; real files have a handful.
const ITEMS_MAX: usize = 1024;
/// Longest line of a header.
const LINE_MAX: usize = 4096;

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Format {
    Text,
    Little,
    Big,
}

/// Sorts of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Kind {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes in a binary file.
    pub(super) fn size(self) -> u64 {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// A number or a list of numbers that each row of an element has.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// Sort of the number of items, for lists.
    pub(super) count: Option<Kind>,
}

/// Rows of the same sort.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) n_rows: u64,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// Fewest bytes that a row can have in the file.
    pub(super) fn row_min(&self, format: Format) -> u64 {
        let sizes = self.properties.iter().map(|property| match format {
            // A digit and what parts it from the next.
            Format::Text => 2,
            _ => property.count.unwrap_or(property.kind).size(),
        });
        sizes.sum()
    }
}

/// What a file says of itself.
#[derive(Clone, Debug)]
pub(super) struct Header {
    pub(super) format: Format,
    pub(super) elements: Vec<Element>,
}

/// Reads the header. Returns it and the bytes behind.
pub(super) fn parse(bytes: &[u8]) -> Result<(Header, &[u8])> {
    let mut lines = Lines { rest: bytes, number: 0 };
    if lines.next()? != "ply" {
        return Err(malformed("line 1", "'ply' is needed"));
    }
    let (mut format, mut elements) = (None, Vec::<Element>::new());
    loop {
        let line = lines.next()?;
        let fail = |problem: &str| Err(malformed(format!("header line {}", lines.number), problem));
        let words: Vec<&str> = line.split_ascii_whitespace().take(6).collect();
        match words[..] {
            ["format", name, "1.0"] => {
                format = Some(match name {
                    "ascii" => Format::Text,
                    "binary_little_endian" => Format::Little,
                    "binary_big_endian" => Format::Big,
                    _ => return fail("unknown format"),
                });
            }
            ["comment" | "obj_info", ..] | [] => {}
            ["element", name, n_rows] if elements.len() < ITEMS_MAX => {
                let Ok(n_rows) = n_rows.parse() else { return fail("the count is no number") };
                elements.push(Element { name: name.into(), n_rows, properties: Vec::new() });
            }
            ["property", ref rest @ ..] => {
                let property =
                    match *rest {
                        ["list", count, kind, name] => {
                            Kind::named(kind).zip(Kind::named(count)).map(|(kind, count)| {
                                Property { name: name.into(), kind, count: Some(count) }
                            })
                        }
                        [kind, name] => Kind::named(kind).map(|kind| Property {
                            name: name.into(),
                            kind,
                            count: None,
                        }),
                        _ => None,
                    };
                let element = elements.last_mut();
                let element = element.filter(|element| element.properties.len() < ITEMS_MAX);
                match (property, element) {
                    (Some(property), Some(element)) => element.properties.push(property),
                    (None, _) => return fail("a property is 'TYPE NAME' or 'list TYPE TYPE NAME'"),
                    (_, None) => return fail("a property before any element, or too many"),
                }
            }
            ["end_header"] => break,
            _ => return fail("not understood"),
        }
    }
    let format = format.ok_or_else(|| malformed("header", "the format is missing"))?;
    Ok((Header { format, elements }, lines.rest))
}

struct Lines<'a> {
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<&'a str> {
        self.number += 1;
        let fail = |problem: &str| malformed(format!("header line {}", self.number), problem);
        let window = self.rest.get(..LINE_MAX).unwrap_or(self.rest);
        let end = window.iter().position(|&byte| byte == b'\n');
        let end = end.ok_or_else(|| fail("the header does not end"))?;
        let line = window.get(..end).unwrap_or_default();
        self.rest = self.rest.get(end + 1..).unwrap_or_default();
        // Comments may be in an old encoding.
        match std::str::from_utf8(line) {
            Ok(line) => Ok(line.trim()),
            Err(_) if line.starts_with(b"comment") || line.starts_with(b"obj_info") => Ok(""),
            Err(_) => Err(fail("not UTF-8")),
        }
    }
}
