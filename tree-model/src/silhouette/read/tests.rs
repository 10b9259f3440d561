use super::*;
use crate::error::ModelError;
use crate::particle::{Matte, Photo};
use crate::silhouette::{Outline, OutlineParams};
use proptest::prelude::*;

/// A tree: a trunk from y = 30 to 100, a round crown above.
fn covers(p: Vec2) -> bool {
    let trunk = p.y > 30.0 && p.y < 100.0 && (p.x - 50.0).abs() < 4.0;
    trunk || p.distance(Vec2::new(50.0, 35.0)) < 30.0
}

fn matte(covers: impl Fn(Vec2) -> bool) -> Matte {
    let alpha = (0..110 * 100).map(|i| {
        let p = Vec2::new((i % 100) as f32 + 0.5, (i / 100) as f32 + 0.5);
        f32::from(u8::from(covers(p)))
    });
    Matte::new(100, 110, alpha.collect()).unwrap()
}

fn of_kind(tree: &TreeStrokes, kind: Kind) -> Vec<&LevelStroke> {
    tree.strokes.iter().filter(|stroke| stroke.kind == kind).collect()
}

/// The area of a stroke, closed as an outline.
fn area(stroke: &LevelStroke) -> f32 {
    let up: Vec<Vec2> = stroke.points.iter().map(|p| *p * Vec2::new(1.0, -1.0)).collect();
    Outline::close(&up, &stroke.name, &OutlineParams::default()).unwrap().0.area()
}

#[test]
fn a_mask_becomes_a_trunk_and_a_crown() {
    let drawing = from_mask(&matte(covers), 0.5).unwrap();
    let tree = &drawing.trees[0];
    let trunk = &of_kind(tree, Kind::Axis)[0].points;
    assert!(trunk[0].distance(Vec2::new(50.0, 100.0)) < 1.5, "{trunk:?}");
    assert!(trunk.last().unwrap().distance(Vec2::new(50.0, 64.0)) < 3.0, "{trunk:?}");
    assert!((tree.trunk_width.unwrap() - 8.0).abs() < 1.1);
    assert!((area(of_kind(tree, Kind::Outline)[0]) / 2827.0 - 1.0).abs() < 0.03);
}

#[test]
fn a_crown_without_a_trunk_is_all_crown() {
    let bush = matte(|p| p.distance(Vec2::splat(50.0)) < 40.0);
    let drawing = from_mask(&bush, 0.5).unwrap();
    assert_eq!(drawing.trees[0].strokes.len(), 1);
    assert!(drawing.repairs.contains(&ReadRepair::NoTrunk));
    // Pointed below, too.
    let leaf = matte(|p| (p.x - 50.0).abs() / 30.0 + (p.y - 50.0).abs() / 45.0 < 1.0);
    assert!(from_mask(&leaf, 0.5).unwrap().repairs.contains(&ReadRepair::NoTrunk));
}

#[test]
fn a_frayed_crown_gets_an_outline_that_can_be_drawn() {
    // Every third line of the crown only.
    let frayed = matte(|p| covers(p) && (p.y > 66.0 || p.x as i32 % 3 == 0));
    let drawing = from_mask(&frayed, 0.5).unwrap();
    let crown = of_kind(&drawing.trees[0], Kind::Outline)[0];
    assert!(crown.points.len() <= 200, "{}", crown.points.len());
    assert!((area(crown) / 2827.0 - 1.0).abs() < 0.1, "{}", area(crown));
}

#[test]
fn masks_of_either_colour_and_alpha_are_the_same() {
    let mask = matte(covers);
    let photo = |pixel: fn(u8) -> [u8; 4]| {
        let pixels = mask.alpha().iter().map(|&a| pixel((255.0 * a) as u8)).collect();
        Photo::new(mask.width(), mask.height(), pixels).unwrap()
    };
    for pixel in [|a| [255 - a, 255 - a, 255 - a, 255], |a| [a, a, a, 255], |a| [9, 99, 9, a]]
        as [fn(u8) -> _; 3]
    {
        assert_eq!(matte_of(&photo(pixel)).unwrap(), mask);
    }
    assert_eq!(from_photo(&photo(|a| [0, 0, 0, a])).unwrap(), from_mask(&mask, 0.5).unwrap());
}

