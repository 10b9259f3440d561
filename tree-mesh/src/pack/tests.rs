use super::*;
use crate::convert::Convention;
use crate::mesh::{Material, Mesh, Surface};
use crate::sample;
use crate::wind::{self, sway};
use glam::{Vec2, Vec3};

/// Half a step of a byte, with the rounding of f32.
const BYTE: f32 = 0.5 / 255.0 + 1e-6;

/// Asserts that two columns agree within a tolerance, by a distance of theirs.
fn close<T: Copy + std::fmt::Debug>(
    what: &str,
    found: &[T],
    wanted: &[T],
    tolerance: f32,
    distance: impl Fn(T, T) -> f32,
) {
    assert_eq!(found.len(), wanted.len(), "{what}");
    for (row, (&f, &w)) in found.iter().zip(wanted).enumerate() {
        assert!(distance(f, w) <= tolerance, "{what}[{row}]: {f:?}, wanted {w:?}");
    }
}

fn numbers(what: &str, found: &[f32], wanted: &[f32], tolerance: f32) {
    close(what, found, wanted, tolerance, |a, b| (a - b).abs());
}

fn places(what: &str, found: &[Vec3], wanted: &[Vec3], tolerance: f32) {
    close(what, found, wanted, tolerance, |a, b| a.distance(b));
}

fn uvs(what: &str, found: &[Vec2], wanted: &[Vec2], tolerance: f32) {
    close(what, found, wanted, tolerance, |a, b| (a - b).abs().max_element());
}

/// What every layout must return of every surface.
fn check_common(mesh: &Mesh, surface: usize, back: &Unpacked) {
    let wanted = &mesh.surfaces[surface];
    places("positions", &back.positions, &wanted.positions, 1e-5);
    places("normals", &back.normals, &wanted.normals, 1e-6);
    close("tangents", &back.tangents, &wanted.tangents, 1e-6, |a, b| a.distance(b));
    uvs("uvs", &back.uvs, &wanted.uvs, 1e-5);
    if !back.uvs2.is_empty() {
        uvs("uvs2", &back.uvs2, &wanted.uvs2, 1e-6);
    }
    assert_eq!(back.indices, wanted.indices);
    numbers("occlusion", &back.occlusion, &wanted.occlusion, BYTE);
}

fn wind_of<T>(mesh: &Mesh, surface: usize, get: impl Fn(wind::VertexWind) -> T) -> Vec<T> {
    wind::vertices(mesh, surface).unwrap().into_iter().map(get).collect()
}

fn branch_of<T>(mesh: &Mesh, surface: usize, get: impl Fn(&wind::Branch) -> T) -> Vec<T> {
    wind_of(mesh, surface, |wind| get(&mesh.branches[wind.branch as usize]))
}

#[test]
fn speedtree_8_comes_back() {
    let mesh = sample::mesh(2);
    for surface in 0..2 {
        let packed = speedtree8::pack(&mesh, surface).unwrap();
        assert_eq!(packed.space, Convention::Unity);
        let back = speedtree8::unpack(&packed);
        check_common(&mesh, surface, &back);
        numbers("flutter", &back.flutter, &wind_of(&mesh, surface, |w| w.flutter), 1e-6);
        places("anchors", &back.anchors, &wind_of(&mesh, surface, |w| w.anchor), 1e-5);
        assert!(back.is_leaf.iter().all(|&leaf| leaf == (surface == 1)));
        let swings: Vec<Vec3> = branch_of(&mesh, surface, wind::Branch::swing);
        let found: Vec<Vec3> = back.directions.iter().map(|&[swing, _]| swing).collect();
        places("swings", &found, &swings, 0.18);
        for (row, wind) in wind::vertices(&mesh, surface).unwrap().iter().enumerate() {
            let branch = &mesh.branches[wind.branch as usize];
            let wanted = if branch.level == 0 { 0.0 } else { wind.reach * branch.give() };
            assert!((back.weights[row].x - wanted).abs() < 1e-6);
        }
    }
}

