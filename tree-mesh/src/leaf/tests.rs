use super::*;
use crate::mesh::Texture;
use crate::{LeafLook, MeshError, texture};
use glam::{Quat, Vec2, Vec3};
use proptest::prelude::*;
use std::sync::Arc;
use tree_core::{Foliage, Leaf, Skeleton, Species};

const FORMS: [LeafForm; 3] = [
    LeafForm::Card,
    LeafForm::Outline { max_vertices: 8 },
    LeafForm::Modelled { max_vertices: 12 },
];

fn built_in(kind: &str) -> LeafLook {
    let species = Species { leaf_kinds: vec![kind.into()], ..Default::default() };
    Look::built_in(&species).unwrap().leaves.remove(0)
}

/// Whether a place of the picture (u, v) lies in a triangle of the mesh.
fn covers(mesh: &LeafMesh, at: Vec2) -> bool {
    mesh.indices.chunks_exact(3).any(|t| {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| mesh.uvs[i as usize]);
        let (ab, bc, ca) =
            ((b - a).perp_dot(at - a), (c - b).perp_dot(at - b), (a - c).perp_dot(at - c));
        let slack = 1e-6;
        (ab >= -slack && bc >= -slack && ca >= -slack)
            || (ab <= slack && bc <= slack && ca <= slack)
    })
}

/// Share of the visible pixels that the mesh covers.
fn kept(look: &LeafLook, mesh: &LeafMesh) -> f64 {
    let texture = look.material.texture.as_ref().unwrap();
    let (mut seen, mut covered) = (0_u32, 0_u32);
    for (i, pixel) in texture.pixels.chunks_exact(4).enumerate() {
        if pixel[3] >= 128 {
            let (x, y) = (i as u32 % texture.width, i as u32 / texture.width);
            let at = (Vec2::new(x as f32, y as f32) + 0.5) / texture.width as f32;
            seen += 1;
            covered += u32::from(covers(mesh, at));
        }
    }
    f64::from(covered) / f64::from(seen)
}

#[test]
fn outlines_hold_every_visible_pixel_of_every_built_in_leaf_and_save_overdraw() {
    println!("kind               visible  card 6    8    12   modelled 12 (triangles)");
    for kind in texture::leaf_names() {
        let mut look = built_in(kind);
        let mut drawn = Vec::new();
        for max_vertices in [6, 8, 12] {
            look.form = LeafForm::Outline { max_vertices };
            let model = look.model().unwrap();
            assert!(model.mesh.positions.len() <= max_vertices as usize, "{kind}");
            assert!(!model.fallback, "{kind}");
            assert!(model.drawn >= model.visible, "{kind}: {model:?}");
            drawn.push(model.drawn);
            if max_vertices == 8 {
                assert!(kept(&look, &model.mesh) > 0.9999, "{kind}: {}", kept(&look, &model.mesh));
            }
        }
        assert!(drawn[2] <= drawn[0] + 1e-3 && drawn[1] < 0.97, "{kind}: {drawn:?}");
        (look.form, look.fold) = (LeafForm::Modelled { max_vertices: 12 }, 0.2);
        let model = look.model().unwrap();
        println!(
            "{kind:18} {:.2}     1   {:.2} {:.2} {:.2} {:.2} ({})",
            model.visible,
            drawn[0],
            drawn[1],
            drawn[2],
            model.drawn,
            model.mesh.n_triangles(),
        );
    }
}

#[test]
fn folded_and_bent_outlines_hold_every_pixel_too() {
    for kind in ["oak", "maple", "pine", "oak-cluster"].into_iter().filter(known) {
        let mut look = LeafLook { fold: 0.4, bend: 0.9, ..built_in(kind) };
        look.form = LeafForm::Outline { max_vertices: 10 };
        let model = look.model().unwrap();
        assert!(kept(&look, &model.mesh) > 0.9999, "{kind}");
    }
}

fn known(kind: &&str) -> bool {
    texture::leaf_names().contains(kind)
}

#[test]
fn a_modelled_margin_is_near_the_visible_one() {
    for kind in ["beech", "birch", "willow"].into_iter().filter(known) {
        let mut look = LeafLook { fold: 0.3, ..built_in(kind) };
        look.form = LeafForm::Modelled { max_vertices: 12 };
        let model = look.model().unwrap();
        assert!(model.opaque, "{kind}");
        assert!((model.drawn / model.visible - 1.0).abs() < 0.1, "{kind}: {model:?}");
        assert!((8..=24).contains(&model.mesh.n_triangles()), "{kind}");
    }
}

