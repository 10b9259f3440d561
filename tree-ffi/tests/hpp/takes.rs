//! How each argument of a C function is taken from a C++ caller, or given to him.

use crate::camel;
use crate::common::header::{Header, Named};
use crate::facts;
use crate::method::{Arrays, Given, Method, Taken, base, calls_back};

impl Method<'_> {
    /// Takes the first of the arguments, with those that go with it; how many they were.
    pub(crate) fn argument(&mut self, header: &Header, left: &[Named]) -> usize {
        let one = &left[0];
        let next = left.get(1);
        let kind = one.kind.as_str();
        if kind == "const char *" && next.is_some_and(is_count) {
            return self.text(&one.name);
        }
        if let Some(n) = arrays_in(header, left) {
            return self.arrays_in(header, &left[..n]);
        }
        if facts::is_field(header, kind) {
            self.take("const Field &", &one.name, None);
            self.pass(&format!("{}.function()", one.name));
            self.pass(&format!("{}.user()", one.name));
            self.calls_back.push(one.name.clone());
            return 2;
        }
        if !kind.contains('*') {
            self.number(one);
            return 1;
        }
        if kind.starts_with("const ") {
            return self.pointer_in(header, one, next);
        }
        self.out(header, left)
    }

    fn text(&mut self, name: &str) -> usize {
        self.take("std::string_view ", name, None);
        // A text without bytes may have no address.
        self.pass(&format!("{name}.data() ? {name}.data() : \"\""));
        self.pass(&format!("{name}.size()"));
        2
    }

    fn number(&mut self, one: &Named) {
        let name = &one.name;
        if facts::FLAGS.contains(&name.as_str()) {
            self.take("bool ", name, None);
            self.pass(&format!("{name} ? 1u : 0u"));
        } else {
            self.take(&format!("{} ", one.kind), name, None);
            self.pass(name);
        }
    }

    /// Arrays with one count after them.
    fn arrays_in(&mut self, header: &Header, arrays: &[Named]) -> usize {
        let function = self.function.name.clone();
        let length = |one: &Named| match facts::width(&function, &one.name) {
            1 => format!("{}.size()", one.name),
            width => format!("{}.size() / {width}", one.name),
        };
        for one in arrays {
            let (name, inner) = (&one.name, base(&one.kind));
            let default = facts::is_optional(&function, name).then_some("{}");
            if header.handles.iter().any(|handle| handle == inner) {
                self.take(&format!("const Handles<{inner}> &"), name, default);
            } else {
                self.take(&format!("Span<const {inner}> "), name, default);
            }
            let width = facts::width(&function, name);
            if width > 1 {
                let text = format!("{name}: must have {width} numbers for each item");
                self.expect(&format!("{name}.size() % {width} == 0"), "TREE_ERROR_BUFFER", &text);
            }
            if name != &arrays[0].name {
                let text = format!("{} and {name} must be of one length", arrays[0].name);
                let same = format!("{} == {}", length(&arrays[0]), length(one));
                self.expect(&same, "TREE_ERROR_BUFFER", &text);
            }
            self.pass(&format!("{name}.data()"));
        }
        self.pass(&length(&arrays[0]));
        arrays.len() + 1
    }

    /// Something the call reads: an object, parameters, a few floats; or a view that it gives.
    fn pointer_in(&mut self, header: &Header, one: &Named, next: Option<&Named>) -> usize {
        let (name, inner) = (&one.name, base(&one.kind));
        let stars = one.kind.matches('*').count();
        if let (2, Some(count)) = (stars, next.filter(|next| next.kind == "size_t *")) {
            self.before.push(format!("const {inner} *{name} = nullptr;"));
            self.before.push(format!("size_t {} = 0;", count.name));
            let span = format!("Span<const {inner}>");
            let value = format!("{span}({name}, {})", count.name);
            self.give(&span, &value, "", true);
            self.pass(&format!("&{name}"));
            self.pass(&format!("&{}", count.name));
            return 2;
        }
        assert!(stars == 1, "hpp: what is {name} of {}?", self.function.name);
        if header.handles.iter().any(|handle| handle == inner) {
            if facts::is_optional(&self.function.name, name) {
                self.take(&format!("Maybe<{inner}> "), name, Some("nullptr"));
                let text = format!("{name}: empty; leave it out, or hand over nullptr");
                self.expect(&format!("{name}.fits()"), "TREE_ERROR_NULL", &text);
                self.pass(name);
            } else {
                self.take(&format!("const {} &", camel(inner)), name, None);
                self.pass(&format!("{name}.get()"));
            }
        } else if header.is_sized(inner) {
            let default = (!facts::is_required(name)).then_some("nullptr");
            self.take(&format!("Ref<{inner}> "), name, default);
            self.pass(name);
            if calls_back(header, inner) {
                self.calls_back.push(name.clone());
            }
        } else if header.structs.contains_key(inner) {
            self.take(&format!("const {inner} &"), name, None);
            self.pass(&format!("&{name}"));
        } else {
            assert!(inner == "float", "hpp: how long is {name} of {}?", self.function.name);
            self.take(
                &format!("const Floats<{}> &", facts::fixed(&self.function.name, name)),
                name,
                None,
            );
            self.pass(name);
        }
        1
    }

    /// Something the call writes.
    fn out(&mut self, header: &Header, left: &[Named]) -> usize {
        let one = &left[0];
        let (name, kind, inner) = (one.name.as_str(), one.kind.as_str(), base(&one.kind));
        if let Some(n) = kind.rsplit_once(")[").map(|(_, n)| n.trim_end_matches(']')) {
            let array = format!("std::array<{inner}, {n}>");
            self.before.push(format!("{array} {name}{{}};"));
            self.give(&array, name, "", false);
            self.pass(&format!("reinterpret_cast<{inner}(*)[{n}]>({name}.data())"));
            return 1;
        }
        if header.handles.iter().any(|handle| handle == inner) {
            assert!(kind.ends_with("**"), "hpp: {name} of {} is taken?", self.function.name);
            self.before.push(format!("{} {name};", camel(inner)));
            self.give(&camel(inner), name, "", false);
            self.pass(&format!("{name}.place()"));
            return 1;
        }
        if header.is_sized(inner) {
            return self.sized_out(header, left);
        }
        if inner == "tree_str" {
            self.before.push(format!("tree_str {name}{{}};"));
            self.give("std::string_view", &format!("detail::text({name})"), "", true);
            self.pass(&format!("&{name}"));
            return 1;
        }
        if inner == "uint32_t" && (name.starts_with("is_") || self.says_whether()) {
            self.before.push(format!("uint32_t {name} = 0;"));
            self.give("bool", &format!("{name} != 0"), "", false);
            self.pass(&format!("&{name}"));
            return 1;
        }
        if facts::SINGLES.contains(&name) || inner == "size_t" {
            self.before.push(format!("{inner} {name}{{}};"));
            self.give(inner, name, "", facts::has_pointers(header, inner));
            self.pass(&format!("&{name}"));
            return 1;
        }
        self.arrays_out(left)
    }

    /// `tree_capsule_contains`, of one point.
    fn says_whether(&self) -> bool {
        let asks = self.function.name.ends_with("_contains");
        asks && !self.function.arguments.iter().any(is_count)
    }

    fn sized_out(&mut self, header: &Header, left: &[Named]) -> usize {
        let (name, inner) = (&left[0].name, base(&left[0].kind));
        let makes = self.function.arguments.iter().any(|one| one.kind.ends_with("**"));
        if inner.ends_with("_report") && makes {
            self.take(&format!("{inner} *"), name, Some("nullptr"));
            self.pass(name);
            return 1;
        }
        let class = camel(inner);
        self.before.push(format!("{class} {name};"));
        let is_view = facts::has_pointers(header, inner);
        self.give(&class, name, &format!("{name}.struct_size = 0;"), is_view);
        self.pass(&format!("&{name}"));
        if left.get(1).is_some_and(|next| next.name == "size" && next.kind == "size_t") {
            self.pass(&format!("sizeof({inner})"));
            return 2;
        }
        1
    }

    /// Arrays that the call fills, with the room in them after them or not.
    fn arrays_out(&mut self, left: &[Named]) -> usize {
        let is_place = |one: &&Named| one.kind.ends_with('*') && !one.kind.ends_with("**");
        let n = left.iter().take_while(is_place).count();
        let has_room = left.get(n).is_some_and(|after| after.name.ends_with("capacity"));
        let arrays = &left[..if has_room { n } else { 1 }];
        self.fills = true;
        let function = self.function.name.clone();
        for one in arrays {
            let (name, inner) = (&one.name, base(&one.kind));
            let room = facts::room(&function, name);
            self.can_make &= room.is_some();
            if self.arrays == Arrays::Made {
                let room = room.unwrap_or("0");
                self.before.push(format!("std::vector<{inner}> {name}({room});"));
                self.give(
                    &format!("std::vector<{inner}>"),
                    name,
                    &format!("{name}.clear();"),
                    false,
                );
                if let Some(n) = facts::written(&function, name) {
                    self.after.push(format!("{name}.resize({n});"));
                }
            } else {
                self.take(&format!("Span<{inner}> "), name, None);
                if !has_room {
                    let room = room.unwrap_or_else(|| {
                        panic!("say in hpp/facts.rs how long {name} of {function} is")
                    });
                    let holds = format!("(!{name}.data() || {name}.size() >= ({room}))");
                    let text = format!("{name}: not room enough");
                    self.expect(&holds, "TREE_ERROR_BUFFER", &text);
                }
            }
            self.pass(&format!("{name}.data()"));
        }
        if !has_room {
            return 1;
        }
        let lengths = arrays.iter().map(|one| format!("{{{0}.data(), {0}.size()}}", one.name));
        match arrays {
            [one] => self.pass(&format!("{}.size()", one.name)),
            _ => self
                .pass(&format!("detail::shortest({{{}}})", lengths.collect::<Vec<_>>().join(", "))),
        }
        arrays.len() + 1
    }

    fn take(&mut self, kind: &str, name: &str, default: Option<&'static str>) {
        self.taken.push(Taken { kind: kind.to_owned(), name: name.to_owned(), default });
    }

    fn pass(&mut self, what: &str) {
        self.passed.push(what.to_owned());
    }

    fn expect(&mut self, holds: &str, code: &str, text: &str) {
        self.expected.push(format!("detail::expect({holds}, {code}, \"{text}\")"));
    }

    fn give(&mut self, kind: &str, value: &str, undo: &str, is_view: bool) {
        let (kind, value, undo) = (kind.to_owned(), value.to_owned(), undo.to_owned());
        self.given.push(Given { kind, value, undo, is_view });
    }
}

fn is_count(one: &Named) -> bool {
    one.kind == "size_t"
        && (one.name == "n" || one.name.starts_with("n_") || one.name.ends_with("len"))
}

/// How many arrays begin the arguments that one count comes after; `None` where none does.
fn arrays_in(header: &Header, left: &[Named]) -> Option<usize> {
    let is_array = |one: &Named| {
        let inner = base(&one.kind);
        let of_handles = header.handles.iter().any(|handle| handle == inner);
        let stars = if of_handles { 2 } else { 1 };
        one.kind.starts_with("const ")
            && inner != "char"
            && inner != "void"
            && one.kind.matches('*').count() == stars
            && !one.kind.contains('(')
    };
    if !is_array(&left[0]) {
        return None;
    }
    let n = left.iter().take_while(|one| is_array(one)).count();
    let counted = left.get(n).is_some_and(is_count);
    let together = left[0].kind.matches('*').count() == 2 || facts::shares_count(&left[0].name);
    (counted && (n == 1 || together)).then_some(n)
}
