#![no_main]

use tree_core::swc;

libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let options = swc::SwcOptions::default();
    if let Ok(import) = swc::read(&text, &options, &tree_fuzz::limits()) {
        let again = swc::write(&import.skeleton, &options).expect("a skeleton that was read");
        let _ = swc::read(&again, &options, &tree_fuzz::limits());
    }
});
