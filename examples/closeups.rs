//! Close-ups of bark, each with its texture and plain, so that the shading can be judged:
//! `out/closeups_NAME.png`, and all of them on one sheet, `out/closeups.jpg`. Leaves have a sheet of
//! their own: `cargo run --release --example leaves`.
//!
//! `cargo run --release --example closeups -- [FOLDER] [TILE_PX] [NAME]`

mod common;

use image::DynamicImage;
use std::error::Error;
use std::path::PathBuf;
use tree_core::glam::{EulerRot, Quat, Vec3};
use tree_core::{Control, Seed, Skeleton, SkeletonBuilder, Species, Tree};
use tree_lod::preview::{self, Camera, Lens, Picture, Pose, Style, View};
use tree_mesh::displace::{DisplaceParams, displace};
use tree_mesh::subdivide::{SubdivideParams, subdivide};
use tree_mesh::{ErrorBound, Look, Mesh, MeshParams, topology};
use tree_model::path::{PathParams, Preset};

/// Pictures in a row: three pairs.
const COLUMNS: u32 = 6;

/// Linear colour of plain bark: grey clay shows light and shade best.
const CLAY: [f32; 4] = [0.2, 0.19, 0.18, 1.0];

/// The sun stands to the left: light that grazes shows every dent.
const SUN: f32 = -0.9;

/// One close-up.
struct Scene {
    name: &'static str,
    tree: Tree,
    params: MeshParams,
    finish: Finish,
    /// Where the camera stands, and what it looks at.
    eye: Vec3,
    target: Vec3,
    /// Vertical field of view.
    fov: f32,
    ground: bool,
}

/// What is done to the built mesh.
#[derive(Clone, Copy)]
enum Finish {
    Plain,
    Subdivided(u32),
    Displaced,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().map_or_else(|| PathBuf::from("out"), PathBuf::from);
    let tile = arguments.next().map_or(Ok(360), |text| text.parse())?;
    let only = arguments.next();
    std::fs::create_dir_all(&folder)?;
    let mut pictures = Vec::new();
    for scene in scenes()? {
        if only.as_ref().is_some_and(|only| only != scene.name) {
            continue;
        }
        let pair = [draw(&scene, true, tile)?, draw(&scene, false, tile)?];
        let path = folder.join(format!("closeups_{}.png", scene.name));
        common::sheet(&pair, 2, tile)?.save(path)?;
        pictures.extend(pair);
    }
    if only.is_none() {
        let path = folder.join("closeups.jpg");
        let sheet = common::sheet(&pictures, COLUMNS, tile)?;
        DynamicImage::ImageRgba8(sheet).to_rgb8().save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}

fn draw(scene: &Scene, textured: bool, tile: u32) -> Result<Picture, Box<dyn Error>> {
    let control = Control::default();
    let species = scene.tree.species();
    let look = if textured { Look::built_in(species)? } else { Look::plain(species) };
    let mut mesh = tree_mesh::build(&scene.tree, &look, &scene.params, &control)?.mesh;
    if !textured {
        mesh.materials[0].base_color = CLAY;
    }
    finish(&mut mesh, scene.finish, &control)?;
    if !textured {
        let (bark, name) = (&mesh.surfaces[0], scene.name);
        let shape = topology::examine(bark)?;
        let crossings = topology::self_intersections(bark, &control)?;
        let (n, closed) = (shape.n_triangles, shape.is_closed());
        println!("{name}: {n} triangles, closed {closed}, {} of them cross", crossings.n_triangles);
    }
    let pose = Pose {
        eye: scene.eye,
        target: scene.target,
        up: Vec3::Y,
        lens: Lens::Perspective { fov: scene.fov },
    };
    let view = View { width: tile, height: tile, samples: 3, camera: Camera::Placed(pose) };
    let ground = scene.ground.then_some(0.0);
    let style =
        Style { ground, sun_map_px: 4096, sun: 2.2, sky: 0.4, sun_yaw: SUN, ..Style::studio() };
    Ok(preview::render(&mesh, &view, &style, &control)?)
}

fn finish(mesh: &mut Mesh, finish: Finish, control: &Control) -> Result<(), Box<dyn Error>> {
    // A coarse mesh is fitted, or it would shrink; the surface of a fine one folds when it is.
    let (levels, fit) = match finish {
        Finish::Plain => return Ok(()),
        Finish::Subdivided(levels) => (levels, 1),
        Finish::Displaced => (3, 0),
    };
    let params = SubdivideParams { levels, fit, ..Default::default() };
    mesh.surfaces[0] = subdivide(&mesh.surfaces[0], &params, control)?;
    if matches!(finish, Finish::Displaced) {
        let relief = DisplaceParams { amplitude: 0.03, scale: 0.04, ..Default::default() };
        displace(&mut mesh.surfaces[0], &mesh.branches, &relief, control)?;
    }
    Ok(())
}

fn scenes() -> Result<Vec<Scene>, Box<dyn Error>> {
    let plain = |name, skeleton, bark: &str| Scene {
        name,
        tree: Tree::bare(skeleton, Species { bark: bark.into(), ..Species::default() }),
        params: MeshParams {
            error: ErrorBound::Metres(0.001),
            flare: 0.0,
            ..MeshParams::default()
        },
        finish: Finish::Plain,
        eye: Vec3::new(0.3, 0.9, 1.6),
        target: Vec3::new(0.02, 0.72, 0.0),
        fov: 0.55,
        ground: false,
    };
    let coarse = |name, finish| -> Result<Scene, Box<dyn Error>> {
        let scene = plain(name, fork()?, "oak");
        let params = MeshParams { error: ErrorBound::Metres(0.03), ..scene.params };
        Ok(Scene { params, finish, ..scene })
    };
    let grown = |name, preset: PathParams| -> Result<Scene, Box<dyn Error>> {
        let tree = PathParams { leaves: None, ..preset }.grow(Seed(7), &Control::default())?.tree;
        let scene = plain(name, tree.skeleton().clone(), &tree.species().bark);
        Ok(Scene { params: MeshParams::default(), ..scene })
    };
    let (x, y) = (Vec3::X, Vec3::Y);
    Ok(vec![
        plain("fork", fork()?, "oak"),
        plain("lateral", branched(0.14, &[(0.7, 0.0, 0.9, 0.055, 0.8)])?, "oak"),
        Scene {
            eye: Vec3::new(0.2, 0.85, 0.5),
            target: Vec3::new(0.06, 0.75, 0.0),
            ..plain("twig", branched(0.07, &[(0.7, -0.5, 0.9, 0.009, 0.35)])?, "smooth")
        },
        Scene {
            eye: Vec3::new(0.2, 1.0, 0.75),
            target: Vec3::new(0.0, 0.74, 0.0),
            ..plain("whorl", branched(0.06, &whorl())?, "pine")
        },
        Scene {
            eye: Vec3::new(0.8, 1.1, 2.6),
            target: y * 0.5,
            params: MeshParams::default(),
            ground: true,
            ..plain("base", branched(0.3, &[(1.1, 0.9, 0.9, 0.05, 0.6)])?, "oak")
        },
        Scene {
            eye: Vec3::new(1.5, -0.7, 3.2),
            target: y * -0.3,
            ..grown("roots", Preset::find("heartroot")?.params()?)?
        },
        Scene {
            eye: Vec3::new(-1.2, 2.4, 4.2),
            target: y * 2.4,
            ..grown("oak", PathParams::oak()?)?
        },
        coarse("fork_coarse", Finish::Plain)?,
        coarse("fork_once", Finish::Subdivided(1))?,
        coarse("fork_twice", Finish::Subdivided(2))?,
        plain("fork_displaced", fork()?, "oak").with(Finish::Displaced),
        Scene {
            eye: Vec3::new(0.05, 1.5, 0.9),
            target: y * 0.72 + x * 0.02,
            ..plain("crotch", fork()?, "oak")
        },
    ])
}

impl Scene {
    fn with(self, finish: Finish) -> Self {
        Self { finish, ..self }
    }
}

/// Two branches nearly alike.
fn fork() -> Result<Skeleton, Box<dyn Error>> {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.125)?;
    let top = limb(&mut builder, (0, Vec3::ZERO), Vec3::new(0.02, 0.6, 0.0), (0.125, 0.115))?;
    limb(&mut builder, top, Vec3::new(0.42, 0.75, 0.08), (0.088, 0.07))?;
    limb(&mut builder, top, Vec3::new(-0.38, 0.8, -0.06), (0.082, 0.065))?;
    Ok(builder.finish())
}

