//! Templates as text, line by line:
//!
//! ```text
//! templates 1
//! template oak
//! species oak
//! height 12.31
//! slenderness 0.0406
//! order scale -0.12 0.4 lateral 0.5 0.5 alpha 0.2 0.1 beta 0.9 0.2 gamma 2.4 0.6
//! view 0.3927 scale -0.1 0.5 alpha 0.2 0.1 beta - -
//! directions 120 80 …      shares of length in thousandths, from straight up to straight down
//! crown 512 498 …          K_f distances in thousandths
//! branches 498 …
//! silhouette -320 410 …    x and y in centimetres
//! ```
//!
//! The first line has the version. `order` comes once for each order of axes, `view` once for each view, followed by the
//! four lines that belong to it. Empty lines and those that begin with # do not count.

use super::{BranchShape, DIRECTION_BINS, Directions, Template, TemplateView};
use crate::error::{ModelError, Result};
use crate::sketch::{Footprint, Habit, Normal, Omega};
use glam::Vec2;
use std::fmt::Write;

/// Version of the format.
const VERSION: u32 = 1;
/// Footprints are stored in such parts of the box's longer side, directions of the whole.
const FOOTPRINT_UNIT: f32 = 0.001;
/// Silhouettes are stored in such parts of a metre.
const SILHOUETTE_UNIT: f32 = 0.01;
/// Most views a template may have in a text.
const MAX_VIEWS: usize = 180;

/// Writes templates as text. What [`parse`] reads again is the same to the digits written.
#[must_use]
pub fn to_text(templates: &[Template]) -> String {
    let mut text = format!("templates {VERSION}\n");
    for template in templates {
        // Writing to a string does not fail.
        let _ = write_template(&mut text, template);
    }
    text
}

fn write_template(text: &mut String, template: &Template) -> std::fmt::Result {
    writeln!(text, "\ntemplate {}", template.name)?;
    writeln!(text, "species {}", template.species)?;
    writeln!(text, "height {}", rounded(template.height, 100.0))?;
    writeln!(text, "slenderness {}", rounded(template.slenderness, 1e5))?;
    for habit in &template.omega.orders {
        write!(text, "order")?;
        for (name, normal) in HABIT.iter().zip(parts_of(habit)) {
            write_normal(text, name, Some(normal))?;
        }
        writeln!(text)?;
    }
    for view in &template.views {
        write!(text, "view {}", rounded(view.yaw, 1e4))?;
        let shape = [view.shape.scale, view.shape.alpha, view.shape.beta];
        for (name, normal) in SHAPE.iter().zip(shape) {
            write_normal(text, name, normal)?;
        }
        write!(text, "\ndirections")?;
        for share in view.directions.0 {
            write!(text, " {}", (share / FOOTPRINT_UNIT).round())?;
        }
        for (name, footprint) in [("crown", &view.crown), ("branches", &view.branches)] {
            write!(text, "\n{name}")?;
            for distance in footprint.distances() {
                write!(text, " {}", (distance / FOOTPRINT_UNIT).round())?;
            }
        }
        write!(text, "\nsilhouette")?;
        for number in view.silhouette.iter().flat_map(|p| [p.x, p.y]) {
            // Adding 0 makes −0 plain.
            write!(text, " {}", (number / SILHOUETTE_UNIT).round() + 0.0)?;
        }
        writeln!(text)?;
    }
    Ok(())
}

const HABIT: [&str; 5] = ["scale", "lateral", "alpha", "beta", "gamma"];
const SHAPE: [&str; 3] = ["scale", "alpha", "beta"];

fn parts_of(habit: &Habit) -> [Normal; 5] {
    [habit.scale, habit.lateral_scale, habit.alpha, habit.beta, habit.gamma]
}

fn write_normal(text: &mut String, name: &str, normal: Option<Normal>) -> std::fmt::Result {
    match normal {
        Some(n) => {
            write!(text, " {name} {} {}", rounded(n.mean, 1e4), rounded(n.deviation, 1e4))
        }
        None => write!(text, " {name} - -"),
    }
}

fn rounded(value: f32, parts: f64) -> f64 {
    (f64::from(value) * parts).round() / parts + 0.0
}

/// Reads templates.
///
/// # Errors
/// [`ModelError::Template`] that names the line and says what is wrong with it, or the template and field out of range.
///
/// # Complexity
/// O(text).
pub fn parse(text: &str) -> Result<Vec<Template>> {
    let mut lines = Lines { lines: text.lines().enumerate(), number: 0 };
    let Some(("templates", version)) = lines.next() else {
        return Err(lines.wrong(format!("the text must begin with 'templates {VERSION}'")));
    };
    if version.parse() != Ok(VERSION) {
        let problem = format!("version '{version}' is not known; this program reads {VERSION}");
        return Err(lines.wrong(problem));
    }
    let mut templates: Vec<Template> = Vec::new();
    let mut begun = 0;
    while let Some((word, rest)) = lines.next() {
        if word == "template" {
            finish(&templates, begun)?;
            begun = lines.number;
            templates.push(Template {
                name: rest.into(),
                species: String::new(),
                height: 0.0,
                slenderness: 0.0,
                omega: Omega { orders: Vec::new() },
                views: Vec::new(),
            });
            continue;
        }
        let Some(template) = templates.last_mut() else {
            return Err(lines.wrong(format!("'{word}' must come after a line 'template NAME'")));
        };
        match word {
            "species" => template.species = rest.into(),
            "height" => template.height = lines.number_in(rest)?,
            "slenderness" => template.slenderness = lines.number_in(rest)?,
            "order" => template.omega.orders.push(lines.habit(rest)?),
            "view" if template.views.len() >= MAX_VIEWS => {
                return Err(lines.wrong(format!("more than {MAX_VIEWS} views")));
            }
            "view" => template.views.push(lines.view(rest)?),
            _ => {
                return Err(lines.wrong(format!(
                    "'{word}' is none of template, species, height, slenderness, order, view"
                )));
            }
        }
    }
    finish(&templates, begun)?;
    Ok(templates)
}

