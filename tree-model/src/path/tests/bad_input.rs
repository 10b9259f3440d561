//! Bad input: each kind has its own error, and nothing panics.

use super::*;
use tree_core::{LimitError, Resource};

fn error(params: &PathParams) -> ModelError {
    params.grow(SEED, &control()).unwrap_err()
}

#[test]
fn parameters_out_of_range_are_named() {
    let field = |params: PathParams| match error(&params) {
        ModelError::Parameter(error) => error.field,
        ModelError::NotFinite { field } => field.into(),
        other => panic!("{other}"),
    };
    assert_eq!(field(PathParams { root: Vec3::NAN, ..shrub() }), "root");
    assert_eq!(field(PathParams { size: f32::NAN, ..shrub() }), "size");
    assert_eq!(field(PathParams { shrink: f32::INFINITY, ..shrub() }), "shrink");
    assert_eq!(field(PathParams { graph_nodes: 0, ..shrub() }), "graph_nodes");
    let mut params = shrub();
    params.levels[1].turn = 9.0;
    assert_eq!(field(params), "levels[1].turn");
    let mut params = shrub();
    params.levels[0].axis = LevelAxis::Fixed(Vec3::ZERO);
    assert_eq!(field(params), "levels[0].axis.length()");
    let mut params = shrub();
    params.endpoints.placed = vec![Vec3::Y, Vec3::new(0.0, f32::INFINITY, 0.0)];
    assert_eq!(field(params), "endpoints.placed[1]");
}

#[test]
fn zero_endpoints_are_refused() {
    let mut params = shrub();
    params.endpoints.random = 0;
    assert!(matches!(error(&params), ModelError::NoEndpoints));
}

#[test]
fn an_empty_or_endless_volume_is_refused() {
    let left = Volume::sphere(Vec3::NEG_X, 0.5).unwrap();
    let right = Volume::sphere(Vec3::X, 0.5).unwrap();
    for volume in [
        left.intersection(&right).unwrap(),
        left.difference(&left).unwrap(),
        Volume::half_space(Vec3::ZERO, Vec3::Y).unwrap(),
    ] {
        let error = error(&PathParams { volume, ..shrub() });
        assert!(matches!(error, ModelError::EmptyVolume { .. }), "{error}");
    }
}

#[test]
fn a_root_outside_the_volume_is_refused() {
    let error = error(&PathParams { root: Vec3::new(30.0, 0.0, 0.0), ..shrub() });
    let ModelError::RootOutside { nearest, .. } = error else { panic!("{error}") };
    assert!((28.0..30.0).contains(&nearest), "{nearest}");
}

#[test]
fn a_root_inside_the_obstacle_is_refused() {
    let volume = Volume::sphere(Vec3::ZERO, 0.2).unwrap();
    let obstacle = Some(Obstacle { volume, clearance: 0.0 });
    let error = error(&PathParams { obstacle, ..shrub() });
    assert!(matches!(error, ModelError::RootBlocked { .. }), "{error}");
}

#[test]
fn an_endpoint_that_cannot_be_reached_is_named() {
    let mut params = shrub();
    params.endpoints.placed = vec![2.0 * Vec3::Y, Vec3::new(0.0, 50.0, 0.0)];
    let found = error(&params);
    assert!(matches!(found, ModelError::EndpointUnreachable { index: 1, .. }), "{found}");

    // Shut in by a shell.
    let mut params = shrub();
    let center = 2.2 * Vec3::Y;
    let shell = Volume::sphere(center, 0.5).unwrap();
    let volume = shell.difference(&Volume::sphere(center, 0.4).unwrap()).unwrap();
    params.obstacle = Some(Obstacle { volume, clearance: 0.0 });
    params.endpoints.placed = vec![center];
    let found = error(&params);
    assert!(matches!(found, ModelError::EndpointUnreachable { index: 0, .. }), "{found}");
}