/// A stem, and branches: how high they leave, which way, at what angle, radius, length.
fn branched(
    radius: f32,
    branches: &[(f32, f32, f32, f32, f32)],
) -> Result<Skeleton, Box<dyn Error>> {
    let mut builder = Skeleton::builder(Vec3::ZERO, radius)?;
    let height = branches[0].0;
    let fork = limb(&mut builder, (0, Vec3::ZERO), Vec3::Y * height, (radius, 0.93 * radius))?;
    limb(&mut builder, fork, Vec3::new(0.03, 0.9, 0.02), (0.92 * radius, 0.8 * radius))?;
    for &(_, yaw, angle, thick, length) in branches {
        let way = Quat::from_euler(EulerRot::YZX, yaw, -angle, 0.0) * Vec3::Y;
        limb(&mut builder, fork, way * length, (thick, 0.7 * thick))?;
    }
    Ok(builder.finish())
}

fn whorl() -> Vec<(f32, f32, f32, f32, f32)> {
    (0_u8..6).map(|i| (0.7, 0.4 + f32::from(i) * 1.047, 1.2, 0.02, 0.6)).collect()
}

/// A limb from a node with a slight bend upwards; its last node and where that is.
fn limb(
    builder: &mut SkeletonBuilder,
    (node, from): (u32, Vec3),
    span: Vec3,
    radii: (f32, f32),
) -> Result<(u32, Vec3), Box<dyn Error>> {
    let (mut last, mut at) = (node, from);
    for i in 1..=6_u8 {
        let share = f32::from(i) / 6.0;
        let sag = Vec3::Y * (0.08 * span.length() * share * (share - 1.0));
        at = from + span * share + sag;
        last = builder.add(last, at, radii.0 + (radii.1 - radii.0) * share)?;
    }
    Ok((last, at))
}
