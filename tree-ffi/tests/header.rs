//! `include/tree.h` is what cbindgen makes of this crate.

use std::path::Path;

/// Constants of the type their functions take: `long` and `double` would warn.
fn with_types(header: &str) -> String {
    let typed = |line: &str| match line.strip_prefix("#define ").and_then(|l| l.split_once(' ')) {
        Some((_, value)) if value.parse::<u32>().is_ok_and(|v| v > i32::MAX as u32) => {
            format!("{line}u")
        }
        Some((_, value)) if value.contains('.') && value.parse::<f32>().is_ok() => {
            format!("{line}f")
        }
        _ => line.to_owned(),
    };
    header.lines().map(typed).collect::<Vec<_>>().join("\n") + "\n"
}

/// Written anew with `TREE_UPDATE=1 cargo test -p tree-ffi --test header`.
#[test]
fn the_header_is_up_to_date() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut config = cbindgen::Config::from_file(here.join("cbindgen.toml")).unwrap();
    let conventions: String = include_str!("../CONVENTIONS.md")
        .lines()
        .map(|line| format!("// {}", line.replace("**", "")).trim_end().to_owned() + "\n")
        .collect();
    let first = config.after_includes.unwrap_or_default();
    config.after_includes = Some(format!("\n{conventions}{first}"));
    let mut made = Vec::new();
    cbindgen::Builder::new()
        .with_crate(here)
        .with_config(config)
        .generate()
        .expect("cbindgen reads this crate")
        .write(&mut made);
    let made = with_types(&String::from_utf8(made).unwrap());
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
