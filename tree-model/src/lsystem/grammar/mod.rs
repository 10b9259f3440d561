//! Grammars: what a text says, ready to be derived.
//!
//! 1. Statements are sorted into settings and productions (`settings`), names of symbols and constants are
//!    gathered, so that they may stand anywhere in the file.
//! 2. Productions are read (`production`) and their expressions compiled.
//! 3. The numbers of parameters are compared with those of the productions (`arity`).
//! 4. For each kind of module a row says at once what happens to it (`rules`).

mod arity;
mod modules;
mod production;
mod rules;
mod settings;

#[cfg(test)]
mod tests;

pub(super) use rules::{Action, Item, Row, Rule, Rules, Successor};

use super::derive;
use super::text::Source;
use super::{Symbols, Word};
use crate::error::{ModelError, Result};
use settings::Settings;
use std::collections::BTreeMap;
use tree_core::{Control, Limits, Resource, Seed};

/// An L-system: alphabet, axiom, productions, and rules of decomposition and interpretation.
///
/// ```
/// use tree_model::lsystem::Grammar;
/// use tree_model::tree_core::{Control, Limits, Seed};
/// let text = "steps: 3\naxiom: a\na -> ab\nb -> a";
/// let grammar = Grammar::parse(text, &Limits::default())?;
/// let derived = grammar.derive(None, Seed(1), &Control::default())?;
/// assert_eq!(derived.word.text(grammar.symbols()), "abaab");
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Grammar {
    text: String,
    /// Values that replace those of the text.
    replaced: BTreeMap<String, f64>,
    symbols: Symbols,
    settings: Settings,
    start: Successor,
    axiom: Word,
    productions: Rules,
    decomposition: Rules,
    interpretation: Rules,
}

impl Grammar {
    /// Reads a grammar; the [module](super) documents the notation.
    ///
    /// # Errors
    /// [`ModelError::Grammar`] with line, column and mostly a hint; [`ModelError::Limit`] for a text longer
    /// than [`Limits::input_bytes`].
    ///
    /// # Complexity
    /// O(text), times the logarithm of the number of names.
    pub fn parse(text: &str, limits: &Limits) -> Result<Self> {
        limits.check(Resource::InputBytes, text.len() as u64)?;
        Self::build(text, BTreeMap::new())
    }

    fn build(text: &str, replaced: BTreeMap<String, f64>) -> Result<Self> {
        let source = Source::new(text)?;
        let mut symbols = Symbols::default();
        let settings::Read { settings, axiom, productions } =
            settings::read(&source, &replaced, &mut symbols)?;
        let mut reader = production::Reader::new(&source, &settings, symbols);
        let start = reader.axiom(axiom)?;
        let [mut derived, mut decomposed, mut drawn] = [(); 3].map(|()| Vec::new());
        for (section, part) in productions {
            let rule = reader.production(part, section)?;
            match section {
                settings::Section::Productions => derived.push(rule),
                settings::Section::Decomposition => decomposed.push(rule),
                settings::Section::Interpretation => drawn.push(rule),
            }
        }
        reader.check_arities()?;
        let symbols = reader.into_symbols();
        let mut grammar = Self {
            text: text.to_owned(),
            replaced,
            productions: Rules::new(derived, &symbols, 1),
            decomposition: Rules::new(decomposed, &symbols, settings.decomposition_depth),
            interpretation: Rules::new(drawn, &symbols, settings.interpretation_depth),
            start,
            axiom: Word::default(),
            symbols,
            settings,
        };
        grammar.axiom = derive::axiom(&grammar, Seed(grammar.settings.seed))?;
        Ok(grammar)
    }

    /// The text this grammar was read from.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The alphabet: every kind of module that the text names.
    #[must_use]
    pub fn symbols(&self) -> &Symbols {
        &self.symbols
    }

    /// The word that derivations begin with; random numbers in it come from [`seed`](Self::seed).
    #[must_use]
    pub fn axiom(&self) -> &Word {
        &self.axiom
    }

