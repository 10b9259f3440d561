//! Reads `include/tree.h`: not C in general, only what cbindgen writes for this crate. What it does
//! not know is an error, so that nothing is left out unseen.

/// All that the header declares, in its order.
#[derive(Default)]
pub struct Header {
    pub constants: Vec<Constant>,
    pub opaques: Vec<Opaque>,
    pub aliases: Vec<Alias>,
    pub callbacks: Vec<Callback>,
    pub structs: Vec<Struct>,
    pub functions: Vec<Function>,
}

/// `#define NAME value`
pub struct Constant {
    pub doc: Vec<String>,
    pub name: String,
    pub value: String,
}

/// `typedef struct X X;`
pub struct Opaque {
    pub doc: Vec<String>,
    pub name: String,
}

/// `typedef uint32_t X;`
pub struct Alias {
    pub doc: Vec<String>,
    pub name: String,
    pub target: Type,
}

/// `typedef int32_t (*X)(...);`, or a function pointer in a struct.
pub struct Callback {
    pub doc: Vec<String>,
    pub name: String,
    pub result: Type,
    pub arguments: Vec<Field>,
}

/// `typedef struct X { ... } X;`
pub struct Struct {
    pub doc: Vec<String>,
    pub name: String,
    pub fields: Vec<Field>,
}

/// A field or an argument.
pub struct Field {
    pub doc: Vec<String>,
    pub name: String,
    pub kind: Type,
}

pub struct Function {
    pub doc: Vec<String>,
    pub name: String,
    pub result: Type,
    pub arguments: Vec<Field>,
}

/// A C type as this header has them.
#[derive(Clone, PartialEq)]
pub enum Type {
    /// A name, `struct` and `const` left out.
    Name(String),
    Pointer(Box<Type>),
    Array(Box<Type>, usize),
    /// A function pointer; the name is that of a [`Callback`].
    Function(String),
}

type Result<T> = std::result::Result<T, String>;

/// A word or a sign, or a comment line.
#[derive(Clone, PartialEq, Debug)]
enum Token {
    Doc(String),
    Define(String, String),
    Word(String),
    Sign(char),
}

fn tokens(text: &str) -> Vec<Token> {
    let mut found = Vec::new();
    let mut plain = String::new();
    // Block comments stand only at the top and say nothing of what is declared.
    let mut rest = text;
    while let Some(begin) = rest.find("/*") {
        plain.push_str(&rest[..begin]);
        rest = rest[begin..].find("*/").map_or("", |end| &rest[begin + end + 2..]);
    }
    plain.push_str(rest);
    let mut skipped = false;
    for line in plain.lines() {
        let line = line.trim();
        // What only C++ sees.
        if line.starts_with("#ifdef __cplusplus") {
            skipped = true;
        }
        if skipped {
            skipped = !line.starts_with("#endif");
            continue;
        }
        if let Some(definition) = line.strip_prefix("#define ") {
            let (name, value) = definition.split_once(' ').unwrap_or((definition, ""));
            found.push(Token::Define(name.into(), value.trim().into()));
        } else if line.starts_with('#') {
            continue;
        } else {
            line_tokens(line, &mut found);
        }
    }
    found
}

fn line_tokens(line: &str, found: &mut Vec<Token>) {
    let (code, doc) = match line.split_once("//") {
        Some((code, doc)) => (code, Some(doc.trim().to_owned())),
        None => (line, None),
    };
    let mut word = String::new();
    for letter in code.chars().chain([' ']) {
        if letter.is_alphanumeric() || letter == '_' {
            word.push(letter);
            continue;
        }
        if !word.is_empty() {
            found.push(Token::Word(std::mem::take(&mut word)));
        }
        if !letter.is_whitespace() {
            found.push(Token::Sign(letter));
        }
    }
    found.extend(doc.map(Token::Doc));
}

/// Reads the header.
pub fn parse(text: &str) -> Result<Header> {
    let mut reader = Reader { tokens: tokens(text), at: 0, header: Header::default() };
    let mut doc = Vec::new();
    while let Some(token) = reader.next() {
        match token {
            Token::Doc(line) => doc.push(line),
            Token::Define(name, value) => {
                let doc = std::mem::take(&mut doc);
                if !value.is_empty() {
                    reader.header.constants.push(Constant { doc, name, value });
                }
            }
            Token::Word(word) if word == "typedef" => reader.typedef(std::mem::take(&mut doc))?,
            Token::Word(_) => {
                reader.at -= 1;
                reader.function(std::mem::take(&mut doc))?;
            }
            Token::Sign(sign) => return Err(format!("'{sign}' where a declaration begins")),
        }
    }
    Ok(reader.header)
}

struct Reader {
    tokens: Vec<Token>,
    at: usize,
    header: Header,
}

impl Reader {
    fn next(&mut self) -> Option<Token> {
        self.at += 1;
        self.tokens.get(self.at - 1).cloned()
    }

    /// Takes this sign when it is next.
    fn takes(&mut self, sign: char) -> bool {
        let there = self.tokens.get(self.at) == Some(&Token::Sign(sign));
        self.at += usize::from(there);
        there
    }

