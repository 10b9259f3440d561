use super::*;
use crate::error::ModelError;
use crate::silhouette::plan::{Origin, Plan};
use glam::Vec2;
use std::f32::consts::{FRAC_PI_2, TAU};
use tree_core::{Control, Seed};

/// A crown of seven lobes, 8 m wide, on a trunk of 10 m.
fn crown(lobes: f32) -> Vec<Vec2> {
    (0..160)
        .map(|i| {
            let angle = i as f32 / 160.0 * TAU;
            let radius = 3.4 + 0.6 * libm::cosf(lobes * (angle - FRAC_PI_2));
            let (sin, cos) = libm::sincosf(angle);
            Vec2::new(radius * cos, 6.0 + radius * sin)
        })
        .collect()
}

const TRUNK: [Vec2; 2] = [Vec2::ZERO, Vec2::new(0.0, 8.0)];

fn drawn() -> Session {
    let mut session = Session::new(SilhouetteParams::default(), Seed(1)).unwrap();
    session.draw_trunk(&TRUNK).unwrap();
    session.draw_crown(&crown(7.0)).unwrap();
    session
}

fn plan(session: &Session) -> &Plan {
    session.plan().unwrap()
}

/// An outline about a branch, a little wider than the one inferred.
fn about(session: &Session, id: u32) -> Vec<Vec2> {
    let lateral = plan(session).system.laterals.iter().find(|l| l.id == id).unwrap();
    let middle = lateral.line.at(0.5);
    lateral.outline.points().iter().map(|&p| middle + 1.05 * (p - middle)).collect()
}

#[test]
fn a_crown_and_a_trunk_give_a_branch_for_each_bump() {
    let session = drawn();
    let bumps = plan(&session).system.laterals.iter().filter(|l| l.origin == Origin::Bump);
    // One of the seven points down, at the trunk.
    assert!((6..=7).contains(&bumps.count()));
    assert!(session.coverage().by_all > 0.5);
}

#[test]
fn an_edit_says_what_changed_and_undo_takes_it_back() {
    let mut session = drawn();
    let before = plan(&session).clone();
    let id = before.system.laterals[0].id;
    let change = session.remove(id).unwrap();
    assert_eq!((change.removed.as_slice(), change.added.len()), ([id].as_slice(), 0));
    assert!(!change.trunk && !change.leaf);
    let back = session.undo().unwrap();
    assert_eq!(back.added, [id]);
    assert_eq!(plan(&session), &before);
    assert_eq!(session.redo().unwrap().removed, [id]);
    assert!(session.redo().is_none());
}

#[test]
fn what_fails_changes_nothing() {
    let mut session = drawn();
    let (before, depth) = (plan(&session).clone(), session.depth());
    assert!(session.draw_crown(&[Vec2::ZERO, Vec2::ONE]).is_err());
    assert!(session.remove(4_000_000).is_err());
    assert!(
        session
            .refine(1, &[Vec2::new(90.0, 0.0), Vec2::new(91.0, 0.0), Vec2::new(90.0, 1.0)])
            .is_err()
    );
    assert_eq!((plan(&session), session.depth()), (&before, depth));
}

#[test]
fn a_branch_drawn_over_passes_angle_and_shape_to_its_siblings() {
    let mut session = drawn();
    let source = plan(&session).system.laterals[1].clone();
    let (base, span) = (source.line.start(), source.line.span());
    // The same ends, but sagging.
    let sag = |t: f32| Vec2::new(0.0, -1.2 * t * (1.0 - t));
    let stroke: Vec<Vec2> =
        (0..=12).map(|i| i as f32 / 12.0).map(|t| base + t * span + sag(t)).collect();
    let change = session.redraw(1, &stroke, &Transfer::Siblings).unwrap();
    assert!(change.reshaped.contains(&source.id) && change.reshaped.len() > 3, "{change:?}");
    let system = &plan(&session).system;
    for lateral in system.laterals.iter().filter(|l| l.origin != Origin::Drawn) {
        let along = system.axis.tangent(lateral.t);
        let angle = along.angle_to(lateral.line.foot()).abs();
        let off = (angle - system.angles.at(lateral.t)).abs().to_degrees();
        assert!(off < 1.0, "branch {} leaves {off} degrees off", lateral.id);
    }
    let only = session.undo().and_then(|_| {
        session.redraw(1, &stroke, &Transfer::Nobody).ok().map(|change| change.reshaped)
    });
    assert_eq!(only, Some(vec![source.id]));
}

