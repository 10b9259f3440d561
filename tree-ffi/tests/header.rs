//! `include/tree.h` is what cbindgen makes of this crate.

use std::path::Path;

/// Written anew with `TREE_UPDATE=1 cargo test -p tree-ffi --test header`.
#[test]
fn the_header_is_up_to_date() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut config = cbindgen::Config::from_file(here.join("cbindgen.toml")).unwrap();
    let conventions: String = include_str!("../CONVENTIONS.md")
        .lines()
        .map(|line| format!("// {line}").trim_end().to_owned() + "\n")
        .collect();
    let title = config.header.unwrap_or_default();
    config.header = Some(format!("{title}\n\n// Conventions\n//\n{conventions}"));
    let mut made = Vec::new();
    cbindgen::Builder::new()
        .with_crate(here)
        .with_config(config)
        .generate()
        .expect("cbindgen reads this crate")
        .write(&mut made);
    let made = String::from_utf8(made).unwrap();
    let path = here.join("../include/tree.h");
    if std::env::var_os("TREE_UPDATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        made == found,
        "include/tree.h is out of date: TREE_UPDATE=1 cargo test -p tree-ffi --test header"
    );
}
