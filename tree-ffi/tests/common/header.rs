//! What `include/tree.h` declares, read with as little C as cbindgen writes.

use std::collections::BTreeMap;

/// A type and a name: an argument, or a field.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    /// The declaration as it stands, such as `float (*min_max)[6]`.
    pub(crate) declaration: String,
    /// The type alone, without `struct` and with one space between words, such as `const tree_mesh *`.
    pub(crate) kind: String,
    pub(crate) name: String,
    around: (String, String),
}

impl Named {
    /// The declaration with another name.
    pub(crate) fn called(&self, name: &str) -> String {
        format!("{}{name}{}", self.around.0, self.around.1)
    }
}

#[derive(Clone, Debug)]
pub(crate) struct Function {
    pub(crate) returns: String,
    pub(crate) name: String,
    pub(crate) arguments: Vec<Named>,
}

#[derive(Debug, Default)]
pub(crate) struct Header {
    pub(crate) functions: Vec<Function>,
    /// Structs with fields.
    pub(crate) structs: BTreeMap<String, Vec<Named>>,
    /// Names of opaque objects.
    pub(crate) handles: Vec<String>,
    /// Names of numbers: `typedef uint32_t tree_x`.
    pub(crate) numbers: BTreeMap<String, String>,
    /// Types of callbacks: return type, arguments.
    pub(crate) callbacks: BTreeMap<String, (String, Vec<Named>)>,
    /// `#define TREE_X value`.
    pub(crate) constants: BTreeMap<String, String>,
}

/// The header as it is in the repository.
pub(crate) fn text() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../include/tree.h");
    std::fs::read_to_string(path).unwrap()
}

pub(crate) fn parse(text: &str) -> Header {
    let mut header = Header::default();
    for statement in statements(text, &mut header.constants) {
        header.take(&statement);
    }
    header
}

/// Statements without comments and preprocessor lines, up to their semicolon.
fn statements(text: &str, constants: &mut BTreeMap<String, String>) -> Vec<String> {
    let mut code = String::new();
    let mut in_comment = false;
    for line in text.lines() {
        let line = line.split("//").next().unwrap_or("").trim();
        if line.starts_with("/*") || in_comment {
            in_comment = !line.ends_with("*/");
            continue;
        }
        let define = line.strip_prefix("#define ").and_then(|define| define.split_once(' '));
        if let Some((name, value)) = define {
            constants.insert(name.to_owned(), value.to_owned());
        }
        let skipped = ["#", "extern \"C\""].iter().any(|start| line.starts_with(start));
        if !skipped && !line.is_empty() {
            code.push_str(line);
            code.push(' ');
        }
    }
    let (mut found, mut statement, mut depth) = (Vec::new(), String::new(), 0);
    for c in code.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ';' if depth == 0 => {
                found.push(std::mem::take(&mut statement).trim().to_owned());
                continue;
            }
            _ => {}
        }
        if depth >= 0 {
            statement.push(c);
        } else {
            depth = 0;
        }
    }
    found
}

impl Header {
    fn take(&mut self, statement: &str) {
        let Some(definition) = statement.strip_prefix("typedef ") else {
            if let Some(function) = function(statement) {
                self.functions.push(function);
            }
            return;
        };
        if let Some((_, rest)) = definition.split_once('{') {
            let (fields, name) = rest.rsplit_once('}').expect("a struct ends");
            let fields = fields.split(';').map(str::trim).filter(|field| !field.is_empty());
            self.structs.insert(name.trim().to_owned(), fields.map(named).collect());
        } else if definition.contains("(*") {
            let (returns, rest) = definition.split_once("(*").expect("just found");
            let (name, rest) = rest.split_once(')').expect("a name ends");
            let inner = rest.trim().trim_start_matches('(').trim_end_matches(')');
            let arguments = split(inner).iter().map(|one| named(one)).collect();
            self.callbacks.insert(name.to_owned(), (returns.trim().to_owned(), arguments));
        } else if let Some(opaque) = definition.strip_prefix("struct ") {
            self.handles.push(opaque.split(' ').next_back().unwrap_or("").to_owned());
        } else if let Some((kind, name)) = definition.rsplit_once(' ') {
            self.numbers.insert(name.to_owned(), kind.to_owned());
        }
    }

    /// Whether the struct says how large it is.
    pub(crate) fn is_sized(&self, name: &str) -> bool {
        self.structs
            .get(name)
            .and_then(|fields| fields.first())
            .is_some_and(|first| first.name == "struct_size")
    }

    /// What a number is made of, through all names.
    pub(crate) fn number<'a>(&'a self, kind: &'a str) -> &'a str {
        self.numbers.get(kind).map_or(kind, |inner| self.number(inner))
    }
}

fn function(statement: &str) -> Option<Function> {
    let open = statement.find('(')?;
    let (front, inner) = (&statement[..open], statement[open + 1..].strip_suffix(')')?);
    let at = front.rfind([' ', '*'])? + 1;
    let arguments = if inner.trim() == "void" { Vec::new() } else { split(inner) };
    Some(Function {
        returns: kind_of(&front[..at]),
        name: front[at..].trim().to_owned(),
        arguments: arguments.iter().map(|one| named(one)).collect(),
    })
}

/// At commas outside parentheses.
fn split(text: &str) -> Vec<String> {
    let (mut parts, mut depth) = (vec![String::new()], 0);
    for c in text.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(String::new());
                continue;
            }
            _ => {}
        }
        parts.last_mut().expect("never empty").push(c);
    }
    parts.iter().map(|part| part.trim().to_owned()).collect()
}

fn named(declaration: &str) -> Named {
    let declaration = declaration.split_whitespace().collect::<Vec<_>>().join(" ");
    let (front, name, back) = if let Some(at) = declaration.find("(*") {
        let end = at + declaration[at..].find(')').expect("a name ends");
        (&declaration[..at + 2], &declaration[at + 2..end], &declaration[end..])
    } else {
        let end = declaration.find('[').unwrap_or(declaration.len());
        let start = declaration[..end]
            .rfind(|c: char| !c.is_alphanumeric() && c != '_')
            .map_or(0, |at| at + 1);
        (&declaration[..start], &declaration[start..end], &declaration[end..])
    };
    let kind = kind_of(&format!("{front}{back}"));
    let around = (front.to_owned(), back.to_owned());
    Named { name: name.to_owned(), kind, around, declaration: declaration.clone() }
}

fn kind_of(text: &str) -> String {
    let words = text.split_whitespace().filter(|word| *word != "struct");
    words.collect::<Vec<_>>().join(" ")
}
