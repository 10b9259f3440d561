//! JSON lines to what each tree is to be.

use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Longest name of a tree: file systems allow 255 bytes, and files add endings.
const NAME_MAX: usize = 100;
/// Most levels of a file.
const MAX_LEVELS: usize = 16;
/// Share of the leaf triangles at the last of a number of levels.
const LAST_SHARE: f32 = 0.05;

/// One tree.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Line {
    /// Its folder, and how its files begin: letters, digits, `-`, `_` and `.`.
    pub(crate) name: String,
    pub(crate) modeler: Source,
    /// Default 1.
    #[serde(default = "one")]
    pub(crate) seed: u64,
    /// Bark and leaves. Default: the preset's, or an oak's.
    pub(crate) species: Option<String>,
    /// Metres, of what was drawn or photographed. Default: the modeler's.
    pub(crate) height: Option<f32>,
    /// How many times larger the whole tree is made, leaves and all. Default 1.
    #[serde(default = "unscaled")]
    pub(crate) scale: f32,
    /// No leaves.
    #[serde(default)]
    pub(crate) bare: bool,
    /// Number of levels, shares falling evenly to 0.05. Default 4.
    pub(crate) levels: Option<usize>,
    /// Share of the leaf triangles at each level, falling, in place of `levels`.
    pub(crate) shares: Option<Vec<f32>>,
    /// Views from around that pruning looks at. Default: by the size of the tree.
    pub(crate) views: Option<u32>,
    /// Default the mesh and its levels.
    #[serde(default = "usual")]
    pub(crate) outputs: Vec<Output>,
    /// The line itself.
    #[serde(skip)]
    pub(crate) text: String,
}

/// What a tree is made of. Files are named from the manifest's folder.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Source {
    /// A preset of the path modeler.
    Path(String),
    /// A preset, or a file that ends in `.l`.
    Lsystem(String),
    /// A preset of self-organising trees.
    Growth(String),
    /// A drawing of outlines (SVG), or a picture of a silhouette.
    Silhouette(PathBuf),
    /// A drawing of branches (SVG, JSON).
    Sketch(PathBuf),
    /// Photographs, a quarter turn apart.
    Photo(Vec<PathBuf>),
    /// A polygon tree (glTF, OBJ, PLY).
    Mesh(PathBuf),
}

/// A file, or a few that belong together.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq, PartialOrd, Ord)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Output {
    /// `NAME.glb`: all of it.
    Mesh,
    /// `NAME_levels.glb`: `MSFT_lod`.
    Levels,
    /// `NAME_pruned.glb` and `.json`: all levels in one index buffer.
    Pruned,
    /// `NAME_hybrid.glb`: branches by prefix, far leaves as pictures.
    Hybrid,
    /// `NAME_octahedral.json` and two pictures.
    Octahedral,
    /// `NAME.trem`: the tree as a progressive stream.
    Stream,
    /// `NAME.swc`.
    Skeleton,
    /// `NAME.png`.
    Picture,
}

/// What is wrong with a line.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum LineError {
    #[error("column {column}: {problem}")]
    Json { column: usize, problem: String },
    #[error(
        "name '{found}': 1 to {NAME_MAX} letters, digits, '-', '_' and '.' are wanted, no '.' first"
    )]
    Name { found: String },
    #[error(
        "name '{name}' is taken by line {first}: each tree needs its own (capitals do not count)"
    )]
    Twice { name: String, first: usize },
    #[error("{field} is {found}, allowed is {min} to {max}")]
    Range { field: &'static str, found: f64, min: f64, max: f64 },
    #[error(
        "shares[{row}] is {found}: shares lie above 0 to 1 and fall, as in [1, 0.5, 0.2, 0.05]"
    )]
    Shares { row: usize, found: f32 },
    #[error("{0}")]
    Fields(&'static str),
}

/// A line's number, from 1, and what it says.
pub(crate) type Row = (usize, Result<Line, LineError>);