#[test]
fn budgets_above_the_limits_are_refused() {
    let limits = Limits { graph_nodes: 499, ..Limits::default() };
    let found = shrub().grow(SEED, &control().with_limits(limits)).unwrap_err();
    assert!(matches!(found, ModelError::Limit(_)), "{found}");
    let limits = Limits { nodes: 50, ..Limits::default() };
    let found = shrub().grow(SEED, &control().with_limits(limits)).unwrap_err();
    assert!(matches!(found, ModelError::Limit(_)), "{found}");
}

#[test]
fn more_nodes_than_a_grid_can_number_are_refused_whatever_the_limits() {
    let limits = Limits { graph_nodes: u64::MAX, nodes: u64::MAX, ..Limits::default() };
    let endless = control().with_limits(limits);
    let params = PathParams { graph_nodes: u32::MAX, ..shrub() };
    let found = params.grow(SEED, &endless).unwrap_err();
    assert!(found.to_string().contains("graph_nodes"), "{found}");
    let ball = Volume::sphere(Vec3::ZERO, 1.0).unwrap();
    for wanted in [1_000_000_000, 1_700_000_000, u32::MAX] {
        match nodes::strew(&ball, None, wanted, &[], SEED, &endless) {
            Err(ModelError::Limit(LimitError { resource, requested, cap })) => {
                assert_eq!((resource, requested), (Resource::GraphNodes, u64::from(wanted)));
                assert!((500_000_000..1_000_000_000).contains(&cap), "{cap}");
            }
            other => panic!("{:?}", other.map(|nodes| nodes.positions.len())),
        }
    }
}

#[test]
fn the_limit_on_graph_nodes_counts_all_levels_and_the_roots() {
    let params = Preset::find("taproot").unwrap().params().unwrap();
    let grown = params.grow(SEED, &control()).unwrap();
    let total = grown.report.graphs().n_nodes;
    let limits = Limits { graph_nodes: total * 9 / 10, ..Limits::default() };
    let found = params.grow(SEED, &control().with_limits(limits)).unwrap_err();
    assert!(matches!(found, ModelError::Limit(_)), "{found}");
}

#[test]
fn more_arcs_than_the_limit_are_refused_before_they_are_linked() {
    let limits = Limits { graph_arcs: 1000, ..Limits::default() };
    let found = shrub().grow(SEED, &control().with_limits(limits)).unwrap_err();
    assert!(found.to_string().contains("graph_arcs"), "{found}");
}

#[test]
fn a_crown_without_room_for_endpoints_is_refused() {
    let mut params = shrub();
    params.volume = Volume::cone(Vec3::ZERO, 9.0 * Vec3::Y, 1.0).unwrap();
    params.graph_nodes = 300;
    params.endpoints.above = 0.95;
    let found = error(&params);
    assert!(matches!(found, ModelError::NoCandidates { wanted: 6 }), "{found}");
}

#[test]
fn volumes_of_extreme_size_are_refused() {
    let volume = Volume::box_solid(Vec3::splat(-2e38), Vec3::splat(2e38)).unwrap();
    let found = error(&PathParams { volume, ..shrub() });
    assert!(matches!(found, ModelError::EmptyVolume { .. }), "{found}");
}

#[test]
fn errors_of_the_roots_and_of_the_radii_say_so() {
    let text = |change: fn(&mut PathParams)| {
        let mut params = Preset::find("taproot").unwrap().params().unwrap();
        change(&mut params);
        error(&params).to_string()
    };
    let found = text(|p| p.roots.as_mut().unwrap().size = f32::NAN);
    assert!(found.starts_with("roots.size is NaN"), "{found}");
    let found = text(|p| {
        let rule = tree_core::allometry::PipeModel { exponent: 0.5, ..Default::default() };
        p.radii = tree_core::allometry::RadiusRule::Pipe(rule);
    });
    assert!(found.starts_with("radii.exponent is 0.5"), "{found}");
    let found = text(|p| p.species.leaf_kinds.clear());
    assert!(found.starts_with("species.leaf_kinds.len() is 0"), "{found}");
}

#[test]
fn a_cost_field_that_gives_no_cost_is_refused() {
    let params = PathParams { cost: Some(std::sync::Arc::new(|_| -1.0)), ..shrub() };
    assert!(matches!(error(&params), ModelError::Cost { found: -1.0, .. }));
}
