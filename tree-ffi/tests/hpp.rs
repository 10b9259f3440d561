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

use common::compile::{self, CPP17};
use common::header::{self, Function, Header, Named};
use std::collections::BTreeMap;
use std::fmt::Write;

/// Places for results that are arrays without a capacity next to them.
const ARRAYS: &[&str] = &[
    "bent",
    "costs",
    "distances",
    "first",
    "inside",
    "of_vertex",
    "points",
    "predecessors",
    "reached",
    "rows",
    "to",
];
/// Places for one number or one struct without a size.
const SINGLES: &[&str] = &[
    "measure",
    "metres",
    "phase",
    "radius",
    "reach",
    "row",
    "seconds",
    "sway",
    "n_threads",
    "volume",
];

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
        ("tree.hpp", [CPP17, &["-fno-exceptions"]].concat()),
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
        let method = Method::of(header, function);
        let body = method.body();
        match method.owner {
            Some(owner) => {
                let list = if header.handles.iter().any(|one| one == owner) {
                    &mut classes
                } else {
                    &mut structs
                };
                list.entry(owner).or_default().push_str(&method.declaration());
                bodies.push_str(&body);
            }
            None => {
                free.push_str(&method.declaration());
                bodies.push_str(&body);
            }
        }
    }
    for (name, methods) in &structs {
        let class = camel(name);
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
    format!("{code}\n{free}\n{bodies}\n}} // namespace tree\n\n#endif // TREE_HPP\n")
}

/// A C function as C++ sees it.
struct Method<'a> {
    function: &'a Function,
    owner: Option<&'a str>,
    is_static: bool,
    is_const: bool,
    name: String,
    /// Type, name, whether it may be left out when all after it may.
    taken: Vec<(String, String, Option<&'static str>)>,
    before: String,
    passed: Vec<String>,
    /// Type and value.
    given: Vec<(String, String)>,
}

impl<'a> Method<'a> {
    fn of(header: &'a Header, function: &'a Function) -> Self {
        let mut method = Self {
            function,
            owner: None,
            is_static: false,
            is_const: false,
            name: plain(function.name.trim_start_matches("tree_")),
            taken: Vec::new(),
            before: String::new(),
            passed: Vec::new(),
            given: Vec::new(),
        };
        method.find_owner(header);
        let mut at = usize::from(!method.is_static && method.owner.is_some());
        if at == 1 {
            let handle = header.handles.iter().any(|one| Some(one.as_str()) == method.owner);
            method.passed.push(if handle { "get()" } else { "this" }.to_owned());
        }
        while at < function.arguments.len() {
            at += method.argument(header, &function.arguments[at], function.arguments.get(at + 1));
        }
        method
    }

    fn find_owner(&mut self, header: &'a Header) {
        let function = self.function;
        let owned_by = |base: &str| function.name.starts_with(&format!("{base}_"));
        let short = |base: &str| plain(&function.name[base.len() + 1..]);
        let first = function.arguments.first();
        let base = first.map_or("", |first| base(&first.kind));
        let stars = first.map_or(0, |first| first.kind.matches('*').count());
        // What makes another object and is named for that: `Mesh::build(tree, look)`.
        let makes = |handle: &&String| {
            let place = format!("{handle} **");
            **handle != base
                && owned_by(handle)
                && function.arguments.iter().any(|one| one.kind == place)
        };
        if let Some(handle) = header.handles.iter().find(makes) {
            self.owner = Some(handle);
            self.is_static = true;
            self.name = short(handle);
        } else if let Some(handle) = header.handles.iter().find(|one| *one == base && stars == 1) {
            self.owner = Some(handle);
            self.is_const = true;
            if owned_by(handle) {
                self.name = short(handle);
            }
        } else if header.is_sized(base) && stars == 1 && owned_by(base) {
            let (name, _) = header.structs.get_key_value(base).expect("it is sized");
            self.owner = Some(name);
            self.name = short(base);
            self.is_const = first.is_some_and(|first| first.kind.starts_with("const "));
            self.is_static = function.arguments.get(1).is_some_and(|second| second.name == "size");
        } else {
            let made = header.handles.iter().filter(|handle| owned_by(handle));
            let longest = made.max_by_key(|handle| handle.len());
            if let Some(handle) = longest {
                self.owner = Some(handle);
                self.is_static = true;
                self.name = short(handle);
            }
        }
        // A method's name must not hide the class's own.
        if ["get", "reset", "release"].contains(&self.name.as_str()) {
            self.name.push('_');
        }
    }

