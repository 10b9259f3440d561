//! Petioles, light, sizes, compound leaves and needles.

use super::{calm, grow, shoot};
use crate::foliage::*;
use glam::Vec3;
use std::f32::consts::PI;
use tree_core::{Control, Seed, Skeleton};

/// A level shoot of 2 m along +X.
fn level() -> Skeleton {
    let mut builder = Skeleton::builder(Vec3::ZERO, 0.01).unwrap();
    for i in 1..=20 {
        builder.add(i - 1, Vec3::X * (0.1 * i as f32), 0.01).unwrap();
    }
    builder.finish()
}

fn formed(form: LeafForm) -> LeafParams {
    LeafParams { form, phototropism: 0.0, droop: 0.0, ..calm(Phyllotaxis::GOLDEN) }
}

#[test]
fn blades_stand_off_the_shoot_along_their_petioles() {
    let params = LeafParams { petiole: 2.0, ..formed(LeafForm::Simple) };
    let foliage = grow(&shoot(2.0), &params);
    let bare = grow(&shoot(2.0), &LeafParams { petiole: 0.0, ..params.clone() });
    assert!(foliage.len() > 15);
    for (far, near) in foliage.iter().zip(bare.iter()) {
        let petiole = far.position - near.position;
        assert!((petiole.length() - 2.0 * params.size).abs() < 1e-5);
        let pitch = libm::acosf(petiole.normalize().y);
        assert!((pitch - params.pitch).abs() < 1e-3, "{pitch}");
        // Without droop and light the blade goes on where the petiole ends.
        assert!((far.rotation * Vec3::Y).dot(petiole.normalize()) > 0.9999);
    }
}

#[test]
fn blades_turn_to_the_light_by_no_more_than_their_joint_allows() {
    let light = Vec3::new(1.0, 0.3, -0.5).normalize();
    let straight = LeafParams { light, phototropism: 1.0, ..calm(Phyllotaxis::GOLDEN) };
    let facing = |params: &LeafParams| {
        let foliage = grow(&level(), params);
        foliage.rotations().iter().map(|&r| (r * Vec3::Z).dot(light)).sum::<f32>()
            / foliage.len() as f32
    };
    let mut last = facing(&LeafParams { phototropism: 0.0, ..straight.clone() });
    for lamina_turn in [0.0, 0.4, 0.8, PI] {
        let params = LeafParams { lamina_turn, ..straight.clone() };
        let now = facing(&params);
        assert!(now > last, "{lamina_turn}: {now} after {last}");
        last = now;
        let pairs = grow(&level(), &params).rotations().to_vec();
        for (turned, held) in pairs.iter().zip(grow(&level(), &straight).rotations()) {
            assert!(turned.angle_between(*held) < lamina_turn + 1e-2);
        }
    }
    assert!(last > 0.999, "free to turn, all face the light: {last}");
}

#[test]
fn a_size_gradient_makes_leaves_smaller_to_its_end() {
    let sizes = |size_gradient| {
        let params = LeafParams { size_gradient, bearing: 1.0, ..calm(Phyllotaxis::GOLDEN) };
        grow(&shoot(2.0), &params).sizes().to_vec()
    };
    let (down, up) = (sizes(0.8), sizes(-0.8));
    assert!(down.windows(2).all(|pair| pair[1] < pair[0]), "{down:?}");
    assert!(up.windows(2).all(|pair| pair[1] > pair[0]), "{up:?}");
    assert!(down[0] <= 0.13 && up[up.len() - 1] <= 0.13);
}

