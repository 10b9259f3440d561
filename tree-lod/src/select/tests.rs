use super::*;
use crate::error::LodError;
use glam::camera::rh::proj::directx::{orthographic, perspective, perspective_infinite_reverse};
use glam::camera::rh::view::look_at_mat4;
use glam::{Mat4, Vec3, Vec4};
use proptest::prelude::*;
use tree_core::Control;

const SIZE: (u32, u32) = (64, 36);
const ASPECT: f32 = 16.0 / 9.0;

/// A ball of 2 m with 16 points on it, a trunk that is always drawn, and 32 levels of leaves.
pub(super) fn model() -> Model {
    let golden = 2.399_963_2;
    let sample = |i: usize| {
        let y = 1.0 - (2 * i + 1) as f32 / 16.0;
        let (sin, cos) = libm::sincosf(golden * i as f32);
        let ring = (1.0 - y * y).sqrt();
        2.0 * Vec3::new(ring * cos, y, ring * sin)
    };
    let level = |i: u32| {
        let wood = Draw { first_index: 0, index_count: 30, base_vertex: 0 };
        let leaves = Draw { first_index: 30, index_count: 3 * i, base_vertex: 7 };
        let lambda = i as f32 / 128.0;
        let fade = (0.1 * lambda).min(1.0 - lambda);
        Level { lambda, scale: 1.0 / lambda, fade, draws: vec![wood, leaves] }
    };
    Model {
        radius: 2.0,
        samples: (0..16).map(sample).collect(),
        occluders: vec![Occluder { center: Vec3::ZERO, radii: Vec3::splat(1.8) }],
        near: 5.0,
        far: 400.0,
        levels: (1..=128).map(level).collect(),
        ..Model::default()
    }
}

pub(super) fn at(position: Vec3) -> Instance {
    Instance { position, ..Instance::default() }
}

pub(super) fn scene(instances: &[Instance]) -> Scene {
    Scene::new(&[model()], instances, &Control::default()).unwrap()
}

/// From the origin along −Z.
fn projected(projection: Mat4) -> Eye {
    Eye { view: look_at_mat4(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y), projection }
}

pub(super) fn eye() -> Eye {
    projected(perspective_infinite_reverse(1.0, ASPECT, 0.1))
}

pub(super) fn frame<'a>(eye: Eye, occlusion: Occlusion<'a>) -> Frame<'a> {
    Frame { eye, occlusion, seconds: 0.016, cut: false }
}

pub(super) fn shown(scene: &Scene, frame: &Frame<'_>) -> (Selected, Vec<Option<Shown>>) {
    let mut state = State::new(scene, &Control::default()).unwrap();
    let selected = scene.select(frame, &SceneParams::default(), &mut state).unwrap();
    (selected, (0..scene.len()).map(|i| state.shown(scene, i)).collect())
}

fn lambda_of(instance: Instance, eye: Eye) -> f32 {
    shown(&scene(&[instance]), &frame(eye, Occlusion::None)).1[0].unwrap().lambda
}

/// Depth of a wall so far ahead.
fn wall(eye: &Eye, distance: f32) -> f32 {
    let clip = eye.projection * Vec4::new(0.0, 0.0, -distance, 1.0);
    clip.z / clip.w
}

fn buffer<'a>(depths: &'a [f32], eye: Eye) -> Occlusion<'a> {
    Occlusion::Depth(DepthBuffer { depths, width: SIZE.0, height: SIZE.1, eye, y_down: false })
}

pub(super) fn uniform(depth: f32) -> Vec<f32> {
    vec![depth; (SIZE.0 * SIZE.1) as usize]
}

fn eyes() -> [Eye; 5] {
    let reverse = |m: Mat4| {
        Mat4::from_cols(
            Vec4::X,
            Vec4::Y,
            Vec4::new(0.0, 0.0, -1.0, 0.0),
            Vec4::new(0.0, 0.0, 1.0, 1.0),
        ) * m
    };
    let flip = Mat4::from_scale(Vec3::new(1.0, -1.0, 1.0));
    let finite = perspective(1.0, ASPECT, 0.1, 300.0);
    let flat = orthographic(-32.0, 32.0, -18.0, 18.0, 0.0, 300.0);
    [finite, reverse(finite), flip * finite, flat, reverse(flat)].map(projected)
}

