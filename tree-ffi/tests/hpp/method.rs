//! A C function as C++ sees it: whose method it is, and its text.

use crate::camel;
use crate::common::header::{Function, Header};
use crate::{facts, plain};

/// How arrays come out of a call.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Arrays {
    /// As vectors.
    Made,
    /// Into the caller's own.
    Filled,
}

/// What the caller hands over.
pub(crate) struct Taken {
    /// With the space after it.
    pub(crate) kind: String,
    pub(crate) name: String,
    /// Holds when all arguments after it are left out too.
    pub(crate) default: Option<&'static str>,
}

/// What the caller gets.
pub(crate) struct Given {
    pub(crate) kind: String,
    pub(crate) value: String,
    /// Done to it when the call fails.
    pub(crate) undo: String,
    /// Whether it points into the object.
    pub(crate) is_view: bool,
}

pub(crate) struct Method<'a> {
    pub(crate) function: &'a Function,
    pub(crate) owner: Option<&'a str>,
    pub(crate) arrays: Arrays,
    /// Whether there is an array that could come out either way.
    pub(crate) fills: bool,
    /// Whether all such arrays can be made before the call.
    pub(crate) can_make: bool,
    is_static: bool,
    is_const: bool,
    of_handle: bool,
    name: String,
    pub(crate) taken: Vec<Taken>,
    /// Statements before the call.
    pub(crate) before: Vec<String>,
    /// Conditions that the library cannot see.
    pub(crate) expected: Vec<String>,
    pub(crate) passed: Vec<String>,
    /// Arguments with functions of the caller's.
    pub(crate) calls_back: Vec<String>,
    /// Statements after a call that went well.
    pub(crate) after: Vec<String>,
    pub(crate) given: Vec<Given>,
}

impl<'a> Method<'a> {
    /// One, or one for each way that arrays come out.
    pub(crate) fn all(header: &'a Header, function: &'a Function) -> Vec<Self> {
        let filled = Self::of(header, function, Arrays::Filled);
        let mut all = Vec::new();
        if filled.fills && filled.can_make {
            all.push(Self::of(header, function, Arrays::Made));
        }
        all.push(filled);
        all
    }

