//! Columns of numbers out of buffers, every bound checked before memory is taken.

use super::buffer::{Buffers, slice};
use super::container::malformed;
use super::document::{Accessor, Document};
use crate::error::{MeshError, Result};

/// Rows that an accessor without bytes of its own (all zeros, or sparse) may have at least.
const BARE_ROWS: u64 = 1 << 16;

/// Sorts of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(code: u32) -> Option<Self> {
        Some(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return None,
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

/// A checked accessor: all its rows are in the bytes.
pub(super) struct Column<'a> {
    number: usize,
    accessor: &'a Accessor,
    component: Component,
    width: usize,
    /// From the first row to the end of the last; `None` when all are zero.
    bytes: Option<&'a [u8]>,
    stride: usize,
    sparse: Option<Sparse<'a>>,
}

/// Rows that differ.
struct Sparse<'a> {
    indices: &'a [u8],
    index_component: Component,
    values: &'a [u8],
}

/// The columns of one document.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a> {
    pub(super) document: &'a Document,
    pub(super) buffers: &'a Buffers<'a>,
    /// Length of the file, which bounds columns that have no bytes.
    pub(super) n_bytes: u64,
}

impl<'a> Columns<'a> {
    /// The accessor of this number, checked against the bytes that are there.
    pub(super) fn get(&self, number: usize) -> Result<Column<'a>> {
        let fail = |problem: String| malformed(format!("accessor {number}"), problem);
        let accessor =
            self.document.accessors.get(number).ok_or_else(|| fail("does not exist".into()))?;
        let component = Component::of(accessor.component_type)
            .ok_or_else(|| fail(format!("componentType {}", accessor.component_type)))?;
        let width = match accessor.shape.as_str() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" => 4,
            other => {
                let other: String = other.chars().take(20).collect();
                return Err(fail(format!("type {other}, only scalars and vectors are read")));
            }
        };
        let size = width * component.size();
        let (bytes, stride) = match accessor.buffer_view {
            Some(view) => {
                let (bytes, stride) = self.buffers.view(self.document, view)?;
                let stride = stride.filter(|&stride| stride > 0).unwrap_or(size as u64);
                if stride < size as u64 {
                    return Err(fail(format!("byteStride {stride}, rows have {size} bytes")));
                }
                let length = match accessor.count.checked_sub(1) {
                    Some(last) => {
                        last.checked_mul(stride).and_then(|sum| sum.checked_add(size as u64))
                    }
                    None => Some(0),
                };
                let rows = length.and_then(|length| slice(bytes, accessor.byte_offset, length));
                let rows = rows.ok_or_else(|| {
                    fail(format!(
                        "{} rows every {stride} bytes from {} on, but bufferView {view} has {} bytes",
                        accessor.count,
                        accessor.byte_offset,
                        bytes.len()
                    ))
                })?;
                // A stride beyond the view matters only to a single row.
                (Some(rows), usize::try_from(stride).unwrap_or(usize::MAX))
            }
            None => {
                let most = self.n_bytes.max(BARE_ROWS);
                if accessor.count > most {
                    return Err(fail(format!("{} rows without bytes", accessor.count)));
                }
                (None, size)
            }
        };
        let sparse = match &accessor.sparse {
            Some(sparse) => {
                if sparse.count > accessor.count {
                    let (found, rows) = (sparse.count, accessor.count);
                    return Err(fail(format!("{found} sparse rows, the accessor has {rows}")));
                }
                let index_component = Component::of(sparse.indices.component_type)
                    .filter(|c| matches!(c, Component::U8 | Component::U16 | Component::U32))
                    .ok_or_else(|| fail("sparse indices that are no unsigned integers".into()))?;
                let part = |view: usize, offset: u64, size: usize| {
                    let (bytes, _) = self.buffers.view(self.document, view)?;
                    let length = sparse.count.checked_mul(size as u64);
                    length.and_then(|length| slice(bytes, offset, length)).ok_or_else(|| {
                        fail(format!("{} sparse rows, bufferView {view} ends first", sparse.count))
                    })
                };
                let (indices, values) = (&sparse.indices, &sparse.values);
                Some(Sparse {
                    indices: part(
                        indices.buffer_view,
                        indices.byte_offset,
                        index_component.size(),
                    )?,
                    index_component,
                    values: part(values.buffer_view, values.byte_offset, size)?,
                })
            }
            None => None,
        };
        Ok(Column { number, accessor, component, width, bytes, stride, sparse })
    }
}