#[test]
fn pinnate_leaves_have_their_leaflets_in_pairs_along_a_rachis() {
    let pinnate = Pinnate { pairs: 5, rachis: 3.0, droop: 0.0, ..Pinnate::DEFAULT };
    for (odd, n) in [(true, 11), (false, 10)] {
        let form = LeafForm::Pinnate(Pinnate { odd, ..pinnate });
        assert_eq!(form.n_leaflets(), n);
        let params = LeafParams { petiole: 0.5, ..formed(form) };
        let foliage = grow(&shoot(0.6), &params);
        let leaves: Vec<_> = foliage.iter().collect();
        for leaf in leaves.chunks(n as usize) {
            // The rachis from the middle of the first pair to that of the last.
            let middle = |i: usize| 0.5 * (leaf[2 * i].position + leaf[2 * i + 1].position);
            let along = (middle(4) - middle(0)).normalize();
            for i in 0..5 {
                let apart = leaf[2 * i].position - leaf[2 * i + 1].position;
                assert!(apart.dot(along).abs() < 1e-4, "pairs lie across the rachis");
                let angles = [0, 1].map(|side| (leaf[2 * i + side].rotation * Vec3::Y).dot(along));
                assert!((angles[0] - angles[1]).abs() < 1e-3, "pairs lean alike");
            }
            if odd {
                let end = leaf[10].position - middle(0);
                assert!((end.length() - 3.0 * params.size).abs() < 0.1 * params.size);
                assert!((leaf[10].rotation * Vec3::Y).dot(along) > 0.999);
            }
        }
    }
}

#[test]
fn a_rachis_with_droop_ends_lower_and_bends_by_its_angle() {
    let tip = |droop| {
        let pinnate = Pinnate { rachis: 4.0, droop, ..Pinnate::DEFAULT };
        let layout = LeafForm::Pinnate(pinnate).layout();
        let last = *layout.leaflets.last().unwrap();
        (last.offset, last.rotation * Vec3::Y)
    };
    assert!(tip(0.0).0.z.abs() < 1e-5);
    let (offset, direction) = tip(1.0);
    assert!(offset.z < -0.5);
    assert!((libm::acosf(direction.y) - 1.0).abs() < 1e-3);
    // Where the formula changes it does not jump.
    assert!(tip(0.999e-3).0.distance(tip(1.001e-3).0) < 1e-4);
}

#[test]
fn bipinnate_leaves_have_pinnae_of_pairs_and_stalks_bear_them_in_order() {
    let pinnate = Pinnate { pairs: 4, odd: false, pinna_pairs: 3, ..Pinnate::DEFAULT };
    let form = LeafForm::Pinnate(pinnate);
    assert_eq!(form.n_leaflets(), 8 * 7);
    let layout = form.layout();
    assert_eq!(layout.leaflets.len(), 8 * 7);
    for (i, stalk) in layout.stalks.iter().enumerate() {
        assert_eq!(stalk.below.is_none(), i == 0);
        assert!(stalk.below.is_none_or(|below| (below as usize) < i));
    }
    for leaflet in &layout.leaflets {
        assert!((leaflet.stalk as usize) < layout.stalks.len());
    }
}

#[test]
fn palmate_leaflets_fan_out_evenly_from_one_point() {
    let palmate = Palmate { leaflets: 5, spread: 2.0, outer: 0.4, droop: 0.0 };
    let foliage = grow(&shoot(0.4), &formed(LeafForm::Palmate(palmate)));
    let leaves: Vec<_> = foliage.iter().collect();
    for leaf in leaves.chunks(5) {
        for pair in leaf.windows(2) {
            let angle = (pair[0].rotation * Vec3::Y).angle_between(pair[1].rotation * Vec3::Y);
            assert!((angle - 0.5).abs() < 1e-3, "{angle}");
            assert!(pair[0].position.distance(pair[1].position) < 1e-6);
        }
        assert!((leaf[0].size / leaf[2].size - 0.4).abs() < 1e-3);
    }
}

#[test]
fn needles_of_a_fascicle_spread_evenly_round_its_axis() {
    for needles in [2, 3, 5] {
        let foliage = grow(&shoot(0.6), &formed(LeafForm::Fascicle { needles, spread: 0.3 }));
        let directions: Vec<Vec3> = foliage.rotations().iter().map(|&r| r * Vec3::Y).collect();
        for fascicle in directions.chunks(needles as usize) {
            let axis = fascicle.iter().sum::<Vec3>().normalize();
            for needle in fascicle {
                assert!((needle.angle_between(axis) - 0.3).abs() < 1e-3);
            }
        }
    }
}