    /// Number of derivations that the text asks for (`steps:`), 0 to 1,000,000. Default 0.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.settings.steps
    }

    /// Angle of turns without a parameter in degrees (`angle:`). Default 90.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.settings.angle
    }

    /// Seed that the text proposes (`seed:`). Default 0.
    #[must_use]
    pub fn seed(&self) -> Seed {
        Seed(self.settings.seed)
    }

    /// Number of productions, without those of decomposition and interpretation.
    #[must_use]
    pub fn n_productions(&self) -> usize {
        self.productions.rules().len()
    }

    /// The named constants with their values, `steps` and `angle` among them where the text sets them.
    pub fn constants(&self) -> impl Iterator<Item = (&str, f64)> {
        self.settings.constants.iter().map(|(name, &value)| (name.as_str(), value))
    }

    /// Gives a constant of the text another value; all that depends on it is computed anew. `steps` (fractions
    /// are cut off) and `angle` can be set as well.
    ///
    /// # Errors
    /// [`ModelError::NotFinite`]; [`ModelError::Parameter`] for steps below 0 or above 1,000,000;
    /// [`ModelError::Grammar`] when the text has no such constant (at line 1, column 1), or an expression of
    /// constants has no value then. The grammar stays as it was.
    ///
    /// # Complexity
    /// O(text): it is read again.
    pub fn set_constant(&mut self, name: &str, value: f64) -> Result<()> {
        if !value.is_finite() {
            return Err(ModelError::NotFinite { field: format!("constant '{name}'") });
        }
        if name == "steps" {
            crate::error::check("steps", value, 0.0, settings::MOST_STEPS)?;
        }
        let known =
            ["steps", "angle"].contains(&name) || self.settings.constants.contains_key(name);
        if !known {
            let names = self.settings.constants.keys().map(String::as_str);
            let hint = super::text::did_you_mean(name, names);
            let problem = format!("the text has no constant '{name}'");
            return Err(ModelError::Grammar { line: 1, column: 1, problem, hint });
        }
        let mut replaced = self.replaced.clone();
        replaced.insert(name.to_owned(), value);
        *self = Self::build(&self.text, replaced)?;
        Ok(())
    }

    /// Reads a word of this grammar's modules, such as `F(1)[+F(0.5)]`.
    ///
    /// # Errors
    /// [`ModelError::Word`], also for modules that the grammar does not know and open brackets.
    pub fn word(&self, text: &str) -> Result<Word> {
        let mut symbols = self.symbols.clone();
        let word = Word::parse(text, &mut symbols)?;
        let unknown = |kind: &super::Kind| self.symbols.get(*kind).is_none();
        if let Some(module) = word.kinds().iter().position(unknown) {
            let (name, n) =
                word.kinds().get(module).and_then(|&kind| symbols.get(kind)).unwrap_or_default();
            let problem = format!("the grammar has no module '{name}' with {n} parameters");
            return Err(ModelError::Word { module, problem });
        }
        word.check(&self.symbols)?;
        Ok(word)
    }

    /// Applies the productions `steps` times to the axiom; `None` takes the number from the text. The same
    /// seed gives the same bits for any number of threads.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for more than a million steps;
    /// [`ModelError::Word`] for an expression without a finite value, naming module and production;
    /// [`ModelError::Limit`] before a word grows beyond [`Limits::modules`]; [`ModelError::Cancelled`].
    ///
    /// # Complexity
    /// O(modules of all words). Memory: two words of the last step, three where more than one thread works.
    pub fn derive(
        &self,
        steps: Option<u32>,
        seed: Seed,
        control: &Control,
    ) -> Result<derive::Derived> {
        let steps = steps.unwrap_or(self.settings.steps);
        crate::error::check("steps", steps, 0.0, settings::MOST_STEPS)?;
        derive::derive(self, steps, seed, control)
    }

    /// Applies the productions once: step `step`, counted from 0, of `of` steps.
    ///
    /// # Errors
    /// As [`derive`](Self::derive), and for a word that is not of this grammar.
    pub fn step(
        &self,
        word: &Word,
        step: u32,
        of: u32,
        seed: Seed,
        control: &Control,
    ) -> Result<Word> {
        word.check(&self.symbols)?;
        derive::step(self, word, step, of, seed, control)
    }

    /// The word as the turtle is to see it: the rules of interpretation applied, again to what they give,
    /// down to their `maximum depth`. Without such rules it is the same word.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn interpretation(&self, word: &Word, seed: Seed, control: &Control) -> Result<Word> {
        word.check(&self.symbols)?;
        derive::interpretation(self, word, seed, control)
    }

    pub(super) fn start(&self) -> &Successor {
        &self.start
    }

    pub(super) fn productions(&self) -> &Rules {
        &self.productions
    }

    pub(super) fn decomposition(&self) -> &Rules {
        &self.decomposition
    }

    pub(super) fn interpretation_rules(&self) -> &Rules {
        &self.interpretation
    }

    /// Whether contexts see a module of this kind, by kind.
    pub(super) fn considered(&self) -> Vec<bool> {
        self.settings.considered(&self.symbols)
    }
}