#[test]
fn folded_leaves_stand_up_and_bent_ones_hang_with_normals_across() {
    let look = LeafLook { fold: 0.5, bend: 1.0, rows: 6, ..Default::default() };
    let mesh = look.model().unwrap().mesh;
    mesh.check().unwrap();
    let low = mesh.positions.iter().map(|p| p.z).fold(0.0, f32::min);
    let (sin, cos) = libm::sincosf(1.0);
    assert!((low - (cos - 1.0)).abs() < 1e-5, "the apex of an arc of a radius 1: {low}");
    let top = mesh.positions.iter().map(|p| p.y).fold(0.0, f32::max);
    assert!(top >= sin - 1e-5);
    // The surface's own normals, triangle by triangle, agree with those of its vertices.
    for t in mesh.indices.chunks_exact(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| mesh.positions[i as usize]);
        let face = (b - a).cross(c - a).normalize();
        for &i in t {
            assert!(face.dot(mesh.normals[i as usize]) > 0.85, "{face}");
        }
    }
}

#[test]
fn pictures_without_visible_pixels_stay_cards_and_say_so() {
    let picture = |width: u32, height: u32, alpha: u8| Texture {
        name: "odd".into(),
        width,
        height,
        pixels: [10, 20, 30, alpha].repeat((width * height) as usize),
    };
    for (texture, fallback) in
        [(picture(1, 1, 0), true), (picture(64, 8, 0), true), (picture(1, 1, 255), false)]
    {
        for form in &FORMS[1..] {
            let mut look = LeafLook { form: form.clone(), ..Default::default() };
            look.material.alpha = Alpha::Mask(0.5);
            look.material.texture = Some(Arc::new(texture.clone()));
            let model = look.model().unwrap();
            assert_eq!(model.fallback, fallback, "{texture:?} {form:?}");
            model.mesh.check().unwrap();
        }
    }
    let mut look = LeafLook { form: FORMS[1].clone(), ..Default::default() };
    assert!(look.model().unwrap().fallback, "no picture");
    look.material.alpha = Alpha::Mask(0.5);
    look.material.texture = Some(Arc::new(Texture { pixels: vec![0; 7], ..picture(1, 1, 0) }));
    assert!(matches!(look.model(), Err(MeshError::Texture { .. })));
}

#[test]
fn numbers_out_of_range_and_broken_leaves_are_named() {
    let refused = |change: fn(&mut LeafLook)| {
        let mut look = LeafLook::default();
        change(&mut look);
        look.check().unwrap_err().to_string()
    };
    assert!(refused(|l| l.fold = f32::NAN).contains("look.leaves.fold"));
    assert!(refused(|l| l.bend = 4.0).contains("look.leaves.bend"));
    assert!(refused(|l| l.sheets = 0).contains("look.leaves.sheets"));
    assert!(refused(|l| l.rows = 17).contains("look.leaves.rows"));
    assert!(refused(|l| l.petiole = 0.5).contains("look.leaves.petiole"));
    assert!(refused(|l| l.form = LeafForm::Outline { max_vertices: 3 }).contains("max_vertices"));
    let good = LeafLook::default().model().unwrap().mesh;
    let broken = |change: fn(&mut LeafMesh)| {
        let mut mesh = good.clone();
        change(&mut mesh);
        mesh.check().unwrap_err().to_string()
    };
    assert!(broken(|m| m.indices[2] = 99).contains("does not exist"));
    assert!(broken(|m| m.positions[1].x = f32::INFINITY).contains("position"));
    assert!(broken(|m| m.normals[0] = Vec3::ZERO).contains("unit length"));
    assert!(broken(|m| m.uvs2[0].x = 1.5).contains("light-map"));
    assert!(broken(|m| m.uvs.truncate(3)).contains("differ"));
    assert!(broken(|m| m.indices.clear()).contains("no triangles"));
}

/// A shoot along +X with one leaf for each place, and the leaves' surface.
fn surface(look: LeafLook, params: &MeshParams, leaves: &[Leaf]) -> Surface {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.01).unwrap();
    builder.add(0, Vec3::X, 0.005).unwrap();
    let foliage = Foliage::try_from(leaves.to_vec()).unwrap();
    let tree = Tree::new(builder.finish(), foliage, Species::default()).unwrap();
    let look = Look { leaves: vec![look], ..Look::plain(tree.species()) };
    let built = crate::build(&tree, &look, params, &Control::default()).unwrap();
    built.mesh.check().unwrap();
    built.mesh.check_normals().unwrap();
    built.mesh.surfaces[1].clone()
}

