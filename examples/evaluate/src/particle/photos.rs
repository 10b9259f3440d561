//! Every photograph of the shared data, alone, and pairs of photographs of different trees.

use super::cases::{Grown, grow};
use super::hints::{HINTS, Hint, How, Scribble};
use super::pictures::photo_folder;
use crate::measure::of_each;
use crate::table::Table;
use std::error::Error;
use std::f32::consts::FRAC_PI_2;
use std::path::Path;
use tree_core::{Control, Seed, Tree};
use tree_model::particle::finish::FinishParams;
use tree_model::particle::matting::{
    AutomaticParams, NaturalParams, Stroke, Trimap, alpha_of, automatic, natural,
};
use tree_model::particle::session::{PhotoParams, Session, Shot};
use tree_model::particle::{Matte, Photo};

/// Least F1 in a view that was given.
const F1: f64 = 0.85;
/// Trees of one kind that were never one tree: the first as the front, the second as the side.
const PAIRS: [(&str, &str); 4] = [
    ("sugar_maple_autumn.jpg", "hard_red_maple_house.jpg"),
    ("american_beech_young.jpg", "catalpa_park.jpg"),
    ("boxelder_lawn.jpg", "osage_orange_autumn.jpg"),
    ("coast_redwood_conifer.jpg", "ponderosa_pine_slope.jpg"),
];

pub(super) fn rows(table: &mut Table) -> Result<(), Box<dyn Error>> {
    let folder = photo_folder();
    if !folder.is_dir() {
        eprintln!("{}: not there, photographs left out", folder.display());
        return Ok(());
    }
    for entry in std::fs::read_dir(&folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if !name.ends_with(".md") && HINTS.iter().all(|hint| hint.file != name) {
            eprintln!("{name}: not known what tree it shows, left out");
        }
    }
    let alone = of_each(&HINTS, |hint| one(&folder, hint))?;
    for (hint, grown) in HINTS.iter().zip(alone) {
        let case = format!("{} ({})", stem(hint.file), hint.how.name());
        if let Some(grown) = grown {
            grown.rows(table, &case, &["front".into()], F1);
        }
    }
    let pairs = of_each(&PAIRS, |pair| two(&folder, *pair))?;
    for ((front, side), grown) in PAIRS.iter().zip(pairs) {
        let case = format!("{} + {}", short(front), short(side));
        if let Some(grown) = grown {
            grown.rows(table, &case, &["front".into(), "side".into()], F1);
        }
    }
    Ok(())
}

fn one(folder: &Path, hint: &Hint) -> Result<Option<Grown>, Box<dyn Error>> {
    let Some(shot) = shot(folder, hint, 0.0)? else { return Ok(None) };
    Ok(Some(grow(vec![shot], &params(hint)?, None)?))
}

fn two(folder: &Path, (front, side): (&str, &str)) -> Result<Option<Grown>, Box<dyn Error>> {
    let find = |file: &str| HINTS.iter().find(|hint| hint.file == file).ok_or("no such hint");
    let (front, side) = (find(front)?, find(side)?);
    let shots = [shot(folder, front, 0.0)?, shot(folder, side, FRAC_PI_2)?];
    let [Some(a), Some(b)] = shots else { return Ok(None) };
    Ok(Some(grow(vec![a, b], &params(front)?, None)?))
}

/// A tree of one photograph; none where it is not there.
pub(crate) fn tree(file: &str) -> Result<Option<Tree>, Box<dyn Error>> {
    let hint = HINTS.iter().find(|hint| hint.file == file).ok_or("no such hint")?;
    let Some(shot) = shot(&photo_folder(), hint, 0.0)? else { return Ok(None) };
    let mut session = Session::new(vec![shot], params(hint)?, Seed(1))?;
    Ok(Some(session.tree(&Control::default())?.tree.clone()))
}

fn params(hint: &Hint) -> Result<PhotoParams, Box<dyn Error>> {
    let mut finish = FinishParams::find(hint.species)?;
    if hint.bare {
        finish.leaves = None;
    }
    Ok(PhotoParams { finish, ..PhotoParams::default() })
}

/// A photograph, separated; none where it is not there.
fn shot(folder: &Path, hint: &Hint, yaw: f32) -> Result<Option<Shot>, Box<dyn Error>> {
    let path = folder.join(hint.file);
    if !path.exists() {
        eprintln!("{}: not there, left out", hint.file);
        return Ok(None);
    }
    let photo = Photo::open(path, &Control::default().limits)?;
    let matte = matte(&photo, hint.how).map_err(|error| format!("{}: {error}", hint.file))?;
    Ok(Some(Shot::new(matte, Some(photo), yaw)))
}

fn matte(photo: &Photo, how: How) -> Result<Matte, Box<dyn Error>> {
    let control = Control::default();
    Ok(match how {
        How::Alpha => alpha_of(photo)?,
        How::Auto => automatic(photo, &AutomaticParams::default(), &control)?.0,
        How::Scribbles(scribbles) => {
            let strokes: Result<Vec<Stroke>, _> = scribbles.iter().map(Scribble::stroke).collect();
            let trimap = Trimap::from_strokes(photo.width(), photo.height(), &strokes?)?;
            natural(photo, &trimap, &NaturalParams::default(), &control)?.0
        }
    })
}

/// A file's name without its ending, and without what it says of how hard it is.
fn stem(file: &str) -> &str {
    let name = file.strip_prefix("hard_").unwrap_or(file);
    name.split('.').next().unwrap_or(name)
}

/// The first words of a file's name.
fn short(file: &str) -> String {
    let words: Vec<&str> = stem(file).split('_').take(2).collect();
    words.join(" ")
}
