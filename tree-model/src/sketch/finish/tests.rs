//! The finish, told by what it does.

use super::*;
use crate::foliage::SPECIES;
use crate::sketch::propagate::fixtures::{
    Builder, crown, omega, one_stroke, palm, palm_omega, sketch,
};
use crate::sketch::propagate::{PropagateParams, Propagated, propagate};
use crate::sketch::{Branches, Label};
use glam::Vec3;
use proptest::prelude::*;
use tree_core::{Control, Seed, Skeleton, Tree};

fn grown(branches: &Branches, crown: bool) -> Propagated {
    let shape = crate::sketch::propagate::fixtures::crown();
    let crown = crown.then_some(&shape);
    let (params, control) = (PropagateParams::default(), Control::default());
    propagate(branches, &omega(), crown, None, &params, Seed(1), &control).unwrap()
}

fn wood(grown: &Propagated) -> Skeleton {
    grow_wood(grown, &FinishParams::default(), &Control::default()).unwrap()
}

fn finished(crown: bool, params: &FinishParams) -> (Tree, FinishReport) {
    let wood = wood(&grown(&sketch(), crown));
    let shape = crate::sketch::propagate::fixtures::crown();
    let crown = crown.then_some(&shape);
    grow_crown(&wood, crown, params, Seed(1), &Control::default()).unwrap()
}

fn of(species: &str) -> FinishParams {
    FinishParams { species: species.into(), ..Default::default() }
}

#[test]
fn every_drawn_point_is_a_node() {
    let sketch = sketch();
    let wood = wood(&grown(&sketch, false));
    for point in &sketch.points {
        assert!(wood.positions().contains(point), "{point}");
    }
}

#[test]
fn branches_join_where_they_fork() {
    let grown = grown(&sketch(), false);
    let wood = wood(&grown);
    let longest = wood.segment_lengths().into_iter().fold(0.0, f32::max);
    // A node at the wrong place would have a long way to its own.
    assert!(longest < 0.6, "{longest}");
    assert_eq!(wood.positions()[0], Vec3::ZERO);
}

#[test]
fn the_trunk_is_as_thick_as_slenderness_says() {
    let wood = wood(&grown(&sketch(), true));
    let height = wood.bounds().size().max_element();
    assert!((wood.radii()[0] / height - FinishParams::default().slenderness).abs() < 1e-4);
}

#[test]
fn an_imagined_root_is_left_out() {
    let mut b = Builder::default();
    let root = b.add(None, Label::Apical, [0.0, 0.0, 0.0]);
    b.add(Some(root), Label::Apical, [0.5, 5.0, 0.0]);
    b.add(Some(root), Label::Lateral(0), [-1.0, 4.0, 0.0]);
    let mut branches = b.build();
    branches.imagined_root = true;
    for point in &mut branches.points[..6] {
        *point = Vec3::NEG_Y;
    }
    let wood = wood(&grown(&branches, false));
    assert_eq!(wood.positions()[0], Vec3::ZERO);
    assert!(wood.positions().iter().all(|point| point.y >= 0.0));
}

#[test]
fn a_tree_in_leaf_has_a_sensible_number_of_leaves() {
    for crown in [false, true] {
        for species in ["oak", "birch", "willow", "spruce"] {
            let (tree, report) = finished(crown, &of(species));
            assert!((1_000..20_000).contains(&tree.foliage().len()), "{species}: {report:?}");
            assert!(tree.skeleton().len() < 100_000, "{species}: {report:?}");
        }
    }
}

#[test]
fn twigs_and_leaves_stay_in_the_crown() {
    let (tree, report) = finished(true, &of("oak"));
    let shape = crown();
    let in_crown = |point: Vec3| shape.contains_3d(point);
    assert!(tree.foliage().positions().iter().all(|&leaf| in_crown(leaf)));
    assert!(report.n_leaves_outside > 0 && report.n_twig_nodes_cut > 0, "{report:?}");
    let twigs =
        &tree.skeleton().positions()[tree.skeleton().len() - report.n_twig_nodes as usize..];
    assert!(twigs.iter().all(|&node| in_crown(node)));
}

