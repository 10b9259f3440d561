//! Cards become modelled leaves: the "modelled leaves" of the table in PEERS.md.
//!
//! How the peers' table made them is not recorded. Here each alpha card gives one leaf of 16
//! triangles, as long and as wide as the card: an ovate outline, two strips from the midrib to the margin,
//! folded along the midrib and bent a little, opaque.

use super::Outcome;
use tree_core::glam::{Vec2, Vec3};
use tree_lod::Elements;
use tree_mesh::{Alpha, LeafMesh, Material, Mesh, Surface};

/// Half the width of the leaf at 1/5 to 4/5 of its length, in widths: widest below the middle.
const HALF_WIDTHS: [f32; 4] = [0.40, 0.50, 0.41, 0.23];
/// How far the margin stands above the midrib, per width away from it: a fold of 11°.
const FOLD: f32 = 0.2;
/// How far the tip hangs below the plane of the base, in lengths.
const BEND: f32 = 0.08;
/// Linear colour of the leaves.
const COLOR: [f32; 4] = [0.09, 0.2, 0.04, 1.0];
/// Vertices of a leaf: six on the midrib, four on either margin.
#[cfg(test)]
pub(super) const VERTICES: usize = 14;
/// Triangles of a leaf.
pub(super) const TRIANGLES: usize = 16;

/// The leaf, `width` lengths wide: base at the origin, midrib along +Y, upper face to +Z.
pub(super) fn leaf(width: f32) -> LeafMesh {
    let hang = |y: f32| -BEND * y * y;
    let midrib = (0..6_u8).map(|i| 0.2 * f32::from(i)).map(|y| Vec3::new(0.0, y, hang(y)));
    let margin = |side: f32| {
        (1..5_u8).zip(HALF_WIDTHS).map(move |(i, half)| {
            let y = 0.2 * f32::from(i);
            Vec3::new(side * half * width, y, hang(y) + FOLD * half * width)
        })
    };
    let positions: Vec<Vec3> = midrib.chain(margin(-1.0)).chain(margin(1.0)).collect();
    let mut indices = Vec::with_capacity(3 * TRIANGLES);
    for (first, right) in [(6, false), (10, true)] {
        let mut triangle = |[a, b, c]: [u32; 3]| {
            indices.extend(if right { [a, b, c] } else { [a, c, b] });
        };
        triangle([0, first, 1]);
        for i in 1..4 {
            triangle([i, first + i - 1, first + i]);
            triangle([i, first + i, i + 1]);
        }
        triangle([4, first + 3, 5]);
    }
    let uv = |p: &Vec3| Vec2::new(0.5 + p.x / width, 1.0 - p.y);
    let uvs = positions.iter().map(uv).collect();
    let normals = normals(&positions, &indices);
    LeafMesh { positions, normals, uvs, uvs2: Vec::new(), indices }
}

/// Normals at vertices, weighted by area.
fn normals(positions: &[Vec3], indices: &[u32]) -> Vec<Vec3> {
    let mut normals = vec![Vec3::ZERO; positions.len()];
    for t in indices.as_chunks::<3>().0 {
        let [a, b, c] = t.map(|i| positions[i as usize]);
        let cross = (b - a).cross(c - a);
        t.iter().for_each(|&i| normals[i as usize] += cross);
    }
    normals.iter().map(|n| n.normalize_or(Vec3::Z)).collect()
}

/// The material of modelled leaves: no mask, both sides.
pub(super) fn material() -> Material {
    Material {
        name: "modelled leaf".into(),
        base_color: COLOR,
        alpha: Alpha::Opaque,
        double_sided: true,
        translucency: 0.4,
        ..Material::default()
    }
}

/// The mesh with a modelled leaf instead of each card of its foliage.
///
/// # Errors
/// When an element of the foliage is not a quad with a corner of the picture at each of its corners.
pub(super) fn instead_of_cards(mesh: &Mesh, elements: &Elements) -> Outcome<Mesh> {
    let mut out = mesh.clone();
    let leaf = leaf(1.0);
    for &number in &elements.surfaces {
        let surface = &mesh.surfaces[number as usize];
        let mut leaves = Surface { material: out.materials.len() as u32, ..Surface::default() };
        for element in (0..elements.len()).filter(|&e| elements.surface[e] == number) {
            let card = card(surface, elements.triangles_of(element))
                .ok_or("a piece of foliage is not a card")?;
            put(&mut leaves, &leaf, card);
        }
        out.surfaces[number as usize] = leaves;
    }
    out.materials.push(material());
    Ok(out)
}