#[test]
fn the_branch_with_the_most_length_inside_is_refined() {
    let mut session = drawn();
    let id = plan(&session).system.laterals[2].id;
    let outline = about(&session, id);
    let change = session.refine(1, &outline).unwrap();
    assert_eq!(change.restyled, [id]);
    assert!(!change.added.is_empty(), "its own branches");
    let other = plan(&session).system.laterals[0].id;
    assert!(matches!(session.copy_style(Some(other), &[id]), Err(ModelError::Silhouette { .. })));
    let styled = session.copy_style(Some(id), &[other]).unwrap();
    assert_eq!(styled.restyled, [other]);
}

#[test]
fn finer_levels_need_the_coarser_ones() {
    let mut session = drawn();
    let error = session.refine(2, &crown(5.0)).unwrap_err().to_string();
    assert!(error.contains("level 1"), "{error}");
    let mut empty = Session::new(SilhouetteParams::default(), Seed(1)).unwrap();
    assert!(empty.refine(1, &crown(5.0)).is_err());
    assert!(empty.tree(&Control::default()).is_err());
}

#[test]
fn a_trunk_away_from_the_crown_is_refused_and_one_that_nearly_reaches_it_lengthened() {
    let mut session = drawn();
    let far = [Vec2::new(40.0, 0.0), Vec2::new(40.0, 5.0)];
    assert!(session.draw_trunk(&far).unwrap_err().to_string().contains("away from the crown"));
    let change = session.draw_trunk(&[Vec2::ZERO, Vec2::new(0.0, 1.5)]).unwrap();
    assert!(change.repairs.iter().any(|repair| repair.contains("lengthened")));
    let end = plan(&session).system.axis.end();
    assert!(plan(&session).system.outline.contains(end));
}

#[test]
fn a_redrawn_crown_keeps_what_was_drawn_on_its_branches() {
    let mut session = drawn();
    let id = plan(&session).system.laterals[2].id;
    let outline = about(&session, id);
    session.refine(1, &outline).unwrap();
    let wider: Vec<Vec2> = crown(7.0).iter().map(|&p| Vec2::new(1.05 * p.x, p.y)).collect();
    let change = session.draw_crown(&wider).unwrap();
    assert!(change.trunk);
    let kept = plan(&session).system.laterals.iter().find(|lateral| lateral.id == id).unwrap();
    assert!(kept.system.is_some());
}

#[test]
fn a_branch_drawn_from_the_side_stands_there() {
    let mut session = drawn();
    let view = Viewpoint { yaw: FRAC_PI_2, pitch: 0.0 };
    let stroke = [Vec2::new(0.0, 5.0), Vec2::new(1.5, 5.8), Vec2::new(3.0, 6.0)];
    let change = session.redraw_from(view, &stroke, &Transfer::Nobody).unwrap();
    let lateral = plan(&session).system.laterals.iter().find(|l| change.added == [l.id]).unwrap();
    // From the right side of the drawing the viewer has -Z to his right.
    let azimuth = lateral.azimuth.unwrap();
    assert!((azimuth - 1.5 * std::f32::consts::PI).abs() < 1e-3, "{azimuth}");
    let again = session.redraw_from(view, &stroke, &Transfer::Nobody).unwrap();
    assert!(again.added.is_empty(), "the same branch: {again:?}");
}

