//! GLB: a header, a chunk of JSON and a chunk of bytes. Lengths are little-endian and multiples of 4.

use crate::error::{MeshError, Result};

/// A GLB states its length in 32 bits.
pub(super) const BYTES_MAX: usize = u32::MAX as usize;
const MAGIC: &[u8; 4] = b"glTF";
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BINARY: u32 = u32::from_le_bytes(*b"BIN\0");
const VERSION: u32 = 2;

/// The two chunks as one file.
///
/// # Errors
/// [`MeshError::Gltf`] when it would be larger than 4 GiB.
pub(super) fn join(json: &[u8], binary: &[u8]) -> Result<Vec<u8>> {
    let padded = [json.len().next_multiple_of(4), binary.len().next_multiple_of(4)];
    // 12 bytes of header and 8 before each of the two chunks.
    let length = padded[0].saturating_add(padded[1]).saturating_add(28);
    if length > BYTES_MAX {
        return Err(too_large());
    }
    let mut file = Vec::with_capacity(length);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&VERSION.to_le_bytes());
    file.extend_from_slice(&(length as u32).to_le_bytes());
    for (chunk, length, kind, fill) in
        [(json, padded[0], JSON, b' '), (binary, padded[1], BINARY, 0)]
    {
        file.extend_from_slice(&(length as u32).to_le_bytes());
        file.extend_from_slice(&kind.to_le_bytes());
        file.extend_from_slice(chunk);
        file.resize(file.len() + length - chunk.len(), fill);
    }
    Ok(file)
}

pub(super) fn too_large() -> MeshError {
    MeshError::Gltf(format!(
        "the file would be larger than {BYTES_MAX} bytes, which GLB cannot state"
    ))
}

/// The JSON and, in a GLB, the bytes of the first buffer. Text that is no GLB is JSON throughout.
pub(super) fn split(file: &[u8]) -> Result<(&[u8], Option<&[u8]>)> {
    let Some(rest) = file.strip_prefix(MAGIC) else {
        return Ok((file.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(file), None));
    };
    let bad = |problem: String| malformed("header", problem);
    let (version, rest) = number(rest).ok_or_else(|| bad("ends in the header".into()))?;
    let (length, rest) = number(rest).ok_or_else(|| bad("ends in the header".into()))?;
    if version != VERSION {
        return Err(bad(format!("GLB version {version}, only {VERSION} is read")));
    }
    let length = (length as usize)
        .checked_sub(12)
        .ok_or_else(|| bad(format!("a length of {length}, the header alone has 12")))?;
    let mut rest = rest.get(..length).ok_or_else(|| {
        bad(format!("{} bytes announced, {} are there", length + 12, rest.len() + 12))
    })?;
    let (mut json, mut binary) = (None, None);
    while !rest.is_empty() {
        let (kind, chunk, after) =
            chunk(rest).ok_or_else(|| malformed("chunk", "runs past the end of the file"))?;
        match kind {
            JSON if json.is_none() => json = Some(chunk),
            BINARY if binary.is_none() => binary = Some(chunk),
            // Chunks of other kinds are to be passed over.
            _ => {}
        }
        rest = after;
    }
    let json = json.ok_or_else(|| malformed("chunk", "a GLB needs a chunk of JSON"))?;
    Ok((json, binary))
}

fn number(bytes: &[u8]) -> Option<(u32, &[u8])> {
    let (number, rest) = bytes.split_first_chunk()?;
    Some((u32::from_le_bytes(*number), rest))
}

fn chunk(bytes: &[u8]) -> Option<(u32, &[u8], &[u8])> {
    let (length, rest) = number(bytes)?;
    let (kind, rest) = number(rest)?;
    let (chunk, rest) = rest.split_at_checked(length as usize)?;
    Some((kind, chunk, rest))
}

pub(super) fn malformed(place: impl Into<String>, problem: impl Into<String>) -> MeshError {
    MeshError::Malformed { format: "glTF", place: place.into(), problem: problem.into() }
}
