use super::vertex::{self, PackedVertex};
use crate::mesh::{Material, Mesh, Surface};
use crate::sample;
use crate::wind::{self, Branch};
use glam::{Vec2, Vec3};
use proptest::prelude::*;

const BYTE: f32 = 0.5 / 255.0 + 1e-6;

#[test]
fn a_vertex_has_32_bytes() {
    assert_eq!(size_of::<PackedVertex>(), 32);
    let mesh = sample::mesh(1);
    let packed = vertex::pack(&mesh, 0).unwrap();
    assert_eq!(packed.bytes().len(), 32 * mesh.surfaces[0].positions.len());
}

/// Asserts the bounds that the module states.
fn check(mesh: &Mesh, number: usize) -> Result<(), TestCaseError> {
    let surface = &mesh.surfaces[number];
    let packed = vertex::pack(mesh, number).unwrap();
    let back = packed.unpack(mesh);
    let bounds = surface.bounds();
    let far = bounds.min.abs().max(bounds.max.abs()).max_element();
    let step = bounds.size() / 131_070.0 + far * 2e-7;
    let [low, high] = packed.uv_range;
    let uv_step = (high - low) / 131_070.0 + low.abs().max(high.abs()) * 2e-7;
    for (row, wind) in wind::vertices(mesh, number).unwrap().iter().enumerate() {
        let off = (back.positions[row] - surface.positions[row]).abs();
        prop_assert!(off.cmple(step).all(), "{off} {step}");
        prop_assert!(back.normals[row].distance(surface.normals[row]) < 1e-4);
        let (tangent, wanted) = (back.tangents[row], surface.tangents[row]);
        prop_assert!(tangent.truncate().distance(wanted.truncate()) < 3e-4, "{tangent} {wanted}");
        prop_assert_eq!(tangent.w, wanted.w);
        prop_assert!((back.uvs[row] - surface.uvs[row]).abs().cmple(uv_step).all());
        let off = (back.uvs2[row] - surface.uvs2[row]).abs().max_element();
        prop_assert!(off <= 0.5 / 65_535.0 + 1e-7);
        prop_assert!((back.occlusion[row] - surface.occlusion[row]).abs() <= BYTE);
        let branch = &mesh.branches[wind.branch as usize];
        prop_assert_eq!(back.branches[row], wind.branch);
        prop_assert_eq!(back.pivots[row], branch.pivot);
        prop_assert_eq!(back.levels[row], branch.level);
        prop_assert!((back.reach[row] - wind.reach).abs() <= 0.5 / 65_535.0 + 1e-7);
        prop_assert!((back.flutter[row] - wind.flutter).abs() <= BYTE);
        prop_assert!((back.phases[row] - branch.phase).abs() <= BYTE);
        prop_assert!((back.stiffness[row] - branch.stiffness).abs() <= BYTE);
        prop_assert!((back.leaf_phases[row] - wind.leaf_phase).abs() <= BYTE);
    }
    prop_assert_eq!(back.indices, surface.indices.clone());
    Ok(())
}

#[test]
fn trees_come_back_within_the_bounds_stated() {
    let mesh = sample::mesh(3);
    for surface in 0..2 {
        check(&mesh, surface).unwrap();
    }
}

#[test]
fn more_branches_than_16_bits_name_are_kept_apart() {
    let mut mesh = sample::mesh(0);
    let bough = Branch { level: 1, length: 1.0, ..Branch::default() };
    mesh.branches.resize(70_001, bough);
    mesh.branches[70_000].pivot = Vec3::ONE;
    mesh.surfaces[0].branches.fill(70_000);
    let back = vertex::pack(&mesh, 0).unwrap().unpack(&mesh);
    assert!(back.branches.iter().all(|&branch| branch == 70_000));
    assert!(back.pivots.iter().all(|&pivot| pivot == Vec3::ONE));
}

fn direction() -> impl Strategy<Value = Vec3> {
    [-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0]
        .prop_map(|v| Vec3::from_array(v).normalize_or(Vec3::Y))
}

fn vertex_strategy() -> impl Strategy<Value = (Vec3, Vec3, f32, bool, [f32; 5])> {
    let numbers = [-50.0_f32..50.0, -50.0_f32..50.0, 0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0];
    let place = [-1.0_f32..1.0, -1.0_f32..1.0, -1.0_f32..1.0].prop_map(Vec3::from_array);
    (place, direction(), 0.0_f32..6.3, any::<bool>(), numbers)
}

proptest! {
    #[test]
    fn any_vertices_come_back(
        rows in proptest::collection::vec(vertex_strategy(), 1..40),
        scale in prop_oneof![Just(1e-3_f32), Just(1.0), Just(40.0), Just(1e4)],
    ) {
        let mut surface = Surface::default();
        for (place, normal, turn, sign, [u, v, u2, v2, occlusion]) in rows {
            let across = normal.any_orthonormal_vector();
            let tangent = across * libm::cosf(turn) + normal.cross(across) * libm::sinf(turn);
            surface.positions.push(place * scale);
            surface.normals.push(normal);
            surface.tangents.push(tangent.normalize().extend(if sign { 1.0 } else { -1.0 }));
            surface.uvs.push(Vec2::new(u, v));
            surface.uvs2.push(Vec2::new(u2, v2));
            surface.occlusion.push(occlusion);
            surface.branches.push(0);
        }
        let branches = vec![Branch { length: scale, stiffness: 0.3, ..Branch::default() }];
        let mesh = Mesh { surfaces: vec![surface], materials: vec![Material::default()], branches };
        check(&mesh, 0)?;
    }
}
