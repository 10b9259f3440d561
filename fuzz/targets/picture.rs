#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| tree_promises::pictures::picture(data));
