//! The bytes of buffers: the chunk of a GLB, base64 in the document, files beside it.

use super::container::malformed;
use super::document::Document;
use crate::error::Result;
use crate::io::import::Beside;
use std::borrow::Cow;

/// The buffers of a document, loaded, each as long as it says.
pub(super) struct Buffers<'a> {
    data: Vec<Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    /// Loads all buffers.
    ///
    /// # Errors
    /// [`MeshError::Malformed`](crate::MeshError::Malformed) for one that has fewer bytes than it
    /// says, and as [`Beside::read`].
    pub(super) fn load(
        document: &Document,
        mut binary: Option<&'a [u8]>,
        beside: &mut Beside<'_>,
    ) -> Result<Self> {
        let mut data = Vec::new();
        for (number, buffer) in document.buffers.iter().enumerate() {
            let place = || format!("buffer {number}");
            let mut bytes = match &buffer.uri {
                Some(uri) => Cow::Owned(resource(uri, &place(), beside)?),
                // Only the first may lie in the GLB.
                None => Cow::Borrowed(binary.take().filter(|_| number == 0).unwrap_or_default()),
            };
            if buffer.byte_length > bytes.len() as u64 {
                return Err(malformed(
                    place(),
                    format!("{} bytes announced, {} are there", buffer.byte_length, bytes.len()),
                ));
            }
            let length = buffer.byte_length as usize;
            match &mut bytes {
                Cow::Owned(bytes) => bytes.truncate(length),
                Cow::Borrowed(bytes) => *bytes = bytes.get(..length).unwrap_or_default(),
            }
            data.push(bytes);
        }
        Ok(Self { data })
    }

    /// The bytes of a view, and from row to row when it says so.
    pub(super) fn view(&self, document: &Document, number: usize) -> Result<(&[u8], Option<u64>)> {
        let place = || format!("bufferView {number}");
        let view = document
            .buffer_views
            .get(number)
            .ok_or_else(|| malformed(place(), "does not exist"))?;
        let buffer = self.data.get(view.buffer).ok_or_else(|| {
            malformed(place(), format!("names buffer {}, which does not exist", view.buffer))
        })?;
        let bytes = slice(buffer, view.byte_offset, view.byte_length).ok_or_else(|| {
            malformed(
                place(),
                format!(
                    "{} bytes from {} on, but buffer {} has {}",
                    view.byte_length,
                    view.byte_offset,
                    view.buffer,
                    buffer.len()
                ),
            )
        })?;
        Ok((bytes, view.byte_stride))
    }
}

/// `length` bytes from `offset` on, if they are there.
pub(super) fn slice(bytes: &[u8], offset: u64, length: u64) -> Option<&[u8]> {
    let end = usize::try_from(offset.checked_add(length)?).ok()?;
    bytes.get(usize::try_from(offset).ok()?..end)
}

/// What a URI stands for: base64 in itself, or a file beside.
pub(super) fn resource(uri: &str, place: &str, beside: &mut Beside<'_>) -> Result<Vec<u8>> {
    match uri.strip_prefix("data:") {
        Some(data) => {
            let base64 = data.split_once(',').filter(|(kind, _)| kind.ends_with(";base64"));
            base64.and_then(|(_, text)| decode_base64(text)).ok_or_else(|| {
                malformed(place, "a data URI that is no base64; 'data:TYPE;base64,...' is read")
            })
        }
        None => beside.read(&percent_decoded(uri)),
    }
}

fn decode_base64(text: &str) -> Option<Vec<u8>> {
    let text = text.trim_end_matches('=').as_bytes();
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3 + 2);
    for group in text.chunks(4) {
        let mut bits = 0_u32;
        for &c in group {
            let value = match c {
                b'A'..=b'Z' => c - b'A',
                b'a'..=b'z' => c - b'a' + 26,
                b'0'..=b'9' => c - b'0' + 52,
                b'+' | b'-' => 62,
                b'/' | b'_' => 63,
                _ => return None,
            };
            bits = bits << 6 | u32::from(value);
        }
        // A last group of n characters holds 6 n bits, of which the whole bytes count.
        bits <<= 6 * (4 - group.len());
        let whole = group.len() * 6 / 8;
        bytes.extend(bits.to_be_bytes().get(1..=whole)?);
    }
    Some(bytes)
}

fn percent_decoded(uri: &str) -> String {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&first, after)) = rest.split_first() {
        let digits = after.first_chunk::<2>().filter(|_| first == b'%');
        let code = digits
            .and_then(|pair| std::str::from_utf8(pair).ok())
            .and_then(|pair| u8::from_str_radix(pair, 16).ok());
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { after.get(2..).unwrap_or_default() } else { after };
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_comes_back_as_the_rfc_says() {
        // RFC 4648, section 10.
        for (text, bytes) in [
            ("", ""),
            ("Zg==", "f"),
            ("Zm8=", "fo"),
            ("Zm9v", "foo"),
            ("Zm9vYg", "foob"),
            ("Zm9vYmFy", "foobar"),
        ] {
            assert_eq!(decode_base64(text).unwrap(), bytes.as_bytes());
        }
        assert_eq!(decode_base64("Zm 8"), None);
        assert_eq!(percent_decoded("a%20b%2e%zz%"), "a b.%zz%");
    }
}