/// Reads all lines that are not blank. One that is wrong leaves the others as they are.
pub(crate) fn read(text: &str) -> Vec<Row> {
    let mut taken = BTreeMap::new();
    let mut rows = Vec::new();
    for (number, text) in (1..).zip(text.lines()).filter(|(_, text)| !text.trim().is_empty()) {
        let line = parse(text.trim()).and_then(|line| match taken.get(&line.name.to_lowercase()) {
            Some(&first) => Err(LineError::Twice { name: line.name, first }),
            None => {
                taken.insert(line.name.to_lowercase(), number);
                Ok(line)
            }
        });
        rows.push((number, line));
    }
    rows
}

fn parse(text: &str) -> Result<Line, LineError> {
    let mut line: Line = serde_json::from_str(text).map_err(|error| {
        // The message ends in a line that is always 1.
        let problem = error.to_string();
        let problem = problem.split(" at line ").next().unwrap_or(&problem).to_owned();
        LineError::Json { column: error.column(), problem }
    })?;
    line.text = text.into();
    line.validate()?;
    Ok(line)
}

impl Line {
    fn validate(&self) -> Result<(), LineError> {
        let good = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        let name = &self.name;
        let whole = (1..=NAME_MAX).contains(&name.len()) && name.chars().all(good);
        if !whole || name.starts_with('.') || name.ends_with('.') {
            return Err(LineError::Name { found: name.clone() });
        }
        range("scale", f64::from(self.scale), 0.001, 1000.0)?;
        if let Some(height) = self.height {
            range("height", f64::from(height), 0.01, 1000.0)?;
        }
        if let Some(levels) = self.levels {
            range("levels", levels as f64, 1.0, MAX_LEVELS as f64)?;
        }
        if let Some(views) = self.views {
            range("views", f64::from(views), 2.0, 64.0)?;
        }
        if let Some(shares) = &self.shares {
            range("number of shares", shares.len() as f64, 1.0, MAX_LEVELS as f64)?;
            let above = std::iter::once(1.0_f32.next_up()).chain(shares.iter().copied());
            let bad = shares.iter().zip(above).position(|(&s, above)| !(s > 0.0 && s < above));
            if let Some(row) = bad {
                return Err(LineError::Shares { row, found: shares[row] });
            }
        }
        let say =
            |wrong: bool, problem| if wrong { Err(LineError::Fields(problem)) } else { Ok(()) };
        say(self.levels.is_some() && self.shares.is_some(), "levels and shares: give one of them")?;
        let preset = matches!(
            self.modeler,
            Source::Path(_) | Source::Lsystem(_) | Source::Growth(_) | Source::Mesh(_)
        );
        say(
            self.height.is_some() && preset,
            "height is for silhouette, sketch and photo; other trees have a size: use scale",
        )?;
        say(self.outputs.is_empty(), "outputs is empty: leave it out for the mesh and its levels")?;
        let none = matches!(&self.modeler, Source::Photo(photos) if photos.is_empty());
        say(none, "photo is empty: a list of at least one picture is wanted, as in [\"front.png\"]")
    }

    /// Files that the tree is made of.
    pub(crate) fn inputs(&self) -> Vec<&Path> {
        match &self.modeler {
            Source::Lsystem(name) if is_grammar(name) => vec![Path::new(name)],
            Source::Path(_) | Source::Lsystem(_) | Source::Growth(_) => Vec::new(),
            Source::Silhouette(path) | Source::Sketch(path) | Source::Mesh(path) => vec![path],
            Source::Photo(paths) => paths.iter().map(PathBuf::as_path).collect(),
        }
    }

    /// Share of the leaf triangles at each level.
    pub(crate) fn shares(&self) -> Vec<f32> {
        if let Some(shares) = &self.shares {
            return shares.clone();
        }
        let n = self.levels.unwrap_or(4);
        let step = 1.0 / (n.max(2) - 1) as f32;
        (0..n).map(|i| libm::powf(LAST_SHARE, i as f32 * step)).collect()
    }
}

/// Whether an L-system is a file, and not a preset.
pub(crate) fn is_grammar(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|end| end == "l")
}

fn range(field: &'static str, found: f64, min: f64, max: f64) -> Result<(), LineError> {
    if (min..=max).contains(&found) {
        Ok(())
    } else {
        Err(LineError::Range { field, found, min, max })
    }
}

fn one() -> u64 {
    1
}

fn unscaled() -> f32 {
    1.0
}

fn usual() -> Vec<Output> {
    vec![Output::Mesh, Output::Levels]
}
