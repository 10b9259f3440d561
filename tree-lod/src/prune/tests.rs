//! A small tree: a surface of wood, and two of leaves that are fans of triangles.

use super::*;
use crate::LodError;
use crate::element::{Elements, LeafSurfaces};
use crate::order::Ranking;
use crate::outline::Tier;
use crate::quality::{Distance, Row, Subject, Table};
use glam::{Vec2, Vec3};
use proptest::prelude::*;
use tree_core::{Control, Limits};
use tree_mesh::{Material, Mesh, Surface};

/// What a model is made of.
#[derive(Clone, Debug)]
struct Case {
    mesh: Mesh,
    elements: Elements,
    tiers: Vec<Tier>,
    order: Vec<u32>,
    kept: Vec<u32>,
}

/// Leaves by their surface (1 or 2) and their triangles in each tier. `joined`: the leaves of a surface
/// have their first vertex in common.
fn case(leaves: &[(u32, [u32; 3])], n_tiers: usize, joined: bool) -> Case {
    let mut mesh = Mesh { materials: vec![Material::default()], ..Mesh::default() };
    mesh.surfaces = vec![Surface::default(); 3];
    for surface in &mut mesh.surfaces {
        fan(surface, Vec3::NEG_ONE, 2, None);
    }
    mesh.surfaces[1].indices.clear();
    mesh.surfaces[2].indices.clear();
    let empty = Tier { starts: vec![0], triangles: Vec::new() };
    let mut tiers = vec![empty; n_tiers];
    let mut elements = Elements { surfaces: vec![1, 2], starts: vec![0], ..Elements::default() };
    for (element, &(number, costs)) in leaves.iter().enumerate() {
        let surface = &mut mesh.surfaces[number as usize];
        let row = surface.n_triangles() as u32;
        let center = Vec3::new(10.0 * element as f32, 3.0, 1.0);
        let triangles = fan(surface, center, costs[0], joined.then_some(0));
        for (tier, &cost) in tiers.iter_mut().zip(&costs) {
            tier.triangles.extend(&triangles[..cost as usize]);
            tier.starts.push(tier.triangles.len() as u32);
        }
        elements.surface.push(number);
        elements.triangles.extend(row..row + costs[0]);
        elements.starts.push(elements.triangles.len() as u32);
        elements.centers.push(center);
    }
    let order = (0..leaves.len() as u32).rev().collect();
    Case { mesh, elements, tiers, order, kept: Vec::new() }
}

fn fan(surface: &mut Surface, center: Vec3, n: u32, first: Option<u32>) -> Vec<[u32; 3]> {
    let mut vertex = |p: Vec3| {
        surface.positions.push(p);
        surface.normals.push(Vec3::Z);
        surface.uvs.push(Vec2::ZERO);
        surface.positions.len() as u32 - 1
    };
    let first = first.unwrap_or_else(|| vertex(center - Vec3::X));
    let rim: Vec<_> =
        (0..=n).map(|i| vertex(center + Vec3::new(1.0, i as f32 - 1.0, (i * i) as f32))).collect();
    let triangles: Vec<_> = rim.windows(2).map(|pair| [first, pair[0], pair[1]]).collect();
    surface.indices.extend(triangles.as_flattened());
    triangles
}

fn table() -> Table {
    let row = |lambda: f32| Row { lambda, scale: 1.0 / lambda, ..Row::default() };
    Table::new(vec![row(0.05), row(0.2), row(0.5), row(1.0)]).unwrap()
}

fn built_with(
    case: &Case,
    params: PruneParams,
    control: &Control,
) -> Result<PrunedModel, LodError> {
    let Case { mesh, elements, tiers, order, kept } = case;
    let ranking = Ranking { order: order.clone(), pivots: elements.centers.clone() };
    let subject = Subject { mesh, elements, tiers, ranking: &ranking, kept };
    PrunedModel::new(&subject, table(), &params, control)
}

fn built(case: &Case) -> PrunedModel {
    built_with(case, PruneParams::default(), &Control::default()).unwrap()
}

