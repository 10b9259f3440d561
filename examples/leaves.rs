//! Close-ups of shoots, one for each arrangement and form of leaves and each habit of twigs:
//! `out/leaves_NAME.png`, and all of them on one sheet, `out/leaves.png`. `out/leaves_habits.png` has
//! one tree with six kinds of twigs, as Neubert's Fig. 5.9.
//!
//! `cargo run --release --example leaves -- [FOLDER] [TILE_PX] [NAME]`

mod common;

use common::sheet;
use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;
use tree_core::glam::{Vec2, Vec3};
use tree_core::{Control, Seed, Skeleton, Species, Tree};
use tree_lod::preview::{self, Camera, Framing, Picture, Style, View};
use tree_mesh::texture::{LeafShape, leaf_shape, leaf_with};
use tree_mesh::{Alpha, LeafLook, Look, Material, MeshParams};
use tree_model::foliage::{
    Branching, LeafParams, Phyllotaxis, SpeciesPreset, TwigParams, grow_leaves_with_stalks,
    grow_twigs, refine,
};
use tree_model::path::PathParams;

/// Pictures in a row.
const COLUMNS: u32 = 4;

/// One picture.
struct Scene {
    name: &'static str,
    /// The shoot: length and radius in metres, how far it leans, how far it bends up.
    shoot: (f32, f32, f32, f32),
    bark: &'static str,
    leaf: &'static str,
    twigs: Option<TwigParams>,
    leaves: Option<LeafParams>,
    /// How far the camera looks down.
    pitch: f32,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().map_or_else(|| PathBuf::from("out"), PathBuf::from);
    let tile = arguments.next().map_or(Ok(480), |text| text.parse())?;
    let only = arguments.next();
    std::fs::create_dir_all(&folder)?;
    let mut pictures = Vec::new();
    for scene in scenes()? {
        if only.as_ref().is_some_and(|only| only != scene.name) {
            continue;
        }
        let picture = draw(&scene, tile)?;
        picture.save_png(folder.join(format!("leaves_{}.png", scene.name)))?;
        pictures.push(picture);
    }
    if only.is_none() {
        let path = folder.join("leaves.png");
        sheet(&pictures, COLUMNS, tile)?.save(&path)?;
        println!("{}", path.display());
        let path = folder.join("leaves_habits.png");
        sheet(&habits(tile)?, 3, tile)?.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}

/// A shoot with its twigs and leaves, drawn.
fn draw(scene: &Scene, tile: u32) -> Result<Picture, Box<dyn Error>> {
    let (control, seed) = (Control::default(), Seed(7));
    let mut skeleton = shoot(scene.shoot)?;
    let mut twig_nodes = 0;
    if let Some(params) = &scene.twigs {
        let twigs = grow_twigs(&skeleton, params, seed.stream("twigs"), &control)?;
        (skeleton, twig_nodes) = (twigs.skeleton, twigs.report.n_nodes);
    }
    let species = Species {
        name: scene.name.into(),
        bark: scene.bark.into(),
        leaf_kinds: vec![scene.leaf.into()],
    };
    let tree = match &scene.leaves {
        Some(params) => {
            let seed = seed.stream("leaves");
            let leafy = grow_leaves_with_stalks(&skeleton, params, None, seed, &control)?;
            Tree::new(leafy.skeleton, leafy.foliage, species)?
        }
        None => Tree::bare(skeleton, species),
    };
    println!("{}: {} twig nodes, {} blades", scene.name, twig_nodes, tree.foliage().len());
    picture(&tree, &look(tree.species())?, scene.pitch, tile)
}

/// A tree on grey paper, seen from `pitch` above.
fn picture(tree: &Tree, look: &Look, pitch: f32, tile: u32) -> Result<Picture, Box<dyn Error>> {
    let control = Control::default();
    let mesh = tree_mesh::build(tree, look, &MeshParams::default(), &control)?.mesh;
    let framing = Framing { yaw: 0.25, pitch, margin: 0.05, ..Framing::default() };
    let view = View { width: tile, height: tile, samples: 3, camera: Camera::Framed(framing) };
    let style = Style { ground: None, ..Style::studio() };
    Ok(preview::render(&mesh, &view, &style, &control)?)
}

/// A shoot that leans over from upright and bends up again.
fn shoot((length, radius, lean, bend): (f32, f32, f32, f32)) -> Result<Skeleton, Box<dyn Error>> {
    let n = (length / 0.02).ceil() as u32;
    let mut builder = Skeleton::builder(Vec3::ZERO, radius)?;
    let mut at = Vec3::ZERO;
    for i in 1..=n {
        let share = i as f32 / n as f32;
        let along = Vec2::from_angle(lean - bend * share);
        at += Vec3::new(along.y, along.x, 0.0) * (length / n as f32);
        builder.add(i - 1, at, radius * (1.0 - 0.75 * share))?;
    }
    Ok(builder.finish())
}

/// Blades without petioles: those are branches here.
fn look(species: &Species) -> Result<Look, Box<dyn Error>> {
    let bare = Species { leaf_kinds: Vec::new(), ..species.clone() };
    let mut look = Look::built_in(&bare)?;
    for kind in &species.leaf_kinds {
        let shape = LeafShape { petiole: 0.0, ..leaf_shape(kind)? };
        let drawn = leaf_with(&shape, 256)?;
        let material = Material {
            name: kind.clone(),
            texture: Some(Arc::new(drawn.texture)),
            roughness: 0.7,
            alpha: Alpha::Mask(0.5),
            double_sided: true,
            translucency: 0.4,
            ..Material::default()
        };
        look.leaves.push(LeafLook { material, width: drawn.width, ..Default::default() });
    }
    Ok(look)
}

fn scenes() -> Result<Vec<Scene>, Box<dyn Error>> {
    let species = |name| SpeciesPreset::find(name);
    let leaves_of = |name| Ok::<_, Box<dyn Error>>(Some(species(name)?.leaves.clone()));
    let spray = (0.34, 0.0035, 1.2, 0.35);
    let upright = (0.4, 0.004, 0.25, 0.25);
    let plain = Scene {
        name: "",
        shoot: upright,
        bark: "smooth",
        leaf: "beech",
        twigs: None,
        leaves: None,
        pitch: 0.4,
    };
    let leaves = LeafParams { jitter: 0.15, bearing: 0.35, ..LeafParams::DEFAULT };
    let arranged = |name, arrangement| Scene {
        name,
        leaves: Some(LeafParams {
            arrangement,
            spacing: 0.05,
            size: 0.085,
            size_gradient: 0.35,
            petiole: 0.12,
            lamina_turn: 0.4,
            ..leaves.clone()
        }),
        ..plain_copy(&plain)
    };
    let bare = |name, branching, twigs: TwigParams| Scene {
        name,
        shoot: (0.7, 0.006, 0.75, 0.35),
        twigs: Some(TwigParams { branching, bearing: 0.65, ..twigs }),
        pitch: 0.1,
        ..plain_copy(&plain)
    };
    let weeping = species("willow")?;
    let twigs = TwigParams { per_metre: 20.0, tip_radius: 0.0012, ..TwigParams::DEFAULT };
    Ok(vec![
        Scene {
            shoot: spray,
            pitch: 0.7,
            leaves: leaves_of("beech")?,
            ..arranged("distichous", Phyllotaxis::Distichous)
        },
        Scene { shoot: spray, pitch: 0.7, ..arranged("opposite", Phyllotaxis::Opposite) },
        Scene {
            leaf: "maple",
            leaves: leaves_of("maple")?,
            ..arranged("decussate", Phyllotaxis::Decussate)
        },
        Scene { leaf: "willow", ..arranged("whorled", Phyllotaxis::Whorled { count: 5 }) },
        Scene { leaf: "oak", leaves: leaves_of("oak")?, ..arranged("spiral", Phyllotaxis::GOLDEN) },
        Scene {
            name: "pinnate",
            leaf: "ash-leaflet",
            leaves: leaves_of("ash")?,
            ..plain_copy(&plain)
        },
        Scene {
            name: "bipinnate",
            leaf: "mimosa-leaflet",
            leaves: leaves_of("mimosa")?,
            ..plain_copy(&plain)
        },
        Scene {
            name: "palmate",
            leaf: "horse-chestnut-leaflet",
            leaves: leaves_of("horse-chestnut")?,
            pitch: 0.5,
            ..plain_copy(&plain)
        },
        Scene {
            name: "fascicles",
            bark: "pine",
            leaf: "needle",
            leaves: leaves_of("pine")?,
            ..plain_copy(&plain)
        },
        Scene {
            name: "rosettes",
            bark: "pine",
            leaf: "needle",
            shoot: spray,
            leaves: leaves_of("larch")?,
            ..plain_copy(&plain)
        },
        Scene {
            name: "spruce",
            bark: "spruce",
            leaf: "needle",
            shoot: (0.5, 0.004, 1.5, 0.2),
            twigs: Some(species("spruce")?.twigs.clone()),
            leaves: leaves_of("spruce")?,
            pitch: 0.6,
        },
        Scene {
            name: "frond",
            bark: "palm",
            leaf: "palm-leaflet",
            shoot: (0.8, 0.11, 0.0, 0.0),
            leaves: leaves_of("palm")?,
            pitch: 0.1,
            ..plain_copy(&plain)
        },
        bare("monopodial", Branching::Monopodial, twigs.clone()),
        Scene {
            // From above: the zig-zag is level.
            pitch: 1.2,
            shoot: (0.5, 0.005, 1.3, 0.1),
            ..bare(
                "sympodial",
                Branching::zigzag(0.7),
                TwigParams {
                    jitter: 0.1,
                    internode: 0.04,
                    arrangement: Phyllotaxis::Distichous,
                    ..twigs.clone()
                },
            )
        },
        bare(
            "helicoid",
            Branching::helicoid(2, 0.45),
            TwigParams { levels: 1, phototropism: 0.0, ..twigs.clone() },
        ),
        Scene {
            leaf: "linden",
            twigs: Some(TwigParams { levels: 1, ..species("linden")?.twigs.clone() }),
            leaves: leaves_of("linden")?,
            shoot: (0.5, 0.006, 1.1, 0.2),
            pitch: 0.4,
            ..bare("linden", Branching::zigzag(0.6), TwigParams::DEFAULT)
        },
        Scene {
            leaf: "willow",
            leaves: leaves_of("willow")?,
            ..bare("weeping", weeping.twigs.branching, weeping.twigs.clone())
        },
        bare(
            "upright",
            Branching::Monopodial,
            TwigParams { gravitropism: -9.0, angle: 1.1, stiffness: 20.0, ..twigs.clone() },
        ),
        bare(
            "bushy",
            Branching::Monopodial,
            TwigParams {
                levels: 3,
                lateral: 0.6,
                per_metre: 25.0,
                internode: 0.025,
                jitter: 0.5,
                ..twigs.clone()
            },
        ),
        bare(
            "drooping",
            Branching::Monopodial,
            TwigParams { stiffness: 0.4, length: 0.45, phototropism: 0.0, ..twigs.clone() },
        ),
    ])
}

fn plain_copy(scene: &Scene) -> Scene {
    Scene { twigs: scene.twigs.clone(), leaves: scene.leaves.clone(), ..*scene }
}

/// One tree with twigs that differ in little: bushy, upright, hanging, weeping, zig-zag, flat.
fn habits(tile: u32) -> Result<Vec<Picture>, Box<dyn Error>> {
    let (control, seed) = (Control::default(), Seed(3));
    let oak = PathParams { leaves: None, ..PathParams::oak()? };
    let oak = oak.grow(seed, &control)?.tree.into_parts();
    let twigs = TwigParams {
        per_metre: 7.0,
        bearing: 0.8,
        length: 0.8,
        internode: 0.1,
        tip_radius: 0.0015,
        load: 0.0,
        ..TwigParams::DEFAULT
    };
    let limp = TwigParams { length: 1.1, lateral: 0.3, phototropism: 0.0, ..twigs.clone() };
    let all = [
        TwigParams { length: 0.5, angle: 1.1, jitter: 0.5, lateral: 0.7, ..twigs.clone() },
        TwigParams { gravitropism: -4.0, stiffness: 30.0, angle: 1.0, ..twigs.clone() },
        TwigParams { stiffness: 0.1, ..limp.clone() },
        TwigParams { stiffness: 0.02, levels: 1, per_metre: 12.0, length: 1.6, ..limp },
        TwigParams { branching: Branching::zigzag(0.8), jitter: 0.1, ..twigs.clone() },
        TwigParams { arrangement: Phyllotaxis::Distichous, jitter: 0.05, ..twigs },
    ];
    let fine = refine(&oak.skeleton, 0.8, 0.15, &control)?.skeleton;
    all.iter()
        .map(|params| {
            let grown = grow_twigs(&fine, params, seed, &control)?;
            let tree = Tree::bare(grown.skeleton, oak.species.clone());
            picture(&tree, &look(tree.species())?, 0.05, tile)
        })
        .collect()
}