    fn sign(&mut self, sign: char) -> Result<()> {
        if self.takes(sign) {
            return Ok(());
        }
        let from = self.at.saturating_sub(6);
        let around = self.tokens.get(from..self.at + 2).unwrap_or_default();
        Err(format!("'{sign}' is missing near {around:?}"))
    }

    fn word(&mut self) -> Result<String> {
        match self.next() {
            Some(Token::Word(word)) => Ok(word),
            other => Err(format!("a name is missing: {other:?}")),
        }
    }

    fn doc(&mut self) -> Vec<String> {
        let mut doc = Vec::new();
        while let Some(Token::Doc(line)) = self.tokens.get(self.at) {
            doc.push(line.clone());
            self.at += 1;
        }
        doc
    }

    /// `typedef` has been taken.
    fn typedef(&mut self, doc: Vec<String>) -> Result<()> {
        let begin = self.at;
        if self.word()? == "struct" {
            let name = self.word()?;
            if self.takes('{') {
                let fields = self.fields(&name)?;
                self.word()?;
                self.header.structs.push(Struct { doc, name, fields });
                return self.sign(';');
            }
            self.word()?;
            self.header.opaques.push(Opaque { doc, name });
            return self.sign(';');
        }
        self.at = begin;
        let declared = self.declared(None)?;
        match declared.kind {
            Type::Function(_) => {
                // Its documentation is the typedef's.
                if let Some(callback) = self.header.callbacks.last_mut() {
                    callback.doc = doc;
                }
            }
            target => self.header.aliases.push(Alias { doc, name: declared.name, target }),
        }
        self.sign(';')
    }

    fn fields(&mut self, owner: &str) -> Result<Vec<Field>> {
        let mut fields = Vec::new();
        loop {
            let doc = self.doc();
            if self.takes('}') {
                return Ok(fields);
            }
            let field = self.declared(Some(owner))?;
            if let (Type::Function(name), Some(callback)) =
                (&field.kind, self.header.callbacks.last_mut())
                && callback.name == *name
                && callback.doc.is_empty()
            {
                callback.doc.clone_from(&doc);
            }
            fields.push(Field { doc, ..field });
            self.sign(';')?;
        }
    }

    fn function(&mut self, doc: Vec<String>) -> Result<()> {
        let Field { name, kind, .. } = self.declared(None)?;
        self.sign('(')?;
        let arguments = self.arguments(&name)?;
        self.header.functions.push(Function { doc, name, result: kind, arguments });
        self.sign(';')
    }

    /// `(` has been taken.
    fn arguments(&mut self, owner: &str) -> Result<Vec<Field>> {
        let mut arguments = Vec::new();
        if self.tokens.get(self.at) == Some(&Token::Word("void".into()))
            && self.tokens.get(self.at + 1) == Some(&Token::Sign(')'))
        {
            self.at += 2;
            return Ok(arguments);
        }
        loop {
            arguments.push(self.declared(Some(owner))?);
            if self.takes(')') {
                return Ok(arguments);
            }
            self.sign(',')?;
        }
    }

    /// A type and the name it is given to. `owner` names function pointers that have no typedef.
    fn declared(&mut self, owner: Option<&str>) -> Result<Field> {
        let mut word = self.word()?;
        while word == "const" || word == "struct" {
            word = self.word()?;
        }
        let mut kind = self.pointers(self.named(word));
        if self.takes('(') {
            self.sign('*')?;
            if self.tokens.get(self.at) == Some(&Token::Word("const".into())) {
                self.at += 1;
            }
            let name = self.word()?;
            self.sign(')')?;
            if self.takes('(') {
                let callback = owner.map_or(name.clone(), |owner| format!("{owner}_{name}"));
                let arguments = self.arguments(&callback)?;
                let known =
                    Callback { doc: Vec::new(), name: callback.clone(), result: kind, arguments };
                self.header.callbacks.push(known);
                return Ok(Field { doc: Vec::new(), name, kind: Type::Function(callback) });
            }
            // A pointer to an array is a pointer to its first element.
            self.lengths(kind.clone())?;
            return Ok(Field { doc: Vec::new(), name, kind: Type::Pointer(Box::new(kind)) });
        }
        let name = self.word()?;
        kind = self.lengths(kind)?;
        Ok(Field { doc: Vec::new(), name, kind })
    }

    fn named(&self, name: String) -> Type {
        if self.header.callbacks.iter().any(|callback| callback.name == name) {
            return Type::Function(name);
        }
        Type::Name(name)
    }

    fn pointers(&mut self, mut kind: Type) -> Type {
        loop {
            if self.takes('*') {
                kind = Type::Pointer(Box::new(kind));
            } else if self.tokens.get(self.at) == Some(&Token::Word("const".into())) {
                self.at += 1;
            } else {
                return kind;
            }
        }
    }

    /// `[3][4]` makes an array of three arrays of four.
    fn lengths(&mut self, kind: Type) -> Result<Type> {
        if !self.takes('[') {
            return Ok(kind);
        }
        let word = self.word()?;
        // A number, or a constant that is one.
        let constant = self.header.constants.iter().find(|constant| constant.name == word);
        let value = constant.map_or(&word, |constant| &constant.value);
        let length = value.parse().map_err(|_| format!("'{word}' is no length"))?;
        self.sign(']')?;
        Ok(Type::Array(Box::new(self.lengths(kind)?), length))
    }
}
