//! Pictures of scenes: trees with their leaves, or main branches in colours, and walls.

use std::error::Error;
use std::path::Path;
use tree_core::glam::{Vec2, Vec3};
use tree_core::{Control, Tree};
use tree_lod::preview::{Camera, Lens, Pose, View};
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{ErrorBound, Look, Material, Mesh, MeshParams, Surface};
use tree_model::plastic::{Adapted, Scene, TreeId};
use tree_model::skeletonize::{SkeletonizeParams, skeletonize};

/// Steps of red that are told apart.
const SHADES: u32 = 8;

/// A camera that sees the tree, what approaches it, and a second tree where there is one.
pub(crate) fn view(size: Vec3, pair: bool) -> View {
    let reach = 0.5 * size.x.max(size.z).max(0.4 * size.y);
    let target = Vec3::new(if pair { 1.1 * reach } else { 0.4 * reach }, 0.48 * size.y, 0.0);
    let far = 2.6 * size.y.max(2.6 * reach);
    let eye = target + Vec3::new(-0.4, 0.12, 1.0).normalize() * far;
    let pose = Pose { eye, target, up: Vec3::Y, lens: Lens::Perspective { fov: 0.55 } };
    View { width: 800, height: 700, camera: Camera::Placed(pose), ..View::default() }
}

/// Everything in the scene as one mesh.
pub(crate) fn frame(
    scene: &Scene,
    trees: &[TreeId],
    wall: Option<(Vec3, Vec3)>,
    colors: bool,
    control: &Control,
) -> Result<Mesh, Box<dyn Error>> {
    let mut all = Mesh::default();
    for &id in trees {
        let adapted = scene.adapted(id, control)?;
        let input = scene.model(id)?.tree();
        let mesh = if colors { colored(input, &adapted) } else { leafy(&adapted.tree, control)? };
        let pose = scene.pose(id)?;
        append(&mut all, mesh, |point| pose.rotation * point + pose.position);
    }
    if let Some((low, high)) = wall {
        append(&mut all, block(low, high), |point| point);
    }
    Ok(all)
}

pub(crate) fn leafy(tree: &Tree, control: &Control) -> Result<Mesh, Box<dyn Error>> {
    let size = tree.skeleton().bounds().size().max_element();
    let look = Look::built_in(tree.species()).unwrap_or_else(|_| Look::plain(tree.species()));
    let params = MeshParams {
        error: ErrorBound::Metres((3e-4 * size).clamp(1e-5, 1.0)),
        min_radius: (5e-5 * size).clamp(1e-5, 0.1),
        ..MeshParams::default()
    };
    Ok(tree_mesh::build(tree, &look, &params, control)?.mesh)
}

/// A tree out of a mesh.
pub(crate) fn imported(path: &Path, control: &Control) -> Result<Tree, Box<dyn Error>> {
    let mesh = io::read(path, &ImportOptions { external: true }, control)?.mesh;
    Ok(skeletonize(&mesh.parts(), &SkeletonizeParams::default(), control)?.tree)
}

pub(crate) fn append(all: &mut Mesh, mesh: Mesh, place: impl Fn(Vec3) -> Vec3) {
    let first = all.materials.len() as u32;
    all.materials.extend(mesh.materials);
    for mut surface in mesh.surfaces {
        surface.material += first;
        surface.branches.clear();
        let turn = |way: Vec3| place(way) - place(Vec3::ZERO);
        surface.normals.iter_mut().for_each(|normal| *normal = turn(*normal));
        surface.positions.iter_mut().for_each(|point| *point = place(*point));
        surface.anchors.iter_mut().for_each(|point| *point = place(*point));
        all.surfaces.push(surface);
    }
}

/// The main branches: red as they moved, blue where the input's were pruned.
fn colored(input: &Tree, adapted: &Adapted) -> Mesh {
    let farthest = adapted.report.farthest.max(1e-6);
    let mut mesh = Mesh::default();
    for shade in 0..SHADES {
        let red = shade as f32 / (SHADES - 1) as f32;
        mesh.materials
            .push(plain("bent", [0.35 + 0.6 * red, 0.33 * (1.0 - red), 0.3 * (1.0 - red), 1.0]));
    }
    mesh.materials.push(plain("pruned", [0.05, 0.12, 0.9, 1.0]));
    mesh.surfaces =
        (0..=SHADES).map(|material| Surface { material, ..Surface::default() }).collect();
    let skeleton = adapted.tree.skeleton();
    for (parent, node) in skeleton.segments() {
        let way = adapted.moved[adapted.source[node as usize] as usize] / farthest;
        let shade = (way * (SHADES - 1) as f32).round().clamp(0.0, (SHADES - 1) as f32) as usize;
        let ends = [parent, node].map(|n| skeleton.positions()[n as usize]);
        tube(&mut mesh.surfaces[shade], ends, skeleton.radii()[node as usize]);
    }
    let old = input.skeleton();
    for (parent, node) in old.segments() {
        if adapted.died[node as usize].is_some() {
            let ends = [parent, node].map(|n| old.positions()[n as usize]);
            tube(&mut mesh.surfaces[SHADES as usize], ends, old.radii()[node as usize]);
        }
    }
    mesh.surfaces.retain(|surface| !surface.positions.is_empty());
    mesh
}

fn plain(name: &str, base_color: [f32; 4]) -> Material {
    Material { name: name.into(), base_color, ..Material::default() }
}

/// Six sides from end to end.
fn tube(surface: &mut Surface, [from, to]: [Vec3; 2], radius: f32) {
    let Some(along) = (to - from).try_normalize() else { return };
    let (u, v) = along.any_orthonormal_pair();
    let first = surface.positions.len() as u32;
    for k in 0..6 {
        let angle = std::f32::consts::TAU * k as f32 / 6.0;
        let out = u * libm::cosf(angle) + v * libm::sinf(angle);
        for end in [from, to] {
            surface.positions.push(end + out * radius.max(0.004));
            surface.normals.push(out);
            surface.uvs.push(Vec2::ZERO);
        }
    }
    for k in 0..6 {
        let [a, b] = [2 * k, 2 * ((k + 1) % 6)];
        surface.indices.extend([a, b, a + 1, a + 1, b, b + 1].map(|i| first + i));
    }
}

/// A box.
pub(crate) fn block(low: Vec3, high: Vec3) -> Mesh {
    let mut surface = Surface::default();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (side, at) in [(-1.0, low[axis]), (1.0, high[axis])] {
            let first = surface.positions.len() as u32;
            for (a, b) in
                [(low[u], low[v]), (high[u], low[v]), (high[u], high[v]), (low[u], high[v])]
            {
                let mut point = Vec3::ZERO;
                point[axis] = at;
                point[u] = a;
                point[v] = b;
                let mut normal = Vec3::ZERO;
                normal[axis] = side;
                surface.positions.push(point);
                surface.normals.push(normal);
                surface.uvs.push(Vec2::ZERO);
            }
            let order = if side > 0.0 { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
            surface.indices.extend(order.map(|i| first + i));
        }
    }
    let material = plain("wall", [0.55, 0.5, 0.45, 1.0]);
    Mesh { surfaces: vec![surface], materials: vec![material], ..Mesh::default() }
}
