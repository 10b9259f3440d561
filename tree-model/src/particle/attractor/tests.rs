use super::*;
use crate::error::ModelError;
use crate::particle::{Matte, Photo};
use glam::Vec2;
use tree_core::{Control, Limits, NO_PARENT, Seed};

const BASE: Vec2 = Vec2::new(60.0, 118.0);

/// A round crown on a trunk, 120 pixels square.
fn lollipop() -> Matte {
    let pixel = |i: usize| {
        let at = Vec2::new((i % 120) as f32 + 0.5, (i / 120) as f32 + 0.5);
        let crown = at.distance(Vec2::new(60.0, 45.0)) < 40.0;
        let trunk = (at.x - 60.0).abs() < 4.0 && at.y > 45.0 && at.y < 118.0;
        if crown || trunk { 1.0 } else { 0.0 }
    };
    Matte::new(120, 120, (0..120 * 120).map(pixel).collect()).unwrap()
}

fn quick() -> LivewireParams {
    LivewireParams { rows: 96, ..Default::default() }
}

fn wire(matte: &Matte, photo: Option<&Photo>, seeds: &[Vec2]) -> (AttractorGraph, LivewireReport) {
    livewire(matte, photo, BASE, seeds, &quick(), &Control::default()).unwrap()
}

fn seeds_of(matte: &Matte, n: u32, seed: u64) -> Vec<Vec2> {
    silhouette_seeds(matte, BASE, n, &SeedParams::default(), Seed(seed), &Control::default())
        .unwrap()
}

#[test]
fn paths_lead_from_the_seeds_to_the_base() {
    let matte = lollipop();
    let seeds = seeds_of(&matte, 8, 1);
    let (graph, report) = wire(&matte, None, &seeds);
    assert_eq!(graph.nodes()[0], BASE);
    assert_eq!(graph.parents().iter().filter(|&&parent| parent == NO_PARENT).count(), 1);
    assert_eq!(report.n_tips as usize, graph.tips().count());
    for tip in graph.tips() {
        assert!(seeds.contains(&graph.nodes()[tip as usize]), "tip {tip}");
    }
    assert!(report.outside < 0.02, "{report:?}");
}

#[test]
fn all_paths_share_the_trunk() {
    let matte = lollipop();
    let (graph, _) = wire(&matte, None, &seeds_of(&matte, 8, 2));
    let crossing = graph.segments().filter(|(below, above)| below.y > 100.0 && above.y <= 100.0);
    assert_eq!(crossing.count(), 1);
}

#[test]
fn a_visible_branch_is_followed_instead_of_the_straight_way() {
    let matte = lollipop();
    // A dark branch up to the left and then across to a seed at the right.
    let way = [(60.0, 100.0), (60.0, 70.0), (38.0, 45.0), (58.0, 25.0), (88.0, 25.0)];
    let way: Vec<Vec2> = way.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
    let control = Control::default();
    let limits = Limits::default();
    let mut canvas =
        crate::particle::draw::Canvas::blank(120, 120, [90, 140, 60, 255], &limits).unwrap();
    way.windows(2).for_each(|pair| canvas.line(pair[0], pair[1], 3.0, [30, 20, 10, 255]));
    let photo = canvas.finish().unwrap();
    let seeds = [way[4]];
    let params = LivewireParams { rows: 120, ..Default::default() };
    let (graph, report) = livewire(&matte, Some(&photo), BASE, &seeds, &params, &control).unwrap();
    let aside = graph.nearest(way[2]).unwrap().distance;
    assert!(aside < 4.0, "{aside}, {report:?}");
}

#[test]
fn gaps_are_bridged() {
    let mut alpha = lollipop().alpha().to_vec();
    alpha[120 * 95..120 * 100].fill(0.0);
    let matte = Matte::new(120, 120, alpha).unwrap();
    let (graph, report) = wire(&matte, None, &[Vec2::new(60.0, 8.0)]);
    assert!(report.outside > 0.01);
    assert_eq!(graph.tips().count(), 1);
}

