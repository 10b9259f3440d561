#![no_main]

use tree_mesh::io::ply;

libfuzzer_sys::fuzz_target!(|data: &[u8]| tree_fuzz::check(ply::from_slice(
    data,
    &tree_fuzz::control()
)));