    fn of(header: &'a Header, function: &'a Function, arrays: Arrays) -> Self {
        let mut method = Self {
            function,
            owner: None,
            arrays,
            fills: false,
            can_make: true,
            is_static: false,
            is_const: false,
            of_handle: false,
            name: plain(function.name.trim_start_matches("tree_")),
            taken: Vec::new(),
            before: Vec::new(),
            expected: Vec::new(),
            passed: Vec::new(),
            calls_back: Vec::new(),
            after: Vec::new(),
            given: Vec::new(),
        };
        method.find_owner(header);
        let mut at = 0;
        if !method.is_static && method.owner.is_some() {
            method.passed.push(if method.of_handle { "get()" } else { "this" }.to_owned());
            at = 1;
        }
        while at < function.arguments.len() {
            at += method.argument(header, &function.arguments[at..]);
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
        let is_handle = stars == 1 && header.handles.iter().any(|handle| handle == base);
        // What makes another object and is named for that: `Mesh::build(tree, look)`. Not a photo session's
        // method that makes a photo.
        let makes = |handle: &&String| {
            let place = format!("{handle} **");
            **handle != base
                && !(is_handle && owned_by(base) && base.len() > handle.len())
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
            if let Some(handle) = made.max_by_key(|handle| handle.len()) {
                self.owner = Some(handle);
                self.is_static = true;
                self.name = short(handle);
            }
        }
        self.of_handle = header.handles.iter().any(|one| Some(one.as_str()) == self.owner);
        // A method's name must not hide the class's own.
        let own = ["get", "reset", "release", "place"];
        if self.of_handle && own.contains(&self.name.as_str()) {
            self.name.push('_');
        }
    }

    fn fails(&self) -> bool {
        self.function.returns == "tree_status"
    }

    fn returns(&self) -> String {
        if !self.fails() {
            return match self.function.returns.as_str() {
                "const char *" => "std::string_view".to_owned(),
                other => other.to_owned(),
            };
        }
        match self.given.as_slice() {
            [] => "bool".to_owned(),
            [one] => one.kind.clone(),
            several => {
                let kinds: Vec<_> = several.iter().map(|one| one.kind.as_str()).collect();
                format!("std::tuple<{}>", kinds.join(", "))
            }
        }
    }

    /// Whether a temporary must not be asked.
    fn is_view(&self) -> bool {
        self.of_handle && !self.is_static && self.given.iter().any(|one| one.is_view)
    }

    fn arguments(&self, with_defaults: bool) -> String {
        let last = self.taken.iter().rposition(|one| one.default.is_none());
        let list = self.taken.iter().enumerate().map(|(i, one)| match one.default {
            Some(value) if with_defaults && last.is_none_or(|last| i > last) => {
                format!("{}{} = {value}", one.kind, one.name)
            }
            _ => format!("{}{}", one.kind, one.name),
        });
        list.collect::<Vec<_>>().join(", ")
    }

    pub(crate) fn declaration(&self) -> String {
        let head = format!("{} {}({})", self.returns(), self.name, self.arguments(true));
        match self.owner {
            Some(_) if self.is_static => format!("    static {head};\n"),
            Some(_) if self.is_view() => {
                format!("    {head} const &;\n    {head} const && = delete;\n")
            }
            Some(_) if self.is_const => format!("    {head} const;\n"),
            Some(_) => format!("    {head};\n"),
            None => format!("{head};\n"),
        }
    }

    pub(crate) fn body(&self) -> String {
        let class = self.owner.map_or(String::new(), |owner| camel(owner) + "::");
        let end = if self.is_view() {
            " const &"
        } else if self.is_const && !self.is_static {
            " const"
        } else {
            ""
        };
        let returns = self.returns();
        let head = format!("inline {returns} {class}{}({}){end}", self.name, self.arguments(false));
        format!("{head} {{\n{}}}\n", self.code())
    }

    fn code(&self) -> String {
        let call = format!("{}({})", self.function.name, self.passed.join(", "));
        if !self.fails() {
            let back = if self.function.returns == "void" { "" } else { "return " };
            return format!("    {back}{call};\n");
        }
        let with: String = self.calls_back.iter().map(|one| format!(", {one}")).collect();
        let mut all = self.expected.clone();
        all.push(format!("detail::done({call}{with})"));
        let well = all.join("\n        && ");
        if self.given.is_empty() {
            return format!("    return {well};\n");
        }
        let lines = |list: &[String]| -> String {
            list.iter().map(|line| format!("    {line}\n")).collect()
        };
        let undo: Vec<_> = self.given.iter().map(|one| one.undo.as_str()).collect();
        let undo = undo.into_iter().filter(|one| !one.is_empty()).collect::<Vec<_>>().join(" ");
        let call = if !undo.is_empty() {
            format!("    if (!({well})) {{ {undo} }}\n")
        } else if all.len() > 1 {
            format!("    static_cast<void>({well});\n")
        } else {
            format!("    {well};\n")
        };
        let value = match self.given.as_slice() {
            [one] => one.value.clone(),
            several => {
                let moved = several.iter().map(|one| {
                    let is_name = one.value.chars().all(|c| c.is_alphanumeric() || c == '_');
                    if is_name { format!("std::move({})", one.value) } else { one.value.clone() }
                });
                format!("{{{}}}", moved.collect::<Vec<_>>().join(", "))
            }
        };
        format!("{}{call}{}    return {value};\n", lines(&self.before), lines(&self.after))
    }
}

/// The type without const and stars.
pub(crate) fn base(kind: &str) -> &str {
    let kind = kind.strip_prefix("const ").unwrap_or(kind);
    kind.split([' ', '*', '(']).next().unwrap_or("")
}

/// Whether a call of this name and arguments is told a struct in which there are callbacks.
pub(crate) fn calls_back(header: &Header, base: &str) -> bool {
    base == "tree_control"
        || header
            .structs
            .get(base)
            .is_some_and(|fields| fields.iter().any(|field| facts::is_field(header, &field.kind)))
}
