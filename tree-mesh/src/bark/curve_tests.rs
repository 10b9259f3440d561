use super::*;
use crate::ErrorBound;

fn drawn(points: &[Vec3], radius: f32, fit: CurveFit) -> Drawing {
    let mut drawing = Drawing::default();
    drawing.raw.extend(points.iter().map(|&position| Station { position, radius, along: 0.0 }));
    let params = MeshParams { fit, error: ErrorBound::Metres(0.005), ..Default::default() };
    if !drawing.draw(&params) {
        drawing.nodes.clear();
    }
    carry(&drawing.nodes, &mut drawing.frames, Vec3::X);
    drawing
}

fn curve(drawing: &Drawing, fit: CurveFit) -> Curve<'_> {
    Curve {
        nodes: &drawing.nodes,
        slopes: &drawing.slopes,
        frames: &drawing.frames,
        fit,
        pointed: drawing.pointed,
    }
}

const ZIGZAG: [Vec3; 6] = [
    Vec3::new(0.0, 0.0, 0.0),
    Vec3::new(0.3, 1.0, 0.1),
    Vec3::new(0.0, 1.4, 0.3),
    Vec3::new(0.2, 3.0, 0.0),
    Vec3::new(0.0, 3.3, -0.4),
    Vec3::new(-0.3, 4.0, 0.0),
];

#[test]
fn the_spline_through_passes_through_every_node_with_one_curvature() {
    let drawing = drawn(&ZIGZAG, 0.01, CurveFit::Through);
    let curve = curve(&drawing, CurveFit::Through);
    for (node, point) in curve.nodes.iter().zip(ZIGZAG) {
        assert!(curve.at(node.along).station.position.distance(point) < 1e-5);
    }
    // Second differences on both sides of an inner node agree.
    let h = 0.02;
    for node in &curve.nodes[1..5] {
        let at = |along: f32| curve.at(along).station.position.as_dvec3();
        let second = |a: f32| (at(a - h) - 2.0 * at(a) + at(a + h)) / f64::from(h * h);
        let (below, above) = (second(node.along - h), second(node.along + h));
        let scale = below.length().max(above.length()).max(1.0);
        assert!(below.distance(above) / scale < 0.25, "{below} {above}");
    }
}

#[test]
fn the_spline_near_starts_and_ends_on_its_nodes_and_stays_between_them() {
    let drawing = drawn(&ZIGZAG, 0.01, CurveFit::Near);
    let curve = curve(&drawing, CurveFit::Near);
    assert_eq!(curve.at(0.0).station.position, ZIGZAG[0]);
    assert!(curve.at(curve.length()).station.position.distance(ZIGZAG[5]) < 1e-6);
    let bounds = tree_core::Aabb::of_points(&ZIGZAG);
    for i in 0..=100 {
        let at = curve.at(curve.length() * i as f32 / 100.0).station.position;
        assert!(at.clamp(bounds.min, bounds.max).distance(at) < 0.02, "{at}");
    }
    // The middle node of a corner is cut: two thirds of it and a sixth of each neighbour.
    let expected = (ZIGZAG[0] + 4.0 * ZIGZAG[1] + ZIGZAG[2]) / 6.0;
    assert!(curve.at(curve.nodes[1].along).station.position.distance(expected) < 1e-5);
}

#[test]
fn tangents_point_where_the_line_goes() {
    for fit in [CurveFit::Through, CurveFit::Near] {
        let drawing = drawn(&ZIGZAG, 0.01, fit);
        let curve = curve(&drawing, fit);
        for i in 1..40 {
            let along = curve.length() * i as f32 / 40.0;
            let step =
                curve.at(along + 1e-3).station.position - curve.at(along - 1e-3).station.position;
            assert!(curve.at(along).tangent.dot(step.normalize()) > 0.98, "{fit:?} {along}");
        }
    }
}

#[test]
fn frames_turn_with_the_line_and_never_about_it() {
    let drawing = drawn(&ZIGZAG, 0.01, CurveFit::Through);
    let curve = curve(&drawing, CurveFit::Through);
    let mut last = None;
    for i in 0..=400 {
        let place = curve.at(curve.length() * i as f32 / 400.0);
        let normal = curve.frame(&place.station, place.tangent).normal;
        if let Some(before) = last {
            assert!(normal.distance(before) < 0.1, "a jump at {}", place.station.along);
        }
        last = Some(normal);
    }
}

#[test]
fn pieces_keep_chords_near_the_line() {
    let (fit, error) = (CurveFit::Through, 0.002);
    let drawing = drawn(&ZIGZAG, 0.001, fit);
    let curve = curve(&drawing, fit);
    for i in 0..curve.nodes.len() - 1 {
        let (a, b) = (curve.nodes[i].along, curve.nodes[i + 1].along);
        let n = curve.n_pieces(i, error);
        let at = |share: f32| curve.at(a + (b - a) * share).station.position;
        for k in 0..n {
            let (from, to) = (at(k as f32 / n as f32), at((k + 1) as f32 / n as f32));
            for step in 1..8 {
                let point = at((k as f32 + step as f32 / 8.0) / n as f32);
                let t =
                    ((point - from).dot(to - from) / (to - from).length_squared()).clamp(0.0, 1.0);
                let off = point.distance(from.lerp(to, t));
                assert!(off < 1.05 * error || n == PIECES_MAX, "{off} in segment {i}");
            }
        }
    }
}

#[test]
fn nodes_without_length_are_dropped_and_counted() {
    let up = |h: f32| Vec3::Y * h;
    let found = drawn(&[up(0.0), up(0.0), up(1.0), up(1.0), up(1.004)], 0.1, CurveFit::Through);
    assert_eq!((found.nodes.len(), found.n_dropped), (2, 3));
    assert_eq!(found.nodes[1].position.y, 1.004, "the tip stays");
    assert_eq!(found.kept, [0, 0, 1, 1, 1]);
    assert!(drawn(&[up(2.0), up(2.0)], 0.1, CurveFit::Through).nodes.is_empty());
    assert!(drawn(&[up(2.0)], 0.1, CurveFit::Through).nodes.is_empty());
}
