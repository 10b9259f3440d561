//! Settings, constants and sections: everything in a grammar but its productions.

use crate::error::Result;
use crate::lsystem::expr::{self, Env, Scope};
use crate::lsystem::text::{Cursor, Source, did_you_mean, find_arrow};
use crate::lsystem::{Kind, Symbols};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use tree_core::Seed;

/// More declared names than this are refused: each would cost at every symbol read.
const MOST_NAMES: usize = 4096;
/// More derivations than this are not what anyone meant.
pub(super) const MOST_STEPS: f64 = 1_000_000.0;
/// Deepest recursion of decomposition and interpretation.
const MOST_PASSES: f64 = 1000.0;
/// The largest seed: up to here an f64 holds every whole number.
const MOST_SEED: f64 = 9_007_199_254_740_992.0;
/// Longer names are refused: at every symbol read, each length that a declared name has is tried.
const LONGEST_NAME: usize = 64;
/// Turns without a parameter, when the text does not say: as in cpfg.
const DEFAULT_ANGLE: f64 = 90.0;

/// Which symbols contexts see.
#[derive(Clone, Debug, Default, PartialEq)]
enum Seen {
    #[default]
    All,
    AllBut(BTreeSet<String>),
    Only(BTreeSet<String>),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Settings {
    pub(super) constants: BTreeMap<String, f64>,
    pub(super) steps: u32,
    pub(super) angle: f64,
    pub(super) seed: u64,
    pub(super) decomposition_depth: u32,
    pub(super) interpretation_depth: u32,
    seen: Seen,
}

impl Settings {
    /// Whether contexts see a symbol.
    pub(super) fn sees(&self, name: &str) -> bool {
        match &self.seen {
            Seen::All => true,
            Seen::AllBut(names) => !names.contains(name),
            Seen::Only(names) => names.contains(name),
        }
    }

    pub(super) fn considered(&self, symbols: &Symbols) -> Vec<bool> {
        let kinds = (0..symbols.len()).map(|kind| Kind(kind as u16));
        kinds.map(|kind| symbols.get(kind).is_some_and(|(name, _)| self.sees(name))).collect()
    }
}

/// Where a production stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    Productions,
    Decomposition,
    Interpretation,
}

