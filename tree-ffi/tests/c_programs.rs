//! C programs against the library, with the machine's compiler.

use std::path::{Path, PathBuf};
use std::process::Command;

const STRICT: &[&str] = &["-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-g"];

fn here() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Where cargo put the library for this test.
fn library_folder() -> PathBuf {
    std::env::current_exe().unwrap().parent().unwrap().to_path_buf()
}

#[test]
fn every_function_works_from_c() {
    let out = library_folder().join("c_test");
    let mut sources: Vec<_> = std::fs::read_dir(here().join("tests/c"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "c"))
        .collect();
    sources.sort();
    let built = Command::new("cc")
        .args(STRICT)
        .arg("-I")
        .arg(here().join("../include"))
        .args(&sources)
        .arg("-L")
        .arg(library_folder())
        .args(["-ltree_ffi", "-lm", "-lpthread", "-o"])
        .arg(&out)
        .status()
        .expect("a C compiler");
    assert!(built.success());
    let ran = Command::new(&out).env("LD_LIBRARY_PATH", library_folder()).output().unwrap();
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stdout));
}