/// Corners of triangles, sorted, in a form that can be compared.
fn sorted(triangles: impl Iterator<Item = [Vec3; 3]>) -> Vec<[[u32; 3]; 3]> {
    let bits = |p: Vec3| p.to_array().map(f32::to_bits);
    let mut all: Vec<_> = triangles.map(|triangle| triangle.map(bits)).collect();
    all.sort_unstable();
    all
}

fn corners(surface: &Surface) -> impl Iterator<Item = [Vec3; 3]> {
    let (triangles, _) = surface.indices.as_chunks::<3>();
    triangles.iter().map(|triangle| triangle.map(|v| surface.positions[v as usize]))
}

/// Corners of what a cut draws of a surface, found the slow way.
fn expected(case: &Case, cut: &Cut, number: u32) -> Vec<[[u32; 3]; 3]> {
    let positions = &case.mesh.surfaces[number as usize].positions;
    let ranks = (0_u32..).zip(&case.order).take(cut.end as usize);
    sorted(ranks.filter(|&(_, &e)| case.elements.surface[e as usize] == number).flat_map(
        |(rank, &element)| {
            let tier = cut.tier as usize + usize::from(rank >= cut.fine);
            let triangles = case.tiers[tier].of(element as usize).iter();
            triangles.map(|triangle| triangle.map(|v| positions[v as usize]))
        },
    ))
}

fn cases() -> impl Strategy<Value = Case> {
    let leaf = (1_u32..3, 0_u32..4, 0_u32..4, 1_u32..4);
    let leaves = prop::collection::vec(leaf, 1..20);
    (leaves, 1_usize..4, any::<bool>()).prop_flat_map(|(leaves, n_tiers, joined)| {
        let cost = |&(s, a, b, c): &(u32, u32, u32, u32)| (s, [a + b + c, b + c, c]);
        let leaves: Vec<_> = leaves.iter().map(cost).collect();
        let case = case(&leaves, n_tiers, joined);
        let order = Just(case.order.clone()).prop_shuffle();
        let kept = prop::collection::vec(0.0_f32..1.0, n_tiers - 1);
        (Just(case), order, kept).prop_map(|(case, order, shares)| {
            let mut kept = vec![order.len() as u32];
            for share in shares {
                let most = kept.last().copied().unwrap_or(1);
                kept.push(((most as f32 * share) as u32).max(1));
            }
            Case { order, kept, ..case }
        })
    })
}

