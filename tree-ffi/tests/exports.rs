//! The shared library exports the functions of the header and nothing else.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test says what failed by failing"
)]

mod common;

use common::{compile, header};
use std::collections::BTreeSet;
use std::process::Command;

#[test]
#[cfg(target_os = "linux")]
fn the_library_exports_what_the_header_declares() {
    let library = compile::library_folder().join("libtree_ffi.so");
    let said = Command::new("nm").args(["-D", "--defined-only"]).arg(&library).output().unwrap();
    assert!(said.status.success(), "nm cannot read {}", library.display());
    let said = String::from_utf8(said.stdout).unwrap();
    let exported: BTreeSet<&str> =
        said.lines().filter_map(|line| line.split_whitespace().last()).collect();
    let header = header::parse(&header::text());
    let declared: BTreeSet<&str> =
        header.functions.iter().map(|function| function.name.as_str()).collect();
    let only = |a: &BTreeSet<&str>, b: &BTreeSet<&str>| {
        a.difference(b).copied().collect::<Vec<_>>().join(", ")
    };
    assert_eq!(only(&exported, &declared), "", "exported, and not declared");
    assert_eq!(only(&declared, &exported), "", "declared, and not exported");
}

/// Programs that link the library by path shall look for it by name.
#[test]
#[cfg(target_os = "linux")]
fn the_library_has_a_name_of_its_own() {
    let library = compile::library_folder().join("libtree_ffi.so");
    let said = Command::new("readelf").arg("-d").arg(&library).output().unwrap();
    let said = String::from_utf8(said.stdout).unwrap();
    assert!(said.lines().any(|l| l.contains("SONAME") && l.contains("[libtree_ffi.so]")), "{said}");
}
