#![no_main]

use tree_fuzz::{limits, sealed};
use tree_lod::multires::stream::{Reader, StreamParams, decode, encode};

// The first byte says how many bytes arrive at once, and whether checksums are put in for the input: otherwise
// hardly any would come past them.
libfuzzer_sys::fuzz_target!(|data: &[u8]| {
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
});