impl Column<'_> {
    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        // Holds: the rows are in memory, or bounded.
        self.accessor.count as usize
    }

    fn fail(&self, problem: String) -> MeshError {
        malformed(format!("accessor {}", self.number), problem)
    }

    /// Vectors of `N` numbers; integers as fractions of 1 where the accessor says so.
    pub(super) fn vectors<const N: usize>(&self) -> Result<Vec<[f32; N]>> {
        if self.width != N {
            return Err(self.fail(format!("{} numbers a row, {N} are needed", self.width)));
        }
        let normalized = self.accessor.normalized;
        match (self.component, normalized) {
            (Component::F32, _) => self.rows(f32::from_le_bytes),
            (Component::U8, true) => self.rows(|[b]: [u8; 1]| f32::from(b) / 255.0),
            (Component::U8, false) => self.rows(|[b]: [u8; 1]| f32::from(b)),
            (Component::I8, true) => {
                self.rows(|b: [u8; 1]| (f32::from(i8::from_le_bytes(b)) / 127.0).max(-1.0))
            }
            (Component::I8, false) => self.rows(|b: [u8; 1]| f32::from(i8::from_le_bytes(b))),
            (Component::U16, true) => {
                self.rows(|b: [u8; 2]| f32::from(u16::from_le_bytes(b)) / 65_535.0)
            }
            (Component::U16, false) => self.rows(|b: [u8; 2]| f32::from(u16::from_le_bytes(b))),
            (Component::I16, true) => {
                self.rows(|b: [u8; 2]| (f32::from(i16::from_le_bytes(b)) / 32_767.0).max(-1.0))
            }
            (Component::I16, false) => self.rows(|b: [u8; 2]| f32::from(i16::from_le_bytes(b))),
            (Component::U32, _) => Err(self.fail("32-bit integers are for indices only".into())),
        }
    }

    /// Indices.
    pub(super) fn indices(&self) -> Result<Vec<u32>> {
        if self.width != 1 {
            return Err(self.fail(format!("{} numbers a row, indices have 1", self.width)));
        }
        let rows = match self.component {
            Component::U8 => self.rows(|[b]: [u8; 1]| u32::from(b))?,
            Component::U16 => self.rows(|b: [u8; 2]| u32::from(u16::from_le_bytes(b)))?,
            Component::U32 => self.rows(u32::from_le_bytes)?,
            _ => return Err(self.fail("indices must be unsigned integers".into())),
        };
        Ok(rows.into_iter().map(|[index]| index).collect())
    }

    /// All rows of `N` numbers of `S` bytes, the sparse ones put in.
    fn rows<T: Copy + Default, const S: usize, const N: usize>(
        &self,
        number: impl Fn([u8; S]) -> T,
    ) -> Result<Vec<[T; N]>> {
        let row = |bytes: &[u8]| {
            let mut row = [T::default(); N];
            for (to, from) in row.iter_mut().zip(bytes.chunks_exact(S)) {
                if let Some(from) = from.first_chunk() {
                    *to = number(*from);
                }
            }
            row
        };
        let mut rows: Vec<[T; N]> = match self.bytes {
            Some(bytes) => bytes.chunks(self.stride.max(1)).map(row).collect(),
            None => vec![[T::default(); N]; self.len()],
        };
        if let Some(sparse) = &self.sparse {
            let values = sparse.values.chunks_exact((N * S).max(1));
            for (index, value) in sparse.indices().zip(values) {
                let n = rows.len();
                let Some(place) = rows.get_mut(index as usize) else {
                    return Err(self.fail(format!("sparse row {index}, there are {n}")));
                };
                *place = row(value);
            }
        }
        Ok(rows)
    }
}

impl Sparse<'_> {
    fn indices(&self) -> impl Iterator<Item = u32> + '_ {
        self.indices.chunks_exact(self.index_component.size()).map(|bytes| {
            // Little-endian, so that fewer bytes are the low ones.
            bytes.iter().rev().fold(0, |sum, &byte| sum << 8 | u32::from(byte))
        })
    }
}
