use super::*;
use crate::error::ModelError;
use crate::particle::attractor::AttractorGraph;
use glam::Vec2;
use proptest::prelude::*;
use tree_core::{Control, Limits, NO_PARENT};

const PICTURE: Vec2 = Vec2::new(80.0, 100.0);
const BASE: Vec2 = Vec2::new(40.0, 95.0);

/// A trunk up to (40, 20) with a branch to the right from its middle.
fn graph() -> AttractorGraph {
    let nodes = [(40.0, 95.0), (40.0, 60.0), (40.0, 20.0), (70.0, 30.0)];
    let nodes = nodes.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
    AttractorGraph::new(nodes, vec![NO_PARENT, 0, 1, 1]).unwrap()
}

fn field(blend: Blend) -> DirectionField {
    let params = FieldParams { blend, ..Default::default() };
    direction_field(&graph(), PICTURE, BASE, &params, &Control::default()).unwrap()
}

#[test]
fn on_the_graph_the_field_leads_to_the_base() {
    let field = field(Blend::default());
    let down = field.sample(Vec2::new(40.0, 80.0));
    assert!(down.y < -0.99, "{down}");
    let branch = field.sample(Vec2::new(60.0, 40.0));
    assert!(branch.dot(Vec2::new(-30.0, -30.0).normalize()) > 0.95, "{branch}");
}

#[test]
fn far_from_the_graph_the_field_leads_to_it() {
    let field = field(Blend::Linear { reach: 0.1, most: 1.0 });
    let left = field.sample(Vec2::new(10.0, 70.0));
    assert!(left.x > 0.99, "{left}");
    let below = field.sample(Vec2::new(40.0, 103.0));
    assert!(below.y > 0.99, "beyond the root back to it: {below}");
}

#[test]
fn a_constant_blend_meets_the_graph_at_its_angle() {
    let field = field(Blend::Constant { share: 0.5 });
    let aside = field.sample(Vec2::new(20.0, 80.0));
    assert!((aside - Vec2::new(0.5, -0.5).normalize()).length() < 0.15, "{aside}");
}

#[test]
fn neighbouring_cells_agree_beside_a_bend() {
    // Along the outer side of the fork, where the source's tangents jump by 45 degrees.
    let field = field(Blend::default());
    let mut before = field.sample(Vec2::new(39.0, 90.0));
    for i in 1..120 {
        let here = field.sample(Vec2::new(39.0, 90.0 - 0.5 * i as f32));
        assert!(here.dot(before) > 0.95, "at {i}: {before} then {here}");
        before = here;
    }
}

#[test]
fn without_a_graph_there_is_no_direction() {
    let empty = AttractorGraph::default();
    let control = Control::default();
    let field = direction_field(&empty, PICTURE, BASE, &FieldParams::default(), &control).unwrap();
    assert!(field.vectors().iter().all(|&vector| vector == Vec2::ZERO));
    assert!(field.to_photo().is_ok());
}

#[test]
fn bad_pictures_bases_and_limits_are_errors() {
    let make = |picture, base, control: &Control| {
        direction_field(&graph(), picture, base, &FieldParams::default(), control)
    };
    let control = Control::default();
    for bad in [Vec2::ZERO, Vec2::splat(f32::NAN), Vec2::new(1.0, 1e9)] {
        let error = make(bad, BASE, &control).unwrap_err();
        assert!(matches!(error, ModelError::Parameter(_)), "{error}");
    }
    let error = make(PICTURE, Vec2::splat(f32::NAN), &control).unwrap_err();
    assert!(matches!(error, ModelError::NotFinite { .. }), "{error}");
    let tight = Control::default().with_limits(Limits { pixels: 100, ..Limits::default() });
    let error = make(PICTURE, BASE, &tight).unwrap_err();
    assert!(matches!(error, ModelError::Limit(_)), "{error}");
    let wide = make(Vec2::new(1e6, 1.0), BASE, &control);
    assert!(matches!(wide, Err(ModelError::Limit(_)) | Ok(_)));
}

#[test]
fn a_function_may_answer_nonsense() {
    let params = FieldParams::default();
    let control = Control::default();
    let nonsense = |_: f32| f32::NAN;
    let field =
        direction_field_with(&graph(), PICTURE, BASE, &params, &nonsense, &control).unwrap();
    assert!(field.vectors().iter().all(|vector| (vector.length() - 1.0).abs() < 1e-4));
}

#[test]
fn arrows_are_drawn_over_pictures() {
    let photo = crate::particle::Photo::new(80, 100, vec![[0, 0, 0, 255]; 8000]).unwrap();
    let drawn = field(Blend::default()).draw_over(&photo, [255; 4]).unwrap();
    assert_ne!(photo, drawn);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// With h = 1 the field points at the nearest point, which brute force finds too.
    #[test]
    fn the_nearest_point_is_that_of_brute_force(
        points in prop::collection::vec((0.0_f32..80.0, 0.0_f32..100.0, 0_u32..9), 2..30),
        rows in 3_u32..40,
    ) {
        let nodes: Vec<Vec2> = points.iter().map(|p| Vec2::new(p.0, p.1)).collect();
        let parents =
            (0..nodes.len() as u32).map(|i| if i == 0 { NO_PARENT } else { points[i as usize].2 % i });
        let graph = AttractorGraph::new(nodes, parents.collect()).unwrap();
        let params = FieldParams {
            rows,
            margin: 0.0,
            blend: Blend::Custom(vec![(0.0, 1.0)]),
        };
        let base = graph.nodes()[0];
        let control = Control::default();
        let field = direction_field(&graph, PICTURE, base, &params, &control).unwrap();
        let nx = field.size()[0] as usize;
        for (i, vector) in field.vectors().iter().enumerate() {
            let center = Vec2::new((i % nx) as f32 + 0.5, (i / nx) as f32 + 0.5) * field.cell();
            let (mut best, mut second) = ((f32::INFINITY, Vec2::ZERO), f32::INFINITY);
            for (a, b) in graph.segments() {
                let t = (center - a).dot(b - a) / (b - a).length_squared().max(1e-30);
                let to = a.lerp(b, t.clamp(0.0, 1.0));
                let distance = to.distance(center);
                if distance < best.0 {
                    if to.distance(best.1) > 1e-2 { second = best.0; }
                    best = (distance, to);
                } else if to.distance(best.1) > 1e-2 {
                    second = second.min(distance);
                }
            }
            // Where two points are as near, either is right.
            if best.0 > 0.1 && second - best.0 > 1e-2 {
                let wanted = (best.1 - center).normalize() * Vec2::new(1.0, -1.0);
                prop_assert!(wanted.dot(*vector) > 0.999, "{wanted} {vector} at {center}");
            }
        }
    }
}
