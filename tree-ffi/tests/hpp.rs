//! `include/tree.hpp` is made of `include/tree.h`, so that it has every function and stays as it is.
//!
//! Objects become classes, structs with a size become structs with a constructor, and functions become
//! methods of what they are told first, or named for.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test says what failed by failing"
)]

mod common;
#[path = "hpp/facts.rs"]
mod facts;
#[path = "hpp/method.rs"]
mod method;
#[path = "hpp/takes.rs"]
mod takes;

use common::compile::{self, CPP17};
use common::header::{self, Header};
use method::Method;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Written anew with `TREE_UPDATE=1 cargo test -p tree-ffi --test hpp`, after the header.
#[test]
fn the_cpp_header_is_up_to_date() {
    let header = header::parse(&header::text());
    let made = wrapper(&header);
    let path = compile::root().join("include/tree.hpp");
    if std::env::var_os("TREE_UPDATE").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        made == found,
        "include/tree.hpp is out of date: TREE_UPDATE=1 cargo test -p tree-ffi --test hpp"
    );
}

#[test]
fn every_function_is_in_the_cpp_header() {
    let header = header::parse(&header::text());
    let wrapper = wrapper(&header);
    let called = |name: &str| {
        let free = name.ends_with("_free") && wrapper.contains(&format!("{name}>"));
        free || wrapper.contains(&format!("{name}("))
    };
    let names = header.functions.iter().map(|function| function.name.as_str());
    let missing: Vec<_> = names.filter(|name| !called(name)).collect();
    assert!(missing.is_empty(), "tree.hpp lacks {missing:?}");
}

#[test]
fn both_headers_stand_alone_in_cpp() {
    let folder = compile::folder("hpp");
    for (name, flags) in [
        ("tree.h", CPP17.to_vec()),
        ("tree.hpp", CPP17.to_vec()),
        ("tree.hpp", [CPP17, &["-fno-exceptions", "-fno-rtti"]].concat()),
    ] {
        let source = folder.join("alone.cpp");
        std::fs::write(&source, format!("#include \"{name}\"\nint main() {{ return 0; }}\n"))
            .unwrap();
        compile::compile("c++", &flags, &[source], "alone");
    }
}

fn camel(name: &str) -> String {
    let words = name.trim_start_matches("tree_").split('_');
    words.map(|word| word[..1].to_uppercase() + &word[1..]).collect()
}

/// A name that C++ keeps for itself gets a line after it.
fn plain(name: &str) -> String {
    match name {
        "new" => "make".to_owned(),
        "union" | "default" | "delete" | "class" | "template" | "operator" => format!("{name}_"),
        _ => name.to_owned(),
    }
}

fn wrapper(header: &Header) -> String {
    let mut code = include_str!("hpp/begin.hpp").to_owned();
    for handle in &header.handles {
        writeln!(code, "class {};", camel(handle)).unwrap();
    }
    let mut structs = BTreeMap::new();
    for name in header.structs.keys().filter(|name| *name != "tree_str") {
        if header.is_sized(name) && name != "tree_control" {
            writeln!(code, "struct {};", camel(name)).unwrap();
            structs.insert(name.as_str(), String::new());
        } else if name != "tree_control" {
            writeln!(code, "using {} = {name};", camel(name)).unwrap();
        }
    }
    let mut classes: BTreeMap<&str, String> =
        header.handles.iter().map(|handle| (handle.as_str(), String::new())).collect();
    let (mut free, mut bodies) = (String::new(), String::new());
    for function in &header.functions {
        let name = function.name.as_str();
        let in_prelude = ["tree_error_text", "tree_error_status", "tree_error_clear"];
        let frees = header.handles.iter().any(|handle| name == format!("{handle}_free"));
        if name.ends_with("_init") || frees || in_prelude.contains(&name) {
            continue;
        }
        for method in Method::all(header, function) {
            bodies.push_str(&method.body());
            let list = match method.owner {
                Some(owner) if header.handles.iter().any(|one| one == owner) => {
                    classes.entry(owner).or_default()
                }
                Some(owner) => structs.entry(owner).or_default(),
                None => &mut free,
            };
            list.push_str(&method.declaration());
        }
    }
    for (name, methods) in &structs {
        let class = camel(name);
        let methods = methods.clone() + &set_functions(header, name);
        let init = format!("{name}_init");
        let begin = if header.functions.iter().any(|function| function.name == init) {
            format!("{init}(this, sizeof({name}));")
        } else {
            "struct_size = sizeof *this;".to_owned()
        };
        write!(
            code,
            "\nstruct {class} : {name} {{\n    {class}() : {name}{{}} {{ {begin} }}\n{methods}}};\n"
        )
        .unwrap();
    }
    for (name, methods) in &classes {
        let class = camel(name);
        write!(
            code,
            "\nclass {class} : public detail::Object<{name}, {name}_free> {{\npublic:\n    \
             using Object::Object;\n{methods}}};\n"
        )
        .unwrap();
    }
    let end = "} // namespace tree\n\n#endif // TREE_HPP\n";
    format!("{code}\n{free}\n{}\n{bodies}\n{end}", done(header))
}

/// Fields of a struct that hold a function of a place, as `tree::Field` is.
fn fields_of_functions<'a>(header: &'a Header, name: &str) -> Vec<&'a str> {
    let fields = header.structs.get(name).map_or(&[][..], Vec::as_slice);
    let is_one = |field: &&header::Named| facts::is_field(header, &field.kind);
    fields.iter().filter(is_one).map(|field| field.name.as_str()).collect()
}

/// Methods that put a `tree::Field` into a struct.
fn set_functions(header: &Header, name: &str) -> String {
    let mut code = String::new();
    for field in fields_of_functions(header, name) {
        writeln!(
            code,
            "    // `{field}` must live as long as this is used.\n    \
             {class} &set_{field}(const Field &function) {{\n        \
             this->{field} = function.function();\n        \
             this->{field}_user = function.user();\n        return *this;\n    }}\n    \
             {class} &set_{field}(const Field &&) = delete;",
            class = camel(name)
        )
        .unwrap();
    }
    code
}

/// What ends each call: what the caller's functions threw is thrown on, and then what the library says.
fn done(header: &Header) -> String {
    let mut code = "namespace detail {\n\n".to_owned();
    for (name, fields) in &header.structs {
        let functions = fields_of_functions(header, name);
        if functions.is_empty() {
            continue;
        }
        writeln!(code, "inline void rethrow(const {name} *params) {{\n    if (!params) return;")
            .unwrap();
        for field in functions {
            writeln!(
                code,
                "    if (params->{field} == Field::call) \
                 static_cast<Field *>(params->{field}_user)->rethrow();"
            )
            .unwrap();
        }
        let own = format!("const {name} *");
        for inner in fields.iter().filter(|field| field.kind == own) {
            writeln!(code, "    rethrow(params->{});", inner.name).unwrap();
        }
        code.push_str("}\n");
    }
    code + "\n// What every call ends with: whether it went well.\n\
            template <class... With>\n\
            bool done(tree_status code, const With &...with) {\n    \
            (rethrow(with), ...);\n    return tree::check(code);\n}\n\n} // namespace detail\n"
}
