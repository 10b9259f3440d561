//! `examples/csharp/TreeNative.cs` is what `host/csharp.rs` makes of `include/tree.h`.

mod host;

/// Written anew with `TREE_UPDATE=1 cargo test -p tree-ffi --test csharp`, after the header.
#[test]
fn the_csharp_layer_is_up_to_date() {
    let made = host::csharp::write(&host::header()).unwrap();
    let path = host::root().join("examples/csharp/TreeNative.cs");
    if std::env::var_os("TREE_UPDATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        made == found,
        "TreeNative.cs is out of date: TREE_UPDATE=1 cargo test -p tree-ffi --test csharp"
    );
}