#[test]
fn empty_pictures_and_bad_thresholds_are_refused() {
    let empty = Matte::new(3, 3, vec![0.0; 9]).unwrap();
    assert!(matches!(from_mask(&empty, 0.5), Err(ModelError::Silhouette { .. })));
    for threshold in [0.0, 2.0, f32::NAN] {
        assert!(matches!(from_mask(&empty, threshold), Err(ModelError::Parameter(_))));
    }
    let dot = Matte::new(1, 1, vec![1.0]).unwrap();
    assert!(matches!(from_mask(&dot, 0.5), Err(ModelError::Silhouette { .. })));
    let full = Matte::new(9, 9, vec![1.0; 81]).unwrap();
    assert_eq!(from_mask(&full, 0.5).unwrap().trees.len(), 1);
}

#[cfg(feature = "svg")]
mod drawings {
    use super::*;

    fn read(body: &str) -> OutlineDrawing {
        from_svg(&format!("<svg xmlns='http://www.w3.org/2000/svg'>{body}</svg>")).unwrap()
    }

    /// Level, kind and degrees of each stroke.
    fn kinds(tree: &TreeStrokes) -> Vec<(String, Kind, f32)> {
        let degrees = |stroke: &LevelStroke| stroke.azimuth.to_degrees().round();
        tree.strokes.iter().map(|s| (s.level.to_string(), s.kind, degrees(s))).collect()
    }

    const LINE: &str = "<path d='M5 9V0' stroke='red' fill='none'/>";
    const LOOP: &str = "<path d='M0 0H9V9H0z' stroke='red' fill='none'/>";

    #[test]
    fn layers_say_level_kind_and_plane() {
        let drawing = read(&format!(
            "<g id='l0'>{LINE}{LOOP}</g><g class='L0@90'>{LOOP}</g><g id='x'><g id='L1_x40_-45'>{LOOP}\
             {LINE}</g></g><g id='Leaves'>{LOOP}</g>{LOOP}"
        ));
        let wanted = [
            ("L0", Kind::Axis, 0.0),
            ("L0", Kind::Outline, 0.0),
            ("L0", Kind::Outline, 90.0),
            ("L1", Kind::Outline, -45.0),
            ("L1", Kind::Axis, -45.0),
            ("leaf", Kind::Outline, 0.0),
        ];
        let wanted: Vec<_> = wanted.map(|(l, k, a)| (l.to_string(), k, a)).into();
        assert_eq!(kinds(&drawing.trees[0]), wanted);
        assert_eq!(drawing.repairs, [ReadRepair::StrayShapes { count: 1 }]);
    }

    #[test]
    fn words_in_the_first_layer_outweigh_how_it_is_drawn() {
        let open = "<path id='crown' d='M0 0V9H9' stroke='red' fill='none'/>";
        let filled = "<path id='trunk' d='M4 0H6V40H4z'/>";
        let drawing = read(&format!("<g id='L0'>{open}{filled}</g>"));
        let tree = &drawing.trees[0];
        assert_eq!((tree.strokes[0].kind, tree.strokes[1].kind), (Kind::Outline, Kind::Axis));
        assert_eq!(drawing.repairs, [ReadRepair::TrunkThinned { tree: String::new() }]);
        assert!((tree.trunk_width.unwrap() - 2.0).abs() < 0.2);
        assert!(tree.strokes[1].points.iter().all(|p| (p.x - 5.0).abs() < 0.2));
    }

    #[test]
    fn groups_of_trees_are_a_stand() {
        let drawing = read(&format!(
            "<g id='tree-oak'><g id='L0'>{LINE}{LOOP}</g></g><g id='tree2'><g id='L0'>{LOOP}</g></g>"
        ));
        let names: Vec<_> = drawing.trees.iter().map(|t| (&t.name[..], t.strokes.len())).collect();
        assert_eq!(names, [("tree-oak", 2), ("tree2", 1)]);
    }

