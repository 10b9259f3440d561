//! pymatting: the tree's share of every pixel of a photograph, from a trimap.
//!
//! The pictures are cut-outs of known alpha before made backgrounds, as in `particle`, which compares errors of its
//! closed form only. Ours takes all threads, and so do theirs where numba and scipy know how.

use super::program::{Absence, Language, Nothing, Peer, Scratch, Told};
use super::{CASE, Outcome, SECONDS, beside, fastest, memory, or_note};
use crate::measure::peak_bytes;
use crate::particle::{Known, known_pictures};
use crate::table::{Aim, Table};
use std::hint::black_box;
use std::path::Path;
use tree_core::{Control, Limits};
use tree_model::particle::matting::{Level, NaturalParams, Trimap, natural};
use tree_model::particle::{Matte, Photo};

const PEER: Peer = Peer {
    name: "pymatting",
    install: "pip install pymatting==1.1.16 pillow, or examples/evaluate/peers/install.sh",
    language: Language::Python,
    script: "matting.py",
};
/// Largest share of the peer's error, as in `particle`.
const ERROR_RATIO: f64 = 1.1;
/// Levin, Lischinski & Weiss 2008.
pub(crate) const CLOSED_FORM: &str = "cf";
/// Its methods: closed form, which ours is too, and nearest neighbours. Random walks take half a minute.
const METHODS: [&str; 2] = [CLOSED_FORM, "knn"];

/// Pictures that are few enough to be quick.
const PICTURES: [&str; 2] = ["rendered oak before hedge", "cutout_holm_oak.png before hedge"];
/// How a case of memory starts; the folder with the two pictures follows.
const FOLDER: &str = "matting:";
const IMAGE: &str = "image.png";
const KNOWN: &str = "trimap.png";

/// What they made of a picture.
pub(crate) struct Alpha {
    pub(crate) values: Vec<f32>,
    told: Told<Nothing>,
    /// Peak memory of ours for the same picture; asked for with the time only.
    ours_bytes: Option<u64>,
}

/// Asks pymatting for the alpha of a picture, by one of its methods: once, and again as long as so many seconds are
/// not over.
pub(crate) fn ask(
    photo: &Photo,
    trimap: &Trimap,
    method: &str,
    seconds: f64,
) -> Result<Alpha, Absence> {
    let work = || -> Outcome<Result<Alpha, Absence>> {
        let scratch = Scratch::new("matting")?;
        let [image, known, out] = [IMAGE, KNOWN, "alpha.png"].map(|n| scratch.file(n));
        photo.save_png(&image)?;
        let levels = trimap.levels().iter().map(|level| match level {
            Level::Background => 0.0,
            Level::Unknown => 0.5,
            Level::Foreground => 1.0,
        });
        Matte::new(trimap.width(), trimap.height(), levels.collect())?.save_png(&known)?;
        let within = seconds.to_string();
        let arguments =
            [image.as_ref(), known.as_ref(), out.as_ref(), method.as_ref(), within.as_ref()];
        let told = match PEER.ask(&arguments) {
            Ok(told) => told,
            Err(absence) => return Ok(Err(absence)),
        };
        let folder = image.parent().ok_or("no folder")?.display().to_string();
        let timed = seconds > 0.0;
        let ours_bytes = timed.then(|| peak_bytes(&format!("{CASE}{FOLDER}{folder}"))).flatten();
        let alpha = Photo::open(out, &Limits::default())?;
        let values: Vec<f32> = alpha.pixels().iter().map(|p| f32::from(p[0]) / 255.0).collect();
        if values.len() != trimap.levels().len() {
            return Err("the alpha is of another size".into());
        }
        Ok(Ok(Alpha { values, told, ours_bytes }))
    };
    work().unwrap_or_else(|error| Err(PEER.broken(error)))
}

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    for known in known_pictures()?.iter().filter(|known| PICTURES.contains(&&*known.name)) {
        if !picture(table, known)? {
            break;
        }
    }
    Ok(())
}

/// One picture; tells whether there is a peer to go on with.
fn picture(table: &mut Table, known: &Known) -> Outcome<bool> {
    let Known { name, photo, trimap, .. } = known;
    let cut_out = || Ok(natural(photo, trimap, &NaturalParams::default(), &Control::default())?.0);
    let mut ours = None;
    for method in METHODS {
        let told = ask(photo, trimap, method, SECONDS);
        let Some(theirs) = or_note(told) else {
            return Ok(false);
        };
        let (seconds, matte) = match ours.take() {
            Some(measured) => measured,
            None => fastest(cut_out)?,
        };
        let case = format!("pymatting {method}, {name}");
        let mut row = |metric, figures, unit, aim| beside(table, &case, metric, figures, unit, aim);
        let peer = 1e3 * theirs.told.seconds;
        row("time", [peer, 1e3 * seconds], "ms", Aim::AtMost(peer));
        let errors = [&theirs.values[..], matte.alpha()].map(|alpha| known.error(alpha));
        row("mean abs. error, unknown", errors, "", Aim::AtMost(ERROR_RATIO * errors[0]));
        memory(table, &case, theirs.told.peak_bytes, theirs.ours_bytes);
        ours = Some((seconds, matte));
    }
    Ok(true)
}

/// Does what a case of [`peak_bytes`] names, if it is one of these: cuts out a picture of a folder.
pub(super) fn build_case(case: &str) -> Outcome<bool> {
    let Some(folder) = case.strip_prefix(FOLDER) else {
        return Ok(false);
    };
    let [photo, known] =
        [IMAGE, KNOWN].map(|name| Photo::open(Path::new(folder).join(name), &Limits::default()));
    let (photo, known) = (photo?, known?);
    let levels = known.pixels().iter().map(|pixel| match pixel[0] {
        0..64 => Level::Background,
        64..192 => Level::Unknown,
        _ => Level::Foreground,
    });
    let trimap = Trimap::new(known.width(), known.height(), levels.collect())?;
    black_box(natural(&photo, &trimap, &NaturalParams::default(), &Control::default())?);
    Ok(true)
}