#[test]
fn share_falls_with_distance_and_field_of_view_and_rises_with_size() {
    let far = |z: f32| lambda_of(at(Vec3::NEG_Z * z), eye());
    let shares: Vec<f32> = (1..40).map(|i| far(10.0 * i as f32)).collect();
    assert!(
        shares.is_sorted_by(|a, b| a >= b) && shares[0] > 0.9 && shares[38] < 0.02,
        "{shares:?}"
    );
    let tele = projected(perspective_infinite_reverse(0.3, ASPECT, 0.1));
    assert!(lambda_of(at(Vec3::NEG_Z * 100.0), tele) > far(100.0));
    let large = Instance { scale: 2.0, ..at(Vec3::NEG_Z * 100.0) };
    assert!((lambda_of(large, eye()) - far(50.0)).abs() < 1e-5);
}

#[test]
fn distance_counts_as_in_a_view_of_60_degrees() {
    let sixty = projected(perspective_infinite_reverse(60.0_f32.to_radians(), ASPECT, 0.1));
    let cook = |d: f32| crate::quality::Distance::cook().lambda((d - 5.0) / 395.0);
    assert!((lambda_of(at(Vec3::NEG_Z * 90.0), sixty) - cook(90.0)).abs() < 1e-4);
}

#[test]
fn orthographic_views_draw_all_alike_however_far() {
    let flat = projected(orthographic(-32.0, 32.0, -18.0, 18.0, 0.0, 300.0));
    let [near, far] = [20.0, 250.0].map(|z| lambda_of(at(Vec3::NEG_Z * z), flat));
    assert!(near == far && near > 0.5 && near < 1.0, "{near} {far}");
}

#[test]
fn every_kind_of_projection_finds_the_same_in_view() {
    let near = [Vec3::new(3.0, 2.0, -40.0), Vec3::new(0.0, 0.0, 40.0), Vec3::new(0.0, 0.0, -310.0)];
    for eye in eyes() {
        let (selected, found) = shown(&scene(&near.map(at)), &frame(eye, Occlusion::None));
        assert_eq!((selected.n_drawn, selected.n_culled), (1, 2));
        assert!(found[0].is_some());
    }
}

#[test]
fn a_tree_behind_a_wall_has_a_tenth_of_its_share_with_any_kind_of_depth() {
    for eye in eyes() {
        let tree = scene(&[at(Vec3::NEG_Z * 60.0)]);
        let free = shown(&tree, &frame(eye, Occlusion::None)).1[0].unwrap();
        for (distance, visible) in [(20.0, 0.0), (200.0, 1.0)] {
            let depths = uniform(wall(&eye, distance));
            let (selected, found) = shown(&tree, &frame(eye, buffer(&depths, eye)));
            let found = found[0].unwrap();
            assert_eq!((found.visible, selected.n_hidden), (visible, usize::from(visible == 0.0)));
            let expected = free.lambda * f32::max(visible, 0.1);
            assert!((found.lambda - expected).abs() < 1e-6, "{found:?} {free:?}");
        }
    }
}

#[test]
fn a_tree_does_not_hide_itself() {
    let eye = eye();
    let mut depths = uniform(0.0);
    for (i, depth) in depths.iter_mut().enumerate() {
        let (x, y) = (i as u32 % SIZE.0, i as u32 / SIZE.0);
        let [x, y] = [(x, SIZE.0, ASPECT), (y, SIZE.1, 1.0)]
            .map(|(i, n, wide)| ((2 * i + 1) as f32 / n as f32 - 1.0) * wide * libm::tanf(0.5));
        let ray = Vec3::new(x, -y, -1.0).normalize();
        let middle = 20.0 * -ray.z;
        let half = 4.0 - (400.0 - middle * middle);
        if half > 0.0 {
            *depth = wall(&eye, (middle - half.sqrt()) * -ray.z);
        }
    }
    assert!(depths.iter().filter(|d| **d > 0.0).count() > 30);
    let (_, found) = shown(&scene(&[at(Vec3::NEG_Z * 20.0)]), &frame(eye, buffer(&depths, eye)));
    assert_eq!(found[0].unwrap().visible, 1.0);
}