#[test]
fn fuller_trees_have_more_leaves() {
    let n = |fullness| finished(false, &FinishParams { fullness, ..of("oak") }).0.foliage().len();
    let [none, half, usual] = [0.0, 0.5, 1.0].map(n);
    assert!(none == 0 && 10 * half < 7 * usual, "{none} {half} {usual}");
}

#[test]
fn a_bare_tree_has_twigs_and_no_leaves() {
    let (tree, report) = finished(false, &FinishParams { leaves: false, ..of("oak") });
    assert!(tree.foliage().is_empty() && report.n_twig_nodes > 1000, "{report:?}");
}

#[test]
fn fronds_bear_leaflets_and_no_twigs() {
    let (params, control) = (PropagateParams::default(), Control::default());
    let fronds = propagate(&palm(), &palm_omega(), None, None, &params, Seed(1), &control).unwrap();
    for (what, n) in [(fronds, 300..5_000), (Propagated::bare(one_stroke()), 1_000..20_000)] {
        let (tree, report) =
            grow_crown(&wood(&what), None, &of("palm"), Seed(1), &control).unwrap();
        assert!(n.contains(&tree.foliage().len()) && report.n_twig_nodes == 0, "{report:?}");
    }
}

#[test]
fn all_species_can_be_had() {
    let wood = wood(&grown(&sketch(), false));
    for species in SPECIES {
        let tree = grow_crown(&wood, None, &of(species.name), Seed(1), &Control::default());
        let n = tree.unwrap().0.foliage().len();
        assert!((500..200_000).contains(&n), "{}: {n}", species.name);
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| finished(true, &of("birch")))
    };
    assert_eq!(run(1), run(3));
}

#[test]
fn bad_parameters_are_named() {
    let of = |params: FinishParams| params.validate().unwrap_err().to_string();
    assert!(of(of_species("baobab")).contains("no preset named 'baobab'"));
    let params = FinishParams { slenderness: f32::NAN, ..Default::default() };
    assert!(of(params).starts_with("finish.slenderness is NaN"));
    let params = FinishParams { twig_length: 0.0, ..Default::default() };
    assert!(of(params).starts_with("finish.twig_length is 0"));
}

fn of_species(name: &str) -> FinishParams {
    of(name)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn any_sketch_becomes_a_sound_tree(
        ends in prop::collection::vec((prop::array::uniform3(-4.0_f32..4.0), any::<u32>(), any::<bool>()), 0..8),
        seed: u64,
    ) {
        let mut b = Builder::default();
        b.add(None, Label::Apical, [0.0, 3.0, 0.0]);
        for (i, &(end, parent, apical)) in ends.iter().enumerate() {
            let label = if apical { Label::Apical } else { Label::Lateral(i as u16) };
            b.add(Some(parent % (i as u32 + 1)), label, end);
        }
        let control = Control::default();
        let params = PropagateParams { max_segments: 1000, ..Default::default() };
        let grown =
            propagate(&b.build(), &omega(), None, None, &params, Seed(seed), &control).unwrap();
        let wood = wood(&grown);
        prop_assert!(wood.check().is_ok());
        let (tree, _) = grow_crown(&wood, None, &of("oak"), Seed(seed), &control).unwrap();
        prop_assert!(tree.skeleton().check().is_ok());
    }
}

#[test]
fn a_trunk_is_as_thick_as_its_height_says_not_its_width() {
    let radius = |width: f32| {
        let mut b = Builder::default();
        let trunk = b.add(None, Label::Apical, [0.0, 1.0, 0.0]);
        b.add(Some(trunk), Label::Apical, [width, 4.0, 0.0]);
        let params = PropagateParams { max_segments: 1, ..Default::default() };
        let control = Control::default();
        let grown = propagate(&b.build(), &omega(), None, None, &params, Seed(1), &control);
        let wood = wood(&grown.unwrap());
        wood.radii()[0] / wood.bounds().size().y
    };
    assert!((radius(1.0) - radius(8.0)).abs() < 1e-5);
}
