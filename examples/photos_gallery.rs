//! Photographs above, trees made of them below, seen as the photographs see them: `docs/pictures/photos.jpg`.
//!
//! `cargo run --release --example photos_gallery -- [PICTURE] [SEED]`
//!
//! Takes photographs of shared data, which is not part of the project's packages; without it nothing is made.
//! `docs/PHOTOS.md` credits the photographers; so does what this prints.

// What is known of the photographs is the evaluation's.
#[allow(dead_code)]
#[path = "evaluate/src/particle/hints.rs"]
mod hints;
#[path = "evaluate/src/particle/scribbles.rs"]
mod scribbles;

use hints::{HINTS, Hint, How, Scribble};
use image::{RgbaImage, imageops};
use std::error::Error;
use std::path::{Path, PathBuf};
use tree_core::{Control, Seed};
use tree_lod::preview::{self, Camera, Lens, Pose, Style, View};
use tree_mesh::{Look, MeshParams};
use tree_model::particle::finish::FinishParams;
use tree_model::particle::matting::{AutomaticParams, NaturalParams, Trimap, automatic, natural};
use tree_model::particle::session::{PhotoParams, Session, Shot};
use tree_model::particle::{self, Matte, Photo};

/// Height of every picture in pixels, and what is left free between them.
const TILE: u32 = 360;
const GAP: u32 = 4;

/// Photographs that may be passed on with a credit, and that.
const SHOWN: [(&str, &str); 6] = [
    (
        "sugar_maple_autumn.jpg",
        "Sugar maple: James St. John, CC BY 2.0 (https://creativecommons.org/licenses/by/2.0/), Wikimedia Commons",
    ),
    (
        "bur_oak_sunset.jpg",
        "Bur oak: Heath Cajandig, CC BY 2.0 (https://creativecommons.org/licenses/by/2.0/), Wikimedia Commons",
    ),
    (
        "catalpa_park.jpg",
        "Northern catalpa: Mark Wagner, CC BY 2.5 (https://creativecommons.org/licenses/by/2.5/), Wikimedia Commons",
    ),
    ("osage_orange_autumn.jpg", "Osage orange: Daderot, public domain, Wikimedia Commons"),
    (
        "hard_honey_locust_hedge.jpg",
        "Honey locust: Wouter Hagens, public domain, Wikimedia Commons",
    ),
    (
        "western_redcedar_crown.jpg",
        "Western redcedar: abdallahh, CC BY 2.0 (https://creativecommons.org/licenses/by/2.0/), Wikimedia Commons",
    ),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let out =
        arguments.next().map_or_else(|| PathBuf::from("docs/pictures/photos.jpg"), PathBuf::from);
    let seed = Seed(arguments.next().map_or(Ok(1), |text| text.parse())?);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/photos");
    let mut columns = Vec::new();
    for (file, credit) in SHOWN {
        let path = folder.join(file);
        let hint = HINTS.iter().find(|hint| hint.file == file);
        match hint {
            Some(hint) if path.exists() => columns.push(column(&path, hint, seed)?),
            _ => {
                println!("{file}: not there, left out");
                continue;
            }
        }
        println!("{credit}");
    }
    if columns.is_empty() {
        println!("no shared data, no picture");
        return Ok(());
    }
    // No picture has holes: without alpha, any format will do.
    image::DynamicImage::from(sheet(&columns)).to_rgb8().save(&out)?;
    println!("{}", out.display());
    Ok(())
}

/// A photograph, and the tree made of it as it is seen from there.
fn column(path: &Path, hint: &Hint, seed: Seed) -> Result<[RgbaImage; 2], Box<dyn Error>> {
    let control = Control::default();
    let photo = Photo::open(path, &control.limits)?;
    let shot = Shot::new(matte(&photo, hint.how)?, Some(photo.clone()), 0.0);
    let params =
        PhotoParams { finish: FinishParams::find(hint.species)?, ..PhotoParams::default() };
    let mut session = Session::new(vec![shot], params, seed)?;
    let tree = session.tree(&control)?.tree.clone();
    let view = session.views(&control)?.first().ok_or("no view")?;
    let look = Look::built_in(tree.species())?;
    let mesh = tree_mesh::build(&tree, &look, &MeshParams::default(), &control)?.mesh;
    let view = as_seen(&view.camera);
    let seen = preview::render(&mesh, &view, &Style::studio(), &control)?;
    let pixels = photo.pixels().as_flattened().to_vec();
    let above = RgbaImage::from_raw(photo.width(), photo.height(), pixels).ok_or("no pixels")?;
    let filter = imageops::FilterType::CatmullRom;
    Ok([
        imageops::resize(&above, view.width, view.height, filter),
        RgbaImage::from_raw(seen.width, seen.height, seen.pixels).ok_or("no pixels")?,
    ])
}

fn matte(photo: &Photo, how: How) -> Result<Matte, Box<dyn Error>> {
    let control = Control::default();
    Ok(match how {
        How::Scribbles(scribbles) => {
            let strokes: Result<Vec<_>, _> = scribbles.iter().map(Scribble::stroke).collect();
            let trimap = Trimap::from_strokes(photo.width(), photo.height(), &strokes?)?;
            natural(photo, &trimap, &NaturalParams::default(), &control)?.0
        }
        How::Alpha | How::Auto => automatic(photo, &AutomaticParams::default(), &control)?.0,
    })
}

/// The view of a photograph's camera, at the height of a tile.
fn as_seen(camera: &particle::Camera) -> View {
    let stand = camera.stand();
    let lens = match stand.fov {
        Some(fov) => Lens::Perspective { fov },
        None => Lens::Orthographic { height: stand.height },
    };
    let pose = Pose { eye: stand.eye, target: stand.target, up: stand.up, lens };
    let width = (camera.size.x * TILE as f32 / camera.size.y).round() as u32;
    View { width: width.max(1), height: TILE, samples: 3, camera: Camera::Placed(pose) }
}

/// Columns side by side.
fn sheet(columns: &[[RgbaImage; 2]]) -> RgbaImage {
    let width: u32 = columns.iter().map(|[photo, _]| photo.width() + GAP).sum();
    let white = image::Rgba([255; 4]);
    let mut sheet = RgbaImage::from_pixel(width.saturating_sub(GAP), 2 * TILE + GAP, white);
    let mut x = 0;
    for [photo, tree] in columns {
        imageops::replace(&mut sheet, photo, x, 0);
        imageops::replace(&mut sheet, tree, x, i64::from(TILE + GAP));
        x += i64::from(photo.width() + GAP);
    }
    sheet
}