    /// Takes an argument, or two that go together; how many they were.
    fn argument(&mut self, header: &Header, one: &Named, next: Option<&Named>) -> usize {
        let (name, kind) = (one.name.clone(), one.kind.as_str());
        let base = base(kind);
        let stars = kind.matches('*').count();
        let is_const = kind.starts_with("const ");
        let next_name = next.map_or("", |next| next.name.as_str());
        let counted = next.is_some_and(|next| next.kind == "size_t")
            && (next_name == "n" || next_name.starts_with("n_") || next_name.ends_with("len"));
        let handle = header.handles.iter().any(|one| one == base);
        let given_size = next.is_some_and(|next| next.name == "size" && next.kind == "size_t");
        if kind == "const char *" && counted {
            self.take("std::string_view", &name, None);
            self.pass(&format!("{name}.data()"));
            // A text without bytes may have no address.
            self.passed.pop();
            self.pass(&format!("{name}.data() ? {name}.data() : \"\""));
            self.pass(&format!("{name}.size()"));
            return 2;
        }
        if is_const && counted && handle && stars == 2 {
            self.take(&format!("Span<const {base} *const>"), &name, None);
            return self.pass_span(&name);
        }
        let rows = base == "uint8_t" || header.structs.contains_key(base);
        if is_const && counted && stars == 1 && rows {
            self.take(&format!("Span<const {base}>"), &name, None);
            return self.pass_span(&name);
        }
        if handle && stars == 2 {
            self.give(&camel(base), &format!("{base} *{name} = nullptr;"), &format!("&{name}"));
            self.given.last_mut().expect("just given").1 = format!("{}({name})", camel(base));
            return 1;
        }
        if kind.contains(")[") {
            let n = kind.rsplit('[').next().unwrap_or("").trim_end_matches(']');
            let array = format!("std::array<{base}, {n}>");
            let pass = format!("reinterpret_cast<{base}(*)[{n}]>({name}.data())");
            self.give(&array, &format!("{array} {name}{{}};"), &pass);
            return 1;
        }
        if is_const && stars == 2 && next.is_some_and(|next| next.kind == "size_t *") {
            let count = &next.expect("just looked").name;
            let before = format!("const {base} *{name} = nullptr; size_t {count} = 0;");
            self.give(&format!("Span<const {base}>"), &before, &format!("&{name}"));
            self.given.last_mut().expect("just given").1 =
                format!("Span<const {base}>({name}, {count})");
            self.pass(&format!("&{count}"));
            return 2;
        }
        if header.is_sized(base) && stars == 1 && !is_const {
            let makes = self.function.arguments.iter().any(|one| one.kind.ends_with("**"));
            if base.ends_with("_report") && makes {
                self.take(&format!("{base} *"), &name, Some("nullptr"));
                self.pass(&name);
                return 1;
            }
            self.give(&camel(base), &format!("{} {name};", camel(base)), &format!("&{name}"));
            if given_size {
                self.pass(&format!("sizeof({base})"));
                return 2;
            }
            return 1;
        }
        if header.is_sized(base) && stars == 1 {
            self.take(&format!("Ref<{base}>"), &name, Some("nullptr"));
            self.pass(&name);
            return 1;
        }
        if base == "tree_str" && stars == 1 && !is_const {
            self.give("std::string_view", &format!("tree_str {name}{{}};"), &format!("&{name}"));
            self.given.last_mut().expect("just given").1 = format!("detail::text({name})");
            return 1;
        }
        let number = !header.structs.contains_key(base) && base != "void" && base != "char";
        let array = ARRAYS.contains(&name.as_str()) || next_name.ends_with("capacity") || counted;
        let single =
            SINGLES.contains(&name.as_str()) || base == "size_t" || name.starts_with("is_");
        let result = stars == 1 && !is_const && !handle && !["void", "char"].contains(&base);
        assert!(
            !result || array || single,
            "say in hpp.rs whether {name} of {} is one value or an array",
            self.function.name
        );
        if number && stars == 1 && !is_const && !array && !handle {
            let truth = base == "uint32_t" && name.starts_with("is_");
            let to = if truth { "bool" } else { base };
            self.give(to, &format!("{base} {name} = 0;"), &format!("&{name}"));
            if truth {
                self.given.last_mut().expect("just given").1 = format!("{name} != 0");
            }
            return 1;
        }
        if header.structs.contains_key(base) && stars == 1 && !is_const && !array {
            self.give(base, &format!("{base} {name}{{}};"), &format!("&{name}"));
            return 1;
        }
        self.taken.push((one.declaration.clone(), String::new(), None));
        self.pass(&name);
        1
    }