#[test]
fn speedtree_9_shaders_find_the_collar_of_each_branch() {
    let mesh = sample::mesh(3);
    let limits = speedtree9::StretchLimits::of(&mesh);
    for surface in 0..2 {
        let packed = speedtree9::pack(&mesh, surface).unwrap();
        let back = speedtree9::unpack(&packed);
        check_common(&mesh, surface, &back);
        numbers("flutter", &back.flutter, &wind_of(&mesh, surface, |w| w.flutter), 1e-6);
        places("anchors", &back.anchors, &wind_of(&mesh, surface, |w| w.anchor), 1e-5);
        for (row, wind) in wind::vertices(&mesh, surface).unwrap().iter().enumerate() {
            let mut number = wind.branch;
            while mesh.branches[number as usize].level > 2 {
                number = mesh.branches[number as usize].parent;
            }
            let branch = &mesh.branches[number as usize];
            let (weight, limit, along) = match branch.level {
                0 => {
                    assert_eq!(back.weights[row], Vec2::ZERO);
                    continue;
                }
                1 => (back.weights[row].x, limits.branch1, back.directions[row][0]),
                _ => (back.weights[row].y, limits.branch2, back.directions[row][1]),
            };
            // What the shader turns about lies on the way from the vertex to the pivot, and in the
            // collar unless the vertex is bent away from it.
            let turned_about = wind.anchor - along * weight * limit;
            let free = branch.length - branch.collar;
            let wanted =
                (wind.anchor.distance(branch.pivot) - branch.reach(wind.anchor) * free).abs();
            let found = turned_about.distance(branch.pivot);
            assert!((found - wanted).abs() < 0.03 * branch.length, "{found} {wanted}");
        }
    }
}

#[test]
fn tree_creator_comes_back() {
    let mesh = sample::mesh(2);
    for surface in 0..2 {
        let back = tree_creator::unpack(&tree_creator::pack(&mesh, surface).unwrap());
        check_common(&mesh, surface, &back);
        numbers("flutter", &back.flutter, &wind_of(&mesh, surface, |w| w.flutter), BYTE);
        for (row, wind) in wind::vertices(&mesh, surface).unwrap().iter().enumerate() {
            let branch = &mesh.branches[wind.branch as usize];
            let bend = wind.reach * sway(wind.reach);
            match branch.level {
                0 => assert!(back.weights[row].distance(Vec2::new(bend, 0.0)) < 1e-6),
                1 => {
                    assert!((back.weights[row].y - bend).abs() < 1e-6);
                    assert!((back.phases[row] - branch.phase).abs() <= BYTE);
                }
                _ => assert!(back.weights[row].y > 0.0, "what hangs on a bough moves with it"),
            }
        }
    }
}

#[test]
fn pivot_painter_comes_back() {
    let mesh = sample::mesh(3);
    let textures = pivot_painter::Textures::new(&mesh).unwrap();
    assert_eq!((textures.report.levels, textures.report.merged), (4, 0));
    assert!(textures.width.is_power_of_two() && textures.height.is_power_of_two());
    for surface in 0..2 {
        let packed = pivot_painter::pack(&mesh, surface, &textures).unwrap();
        let back = pivot_painter::unpack(&packed, &textures);
        check_common(&mesh, surface, &back);
        assert_eq!(back.branches, wind_of(&mesh, surface, |w| w.branch));
        assert_eq!(back.parents, branch_of(&mesh, surface, |b| b.parent));
        places("pivots", &back.pivots, &branch_of(&mesh, surface, |b| b.pivot), 1e-5);
        places("axes", &back.axes, &branch_of(&mesh, surface, |b| b.axis), 0.008);
        numbers("flutter", &back.flutter, &wind_of(&mesh, surface, |w| w.flutter), BYTE);
        numbers("phases", &back.leaf_phases, &wind_of(&mesh, surface, |w| w.leaf_phase), BYTE);
    }
    for (number, branch) in mesh.branches.iter().enumerate() {
        let extent = textures.element(number as u32).unwrap().extent;
        assert!((extent - branch.length).abs() <= 0.041, "{extent} {}", branch.length);
    }
    let halves = textures.position_and_index_half();
    for (texel, half) in textures.position_and_index.iter().zip(halves) {
        let wanted = pivot_painter::from_index_bits(texel[3]);
        assert_eq!(pivot_painter::from_index_bits(half::to_f32(half[3])), wanted);
    }
}

#[test]
fn every_element_number_survives_the_bits_of_a_half() {
    for number in 0..pivot_painter::MAX_ELEMENTS as u32 {
        let bits = pivot_painter::index_bits(number);
        assert!(bits.is_finite());
        assert_eq!(pivot_painter::from_index_bits(bits), number);
    }
    assert!(!pivot_painter::index_bits(pivot_painter::MAX_ELEMENTS as u32).is_finite());
}