#[test]
fn seeds_lie_on_the_silhouette_off_the_trunk_and_apart() {
    let seeds = seeds_of(&lollipop(), 12, 3);
    assert_eq!(seeds.len(), 12);
    for (i, seed) in seeds.iter().enumerate() {
        let radius = seed.distance(Vec2::new(60.0, 45.0));
        assert!((37.0..=41.5).contains(&radius), "{seed}");
        assert!(seed.y < 85.0, "{seed}");
        let nearest = |other: &Vec2| other.distance(*seed);
        let rest = seeds.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, other)| other);
        assert!(rest.map(nearest).fold(f32::INFINITY, f32::min) > 5.0);
    }
}

#[test]
fn seeds_differ_with_the_seed_and_only_with_it() {
    let matte = lollipop();
    assert_eq!(seeds_of(&matte, 9, 4), seeds_of(&matte, 9, 4));
    assert_ne!(seeds_of(&matte, 9, 4), seeds_of(&matte, 9, 5));
}

#[test]
fn one_thread_and_two_give_the_same_graph() {
    let matte = lollipop();
    let seeds = seeds_of(&matte, 8, 6);
    let on = |n| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
        pool.install(|| wire(&matte, None, &seeds))
    };
    assert_eq!(on(1), on(2));
}

#[test]
fn odd_mattes_have_a_graph_or_a_typed_error() {
    let control = Control::default();
    for (width, height, value) in [(1, 1, 1.0), (1, 90, 1.0), (90, 1, 1.0), (64, 64, 1.0)] {
        let matte = Matte::new(width, height, vec![value; (width * height) as usize]).unwrap();
        let seeds = seeds_of(&matte, 5, 1);
        let photo = Photo::new(width, height, vec![[9, 9, 9, 255]; (width * height) as usize]);
        let photo = photo.unwrap();
        let (graph, _) = wire(&matte, Some(&photo), &seeds);
        assert_eq!(graph.nodes()[0], BASE);
    }
    let empty = Matte::new(9, 9, vec![0.0; 81]).unwrap();
    let error = livewire(&empty, None, BASE, &[], &quick(), &control).unwrap_err();
    assert!(matches!(error, ModelError::Attractor { .. }), "{error}");
    let params = SeedParams::default();
    let error = silhouette_seeds(&empty, BASE, 3, &params, Seed(1), &control).unwrap_err();
    assert!(matches!(error, ModelError::Attractor { .. }), "{error}");
}

#[test]
fn bad_seeds_are_reported_and_bad_bases_refused() {
    let matte = lollipop();
    let seeds = [Vec2::NAN, Vec2::new(1e9, 30.0), Vec2::new(60.0, 8.0)];
    let (_, report) = wire(&matte, None, &seeds);
    assert_eq!((report.n_bad_seeds, report.n_moved_seeds), (1, 1));
    let control = Control::default();
    let error = livewire(&matte, None, Vec2::NAN, &[], &quick(), &control).unwrap_err();
    assert!(matches!(error, ModelError::NotFinite { .. }), "{error}");
    let photo = Photo::new(1, 1, vec![[0; 4]]).unwrap();
    let error = livewire(&matte, Some(&photo), BASE, &[], &quick(), &control).unwrap_err();
    assert!(matches!(error, ModelError::Picture { .. }), "{error}");
    let (far, _) =
        livewire(&matte, None, Vec2::new(-1e6, 1e7), &seeds, &quick(), &control).unwrap();
    assert_eq!(far.nodes()[0], Vec2::new(-1e6, 1e7));
}

#[test]
fn parameters_limits_and_cancelling_are_heeded() {
    let matte = lollipop();
    let control = Control::default();
    let bad = LivewireParams { follow: 1.0, ..Default::default() };
    let error = livewire(&matte, None, BASE, &[], &bad, &control).unwrap_err();
    assert!(error.to_string().contains("livewire.follow"), "{error}");
    let bad = SeedParams { from_trunk: f32::NAN, ..Default::default() };
    assert!(silhouette_seeds(&matte, BASE, 3, &bad, Seed(1), &control).is_err());
    let tight = Control::default().with_limits(Limits { pixels: 99, ..Limits::default() });
    let error = livewire(&matte, None, BASE, &[], &quick(), &tight).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
    let stop = Control::default().with_stop(|| true);
    let error = livewire(&matte, None, BASE, &[], &quick(), &stop).unwrap_err();
    assert!(matches!(error, ModelError::Cancelled(_)), "{error}");
}
