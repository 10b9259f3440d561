//! What was asked for on the command line.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use tree_core::{Control, Seed, Species, Tree, swc};
use tree_model::lsystem::LSystem;
use tree_model::path::Preset;

pub(crate) const USAGE: &str = "plastic [PRESET|FILE.swc|FILE.glb] [--scene wall|pair|sun] [--frames N] [--distance METRES] \
                                [--species NAME] [--colors] [--regrow] [--out FOLDER]";

/// What happens.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Act {
    Wall,
    Pair,
    Sun,
}

impl Act {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Wall => "wall",
            Self::Pair => "pair",
            Self::Sun => "sun",
        }
    }
}

pub(crate) struct Request {
    pub(crate) input: String,
    pub(crate) act: Act,
    pub(crate) frames: u32,
    pub(crate) distance: Option<f32>,
    pub(crate) species: Option<String>,
    pub(crate) colors: bool,
    pub(crate) regrow: bool,
    pub(crate) out: PathBuf,
}

impl Request {
    pub(crate) fn parse(
        mut arguments: impl Iterator<Item = String>,
    ) -> Result<Self, Box<dyn Error>> {
        let mut request = Self {
            input: "oak".into(),
            act: Act::Wall,
            frames: 4,
            distance: None,
            species: None,
            colors: false,
            regrow: false,
            out: "out".into(),
        };
        while let Some(name) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{name} needs a value"));
            match name.as_str() {
                "--scene" => {
                    request.act = match value()?.as_str() {
                        "wall" => Act::Wall,
                        "pair" => Act::Pair,
                        "sun" => Act::Sun,
                        other => {
                            return Err(
                                format!("no scene '{other}'; there are wall, pair, sun").into()
                            );
                        }
                    }
                }
                "--frames" => request.frames = number::<u32>(&name, &value()?)?.clamp(1, 1000),
                "--distance" => request.distance = Some(number(&name, &value()?)?),
                "--species" => request.species = Some(value()?),
                "--colors" => request.colors = true,
                "--regrow" => request.regrow = true,
                "--out" => request.out = value()?.into(),
                flag if flag.starts_with("--") => {
                    return Err(format!("unknown option {flag}").into());
                }
                input => request.input = input.into(),
            }
        }
        Ok(request)
    }

    /// The tree, and a name for its files.
    pub(crate) fn tree(&self, control: &Control) -> Result<(Tree, String), Box<dyn Error>> {
        let path = Path::new(&self.input);
        let stem =
            path.file_stem().map_or("tree".into(), |stem| stem.to_string_lossy().into_owned());
        let named = self.species.clone().unwrap_or_else(|| "oak".into());
        let species = Species { name: named.clone(), bark: named.clone(), leaf_kinds: vec![named] };
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("swc") => {
                let read = swc::read_file(path, &swc::SwcOptions::default(), &control.limits)?;
                Ok((Tree::bare(read.skeleton, species), stem))
            }
            Some("glb" | "gltf") => Ok((crate::draw::imported(path, control)?, stem)),
            _ => {
                if let Ok(preset) = Preset::find(&self.input) {
                    return Ok((preset.params()?.grow(Seed(1), control)?.tree, self.input.clone()));
                }
                let grown = LSystem::preset(&self.input)?.grow(Seed(1), control)?;
                Ok((grown.tree, self.input.clone()))
            }
        }
    }
}

fn number<T: FromStr>(name: &str, text: &str) -> Result<T, String> {
    text.parse().map_err(|_| format!("{name} needs a number, not '{text}'"))
}