#[test]
fn needles_of_a_rosette_go_to_all_sides_within_their_spread() {
    let rosette = LeafForm::Rosette { needles: 40, spread: 1.2 };
    let layout = rosette.layout();
    let mut sum = Vec3::ZERO;
    for leaflet in &layout.leaflets {
        let direction = leaflet.rotation * Vec3::Y;
        assert!(direction.angle_between(Vec3::Y) < 1.2 + 1e-3);
        sum += direction / 40.0;
    }
    assert!(sum.x.abs() < 0.1 && sum.z.abs() < 0.1, "{sum}");
}

#[test]
fn stalks_bear_the_blades_and_leave_the_old_nodes_alone() {
    let skeleton = shoot(1.0);
    let form = LeafForm::Pinnate(Pinnate { petiolule: 0.05, ..Pinnate::DEFAULT });
    let params = LeafParams { petiole: 0.5, ..formed(form) };
    let control = Control::default();
    let leafy = grow_leaves_with_stalks(&skeleton, &params, None, Seed(4), &control).unwrap();
    let n = skeleton.len();
    assert_eq!(leafy.skeleton.positions()[..n], *skeleton.positions());
    assert_eq!(leafy.skeleton.radii()[..n], *skeleton.radii());
    assert_eq!(leafy.skeleton.parents()[..n], *skeleton.parents());
    assert_eq!(leafy.skeleton.len() as u64, n as u64 + leafy.report.n_stalk_nodes);
    assert_eq!(leafy.foliage.positions(), grow(&skeleton, &params).positions());
    for leaf in leafy.foliage.iter() {
        let stalk = leafy.skeleton.positions()[leaf.node as usize];
        let petiolule = stalk.distance(leaf.position);
        assert!((petiolule - 0.05 * params.size).abs() < 1e-4, "{petiolule}");
    }
    for (parent, node) in leafy.skeleton.segments().skip(n - 1) {
        let radii = leafy.skeleton.radii();
        assert!(radii[node as usize] <= radii[parent as usize]);
    }
}

#[test]
fn leaves_without_stalks_add_no_nodes() {
    let params = formed(LeafForm::Simple);
    let control = Control::default();
    let leafy = grow_leaves_with_stalks(&shoot(1.0), &params, None, Seed(4), &control).unwrap();
    assert_eq!(leafy.skeleton, shoot(1.0));
    assert_eq!(leafy.foliage, grow(&shoot(1.0), &params));
}

#[test]
fn two_rows_lie_level_on_a_level_shoot() {
    for arrangement in [Phyllotaxis::Distichous, Phyllotaxis::Opposite] {
        let foliage = grow(&level(), &calm(arrangement));
        assert!(foliage.positions().iter().all(|p| p.y.abs() < 1e-4), "{arrangement:?}");
        assert!(foliage.positions().iter().any(|p| p.z > 0.005));
        assert!(foliage.positions().iter().any(|p| p.z < -0.005));
    }
}

#[test]
fn every_species_grows_twigs_and_leaves() {
    let control = Control::default();
    for species in SPECIES {
        let twigs = grow_twigs(&shoot(1.0), &species.twigs, Seed(2), &control).unwrap();
        assert!(twigs.report.n_twigs > 0, "{}", species.name);
        let leafy =
            grow_leaves_with_stalks(&twigs.skeleton, &species.leaves, None, Seed(2), &control)
                .unwrap();
        assert!(leafy.report.n_leaves > 0, "{}", species.name);
        assert_eq!(SpeciesPreset::find(species.name).unwrap(), species);
    }
    let error = SpeciesPreset::find("triffid").unwrap_err().to_string();
    assert!(error.contains("triffid") && error.contains("larch"), "{error}");
}
