#![no_main]

use tree_mesh::io::gltf;

libfuzzer_sys::fuzz_target!(|data: &[u8]| tree_fuzz::check(gltf::from_slice(
    data,
    &tree_fuzz::control()
)));