/// Checks the template just read.
fn finish(templates: &[Template], line: usize) -> Result<()> {
    let Some(template) = templates.last() else { return Ok(()) };
    let within = |problem: String| ModelError::Template {
        problem: format!("line {line}: '{}': {problem}", template.name),
    };
    template.validate().map_err(|error| within(error.to_string()))?;
    if templates[..templates.len() - 1].iter().any(|other| other.name == template.name) {
        return Err(within("there is one of this name already".into()));
    }
    Ok(())
}

/// The lines that count, as first word and rest.
struct Lines<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    /// Number of the line last read, from 1.
    number: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<(&'a str, &'a str)> {
        for (index, line) in self.lines.by_ref() {
            self.number = index + 1;
            let line = line.trim();
            if !line.is_empty() && !line.starts_with('#') {
                let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
                return Some((word, rest.trim()));
            }
        }
        None
    }

    fn wrong(&self, problem: impl std::fmt::Display) -> ModelError {
        ModelError::Template { problem: format!("line {}: {problem}", self.number) }
    }

    fn number_in(&self, word: &str) -> Result<f32> {
        let number: Option<f32> = word.parse().ok().filter(|number: &f32| number.is_finite());
        number.ok_or_else(|| self.wrong(format!("'{}' is no number", shortened(word))))
    }

    /// Named normal distributions in a fixed order.
    fn normals<const N: usize>(&self, rest: &str, names: [&str; N]) -> Result<[Option<Normal>; N]> {
        let mut words = rest.split_whitespace();
        let mut normals = [None; N];
        for (normal, name) in normals.iter_mut().zip(names) {
            let (Some(found), Some(mean), Some(deviation)) =
                (words.next(), words.next(), words.next())
            else {
                return Err(self.wrong(format!("'{name} MEAN DEVIATION' is missing")));
            };
            if found != name {
                return Err(
                    self.wrong(format!("'{}' stands where '{name}' must", shortened(found)))
                );
            }
            if (mean, deviation) != ("-", "-") {
                *normal = Some(Normal::new(self.number_in(mean)?, self.number_in(deviation)?));
            }
        }
        match words.next() {
            Some(word) => Err(self.wrong(format!("'{}' is one word too many", shortened(word)))),
            None => Ok(normals),
        }
    }

    fn habit(&self, rest: &str) -> Result<Habit> {
        let normals = self.normals(rest, HABIT)?;
        let [Some(scale), Some(lateral_scale), Some(alpha), Some(beta), Some(gamma)] = normals
        else {
            return Err(self.wrong("an order needs all five distributions"));
        };
        Ok(Habit { scale, lateral_scale, alpha, beta, gamma })
    }

    fn view(&mut self, rest: &str) -> Result<TemplateView> {
        let (yaw, rest) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        let yaw = self.number_in(yaw)?;
        let [scale, alpha, beta] = self.normals(rest, SHAPE)?;
        let shares: Result<[f32; DIRECTION_BINS], _> =
            self.numbers("directions", FOOTPRINT_UNIT)?.try_into();
        let directions = shares
            .map(Directions)
            .map_err(|_| self.wrong(format!("directions has {DIRECTION_BINS} numbers")))?;
        let crown = self.footprint("crown")?;
        let branches = self.footprint("branches")?;
        let numbers = self.numbers("silhouette", SILHOUETTE_UNIT)?;
        if numbers.len() % 2 == 1 {
            return Err(self.wrong("an x is without its y"));
        }
        let silhouette = numbers.chunks_exact(2).map(|p| Vec2::new(p[0], p[1])).collect();
        let shape = BranchShape { scale, alpha, beta };
        Ok(TemplateView { yaw, shape, directions, crown, branches, silhouette })
    }

    fn footprint(&mut self, name: &str) -> Result<Footprint> {
        let distances = self.numbers(name, FOOTPRINT_UNIT)?;
        Footprint::try_from(distances).map_err(|error| self.wrong(error))
    }

    /// The next line, which begins with `name` and has numbers only, times `unit`.
    fn numbers(&mut self, name: &str, unit: f32) -> Result<Vec<f32>> {
        match self.next() {
            Some((word, rest)) if word == name => {
                rest.split_whitespace().map(|word| Ok(self.number_in(word)? * unit)).collect()
            }
            _ => Err(self.wrong(format!("a line '{name} …' must stand here"))),
        }
    }
}

/// What messages quote of a word that came in.
fn shortened(word: &str) -> String {
    const LONGEST: usize = 40;
    if word.chars().count() <= LONGEST {
        return word.into();
    }
    word.chars().take(LONGEST).chain(['…']).collect()
}
