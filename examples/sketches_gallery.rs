//! Sketches and the trees made of them, from the front and the side: `docs/pictures/sketches_*.jpg`.
//!
//! `cargo run --release --example sketches_gallery -- [FOLDER] [SEED] [--stages]`
//!
//! Takes drawings of shared data, which is not part of the project's packages; without it nothing is made.
//! `docs/SKETCHES.md` has the credits; so does what this prints. With `--stages` each row also shows what clean-up made of the
//! drawing and the inferred branches from the side.

#[path = "common/paper.rs"]
mod paper;

use image::{RgbaImage, imageops};
use paper::{Frame, INK, Paper, Side};
use std::error::Error;
use std::path::Path;
use std::time::Instant;
use tree_core::{Control, Seed, file};
use tree_lod::preview::{self, Picture, Style};
use tree_mesh::{Look, MeshParams};
use tree_model::sketch::Drawing;
use tree_model::sketch::session::{Session, SketchParams};

/// Pixels along each side of a tile, and what is left free between them.
const TILE: u32 = 200;
const GAP: u32 = 4;

/// Rows beside one another in a sheet.
const ACROSS: usize = 2;

/// Drawings for which the template is named: what kind of tree a palm's or a conifer's outline means is not found out.
const TEMPLATES: [(&str, &str); 7] = [
    ("map_tree_05.svg", "spruce"),
    ("map_tree_07.svg", "spruce"),
    ("map_tree_13.svg", "palm"),
    ("evergreen_with_branches.svg", "spruce"),
    ("lucide_tree-pine.svg", "spruce"),
    ("openmoji_1F334.svg", "palm"),
    ("quickdraw_palm_tree.ndjson", "palm"),
];

/// Drawings of a file of many, from 1.
const LINES: [usize; 6] = [1, 2, 3, 4, 5, 6];

const QUICKDRAW: &str = "The Quick, Draw! Dataset (Google), CC BY 4.0";
const OPENCLIPART: &str = "Open Clip Art Library, public domain";
const LUCIDE: &str = "Lucide, ISC";
const OPENMOJI: &str = "OpenMoji, CC BY-SA 4.0";

/// Sheets: their files' names, drawings, and credits.
const SHEETS: [(&str, &[(&str, &str)]); 4] = [
    (
        "sketches_pen.jpg",
        &[
            ("map_tree_01.svg", OPENCLIPART),
            ("map_tree_02.svg", OPENCLIPART),
            ("map_tree_04.svg", OPENCLIPART),
            ("map_tree_05.svg", OPENCLIPART),
            ("map_tree_07.svg", OPENCLIPART),
            ("map_tree_11.svg", OPENCLIPART),
            ("map_tree_13.svg", OPENCLIPART),
            ("branches_and_roots.svg", OPENCLIPART),
            ("evergreen_with_branches.svg", OPENCLIPART),
            ("lucide_tree-deciduous.svg", LUCIDE),
            ("lucide_tree-pine.svg", LUCIDE),
        ],
    ),
    // Apart: who passes it on has to do so under the same licence.
    (
        "sketches_openmoji.jpg",
        &[("openmoji_1F333.svg", OPENMOJI), ("openmoji_1F334.svg", OPENMOJI)],
    ),
    ("sketches_trees.jpg", &[("quickdraw_tree.ndjson", QUICKDRAW)]),
    (
        "sketches_palms_bushes.jpg",
        &[("quickdraw_palm_tree.ndjson", QUICKDRAW), ("quickdraw_bush.ndjson", QUICKDRAW)],
    ),
];

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> Outcome {
    let (flags, words): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|word| word.starts_with("--"));
    let out = Path::new(words.first().map_or("docs/pictures", String::as_str));
    let seed = Seed(words.get(1).map_or(Ok(1), |text| text.parse())?);
    let stages = flags.iter().any(|flag| flag == "--stages");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/sketches");
    for (name, files) in SHEETS {
        let mut rows = Vec::new();
        for (file, credit) in files {
            let path = folder.join(file);
            if !path.exists() {
                println!("{file}: not there, left out");
                continue;
            }
            println!("{file}: {credit}");
            let text = file::read_text(&path, &Control::default().limits)?;
            let drawings = paper::read_drawings(&path, &text)?;
            let one = drawings.len() == 1;
            let template = TEMPLATES.iter().find(|(of, _)| of == file).map(|(_, name)| *name);
            for (i, drawing) in drawings.into_iter().enumerate() {
                if one || LINES.contains(&(i + 1)) {
                    print!("  {}: ", i + 1);
                    rows.push(row(&drawing, template, seed, stages)?);
                }
            }
        }
        if !rows.is_empty() {
            let path = out.join(name);
            // No picture has holes: without alpha, any format will do.
            image::DynamicImage::from(sheet(&rows)).to_rgb8().save(&path)?;
            println!("{}", path.display());
        }
    }
    Ok(())
}

