#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| tree_promises::c_abi::c_abi(data));