/// What the first reading finds.
pub(super) struct Read {
    pub(super) settings: Settings,
    /// The part after `axiom:`.
    pub(super) axiom: Range<usize>,
    pub(super) productions: Vec<(Section, Range<usize>)>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Key {
    Axiom,
    Steps,
    Angle,
    Seed,
    Ignore,
    Consider,
    Depth,
    Unused,
    Enter(Section),
    End,
}

/// Keys of settings, as the books and programs write them. A statement with an arrow is a production,
/// whatever it begins with, unless the key is `axiom`.
const KEYS: [(&str, Key); 21] = [
    ("axiom", Key::Axiom),
    ("ω", Key::Axiom),
    ("w", Key::Axiom),
    ("steps", Key::Steps),
    ("derivation length", Key::Steps),
    ("n", Key::Steps),
    ("angle", Key::Angle),
    ("δ", Key::Angle),
    ("delta", Key::Angle),
    ("seed", Key::Seed),
    ("ignore", Key::Ignore),
    ("consider", Key::Consider),
    ("maximum depth", Key::Depth),
    ("lsystem", Key::Unused),
    ("display interval", Key::Unused),
    ("productions", Key::Enter(Section::Productions)),
    ("decomposition", Key::Enter(Section::Decomposition)),
    ("homomorphism", Key::Enter(Section::Interpretation)),
    ("interpretation", Key::Enter(Section::Interpretation)),
    ("endlsystem", Key::End),
    ("end", Key::End),
];

/// Sorts the statements, and reads those that are no productions.
pub(super) fn read(
    source: &Source<'_>,
    replaced: &BTreeMap<String, f64>,
    symbols: &mut Symbols,
) -> Result<Read> {
    let statements = source.statements()?;
    let mut reader = Reader::new(source, replaced);
    for part in &statements {
        reader.declare(Cursor::new(source, part.clone()), symbols)?;
    }
    for part in statements {
        if reader.statement(part, symbols)? {
            break;
        }
    }
    let Reader { settings, axiom, productions, .. } = reader;
    let axiom = axiom.ok_or_else(|| {
        let hint = "write 'axiom: ' and the word to begin with";
        source.error(source.clean().len(), "the grammar has no axiom", hint)
    })?;
    Ok(Read { settings, axiom, productions })
}

struct Reader<'a> {
    source: &'a Source<'a>,
    replaced: &'a BTreeMap<String, f64>,
    settings: Settings,
    section: Section,
    axiom: Option<Range<usize>>,
    productions: Vec<(Section, Range<usize>)>,
    n_names: usize,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source<'a>, replaced: &'a BTreeMap<String, f64>) -> Self {
        let set = |name| replaced.get(name).copied();
        let settings = Settings {
            constants: BTreeMap::new(),
            steps: set("steps").map_or(0, |steps| steps.clamp(0.0, MOST_STEPS) as u32),
            angle: set("angle").unwrap_or(DEFAULT_ANGLE),
            seed: 0,
            decomposition_depth: 1,
            interpretation_depth: 1,
            seen: Seen::All,
        };
        let section = Section::Productions;
        let (axiom, productions, n_names) = (None, Vec::new(), 0);
        Self { source, replaced, settings, section, axiom, productions, n_names }
    }

    /// Reads `#symbols`, which holds for the whole file.
    fn declare(&mut self, mut cursor: Cursor<'_>, symbols: &mut Symbols) -> Result<()> {
        if directive(&mut cursor) != Some("symbols") {
            return Ok(());
        }
        cursor.eat(":");
        while !cursor.is_done() {
            let at = cursor.at();
            let name: &str = cursor.rest().split([' ', '\t', ',', '\n']).next().unwrap_or_default();
            if let Some(c) =
                name.chars().find(|&c| !crate::lsystem::text::is_symbol_char(c) || "[]".contains(c))
            {
                let problem = format!("'{}' cannot be part of a symbol", c.escape_debug());
                return Err(cursor.error(problem, "divide names by spaces or commas"));
            }
            if name.len() > LONGEST_NAME {
                let problem = format!("a symbol of more than {LONGEST_NAME} bytes");
                return Err(cursor.error(problem, "divide names by spaces or commas"));
            }
            self.n_names += 1;
            if self.n_names > MOST_NAMES {
                return Err(cursor.error(format!("more than {MOST_NAMES} declared symbols"), ""));
            }
            symbols.declare(name);
            cursor.go(at + name.len());
            cursor.eat(",");
        }
        Ok(())
    }

    /// Reads a statement; true when it ends the grammar.
    fn statement(&mut self, part: Range<usize>, symbols: &Symbols) -> Result<bool> {
        let mut cursor = Cursor::new(self.source, part.clone());
        let start = cursor.clone();
        if let Some(word) = directive(&mut cursor) {
            self.directive(word, cursor, symbols)?;
            return Ok(false);
        }
        let has_arrow = find_arrow(start.rest()).is_some();
        match key(&mut cursor) {
            Some((key, long)) if !has_arrow || (key == Key::Axiom && long) => {
                self.setting(key, cursor, symbols)
            }
            _ if has_arrow => {
                self.productions.push((self.section, part));
                Ok(false)
            }
            _ => self.constant(start).map(|()| false),
        }
    }

    fn directive(&mut self, word: &str, mut cursor: Cursor<'_>, symbols: &Symbols) -> Result<()> {
        match word {
            "symbols" => Ok(()),
            "define" => {
                cursor.peek();
                let at = cursor.at();
                let Some(name) = cursor.name() else { return Err(cursor.unexpected("a name")) };
                if cursor.rest().starts_with('(') {
                    let hint = "write the expression where it is needed";
                    return Err(cursor.error_at(
                        at,
                        format!("the macro '{name}' has parameters"),
                        hint,
                    ));
                }
                self.define(name, &mut cursor)
            }
            "ignore" | "consider" => {
                cursor.eat(":");
                self.seen(word == "ignore", cursor, symbols)
            }
            _ => {
                let known = ["define", "symbols", "ignore", "consider"];
                let hint = did_you_mean(word, known.into_iter());
                Err(cursor.error_at(
                    cursor.at() - word.len() - 1,
                    format!("there is no '#{word}'"),
                    hint,
                ))
            }
        }
    }

    /// Reads a setting behind its key; true when it ends the grammar.
    fn setting(&mut self, key: Key, mut cursor: Cursor<'_>, symbols: &Symbols) -> Result<bool> {
        match key {
            Key::End => return Ok(true),
            Key::Enter(section) => {
                self.section = section;
                cursor.finish()?;
            }
            Key::Unused => {}
            Key::Axiom if self.axiom.is_some() => {
                return Err(cursor.error("this is a second axiom", ""));
            }
            Key::Axiom => self.axiom = Some(cursor.at()..cursor.at() + cursor.rest().len()),
            Key::Ignore | Key::Consider => self.seen(key == Key::Ignore, cursor, symbols)?,
            Key::Angle => {
                let any = f64::NEG_INFINITY..f64::INFINITY;
                self.settings.angle = self.number("angle", &mut cursor, any)?;
            }
            Key::Steps => {
                self.settings.steps = self.whole("steps", &mut cursor, MOST_STEPS)? as u32;
            }
            Key::Seed => {
                self.settings.seed = self.whole("seed", &mut cursor, MOST_SEED)? as u64;
            }
            Key::Depth if self.section == Section::Productions => {
                let hint = "write it after 'decomposition' or 'interpretation'";
                return Err(cursor.error("a maximum depth of productions", hint));
            }
            Key::Depth => {
                let depth = self.whole("maximum depth", &mut cursor, MOST_PASSES)? as u32;
                if self.section == Section::Decomposition {
                    self.settings.decomposition_depth = depth;
                } else {
                    self.settings.interpretation_depth = depth;
                }
            }
        }
        Ok(false)
    }

    fn whole(&mut self, name: &str, cursor: &mut Cursor<'_>, most: f64) -> Result<f64> {
        let at = cursor.at();
        let value = self.number(name, cursor, 0.0..most)?;
        if value.fract() == 0.0 {
            return Ok(value);
        }
        Err(cursor.error_at(at, format!("'{name}' is {value}"), "it must be a whole number"))
    }

    fn number(&mut self, name: &str, cursor: &mut Cursor<'_>, range: Range<f64>) -> Result<f64> {
        cursor.peek();
        let at = cursor.at();
        let mut value = self.value(cursor)?;
        cursor.eat("°");
        cursor.finish()?;
        if let Some(&replaced) = self.replaced.get(name) {
            value = if name == "steps" { replaced.floor() } else { replaced };
        }
        if value < range.start || value > range.end {
            let hint = format!("allowed is {} to {}", range.start, range.end);
            return Err(cursor.error_at(at, format!("'{name}' is {value}"), hint));
        }
        if name == "steps" || name == "angle" {
            self.settings.constants.insert(name.to_owned(), value);
        }
        Ok(value)
    }

    /// `name = value`, the last thing that a statement without an arrow can be.
    fn constant(&mut self, mut cursor: Cursor<'_>) -> Result<()> {
        let start = cursor.clone();
        if let Some(name) = cursor.name()
            && cursor.eat("=")
        {
            return self.define(name, &mut cursor);
        }
        let words = start.rest().split([':', '=']).next().unwrap_or_default().trim();
        let mut hint = did_you_mean(words, KEYS.iter().map(|&(key, _)| key));
        if hint.is_empty() {
            hint =
                "write 'predecessor -> successor', 'name = value' or a setting such as 'axiom: F'"
                    .into();
        }
        Err(start.error("this is neither a production nor a setting", hint))
    }

    fn define(&mut self, name: &str, cursor: &mut Cursor<'_>) -> Result<()> {
        let mut value = self.value(cursor)?;
        cursor.finish()?;
        if let Some(&replaced) = self.replaced.get(name) {
            value = replaced;
        }
        self.settings.constants.insert(name.to_owned(), value);
        Ok(())
    }

    /// An expression of the constants so far.
    fn value(&mut self, cursor: &mut Cursor<'_>) -> Result<f64> {
        cursor.peek();
        let (at, mut draws) = (cursor.at(), 0);
        let scope =
            &mut Scope { constants: &self.settings.constants, params: &[], draws: &mut draws };
        let value = expr::parse(cursor, scope)?;
        if draws > 0 {
            return Err(cursor.error_at(at, "a constant cannot be random", "draw in a production"));
        }
        let env = Env { step: 0.0, steps: 0.0, stream: Seed(0), module: 0 };
        value.eval(&[], &env, &mut Vec::new()).map_err(|fault| {
            cursor.error_at(at, fault.0.into_string(), "it must be a finite number")
        })
    }

    fn seen(&mut self, ignore: bool, mut cursor: Cursor<'_>, symbols: &Symbols) -> Result<()> {
        let at = cursor.at();
        let mut names = BTreeSet::new();
        loop {
            cursor.eat(",");
            let Some(name) = cursor.symbol(symbols)? else { break };
            names.insert(name.to_owned());
        }
        self.settings.seen = match (std::mem::take(&mut self.settings.seen), ignore) {
            (Seen::AllBut(mut before), true) => {
                before.append(&mut names);
                Seen::AllBut(before)
            }
            (Seen::Only(mut before), false) => {
                before.append(&mut names);
                Seen::Only(before)
            }
            (Seen::All, true) => Seen::AllBut(names),
            (Seen::All, false) => Seen::Only(names),
            _ => {
                return Err(cursor.error_at(
                    at,
                    "both 'ignore' and 'consider' are given",
                    "keep one",
                ));
            }
        };
        Ok(())
    }
}

/// Reads past `#word`, and gives the word.
fn directive<'a>(cursor: &mut Cursor<'a>) -> Option<&'a str> {
    let after = cursor.rest().strip_prefix('#')?;
    if !after.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    cursor.eat("#");
    cursor.name()
}

/// Reads past a key and its colon or equals sign; says whether it has more than one letter.
fn key(cursor: &mut Cursor<'_>) -> Option<(Key, bool)> {
    let rest = cursor.rest();
    let end = rest.find([':', '=']).unwrap_or(rest.len());
    let words: Vec<&str> = rest[..end].split_whitespace().take(3).collect();
    let words = words.join(" ");
    let is = |name: &str| name == words || (name.len() > 1 && name.eq_ignore_ascii_case(&words));
    let &(name, key) = KEYS.iter().find(|(name, _)| is(name))?;
    let (separator, long) = (rest[end..].chars().next(), name.len() > 1);
    match (separator, key) {
        (None, Key::Enter(_) | Key::End) => {}
        (Some(':'), _) => {}
        // n = 7 may be a constant of that name.
        (Some('='), _) if long => {}
        _ => return None,
    }
    cursor.go(cursor.at() + end + usize::from(separator.is_some()));
    Some((key, long))
}
