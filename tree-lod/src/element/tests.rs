use super::*;
use crate::LodError;
use glam::{Vec2, Vec3};
use tree_core::Control;
use tree_mesh::{Alpha, Material, Mesh, Surface};

/// Quads of these centres in the plane across z, each with four vertices of its own.
fn cards(centers: &[Vec3]) -> Surface {
    let mut surface = Surface::default();
    for &center in centers {
        let first = surface.positions.len() as u32;
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            surface.positions.push(center + Vec3::new(x, y, 0.0));
            surface.normals.push(Vec3::Z);
            surface.uvs.push(Vec2::new(0.5 + 0.5 * x, 0.5 - 0.5 * y));
        }
        surface.indices.extend([0, 1, 2, 0, 2, 3].map(|k| first + k));
    }
    surface
}

fn mesh(surface: Surface) -> Mesh {
    let material = Material { alpha: Alpha::Mask(0.5), ..Material::default() };
    Mesh { surfaces: vec![surface], materials: vec![material], ..Mesh::default() }
}

fn split(mesh: &Mesh, grain: Grain) -> Elements {
    Elements::of_mesh(mesh, &LeafSurfaces::Found, grain, &Control::default()).unwrap()
}

#[test]
fn every_card_is_an_element_also_where_two_coincide() {
    let elements = split(&mesh(cards(&[Vec3::X, Vec3::X, Vec3::ZERO])), Grain::Blade);
    assert_eq!((elements.len(), elements.n_triangles()), (3, 6));
    assert_eq!(elements.centers, [Vec3::X, Vec3::X, Vec3::ZERO]);
    assert!(elements.areas.iter().all(|&area| (area - 4.0).abs() < 1e-6));
    assert_eq!(elements.normals, [Vec3::Z; 3]);
}

#[test]
fn a_soup_of_triangles_is_joined_where_they_touch() {
    let card = cards(&[Vec3::ZERO]);
    let mut soup = Surface::default();
    for &vertex in &card.indices {
        soup.positions.push(card.positions[vertex as usize]);
        soup.normals.push(Vec3::Z);
        soup.uvs.push(Vec2::ZERO);
        soup.indices.push(soup.indices.len() as u32);
    }
    assert_eq!(split(&mesh(soup), Grain::Blade).len(), 1);
}

#[test]
fn leaves_stay_whole_when_asked_for() {
    let mut surface = cards(&[Vec3::ZERO, Vec3::X, 2.0 * Vec3::X, 3.0 * Vec3::X]);
    surface.anchors = vec![Vec3::ZERO, 2.0 * Vec3::X];
    let mesh = mesh(surface);
    assert_eq!(split(&mesh, Grain::Leaf).len(), 2);
    assert_eq!(split(&mesh, Grain::Blade).len(), 4);
}

#[test]
fn every_triangle_of_the_foliage_is_in_one_element() {
    let elements = split(&mesh(cards(&[Vec3::X; 7])), Grain::Blade);
    let mut all = elements.triangles.clone();
    all.sort_unstable();
    assert!(all.iter().copied().eq(0..14));
    assert_eq!(elements.starts.len(), elements.len() + 1);
}

#[test]
fn a_card_without_area_has_a_centre_and_no_normal() {
    let mut surface = cards(&[Vec3::X]);
    surface.positions.fill(Vec3::Y);
    let elements = split(&mesh(surface), Grain::Blade);
    assert_eq!(
        (elements.centers[0], elements.normals[0], elements.areas[0]),
        (Vec3::Y, Vec3::ZERO, 0.0)
    );
}

#[test]
fn a_mesh_without_foliage_is_refused_with_advice() {
    let mut bare = mesh(cards(&[Vec3::X]));
    bare.materials[0] = Material { name: "bark".into(), ..Material::default() };
    let of = |foliage| Elements::of_mesh(&bare, &foliage, Grain::Blade, &Control::default());
    assert!(matches!(of(LeafSurfaces::Found), Err(LodError::Foliage(_))));
    assert!(matches!(of(LeafSurfaces::Surfaces(vec![1])), Err(LodError::Foliage(_))));
    assert!(matches!(of(LeafSurfaces::Surfaces(vec![0, 0])), Err(LodError::Foliage(_))));
    assert_eq!(of(LeafSurfaces::Surfaces(vec![0])).unwrap().len(), 1);
}

#[test]
fn twigs_that_meet_in_a_point_stay_apart_and_unused_vertices_change_nothing() {
    let mut soup = Surface::default();
    for i in 0..20 {
        let (a, b) = (Vec3::new(1.0, i as f32, 0.0), Vec3::new(1.0, i as f32 + 0.5, 0.0));
        for corner in [Vec3::ZERO, a, b] {
            soup.positions.push(corner);
            soup.normals.push(Vec3::Z);
            soup.uvs.push(Vec2::ZERO);
            soup.indices.push(soup.indices.len() as u32);
        }
    }
    assert_eq!(split(&mesh(soup), Grain::Blade).len(), 20);
    let mut doubled = cards(&[Vec3::X, Vec3::X]);
    for column in [&mut doubled.positions, &mut doubled.normals] {
        column.extend([Vec3::Z; 60]);
    }
    doubled.uvs.extend([Vec2::ZERO; 60]);
    assert_eq!(split(&mesh(doubled), Grain::Blade).len(), 2);
}

#[test]
fn a_seam_that_the_mesh_tells_does_not_cut_a_leaf() {
    let mut leaf = cards(&[Vec3::ZERO, 2.0 * Vec3::X]);
    leaf.welds = vec![0, 1, 2, 3, 1, 5, 6, 2];
    assert_eq!(split(&mesh(leaf), Grain::Blade).len(), 1);
}

#[test]
fn long_strips_are_found_in_time() {
    let n = 200_000_u32;
    let mut strip = Surface::default();
    for i in 0..n {
        strip.positions.push(Vec3::new(i as f32, (i % 2) as f32, 0.0));
        strip.normals.push(Vec3::Z);
        strip.uvs.push(Vec2::ZERO);
    }
    strip.indices = (2..n).rev().flat_map(|i| [i, i - 1, i - 2]).collect();
    assert_eq!(split(&mesh(strip), Grain::Blade).len(), 1);
}