    const TREE: &str = "<path d='M46 100V60H54V100z'/><circle cx='50' cy='35' r='30'/>";

    #[test]
    fn a_silhouette_without_layers_becomes_trunk_and_crown() {
        let drawing = read(TREE);
        let tree = &drawing.trees[0];
        assert_eq!((tree.strokes[0].kind, tree.strokes[1].kind), (Kind::Axis, Kind::Outline));
        assert!((area(&tree.strokes[1]) / 2827.0 - 1.0).abs() < 0.01);
        assert!(tree.strokes[0].points[0].distance(Vec2::new(50.0, 100.0)) < 0.5);
    }

    #[test]
    fn holes_highlights_and_far_parts_are_told_of() {
        let drawing = read(&format!(
            "{TREE}<circle cx='50' cy='35' r='9' fill='white'/><circle cx='200' cy='35' r='5'/>"
        ));
        assert!((area(&drawing.trees[0].strokes[1]) / 2827.0 - 1.0).abs() < 0.02);
        let has = |wanted: fn(&ReadRepair) -> bool| drawing.repairs.iter().any(wanted);
        assert!(has(|repair| matches!(repair, ReadRepair::HolesFilled { .. })));
        assert!(has(|repair| matches!(repair, ReadRepair::PartsDropped { count: 1, .. })));
    }

    #[test]
    fn brown_below_green_is_the_trunk_however_thick() {
        let drawing = read(
            "<path fill='#662113' d='M35 100V60H65V100z'/><circle fill='green' cx='50' cy='35' r='30'/>",
        );
        let trunk = &drawing.trees[0].strokes[0];
        assert_eq!((trunk.kind, &trunk.name[..]), (Kind::Axis, "trunk"));
    }

    #[test]
    fn what_draws_no_tree_is_an_error() {
        for text in ["", "<svg", "<svg xmlns='http://www.w3.org/2000/svg'/>"] {
            assert!(matches!(from_svg(text), Err(ModelError::Svg(_))), "{text}");
        }
        let line = format!("<svg xmlns='http://www.w3.org/2000/svg'>{LINE}</svg>");
        assert!(matches!(from_svg(&line), Err(ModelError::Silhouette { .. })));
    }

    /// Trunk or none, in the files of shared data that are trees of their own.
    #[test]
    fn shared_silhouettes_become_outlines() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/data/silhouettes");
        let folder = [folder, "/work/shared/data/silhouettes"]
            .into_iter()
            .find(|f| std::fs::exists(f).unwrap_or(false));
        let Some(folder) = folder else {
            println!("shared/data/silhouettes is absent: nothing tested");
            return;
        };
        for name in [
            "fontawesome_tree",
            "gameicons_oak",
            "gameicons_palm-tree",
            "gameicons_willow-tree",
            "twemoji_1f333",
        ] {
            let text = std::fs::read_to_string(format!("{folder}/{name}.svg")).unwrap();
            let tree = &from_svg(&text).unwrap().trees[0];
            assert_eq!(tree.strokes.len(), 2, "{name} has a trunk and a crown");
            assert!(tree.strokes[1].points.len() <= 400 && area(&tree.strokes[1]) > 0.0);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn no_names_and_paths_panic(
            name in "[Ll0-9@_x.é -]{0,8}",
            path in "M[0-9 ,.MLHVz-]{0,40}",
            fill in "none|red|white|green",
        ) {
            let shape = format!("<path d='{path}' fill='{fill}' stroke='red'/>");
            let _ = from_svg(&format!(
                "<svg xmlns='http://www.w3.org/2000/svg'><g id='{name}'>{shape}</g>{shape}</svg>"
            ));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn no_mask_panics(width in 1_u32..30, cells in prop::collection::vec(0.0_f32..1.0, 1..200)) {
        let height = cells.len() as u32 / width;
        let alpha = cells[..(width * height) as usize].to_vec();
        if let Ok(matte) = Matte::new(width, height, alpha) {
            let drawing = from_mask(&matte, 0.5);
            prop_assert!(drawing.is_err() || !drawing.unwrap().trees[0].strokes.is_empty());
        }
    }
}