/// A drawing, the tree made of it from the front and from the side.
fn row(
    drawing: &Drawing,
    template: Option<&str>,
    seed: Seed,
    stages: bool,
) -> Outcome<Vec<RgbaImage>> {
    let control = Control::default();
    let params =
        SketchParams { template: template.map(ToOwned::to_owned), ..SketchParams::default() };
    let mut session = Session::new(drawing.clone(), params, seed)?;
    let start = Instant::now();
    let grown = session.tree(&control)?.clone();
    let (time, report) = (start.elapsed().as_secs_f64(), &grown.report);
    println!(
        "{}, {} segments, {} leaves, {} repairs, {:.0} ms",
        report.template,
        report.segments,
        grown.tree.foliage().len(),
        report.warnings().len(),
        1000.0 * time,
    );
    let look = Look::built_in(grown.tree.species())?;
    let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), &control)?.mesh;
    let cleaned = session.cleaned(&control)?.clone();
    let frames =
        [Side::Front, Side::Right].map(|side| Frame::around(side, &cleaned, drawing, &mesh, TILE));
    let style = Style { ground: None, ..Style::studio() };
    let mut paper = Paper::new(frames[0]);
    paper.drawing(drawing, &cleaned, 1.6, INK);
    let mut row = vec![tile(paper.picture())?];
    if stages {
        let crown = session.crown(&control)?.cloned();
        let mut paper = Paper::new(frames[0]);
        paper.cleaned(drawing, &cleaned, crown.as_ref());
        row.push(tile(paper.picture())?);
        let branches = &session.inferred(&control)?.branches;
        for frame in frames {
            let mut paper = Paper::new(frame);
            paper.branches(branches, branches.len());
            row.push(tile(paper.picture())?);
        }
    }
    for frame in frames {
        row.push(tile(preview::render(&mesh, &frame.view(), &style, &control)?)?);
    }
    Ok(row)
}

/// A picture in the middle of a tile in the colour of its corner.
fn tile(picture: Picture) -> Outcome<RgbaImage> {
    let (width, height) = (picture.width, picture.height);
    let image = RgbaImage::from_raw(width, height, picture.pixels).ok_or("too few pixels")?;
    let mut tile = RgbaImage::from_pixel(TILE, TILE, *image.get_pixel(0, 0));
    let at = |size: u32| i64::from(TILE.saturating_sub(size)) / 2;
    imageops::replace(&mut tile, &image, at(width), at(height));
    Ok(tile)
}

/// Rows below one another, some beside one another.
fn sheet(rows: &[Vec<RgbaImage>]) -> RgbaImage {
    let (pitch, wide) = (TILE + GAP, rows.iter().map(Vec::len).max().unwrap_or(0) as u32);
    let block = wide * pitch + 2 * GAP;
    let (width, height) = (ACROSS as u32 * block, rows.len().div_ceil(ACROSS) as u32 * pitch);
    let mut sheet = RgbaImage::from_pixel(width - 3 * GAP, height - GAP, image::Rgba([255; 4]));
    for (i, row) in rows.iter().enumerate() {
        let (x, y) = ((i % ACROSS) as u32 * block, (i / ACROSS) as u32 * pitch);
        for (k, tile) in (0..).zip(row) {
            imageops::replace(&mut sheet, tile, i64::from(x + k * pitch), i64::from(y));
        }
    }
    sheet
}