/// Corners of a card: base left, base right, tip left, tip right.
fn card(surface: &Surface, triangles: &[u32]) -> Option<[Vec3; 4]> {
    if triangles.len() != 2 {
        return None;
    }
    let corners =
        || triangles.iter().flat_map(|&t| &surface.indices[3 * t as usize..3 * t as usize + 3]);
    // v runs down the picture: the base of the leaf is at its lower edge.
    let at = |u: f32, v: f32| {
        corners()
            .find(|&&i| surface.uvs[i as usize].distance_squared(Vec2::new(u, v)) < 1e-4)
            .map(|&i| surface.positions[i as usize])
    };
    Some([at(0.0, 1.0)?, at(1.0, 1.0)?, at(0.0, 0.0)?, at(1.0, 0.0)?])
}

/// Sets a leaf down in the rectangle of a card.
fn put(leaves: &mut Surface, leaf: &LeafMesh, [left, right, tip_left, tip_right]: [Vec3; 4]) {
    let base = 0.5 * (left + right);
    let (across, along) = (right - left, 0.5 * (tip_left + tip_right) - base);
    let normal = across.cross(along).normalize_or(Vec3::Y);
    let size = along.length();
    let first = leaves.positions.len() as u32;
    for (p, n) in leaf.positions.iter().zip(&leaf.normals) {
        leaves.positions.push(base + p.x * across + p.y * along + p.z * size * normal);
        // Exact for square cards, near enough for shading others.
        let turned = n.x * across.normalize_or_zero() + n.y * along / size.max(1e-9) + n.z * normal;
        leaves.normals.push(turned.normalize_or(normal));
    }
    leaves.uvs.extend(&leaf.uvs);
    leaves.indices.extend(leaf.indices.iter().map(|i| first + i));
    leaves.anchors.push(base);
}

#[cfg(test)]
mod tests {
    use super::*;
    use tree_core::Control;
    use tree_lod::{Grain, LeafSurfaces};

    #[test]
    fn the_leaf_has_sixteen_triangles_that_look_up_and_fills_its_rectangle() {
        let leaf = leaf(0.6);
        leaf.check().unwrap();
        assert_eq!((leaf.positions.len(), leaf.n_triangles()), (VERTICES, TRIANGLES));
        for t in leaf.indices.as_chunks::<3>().0 {
            let [a, b, c] = t.map(|i| leaf.positions[i as usize]);
            assert!((b - a).cross(c - a).z > 0.0, "{t:?}");
        }
        let x = leaf.positions.iter().fold(0.0_f32, |x, p| x.max(p.x.abs()));
        assert!((x - 0.3).abs() < 1e-6);
    }

    #[test]
    fn a_card_becomes_one_leaf_inside_it() {
        let mut surface = Surface { indices: vec![0, 1, 2, 0, 2, 3], ..Surface::default() };
        surface.positions = [[-1.0, 4.0], [-1.0, 2.0], [1.0, 2.0], [1.0, 4.0]]
            .map(|[x, y]| Vec3::new(x, y, 0.0))
            .into();
        surface.uvs = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(Vec2::from).into();
        surface.normals = vec![Vec3::Z; 4];
        let material = Material { name: "leaves".into(), ..Material::default() };
        let mesh = Mesh { surfaces: vec![surface], materials: vec![material], branches: vec![] };
        let elements =
            Elements::of_mesh(&mesh, &LeafSurfaces::Found, Grain::Blade, &Control::default())
                .unwrap();
        let made = instead_of_cards(&mesh, &elements).unwrap();
        made.check().unwrap();
        assert_eq!(made.surfaces[0].anchors, [Vec3::new(0.0, 2.0, 0.0)]);
        let bounds = made.bounds();
        assert!(bounds.min.y >= 2.0 - 1e-6 && bounds.max.y <= 4.0 + 1e-6);
        assert!((bounds.max.x - 1.0).abs() < 1e-6 && (bounds.min.x + 1.0).abs() < 1e-6);
    }
}