#[test]
fn the_first_row_of_depths_is_the_top_or_with_y_down_the_bottom() {
    let eye = eye();
    let mut depths = uniform(wall(&eye, 300.0));
    depths[..(SIZE.0 * SIZE.1 / 2) as usize].fill(wall(&eye, 10.0));
    let trees = scene(&[at(Vec3::new(0.0, 8.0, -60.0)), at(Vec3::new(0.0, -8.0, -60.0))]);
    for (y_down, expected) in [(false, [0.0, 1.0]), (true, [1.0, 0.0])] {
        let depth = DepthBuffer { depths: &depths, width: SIZE.0, height: SIZE.1, eye, y_down };
        let found = shown(&trees, &frame(eye, Occlusion::Depth(depth))).1;
        assert_eq!([found[0].unwrap().visible, found[1].unwrap().visible], expected);
    }
}

#[test]
fn points_outside_the_old_picture_or_behind_a_nan_count_as_seen() {
    let tree = scene(&[at(Vec3::NEG_Z * 60.0)]);
    let view = look_at_mat4(Vec3::ZERO, Vec3::Z, Vec3::Y);
    let behind = Eye { view, ..eye() };
    for (depths, old) in [(uniform(1.0), behind), (uniform(f32::NAN), eye())] {
        let found = shown(&tree, &frame(eye(), buffer(&depths, old))).1;
        assert_eq!(found[0].unwrap().visible, 1.0);
    }
}

#[test]
fn the_built_in_pass_hides_what_stands_behind_and_nothing_else() {
    let side = |x: f32| at(Vec3::new(x, 0.0, -40.0));
    let mut trees = vec![at(Vec3::NEG_Z * 12.0), at(Vec3::NEG_Z * 100.0), side(-14.0), side(14.0)];
    let (_, found) = shown(&scene(&trees), &frame(eye(), Occlusion::BuiltIn));
    let visible: Vec<f32> = found.iter().map(|tree| tree.unwrap().visible).collect();
    assert_eq!(visible, [1.0, 0.0, 1.0, 1.0]);
    // The same in a parallel view, which is wide enough for all.
    trees[1].position.z = -200.0;
    let flat = projected(orthographic(-32.0, 32.0, -18.0, 18.0, 0.0, 300.0));
    let (_, found) = shown(&scene(&trees), &frame(flat, Occlusion::BuiltIn));
    let visible: Vec<f32> = found.iter().map(|tree| tree.unwrap().visible).collect();
    assert!(visible[0] == 1.0 && visible[1] < 0.5 && visible[2] == 1.0, "{visible:?}");
}

#[test]
fn a_trembling_camera_changes_no_level() {
    let trees: Vec<Instance> = (1..30).map(|i| at(Vec3::NEG_Z * 12.0 * i as f32)).collect();
    let scene = scene(&trees);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let mut levels = Vec::new();
    for i in 0..400 {
        let shake = Vec3::Z * if i % 2 == 0 { 0.1 } else { -0.1 };
        let view = look_at_mat4(shake, shake + Vec3::NEG_Z, Vec3::Y);
        let frame = frame(Eye { view, ..eye() }, Occlusion::None);
        scene.select(&frame, &SceneParams::default(), &mut state).unwrap();
        let now: Vec<_> = (0..29).map(|i| state.shown(&scene, i).unwrap().level).collect();
        if i >= 200 {
            levels.push(now);
        }
    }
    assert!(levels.iter().all(|now| *now == levels[0]));
}

#[test]
fn share_moves_smoothly_to_its_aim_and_at_once_after_a_cut() {
    let scene = scene(&[at(Vec3::NEG_Z * 60.0)]);
    let eye = eye();
    let depths = uniform(wall(&eye, 20.0));
    let params = SceneParams::default();
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let hidden = frame(eye, buffer(&depths, eye));
    let free = frame(eye, Occlusion::None);
    let mut go = |frame: &Frame<'_>| {
        scene.select(frame, &params, &mut state).unwrap();
        state.shown(&scene, 0).unwrap().lambda
    };
    let low = go(&hidden);
    let shares: Vec<f32> = (0..200).map(|_| go(&free)).collect();
    let steps = std::iter::once(&low).chain(&shares).zip(&shares);
    assert!(steps.clone().all(|(a, b)| b >= a && b / a < 1.09), "{shares:?}");
    assert!((shares[199] / (10.0 * low) - 1.0).abs() < 0.01);
    let cut = go(&Frame { cut: true, ..hidden });
    assert_eq!(cut, low);
}