#[test]
fn deep_and_crowded_hierarchies_are_merged_and_reported() {
    let mesh = sample::mesh(4);
    let report = pivot_painter::Textures::new(&mesh).unwrap().report;
    assert_eq!((report.levels, report.kept_levels), (5, 4));
    let deep = mesh.branches.iter().filter(|branch| branch.level == 4).count();
    assert_eq!(report.merged, deep);
    let mut crowded = Mesh { branches: vec![wind::Branch::default()], ..Mesh::default() };
    let bough = wind::Branch { level: 1, ..wind::Branch::default() };
    crowded.branches.resize(40_000, bough);
    let textures = pivot_painter::Textures::new(&crowded).unwrap();
    assert_eq!((textures.report.kept_levels, textures.report.elements), (1, 1));
    assert_eq!(textures.element_of(39_999), Some(0));
}

#[test]
fn godot_comes_back_in_floats_and_in_halves() {
    let mesh = sample::mesh(2);
    for (precision, step) in
        [(godot::Precision::Float, 0.0), (godot::Precision::Half, 0.5 / 1024.0)]
    {
        for surface in 0..2 {
            let packed = godot::pack(&mesh, surface, precision).unwrap();
            let back = godot::unpack(&packed);
            check_common(&mesh, surface, &back);
            let pivots = branch_of(&mesh, surface, |b| b.pivot);
            let off = |a: Vec3, b: Vec3| ((a - b).abs() - b.abs() * step).max_element();
            close("pivots", &back.pivots, &pivots, 1e-7, off);
            places("axes", &back.axes, &branch_of(&mesh, surface, |b| b.axis), 2.0 * step);
            numbers("phases", &back.phases, &branch_of(&mesh, surface, |b| b.phase), step);
            numbers(
                "stiffness",
                &back.stiffness,
                &branch_of(&mesh, surface, |b| b.stiffness),
                step,
            );
            numbers("reach", &back.reach, &wind_of(&mesh, surface, |w| w.reach), step);
            numbers("flutter", &back.flutter, &wind_of(&mesh, surface, |w| w.flutter), step);
            assert_eq!(back.levels, branch_of(&mesh, surface, |b| b.level));
        }
    }
}

#[test]
fn gltf_comes_back_with_all_of_it() {
    let mesh = sample::mesh(2);
    for surface in 0..2 {
        let packed = gltf_wind::pack(&mesh, surface).unwrap();
        assert!(gltf_wind::ATTRIBUTES.iter().all(|name| packed.stream(name).is_some()));
        let back = gltf_wind::unpack(&packed);
        check_common(&mesh, surface, &back);
        assert_eq!(back.branches, wind_of(&mesh, surface, |w| w.branch));
        assert_eq!(back.parents, branch_of(&mesh, surface, |b| b.parent));
        assert_eq!(back.levels, branch_of(&mesh, surface, |b| b.level));
        assert_eq!(back.pivots, branch_of(&mesh, surface, |b| b.pivot));
        assert_eq!(back.axes, branch_of(&mesh, surface, |b| b.axis));
        assert_eq!(back.phases, branch_of(&mesh, surface, |b| b.phase));
        assert_eq!(back.stiffness, branch_of(&mesh, surface, |b| b.stiffness));
        assert_eq!(back.reach, wind_of(&mesh, surface, |w| w.reach));
        assert_eq!(back.flutter, wind_of(&mesh, surface, |w| w.flutter));
        assert_eq!(back.leaf_phases, wind_of(&mesh, surface, |w| w.leaf_phase));
        assert_eq!(back.anchors, wind_of(&mesh, surface, |w| w.anchor));
    }
}