    fn take(&mut self, kind: &str, name: &str, default: Option<&'static str>) {
        let space = if kind.ends_with('*') { "" } else { " " };
        self.taken.push((format!("{kind}{space}"), name.to_owned(), default));
    }

    fn pass(&mut self, what: &str) {
        self.passed.push(what.to_owned());
    }

    fn pass_span(&mut self, name: &str) -> usize {
        self.pass(&format!("{name}.data()"));
        self.pass(&format!("{name}.size()"));
        2
    }

    fn give(&mut self, kind: &str, before: &str, pass: &str) {
        let name = before.trim_end_matches(|c| ";{}=0 nulptr".contains(c));
        let value = pass.trim_start_matches('&');
        let value = if value.starts_with("reinterpret") {
            name.rsplit(' ').next().unwrap_or("").trim_end_matches("{}").to_owned()
        } else {
            value.to_owned()
        };
        self.before.push_str(before);
        self.before.push(' ');
        self.given.push((kind.to_owned(), value));
        self.pass(pass);
    }

    fn returns(&self) -> String {
        if self.function.returns != "tree_status" {
            return match self.function.returns.as_str() {
                "const char *" => "std::string_view".to_owned(),
                other => other.to_owned(),
            };
        }
        match self.given.as_slice() {
            [] => "void".to_owned(),
            [(kind, _)] => kind.clone(),
            several => {
                let kinds: Vec<_> = several.iter().map(|(kind, _)| kind.as_str()).collect();
                format!("std::tuple<{}>", kinds.join(", "))
            }
        }
    }

    fn arguments(&self, with_defaults: bool) -> String {
        let last = self.taken.iter().rposition(|(_, _, default)| default.is_none());
        let list = self.taken.iter().enumerate().map(|(i, (kind, name, default))| match default {
            Some(value) if with_defaults && last.is_none_or(|last| i > last) => {
                format!("{kind}{name} = {value}")
            }
            _ => format!("{kind}{name}"),
        });
        list.collect::<Vec<_>>().join(", ")
    }

    fn declaration(&self) -> String {
        let (returns, name) = (self.returns(), &self.name);
        let arguments = self.arguments(true);
        match self.owner {
            Some(_) if self.is_static => format!("    static {returns} {name}({arguments});\n"),
            Some(_) if self.is_const => format!("    {returns} {name}({arguments}) const;\n"),
            Some(_) => format!("    {returns} {name}({arguments});\n"),
            None => format!("{returns} {name}({arguments});\n"),
        }
    }

    fn body(&self) -> String {
        let class = self.owner.map_or(String::new(), |owner| camel(owner) + "::");
        let end = if self.is_const && !self.is_static { " const" } else { "" };
        let head = format!(
            "inline {} {class}{}({}){end}",
            self.returns(),
            self.name,
            self.arguments(false)
        );
        let call = format!("{}({})", self.function.name, self.passed.join(", "));
        let values: Vec<_> = self.given.iter().map(|(_, value)| value.as_str()).collect();
        let before = self.before.trim_end();
        let code = if self.function.returns != "tree_status" {
            let back = if self.function.returns == "void" { "" } else { "return " };
            format!("    {back}{call};")
        } else if values.is_empty() {
            format!("    tree::check({call});")
        } else if let [value] = values.as_slice() {
            format!("    {before}\n    tree::check({call});\n    return {value};")
        } else {
            format!("    {before}\n    tree::check({call});\n    return {{{}}};", values.join(", "))
        };
        format!("{head} {{\n{code}\n}}\n")
    }
}

fn base(kind: &str) -> &str {
    let kind = kind.strip_prefix("const ").unwrap_or(kind);
    kind.split([' ', '*', '(']).next().unwrap_or("")
}