#[test]
fn batches_draw_what_single_draws_do() {
    let mut other = model();
    other.levels.truncate(3);
    other.levels[0].draws[1].index_count = 0;
    let trees: Vec<Instance> = (0..300_u32)
        .map(|i| {
            let position = Vec3::new((i % 17) as f32 - 8.0, 0.0, -2.0 * i as f32);
            Instance { model: i % 2, ..at(position) }
        })
        .collect();
    let scene = Scene::new(&[model(), other], &trees, &Control::default()).unwrap();
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let params = SceneParams::default();
    let selected = scene.select(&frame(eye(), Occlusion::BuiltIn), &params, &mut state).unwrap();
    let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
    let mut rows = vec![InstanceLod::default(); scene.len()];
    let mut all = |batched: bool| {
        let written = match batched {
            true => scene.batches(&mut state, &mut draws, &mut rows).unwrap(),
            false => scene.draws(&state, &mut draws, &mut rows).unwrap(),
        };
        assert_eq!(written.instances, selected.n_drawn);
        let mut all = Vec::new();
        for draw in &draws[..written.draws] {
            for i in draw.first_instance..draw.first_instance + draw.instance_count {
                let row = rows[i as usize];
                let bits = [row.scale, row.lambda, row.fade, row.contrast].map(f32::to_bits);
                all.push((
                    row.instance,
                    draw.first_index,
                    draw.index_count,
                    draw.base_vertex,
                    bits,
                ));
            }
        }
        all.sort_unstable();
        (written.draws, all)
    };
    let (single, batched) = (all(false), all(true));
    assert_eq!(single.1, batched.1);
    assert!(batched.0 < single.0, "{} {}", batched.0, single.0);
    let indices: u64 = single.1.iter().map(|draw| u64::from(draw.2)).sum();
    assert_eq!(indices, selected.n_indices);
}

#[test]
fn a_buffer_that_is_too_small_is_refused_and_left_alone() {
    let scene = scene(&[at(Vec3::NEG_Z * 60.0), at(Vec3::NEG_Z * 70.0)]);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let params = SceneParams::default();
    scene.select(&frame(eye(), Occlusion::None), &params, &mut state).unwrap();
    for (n_draws, n_rows, needed) in [(3, 2, 4), (4, 1, 2)] {
        let mut draws = vec![DrawIndexed::default(); n_draws];
        let mut rows = vec![InstanceLod::default(); n_rows];
        let errors = [
            scene.draws(&state, &mut draws, &mut rows).unwrap_err(),
            scene.batches(&mut state, &mut draws, &mut rows).unwrap_err(),
        ];
        for error in errors {
            assert!(matches!(error, LodError::Scene { row, .. } if row == needed), "{error}");
        }
        assert_eq!(draws, vec![DrawIndexed::default(); n_draws]);
        assert_eq!(rows, vec![InstanceLod::default(); n_rows]);
    }
}

#[test]
fn the_full_model_does_not_fade() {
    let scene = scene(&[at(Vec3::NEG_Z * 3.0), at(Vec3::NEG_Z * 100.0)]);
    let mut state = State::new(&scene, &Control::default()).unwrap();
    let params = SceneParams::default();
    scene.select(&frame(eye(), Occlusion::None), &params, &mut state).unwrap();
    let mut rows = vec![InstanceLod::default(); 2];
    scene.draws(&state, &mut [DrawIndexed::default(); 4], &mut rows).unwrap();
    rows.sort_by_key(|row| row.instance);
    assert_eq!((rows[0].lambda, rows[0].fade, rows[0].scale), (1.0, 0.0, 1.0));
    assert!(rows[1].fade > 0.0 && rows[1].scale > 1.0 && rows[1].contrast < 1.0, "{rows:?}");
}