#[test]
fn what_a_surface_lacks_is_filled_in() {
    let mut mesh = sample::mesh(1);
    mesh.branches.clear();
    for surface in &mut mesh.surfaces {
        surface.tangents.clear();
        surface.uvs2.clear();
        surface.occlusion.clear();
        surface.branches.clear();
        surface.welds.clear();
    }
    let textures = pivot_painter::Textures::new(&mesh).unwrap();
    for packed in [
        speedtree8::pack(&mesh, 0),
        speedtree9::pack(&mesh, 0),
        tree_creator::pack(&mesh, 0),
        pivot_painter::pack(&mesh, 0, &textures),
        godot::pack(&mesh, 0, godot::Precision::Half),
        gltf_wind::pack(&mesh, 0),
    ] {
        let packed = packed.unwrap();
        let count = mesh.surfaces[0].positions.len();
        assert!(packed.streams.iter().all(|stream| stream.n_vertices() == count));
        for (normal, tangent) in packed.rows("NORMAL").zip(packed.rows("TANGENT")) {
            assert!(normal.truncate().dot(tangent.truncate()).abs() < 1e-5);
        }
        assert!(packed.rows("COLOR").all(|color| color.w == 1.0));
    }
}

#[test]
fn chains_of_thousands_of_branches_find_their_boughs() {
    const LENGTH: u32 = 20_000;
    // Two chains on one trunk: 1, 3, 5... and 2, 4, 6...
    let branch = |number: u32| wind::Branch {
        parent: number.saturating_sub(2),
        level: number.div_ceil(2),
        pivot: Vec3::Y * (number as f32 / LENGTH as f32),
        length: 2.0 + (number % 7) as f32,
        phase: wind::leaf_phase(number),
        ..Default::default()
    };
    let vertices = 0..2 * LENGTH + 1;
    let surface = Surface {
        positions: vertices.clone().map(|v| Vec3::new(1.5, v as f32 * 1e-5, 0.0)).collect(),
        normals: vec![Vec3::X; vertices.len()],
        uvs: vec![Vec2::ZERO; vertices.len()],
        branches: vertices.clone().collect(),
        ..Default::default()
    };
    let mesh = Mesh {
        surfaces: vec![surface],
        materials: vec![Material::default()],
        branches: vertices.clone().map(branch).collect(),
    };
    let carrier = |number: u32, level: u32| {
        // The trunk, or the branch of this level on the same chain.
        let own = number.div_ceil(2);
        (own >= level).then_some(if level == 0 { 0 } else { 2 * level - number % 2 })
    };
    let source = common::Source::new(&mesh, 0, Convention::Unity).unwrap();
    for level in 0..3 {
        let wanted: Vec<Option<u32>> = vertices.clone().map(|v| carrier(v, level)).collect();
        assert_eq!(source.ancestors(level), wanted, "level {level}");
    }
    let limits = speedtree9::StretchLimits::of(&mesh);
    let speedtree = speedtree9::unpack(&speedtree9::pack(&mesh, 0).unwrap());
    let creator = tree_creator::unpack(&tree_creator::pack(&mesh, 0).unwrap());
    for vertex in vertices {
        let row = vertex as usize;
        let [bough, twig] = [1, 2].map(|level| carrier(vertex, level).map(branch));
        let weight = |branch: Option<wind::Branch>, limit: f32| {
            let at = mesh.surfaces[0].positions[row];
            branch.map_or(0.0, |b| b.reach(at) * (b.length - b.collar) / limit)
        };
        let wanted = Vec2::new(weight(bough, limits.branch1), weight(twig, limits.branch2));
        assert_eq!(speedtree.weights[row], wanted, "vertex {vertex}");
        let phase = bough.map_or(0.0, |bough| bough.phase);
        assert!((creator.phases[row] - phase).abs() <= BYTE, "vertex {vertex}");
    }
}

#[test]
fn a_parent_that_comes_later_is_refused() {
    let mut mesh = sample::mesh(1);
    mesh.branches[1].parent = 2;
    assert!(speedtree9::pack(&mesh, 0).is_err());
    assert!(pivot_painter::Textures::new(&mesh).is_err());
    assert!(speedtree9::pack(&mesh, 7).is_err());
}

#[test]
fn indices_are_narrow_up_to_65535_vertices_and_never_wrap() {
    let last = |count: u32| vec![0, 1, count - 1];
    assert!(matches!(Indices::new(&last(65_535), 65_535), Indices::U16(_)));
    for count in [65_536, 65_537, 70_000] {
        let indices = Indices::new(&last(count), count as usize);
        assert!(matches!(indices, Indices::U32(_)));
        assert_eq!(indices.to_u32(), last(count));
    }
    // A wrong count widens them instead of wrapping them.
    assert_eq!(Indices::new(&[70_000], 3).to_u32(), [70_000]);
    assert_eq!(Indices::new(&[1, 2], 3).bytes().len(), 4);
}