#[test]
fn bad_strokes_are_refused_or_repaired() {
    let bad = Vec2::new(f32::NAN, 0.0);
    let mut session = drawn();
    for stroke in [vec![], vec![bad; 5], vec![Vec2::ONE; 9], vec![Vec2::MAX, -Vec2::MAX]] {
        assert!(session.draw_crown(&stroke).is_err());
        assert!(session.draw_trunk(&stroke).is_err());
        assert!(session.redraw(1, &stroke, &Transfer::Siblings).is_err());
        assert!(session.draw_leaf(&stroke).is_err());
    }
    let mut holed = crown(7.0);
    holed.insert(3, bad);
    let clockwise: Vec<Vec2> = holed.into_iter().rev().collect();
    let change = session.draw_crown(&clockwise).unwrap();
    assert!(change.repairs.iter().any(|repair| repair.contains("not finite")), "{change:?}");
    let crossed: Vec<Vec2> =
        [(-3.0, 3.0), (3.0, 9.0), (3.0, 3.0), (-3.0, 9.0)].map(|(x, y)| Vec2::new(x, y)).to_vec();
    assert!(session.draw_crown(&crossed).is_ok());
    assert!(session.tree(&Control::default()).is_ok());
}

#[test]
fn parameters_out_of_range_are_named() {
    let mut params = SilhouetteParams { height: -1.0, ..SilhouetteParams::default() };
    assert!(Session::new(params.clone(), Seed(1)).unwrap_err().to_string().contains("height"));
    params.height = 10.0;
    params.grow.fill = 99.0;
    let error = drawn().set_params(params).unwrap_err().to_string();
    assert!(error.contains("grow.fill"), "{error}");
}

#[test]
fn a_drawing_is_played_to_scale_and_what_cannot_be_used_is_told() {
    use crate::Modeler;
    use crate::silhouette::read::{Kind, Level, LevelStroke, TreeStrokes};
    let stroke = |level, kind, points: Vec<Vec2>| LevelStroke {
        level,
        kind,
        azimuth: 0.0,
        points,
        name: String::new(),
    };
    // Drawn in pixels, y down, away from the origin.
    let pixels = |points: &[Vec2]| {
        points.iter().map(|p| Vec2::new(300.0 + 50.0 * p.x, 700.0 - 50.0 * p.y)).collect()
    };
    let strokes = vec![
        stroke(Level::Number(0), Kind::Outline, pixels(&crown(7.0))),
        stroke(Level::Number(0), Kind::Axis, pixels(&TRUNK)),
        stroke(
            Level::Number(1),
            Kind::Outline,
            pixels(&[Vec2::new(90.0, 0.0), Vec2::new(91.0, 0.0), Vec2::new(90.0, 1.0)]),
        ),
    ];
    let model = SilhouetteModel {
        strokes: TreeStrokes { strokes, ..TreeStrokes::default() },
        params: SilhouetteParams { height: 20.0, ..SilhouetteParams::default() },
    };
    let (session, report) =
        Session::of_drawing(&model.strokes, model.params.clone(), Seed(1)).unwrap();
    assert_eq!((report.strokes, report.refused.len()), (2, 1), "{report:?}");
    let axis = &plan(&session).system.axis;
    assert!(axis.start().length() < 1e-3);
    let tree = model.model(Seed(1), &Control::default()).unwrap();
    let top = tree.skeleton().bounds().max.y;
    assert!((15.0..21.0).contains(&top), "{top}");
    let nothing = SilhouetteModel::default().model(Seed(1), &Control::default());
    assert!(matches!(nothing, Err(ModelError::Silhouette { .. })));
}

#[test]
fn a_branch_whose_source_of_style_goes_takes_the_nearest_again() {
    let mut session = drawn();
    let ids: Vec<u32> = plan(&session).system.laterals.iter().map(|l| l.id).collect();
    let outline = about(&session, ids[2]);
    session.refine(1, &outline).unwrap();
    session.copy_style(Some(ids[2]), &[ids[0]]).unwrap();
    let change = session.remove(ids[2]).unwrap();
    assert!(change.restyled.contains(&ids[0]) && change.removed.contains(&ids[2]), "{change:?}");
}

#[test]
fn a_finer_branch_cannot_have_the_style_of_a_coarser_one() {
    let mut session = drawn();
    let id = plan(&session).system.laterals[2].id;
    let outline = about(&session, id);
    let fine = session.refine(1, &outline).unwrap().added[0];
    let error = session.copy_style(Some(id), &[fine]).unwrap_err().to_string();
    assert!(error.contains("coarser"), "{error}");
}
