//! Every fuzz target on files of the corpus, as they are and changed at random. Not guided by coverage, as `fuzz/run` is, but within
//! `cargo test`: four times as many of each as `PROPTEST_CASES`, else a thousand.

// What is broken here fails a test.
#![allow(clippy::expect_used, clippy::panic, clippy::unwrap_used)]

use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::fs;
use std::path::{Path, PathBuf};
use tree_promises::{c_abi, drawings, meshes, pictures, plants, stream};

/// One change of an input.
#[derive(Clone, Debug)]
enum Edit {
    Set(Index, u8),
    Insert(Index, Vec<u8>),
    Remove(Index, usize),
    /// So many bytes of there come here too.
    Copy(Index, usize, Index),
    /// The number there becomes another.
    Number(Index, &'static str),
    /// What follows is what follows there in another file.
    Cross(Index, Index, Index),
}

/// Numbers that are valid and rarely meant, and some that are not valid.
const NUMBERS: [&str; 12] = [
    "0",
    "-1",
    "1e-30",
    "1e38",
    "-1e39",
    "1e999",
    "NaN",
    "255",
    "65536",
    "4294967295",
    "-2147483649",
    "18446744073709551616",
];

fn edit() -> impl Strategy<Value = Edit> {
    prop_oneof![
        (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Edit::Set(at, byte)),
        (any::<Index>(), prop::collection::vec(any::<u8>(), 1..6))
            .prop_map(|(at, new)| Edit::Insert(at, new)),
        (any::<Index>(), 1..64_usize).prop_map(|(at, n)| Edit::Remove(at, n)),
        (any::<Index>(), 1..64_usize, any::<Index>())
            .prop_map(|(from, n, to)| Edit::Copy(from, n, to)),
        (any::<Index>(), select(&NUMBERS[..])).prop_map(|(at, number)| Edit::Number(at, number)),
        (any::<Index>(), any::<Index>(), any::<Index>())
            .prop_map(|(at, file, from)| Edit::Cross(at, file, from)),
    ]
}

impl Edit {
    fn apply(&self, data: &mut Vec<u8>, files: &[Vec<u8>]) {
        let n = data.len();
        let place = |at: &Index| at.index(n + 1);
        match self {
            Self::Set(at, byte) => {
                data.iter_mut().skip(place(at)).take(1).for_each(|old| *old = *byte);
            }
            Self::Insert(at, new) => drop(data.splice(place(at)..place(at), new.iter().copied())),
            Self::Remove(at, many) => drop(data.drain(place(at)..n.min(place(at) + many))),
            Self::Copy(from, many, to) => {
                let part = data[place(from)..n.min(place(from) + many)].to_vec();
                data.splice(place(to)..place(to), part);
            }
            Self::Number(at, number) => {
                let behind = |start: usize, digit| {
                    let found =
                        data[start..].iter().position(|c| b"+-.0123456789".contains(c) == digit);
                    found.map_or(n, |ahead| start + ahead)
                };
                let start = behind(place(at), true);
                let end = behind(start, false);
                data.splice(start..end, number.bytes());
            }
            Self::Cross(at, file, from) => {
                let other = &files[file.index(files.len())];
                data.truncate(place(at));
                data.extend_from_slice(&other[from.index(other.len() + 1)..]);
            }
        }
    }
}

fn files_of(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../corpus").join(target);
    let entries = fs::read_dir(&folder).expect("every target has a corpus");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().map(|path| fs::read(path).unwrap()).collect()
}

fn keeps_its_promises(target: &str, promise: fn(&[u8])) {
    let files = files_of(target);
    assert!(!files.is_empty(), "{target} has no corpus");
    files.iter().for_each(|file| promise(file));
    promise(&[]);
    let edits = prop::collection::vec(edit(), 1..6);
    let usual = ProptestConfig::default();
    let config = ProptestConfig { cases: 4 * usual.cases, failure_persistence: None, ..usual };
    let asked = proptest::test_runner::TestRunner::new(config).run(
        &(any::<Index>(), edits),
        |(file, edits)| {
            let mut data = files[file.index(files.len())].clone();
            edits.iter().for_each(|edit| edit.apply(&mut data, &files));
            promise(&data);
            Ok(())
        },
    );
    asked.unwrap_or_else(|broken| panic!("{target}: {broken}"));
}

macro_rules! targets {
    ($($module:ident: $($target:ident)*;)*) => {
        /// All that are tested here, and what each calls.
        const TARGETS: &[(&str, &str)] = &[
            $($((
                stringify!($target),
                concat!("tree_promises::", stringify!($module), "::", stringify!($target), "(data)"),
            )),*),*
        ];

        $($(
            #[test]
            fn $target() {
                keeps_its_promises(stringify!($target), $module::$target);
            }
        )*)*
    };
}

targets! {
    c_abi: c_abi;
    drawings: silhouette sketch svg;
    meshes: gltf obj ply;
    pictures: photo picture;
    plants: lsystem points swc;
    stream: stream;
}

#[test]
fn the_fuzz_targets_are_those_tested_here() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../targets");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), TARGETS.len());
    for (target, call) in TARGETS {
        let text = fs::read_to_string(folder.join(format!("{target}.rs"))).unwrap();
        assert!(text.contains(call), "{target} shall call {call}");
    }
}
