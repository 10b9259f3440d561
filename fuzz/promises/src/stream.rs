//! Streams of trees with levels.

use crate::limits;
use tree_lod::multires::stream::{Reader, StreamParams, decode, encode};

/// The first byte says how many bytes arrive at once, and whether checksums are put in for the input: otherwise
/// hardly any would come past them.
pub fn stream(data: &[u8]) {
    let Some((&how, data)) = data.split_first() else { return };
    let bytes = if how % 2 == 1 { sealed(data) } else { data.to_vec() };
    let mut reader = Reader::new(&limits());
    let arrived =
        bytes.chunks(1 + usize::from(how / 2)).try_for_each(|part| reader.push(part).map(drop));
    let whole = decode(&bytes, &limits());
    if arrived.is_ok() {
        assert_eq!(whole.is_ok(), reader.multires().is_ok());
    } else {
        assert!(whole.is_err());
    }
    let Ok(multires) = reader.multires() else { return };
    if let Ok((whole, received)) = whole {
        assert_eq!((whole, received), (multires.clone(), reader.received()));
    }
    let n = multires.n_levels();
    for level in [1, n.div_ceil(2), n] {
        multires.tree_at(level).expect("every level is a tree");
    }
    let again =
        encode(&multires, n, &StreamParams::default()).expect("what was read can be written");
    let (again, received) = decode(&again, &limits()).expect("what was written can be read");
    assert!(received.is_complete && received.n_levels == n);
    assert_eq!(again.tree().skeleton(), multires.tree().skeleton());
}

/// A stream of a tree with levels whose checksums hold. `data` is the head without its beginning and its check, then
/// the levels without their lengths and checks; before each of them stands how many bytes it has, in two bytes, the
/// lower one first.
fn sealed(data: &[u8]) -> Vec<u8> {
    let mut bytes = b"TREM\x01".to_vec();
    let mut rest = data;
    let head = part(&mut rest);
    bytes.extend_from_slice(head);
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    while !rest.is_empty() {
        let level = part(&mut rest);
        let mut length = level.len();
        while length >= 0x80 {
            bytes.push(length as u8 | 0x80);
            length >>= 7;
        }
        bytes.push(length as u8);
        bytes.extend_from_slice(level);
        bytes.extend((crc32fast::hash(&bytes) as u16).to_le_bytes());
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

fn part<'a>(rest: &mut &'a [u8]) -> &'a [u8] {
    let (length, behind) = rest.split_at(rest.len().min(2));
    let length = length.iter().rev().fold(0, |length, &byte| 256 * length + usize::from(byte));
    let (part, behind) = behind.split_at(length.min(behind.len()));
    *rest = behind;
    part
}