proptest! {
    #[test]
    fn a_window_draws_each_element_once_and_in_its_tier(case in cases()) {
        let model = built(&case);
        for step in 0..model.schedule.n_steps() {
            let cut = model.schedule.cut(step);
            let mut n = 0;
            for part in &model.parts {
                let window = part.layout.window(&cut);
                n += u64::from(window.end - window.start);
                let surface = &model.mesh.surfaces[part.surface as usize];
                let all: Vec<_> = corners(surface).collect();
                let drawn = all[window.start as usize..window.end as usize].iter().copied();
                prop_assert_eq!(sorted(drawn), expected(&case, &cut, part.surface));
            }
            prop_assert_eq!(n, cut.n_triangles);
        }
    }

    #[test]
    fn windows_only_move_on_as_geometry_falls(case in cases()) {
        let model = built(&case);
        for part in &model.parts {
            let windows = (0..model.schedule.n_steps())
                .map(|step| part.layout.window(&model.schedule.cut(step)));
            let windows: Vec<_> = windows.collect();
            for pair in windows.windows(2) {
                let (a, b) = (&pair[0], &pair[1]);
                prop_assert!(b.start <= a.start && b.end <= a.end, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn the_full_level_is_the_mesh_that_came_in(case in cases()) {
        let full = built(&case).mesh_at(1.0).unwrap();
        full.check().unwrap();
        prop_assert_eq!(full.surfaces.len(), case.mesh.surfaces.len());
        prop_assert_eq!(&full.surfaces[0], &case.mesh.surfaces[0]);
        for (a, b) in full.surfaces.iter().zip(&case.mesh.surfaces) {
            prop_assert_eq!(sorted(corners(a)), sorted(corners(b)));
        }
    }

    #[test]
    fn every_vertex_belongs_to_one_element(case in cases()) {
        let model = built(&case);
        model.mesh.check().unwrap();
        for part in &model.parts {
            let surface = &model.mesh.surfaces[part.surface as usize];
            prop_assert_eq!(part.centers.len(), surface.positions.len());
            let (triangles, _) = surface.indices.as_chunks::<3>();
            for triangle in triangles {
                let [a, b, c] = triangle.map(|v| part.centers[v as usize]);
                prop_assert!(a == b && b == c);
            }
        }
    }

    #[test]
    fn a_level_as_a_mesh_is_what_the_shader_draws(case in cases(), lambda in 0.0_f32..=1.0) {
        let model = built(&case);
        let level = model.level(lambda).unwrap();
        let mesh = model.mesh_of(&level).unwrap();
        mesh.check().unwrap();
        for (part, window) in model.parts.iter().zip(&level.windows) {
            let surface = &model.mesh.surfaces[part.surface as usize];
            let range = window.first_index as usize..(window.first_index + window.index_count) as usize;
            let shaded = surface.indices[range].iter().map(|&v| {
                let (p, center) = (surface.positions[v as usize], part.centers[v as usize]);
                position(p, center, level.growth, level.lambda, level.fade)
            });
            let baked = &mesh.surfaces[part.surface as usize];
            let baked = baked.indices.iter().map(|&v| baked.positions[v as usize]);
            prop_assert!(shaded.eq(baked));
        }
    }

    #[test]
    fn something_is_always_seen(case in cases(), lambda in 0.0_f32..=1.0) {
        let model = built(&case);
        let mesh = model.mesh_of(&model.level(lambda).unwrap()).unwrap();
        let foliage = mesh.surfaces[1..].iter().flat_map(corners);
        let area: f32 = foliage.map(|[a, b, c]| (b - a).cross(c - a).length()).sum();
        prop_assert!(area > 0.1);
    }
}

/// Cards of two triangles in surface 1.
fn cards(n: usize) -> Case {
    case(&vec![(1, [2, 2, 2]); n], 1, false)
}

#[test]
fn the_budget_is_met() {
    let leaves: Vec<_> = (0..600).map(|i| (1 + i % 2, [6 + i % 5, 4, 2])).collect();
    let model = built(&case(&leaves, 3, false));
    for i in 5..=100 {
        let wanted = f64::from(i) / 100.0 * model.schedule.n_triangles() as f64;
        let found = model.level(i as f32 / 100.0).unwrap().n_triangles as f64;
        assert!(found <= wanted + 1e-3 && found >= 0.98 * wanted, "{i} %: {found} of {wanted}");
    }
}

#[test]
fn elements_begin_to_be_drawn_without_size() {
    let model = built(&cards(50));
    let sizes = |lambda: f32| {
        let mesh = model.mesh_of(&model.level(lambda).unwrap()).unwrap();
        let size = |[a, b, c]: [Vec3; 3]| (b - a).cross(c - a).length();
        corners(&mesh.surfaces[1]).map(size).collect::<Vec<_>>()
    };
    let scale = model.table.at(0.5).scale;
    let at_half = sizes(0.5);
    assert_eq!(at_half.len(), 50);
    assert_eq!(at_half[49], 0.0);
    let full = sizes(1.0);
    assert!((at_half[0] / full[0] - scale).abs() < 1e-4, "{}", at_half[0]);
    assert!(full.iter().skip(2).step_by(2).all(|size| (size / full[0] - 1.0).abs() < 1e-4));
}

#[test]
fn nothing_jumps_between_neighbouring_shares() {
    let model = built(&cards(400));
    let area = |lambda: f32| {
        let mesh = model.mesh_of(&model.level(lambda).unwrap()).unwrap();
        let size = |[a, b, c]: [Vec3; 3]| f64::from((b - a).cross(c - a).length());
        corners(&mesh.surfaces[1]).map(size).sum::<f64>()
    };
    let mut last = area(1.0);
    for step in (40..1000).rev() {
        let next = area(step as f32 / 1000.0);
        assert!((next / last - 1.0).abs() < 0.03, "{step}: {last} {next}");
        last = next;
    }
}

#[test]
fn parts_that_do_not_change_are_stored_once() {
    let leaves = [(1, [4, 4, 4]), (1, [2, 2, 2]), (2, [4, 2, 1])];
    let model = built(&case(&leaves, 3, false));
    let n = |part: usize| model.mesh.surfaces[part].n_triangles();
    assert_eq!((n(1), n(2)), (6, 7));
    let sizes = model.sizes();
    assert_eq!((sizes.indices_before, sizes.indices_after), (4 * 3 * 10, 4 * 3 * 13));
    assert!(sizes.vertices_after > sizes.vertices_before);
}

#[test]
fn a_shared_vertex_is_copied_with_all_its_columns() {
    let mut case = case(&[(1, [2, 2, 2]), (1, [2, 2, 2])], 1, true);
    let n = case.mesh.surfaces[1].positions.len();
    let surface = &mut case.mesh.surfaces[1];
    surface.occlusion = (0..n).map(|i| i as f32 / n as f32).collect();
    surface.welds = (0..n as u32).collect();
    surface.anchors = vec![Vec3::ZERO];
    let model = built(&case);
    let pruned = &model.mesh.surfaces[1];
    assert_eq!(pruned.positions.len(), n + 1);
    assert_eq!(
        (pruned.positions[n], pruned.occlusion[n], pruned.welds[n]),
        (pruned.positions[0], 0.0, 0)
    );
    assert!(pruned.anchors.is_empty());
    assert!(tree_mesh::topology::welded(&model.mesh_at(0.5).unwrap().surfaces[1]).is_ok());
}

#[test]
fn levels_rise_to_the_full_model_and_make_a_scene() {
    let model = built(&case(&vec![(2, [8, 4, 2]); 40], 3, false));
    let levels = model.levels(24).unwrap();
    assert_eq!((levels.len(), levels[0].lambda, levels[23].lambda), (24, 0.05, 1.0));
    assert!(levels.windows(2).all(|pair| pair[0].n_triangles <= pair[1].n_triangles));
    let last = &levels[23];
    assert_eq!((last.n_triangles, last.growth, last.fade, last.contrast), (320, 1.0, 0.0, 1.0));
    let scene = model.to_select_model(24, Distance::cook()).unwrap();
    let draws = &scene.levels[23].draws;
    // Wood has two triangles; surface 1 has none; the finest tier comes last.
    let counts: Vec<_> = draws.iter().map(|d| (d.first_index, d.index_count)).collect();
    assert_eq!(counts, [(0, 6), (6, 0), (6 + 3 * 40 * (4 + 2), 960)]);
    let base = model.mesh.surfaces[0].positions.len() + model.mesh.surfaces[1].positions.len();
    assert_eq!(draws[2].base_vertex, base as i32);
    for level in &levels {
        let mesh = model.mesh_of(level).unwrap();
        let points = mesh.surfaces.iter().flat_map(|surface| &surface.positions);
        let far = points.fold(0.0_f32, |far, p| far.max(p.distance(scene.center)));
        assert!(far <= scene.radius * 1.0001);
    }
}

#[test]
fn the_text_of_levels_is_json_with_the_same_numbers() {
    let model = built(&cards(30));
    let levels = model.levels(4).unwrap();
    let json: serde_json::Value = serde_json::from_str(&model.to_json(&levels)).unwrap();
    assert_eq!(json["parts"][0]["surface"], 1);
    assert_eq!(
        (&json["parts"][0]["primitive"], &json["parts"][1]["primitive"]),
        (&1.into(), &serde_json::Value::Null)
    );
    for (row, level) in json["levels"].as_array().unwrap().iter().zip(&levels) {
        assert_eq!(row["lambda"].as_f64().unwrap() as f32, level.lambda);
        assert_eq!(row["windows"][0]["index_count"], level.windows[0].index_count);
    }
    assert_eq!(json["table"].as_array().unwrap().len(), 4);
}

#[test]
fn what_does_not_fit_the_mesh_is_refused() {
    let good = case(&[(1, [2, 2, 2]), (2, [2, 2, 2])], 1, false);
    let refused = |change: &dyn Fn(&mut Case)| {
        let mut bad = good.clone();
        change(&mut bad);
        let found = built_with(&bad, PruneParams::default(), &Control::default());
        found.expect_err("should not be taken").to_string()
    };
    let found = [
        refused(&|c| c.order[0] = 0),
        refused(&|c| c.order.truncate(1)),
        refused(&|c| c.tiers.clear()),
        refused(&|c| c.elements.surface.truncate(1)),
        refused(&|c| c.elements.surface[0] = 0),
        refused(&|c| c.elements.surfaces = vec![1, 7]),
        refused(&|c| c.elements.centers[1].y = f32::NAN),
        refused(&|c| c.elements.centers[1].y = 1e30),
        refused(&|c| c.elements.centers.truncate(1)),
        refused(&|c| c.tiers[0].triangles[1][2] = 99),
        refused(&|c| c.mesh.surfaces[1].positions[0].x = f32::INFINITY),
        refused(&|c| c.mesh.surfaces[1].positions[0].x = 1e30),
    ];
    for (found, wanted) in found.iter().zip([
        "order, row 1",
        "order, row 1",
        "no tiers",
        "elements has 1",
        "not foliage",
        "surfaces of elements",
        "pivots[1]",
        "pivots",
        "pivots has 1",
        "vertex 99",
        "positions[0]",
        "positions",
    ]) {
        assert!(found.contains(wanted), "{found}: {wanted}");
    }
}

#[test]
fn a_mesh_becomes_a_pruned_model_in_one_call() {
    let mesh = case(&[(1, [8, 8, 8]); 30], 1, false).mesh;
    let params = MakeParams { foliage: LeafSurfaces::Surfaces(vec![1]), ..MakeParams::default() };
    let model = PrunedModel::make(&mesh, &params, &Control::default()).unwrap();
    assert_eq!(model.level(1.0).unwrap().n_triangles, 240);
    let found = model.level(0.3).unwrap().n_triangles;
    assert!((60..=72).contains(&found), "{found}");
    let bare = MakeParams { foliage: LeafSurfaces::Surfaces(vec![7]), ..params };
    assert!(PrunedModel::make(&mesh, &bare, &Control::default()).is_err());
}

#[test]
fn bad_numbers_and_strange_levels_are_refused() {
    let model = built(&cards(3));
    for lambda in [-0.1, 1.5, f32::NAN] {
        assert!(
            matches!(model.level(lambda), Err(LodError::Parameter(error)) if error.field == "lambda")
        );
        assert!(model.mesh_at(lambda).is_err());
    }
    for n in [0, 1, 5000] {
        assert!(
            matches!(model.levels(n), Err(LodError::Parameter(error)) if error.field == "levels")
        );
    }
    let other = built(&cards(9)).level(1.0).unwrap();
    assert!(matches!(model.mesh_of(&other), Err(LodError::Foliage(_))));
    let level = model.level(1.0).unwrap();
    assert!(model.mesh_of(&Level { growth: f32::NAN, ..level }).is_err());
    for params in [PruneParams { fade: f32::NAN }, PruneParams { fade: 1.1 }] {
        let found = built_with(&cards(3), params, &Control::default());
        assert!(matches!(found, Err(LodError::Parameter(_))));
    }
    let limits = Limits { triangles: 5, ..Limits::default() };
    let control = Control::default().with_limits(limits);
    let found = built_with(&cards(3), PruneParams::default(), &control);
    assert!(matches!(found, Err(LodError::Limit(_))));
}