/// A direction and a length, so that places are near and far alike.
fn place() -> impl Strategy<Value = Vec3> {
    (prop::array::uniform3(-1.0_f32..1.0), 0.0_f32..200.0).prop_map(|(d, l)| Vec3::from(d) * l)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// The oracle works with clip coordinates: a point of the sphere is in the picture when |x| ≤ w and
    /// |y| ≤ w and 0 ≤ z ≤ w.
    #[test]
    fn what_is_in_the_picture_is_never_culled_and_what_is_far_off_always(
        places in prop::collection::vec(place(), 1..150), from in place(), to in place(), kind in 0..5_usize,
    ) {
        prop_assume!((to - from).length() > 1.0 && (to - from).normalize().y.abs() < 0.99);
        let eye = Eye { view: look_at_mat4(from, to, Vec3::Y), ..eyes()[kind] };
        let trees: Vec<Instance> = places.iter().map(|&p| at(p)).collect();
        let scene = scene(&trees);
        let found = shown(&scene, &frame(eye, Occlusion::None)).1;
        let matrix = eye.projection * eye.view;
        let ball: Vec<Vec3> = model().samples.into_iter().chain([Vec3::ZERO]).map(|p| 0.999 * p).collect();
        for (tree, found) in trees.iter().zip(&found) {
            let inside = |p: &Vec3| {
                let c = matrix * (tree.position + *p).extend(1.0);
                c.x.abs() <= c.w && c.y.abs() <= c.w && c.z >= 0.0 && c.z <= c.w
            };
            if ball.iter().any(inside) {
                prop_assert!(found.is_some());
            }
            // The corners of a box around the sphere, all beyond the same side.
            let corner = |i: u32| Vec3::new(f(i & 1), f(i >> 1 & 1), f(i >> 2 & 1)) * 2.01;
            let clip: Vec<Vec4> = (0..8).map(|i| matrix * (tree.position + corner(i)).extend(1.0)).collect();
            let sides: [fn(&Vec4) -> bool; 6] = [
                |c| c.x < -c.w, |c| c.x > c.w, |c| c.y < -c.w, |c| c.y > c.w, |c| c.z < 0.0, |c| c.z > c.w,
            ];
            if sides.iter().any(|side| clip.iter().all(side)) {
                prop_assert!(found.is_none());
            }
        }
    }

    /// Any bits at all for matrices, depths and times.
    #[test]
    fn no_input_makes_it_panic(
        bits in prop::array::uniform32(any::<f32>()), depths in prop::collection::vec(any::<f32>(), 12),
        places in prop::collection::vec(place(), 1..9), seconds in any::<f32>(), w in prop::bool::ANY,
    ) {
        let scene = scene(&places.iter().map(|&p| at(p)).collect::<Vec<_>>());
        let mut state = State::new(&scene, &Control::default()).unwrap();
        let mut projection = Mat4::from_cols_slice(&bits[..16]);
        // Half of them such that they pass for a projection.
        for (i, axis) in [3, 3, 3, 3].into_iter().enumerate() {
            let last = if w { [0.0, 0.0, -1.0, 0.0][i] } else { [0.0, 0.0, 0.0, 1.0][i] };
            projection.col_mut(i)[axis] = last;
        }
        for view in [eye().view, Mat4::from_cols_slice(&bits[16..])] {
            let eye = Eye { view, projection };
            let depth = DepthBuffer { depths: &depths, width: 4, height: 3, eye, y_down: w };
            for occlusion in [Occlusion::None, Occlusion::BuiltIn, Occlusion::Depth(depth)] {
                for seconds in [seconds, 0.1] {
                    let frame = Frame { eye, occlusion, seconds, cut: false };
                    let _ = scene.select(&frame, &SceneParams::default(), &mut state);
                    let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
                    let mut rows = vec![InstanceLod::default(); scene.len()];
                    let _ = scene.draws(&state, &mut draws, &mut rows);
                    let _ = scene.batches(&mut state, &mut draws, &mut rows);
                }
            }
        }
    }
}

fn f(bit: u32) -> f32 {
    2.0 * bit as f32 - 1.0
}