fn leaf(position: Vec3, rotation: Quat) -> Leaf {
    Leaf { node: 1, position, rotation, size: 0.1, kind: 0 }
}

/// The direction in which a texture coordinate grows over a triangle.
fn slopes(surface: &Surface, t: &[u32]) -> (Vec3, Vec3) {
    let [a, b, c] = [t[0], t[1], t[2]].map(|i| i as usize);
    let (p, q) =
        (surface.positions[b] - surface.positions[a], surface.positions[c] - surface.positions[a]);
    let (s, t) = (surface.uvs[b] - surface.uvs[a], surface.uvs[c] - surface.uvs[a]);
    let area = s.perp_dot(t);
    ((p * t.y - q * s.y) / area, (q * s.x - p * t.x) / area)
}

#[test]
fn tangents_point_along_u_and_bitangents_against_v() {
    let turn = Quat::from_euler(glam::EulerRot::XYZ, 0.4, 1.1, -2.0);
    for form in FORMS {
        let look = LeafLook { form, sheets: 2, fold: 0.3, bend: 0.5, ..built_in("oak") };
        let params = MeshParams { leaf_rounding: 0.0, tangents: true, ..Default::default() };
        let surface = surface(look, &params, &[leaf(Vec3::X * 0.5, turn)]);
        for t in surface.indices.chunks_exact(3) {
            let (u, v) = slopes(&surface, t);
            for &i in t {
                let (n, tangent) = (surface.normals[i as usize], surface.tangents[i as usize]);
                let along = tangent.truncate();
                assert!((along.length() - 1.0).abs() < 1e-4 && along.dot(n).abs() < 1e-4);
                assert!(along.dot(u.normalize()) > 0.9, "{along} {u}");
                let up = n.cross(along) * tangent.w;
                assert!(up.dot(v.normalize()) < -0.9, "{up} {v}");
            }
        }
    }
}

#[test]
fn petioles_reach_from_the_shoot_to_the_lamina() {
    let base = Vec3::new(0.5, 0.04, 0.0);
    let look = LeafLook { petiole: 0.02, ..Default::default() };
    let on_shoot = Vec3::new(0.25, 0.0, 0.0);
    let leaves = [leaf(base, Quat::IDENTITY), leaf(on_shoot, Quat::IDENTITY)];
    let params = MeshParams { lightmap: true, tangents: true, ..Default::default() };
    let surface = surface(look, &params, &leaves);
    assert_eq!(surface.vertices_per_leaf(), Some(12));
    assert_eq!(surface.n_triangles(), 2 * (2 + 6));
    assert_eq!(surface.anchors[0], Vec3::new(0.5, 0.0, 0.0));
    assert_eq!(surface.anchors[1], on_shoot);
    let stalk = &surface.positions[4..12];
    let low = stalk.iter().map(|p| p.y).fold(1.0, f32::min);
    let high = stalk.iter().map(|p| p.y).fold(0.0, f32::max);
    assert!(low.abs() < 1e-6 && (high - 0.04).abs() < 1e-6, "{low} to {high}");
    assert!(stalk.iter().all(|p| (p.x - 0.5).abs() < 0.0011));
    for t in surface.indices.chunks_exact(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| surface.positions[i as usize]);
        let face = (b - a).cross(c - a);
        assert!(face.length() > 1e-9, "no triangle without area");
        if t[0] >= 4 && t[0] < 12 {
            let outward = (a + b + c) / 3.0 - Vec3::new(0.5, 0.02, 0.0);
            assert!(face.dot(outward - Vec3::Y * outward.y) > 0.0, "faces outwards");
        }
    }
}

/// Squares of texture space that triangles touch, counted at the middles of a fine grid.
fn overlaps(surface: &Surface, n: usize) -> usize {
    let mut uses = vec![0_u8; n * n];
    for t in surface.indices.chunks_exact(3) {
        let [a, b, c] = [t[0], t[1], t[2]].map(|i| surface.uvs2[i as usize]);
        let (low, high) = (a.min(b).min(c) * n as f32, a.max(b).max(c) * n as f32);
        for y in low.y as usize..=(high.y as usize).min(n - 1) {
            for x in low.x as usize..=(high.x as usize).min(n - 1) {
                // Off the diagonals of the grid, so that shared edges count once.
                let at = (Vec2::new(x as f32 + 0.413, y as f32 + 0.587)) / n as f32;
                let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(at - p) > 0.0);
                uses[y * n + x] += u8::from(sides[0] == sides[1] && sides[1] == sides[2]);
            }
        }
    }
    uses.iter().filter(|&&n| n > 1).count()
}

