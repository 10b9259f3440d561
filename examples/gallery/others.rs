//! Pictures that other examples make, put on sheets where there are several.

use crate::{Outcome, sheet};
use image::DynamicImage;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where the other examples write.
const OUT: &str = "out/gallery";
const SHARED: &str = "../shared/data";

/// What one picture is made of.
struct Part {
    name: &'static str,
    /// Whether it takes shared data.
    shared: bool,
    /// The commands' arguments: the name of an example, then its own; `-p` first for a package.
    commands: &'static [&'static str],
    /// Files in rows, beside what is written to `out`; none where the command writes the picture itself.
    rows: &'static [&'static [&'static str]],
    /// Of the sheet, in pixels.
    width: u32,
}

const PART: Part = Part { name: "", shared: false, commands: &[], rows: &[], width: 1680 };

const PARTS: &[Part] = &[
    Part { name: "oak", commands: &["quickstart"], rows: &[&["out/oak.png"]], width: 1024, ..PART },
    Part {
        name: "closeups",
        commands: &["closeups -- out/gallery"],
        rows: &[&["closeups.jpg"]],
        width: 1440,
        ..PART
    },
    Part {
        name: "leaves",
        commands: &["leaves -- out/gallery"],
        rows: &[&["leaves.png"]],
        width: 1440,
        ..PART
    },
    Part { name: "templates", commands: &["templates -- sheet FOLDER"], ..PART },
    Part {
        name: "photos",
        shared: true,
        commands: &["photos_gallery -- FOLDER/photos.jpg"],
        ..PART
    },
    Part { name: "sketches", shared: true, commands: &["sketches_gallery -- FOLDER"], ..PART },
    Part {
        name: "silhouettes_kinds",
        commands: &["-p evaluate -- silhouette"],
        rows: &[
            &["out/silhouettes/poplar.png", "out/silhouettes/pine.png"],
            &["out/silhouettes/christmas_tree.png", "out/silhouettes/palm.png"],
            &["out/silhouettes/willow.png", "out/silhouettes/eucalyptus.png"],
        ],
        width: 1445,
        ..PART
    },
    Part {
        name: "silhouettes_stands",
        commands: &["-p evaluate -- silhouette"],
        rows: &[&["out/silhouettes/fern_forest.png"], &["out/silhouettes/stand.png"]],
        width: 1440,
        ..PART
    },
    Part {
        name: "skeletonize",
        shared: true,
        commands: &[
            "skeletonize -- SHARED/meshes/eztree_oak_medium.glb --picture out/gallery/a.png",
            "skeletonize -- SHARED/meshes/quaternius/Birch_8.obj --picture out/gallery/b.png",
            "skeletonize -- SHARED/meshes/walnut_wood.glb --picture out/gallery/c.png",
            "skeletonize -- SHARED/meshes/nature_PalmTree_1.glb --picture out/gallery/d.png",
            "skeletonize -- SHARED/meshes/waterways/tree.glb --picture out/gallery/e.png",
        ],
        rows: &[&["a.png", "b.png", "c.png"], &["d.png", "e.png"]],
        ..PART
    },
    Part {
        name: "scans",
        shared: true,
        commands: &[
            "skeletonize -- SHARED/pointclouds/itsme_tree2.ply --picture out/gallery/f.png --out out/gallery/f.swc",
            "skeletonize -- SHARED/pointclouds/puu1_crown.ply --picture out/gallery/g.png --out out/gallery/g.swc",
            "skeletonize -- SHARED/pointclouds/hard_treeiso_pine_plot.ply --several --picture out/gallery/h.png --out \
             out/gallery/h.swc",
        ],
        rows: &[&["f.png", "g.png", "h.png"]],
        width: 1440,
    },
    Part {
        name: "levels",
        commands: &["prune -- --out out/gallery"],
        rows: &[&["oak_levels.png"]],
        width: 1440,
        ..PART
    },
    Part {
        name: "growth",
        commands: &[
            "growth -- --all --out out/gallery",
            "growth -- --preset oak --years 5 --out out/gallery",
        ],
        rows: &[&["presets.png"], &["years.png"]],
        width: 1600,
        ..PART
    },
    Part {
        name: "plastic",
        commands: &[
            "plastic -- oak --frames 3 --out out/gallery",
            "plastic -- oak --frames 1 --colours --out out/gallery/colors",
            "plastic -- oak --scene pair --frames 2 --out out/gallery",
            "plastic -- birch --scene pair --frames 1 --out out/gallery",
            "plastic -- oak --scene sun --frames 1 --out out/gallery",
            "plastic -- palm --frames 2 --out out/gallery",
            "plastic -- spruce --frames 2 --out out/gallery",
        ],
        rows: &[
            &[
                "oak_wall_000.png",
                "oak_wall_001.png",
                "oak_wall_002.png",
                "colors/oak_wall_000.png",
            ],
            &["oak_pair_000.png", "oak_pair_001.png", "birch_pair_000.png", "oak_sun_000.png"],
            &[
                "palm_wall_000.png",
                "palm_wall_001.png",
                "spruce_wall_000.png",
                "spruce_wall_001.png",
            ],
        ],
        ..PART
    },
    Part {
        name: "hybrid",
        commands: &[
            "multires -- birch --out out/gallery",
            "multires -- spruce --out out/gallery",
            "multires -- palm --out out/gallery",
        ],
        rows: &[&["birch_distances.png"], &["spruce_distances.png"], &["palm_distances.png"]],
        width: 780,
        ..PART
    },
];

pub(crate) fn parts() -> impl Iterator<Item = &'static &'static str> {
    PARTS.iter().map(|part| &part.name)
}

pub(crate) fn draw(name: &str, folder: &Path) -> Outcome {
    let part = PARTS.iter().find(|part| part.name == name).ok_or("no such part")?;
    if part.shared && !Path::new(SHARED).is_dir() {
        println!("left out: there is no {SHARED}");
        return Ok(());
    }
    std::fs::create_dir_all(OUT)?;
    for command in part.commands {
        run(command, folder)?;
    }
    let open = |file: &&str| -> Outcome<DynamicImage> {
        let path =
            if file.starts_with("out/") { PathBuf::from(file) } else { Path::new(OUT).join(file) };
        image::open(&path).map_err(|error| format!("{}: {error}", path.display()).into())
    };
    let rows = part.rows.iter().map(|row| row.iter().map(open).collect());
    let rows = rows.collect::<Outcome<Vec<Vec<DynamicImage>>>>()?;
    if rows.is_empty() {
        return Ok(());
    }
    sheet::save(&sheet::rows(&rows, part.width), &folder.join(format!("{name}.jpg")))
}

/// An example, as a user would run it.
fn run(command: &str, folder: &Path) -> Outcome {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let folder = folder.to_string_lossy();
    let mut words: Vec<String> = command
        .split(' ')
        .map(|w| w.replace("FOLDER", &folder).replace("SHARED", SHARED))
        .collect();
    if words.first().is_some_and(|first| first != "-p") {
        words.insert(0, "--example".into());
    }
    println!("{command}");
    let status = Command::new(cargo).args(["run", "-q", "--release"]).args(&words).status()?;
    // An evaluation that misses an aim has drawn its pictures all the same.
    if status.success() || command.starts_with("-p") {
        Ok(())
    } else {
        Err(format!("{command}: {status}").into())
    }
}