#[test]
fn no_two_places_of_the_light_map_are_the_same() {
    for form in FORMS {
        let look = LeafLook { form, sheets: 3, fold: 0.3, petiole: 0.02, ..built_in("oak") };
        let leaves: Vec<Leaf> =
            (0..23).map(|i| leaf(Vec3::X * 0.04 * i as f32, Quat::IDENTITY)).collect();
        let params = MeshParams { lightmap: true, ..Default::default() };
        let surface = surface(look, &params, &leaves);
        assert!(surface.uvs2.iter().all(|uv| uv.x >= 0.0 && uv.x <= 1.0));
        assert!(surface.uvs2.iter().all(|uv| uv.y >= 0.5 && uv.y <= 1.0));
        assert_eq!(overlaps(&surface, 1500), 0);
    }
}

#[test]
fn columns_not_asked_for_are_empty() {
    let params = MeshParams::default();
    let surface = surface(LeafLook::default(), &params, &[leaf(Vec3::ZERO, Quat::IDENTITY)]);
    assert!(surface.tangents.is_empty() && surface.uvs2.is_empty());
    assert_eq!(surface.branches, [0; 4]);
}

#[test]
fn soft_normals_follow_a_cone_where_an_ellipsoid_would_not() {
    // A hollow cone: points on its mantle, as a conifer whose twigs bear needles at their ends.
    let mut points = Vec::new();
    for i in 0..4000_u32 {
        let share = ((i as f32 + 0.5) / 4000.0).sqrt();
        let (sin, cos) = libm::sincosf(2.399_963 * i as f32);
        points.push(Vec3::new(2.0 * share * cos, 8.0 * (1.0 - share), 2.0 * share * sin));
    }
    let crown = Crown::of(&points);
    let inner: Vec<&Vec3> = points.iter().filter(|p| p.y > 1.5 && p.y < 6.5).collect();
    let mut sum = 0.0;
    for p in &inner {
        let mantle = Vec3::new(p.x, 0.0, p.z).normalize() * 8.0 + Vec3::Y * 2.0;
        sum += crown.outward(**p).normalize().dot(mantle.normalize());
    }
    let mean = sum / inner.len() as f32;
    assert!(mean > 0.95, "cosine to the mantle's normal: {mean}");
}

#[test]
fn crowns_without_extent_leave_normals_alone() {
    for points in [vec![], vec![Vec3::ONE; 5]] {
        assert_eq!(Crown::of(&points).outward(Vec3::Y), Vec3::ZERO);
    }
    let flat: Vec<Vec3> = (0..100).map(|i| Vec3::X * i as f32).collect();
    let outward = Crown::of(&flat).outward(Vec3::X * 98.0);
    assert!(outward.length() < 1.001 && outward.x > 0.5, "{outward}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..Default::default() })]

    #[test]
    fn any_picture_is_outlined_without_losing_a_pixel(
        size in (1_u32..40, 1_u32..40),
        blobs in prop::collection::vec((0.0_f32..1.0, 0.0_f32..1.0, 0.01_f32..0.4), 1..5),
        max_vertices in 4_u32..17,
        curved in any::<bool>(),
    ) {
        let (width, height) = size;
        let inside = |i: u32| {
            let x = ((i % width) as f32 + 0.5) / width as f32;
            let y = ((i / width) as f32 + 0.5) / height as f32;
            blobs.iter().any(|b| libm::hypotf(x - b.0, y - b.1) < b.2)
        };
        let alpha = |i| if inside(i) { 255 } else { 0 };
        let pixels = (0..width * height).flat_map(|i| [0, 0, 0, alpha(i)]).collect();
        let mut look = LeafLook {
            form: LeafForm::Outline { max_vertices },
            fold: if curved { 0.5 } else { 0.0 },
            ..Default::default()
        };
        look.material.alpha = Alpha::Mask(0.5);
        look.material.texture = Some(Arc::new(Texture { name: "blobs".into(), width, height, pixels }));
        let model = look.model().unwrap();
        model.mesh.check().unwrap();
        prop_assert!(model.drawn > 0.0 && model.drawn <= 1.0 + 1e-5);
        for i in (0..width * height).filter(|&i| inside(i)) {
            let at = Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5)
                / Vec2::new(width as f32, height as f32);
            prop_assert!(covers(&model.mesh, at), "{at}");
        }
        // No triangle is turned over.
        for t in model.mesh.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| model.mesh.uvs[i as usize]);
            prop_assert!((b - a).perp_dot(c - a) < 0.0, "v runs downwards");
        }
    }
}
