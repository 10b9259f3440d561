//! What one part makes goes into the next: photographs to plastic trees to levels, sketches to silhouettes of their branches, imported
//! meshes to scenes and streams, and a forest of it all for one camera. The way into C is `tree-ffi/tests/c_alone/workflow.c`.

#![allow(clippy::unwrap_used)]

use std::sync::{Arc, OnceLock};
use tree_core::glam::camera::rh::proj::directx::perspective_infinite_reverse;
use tree_core::glam::{Mat4, Quat, Vec2, Vec3};
use tree_core::{Continuation, Control, Limits, Seed, Skeleton, Species, Tree, Volume, file};
use tree_lod::cover::Around;
use tree_lod::multires::stream::{self, StreamParams};
use tree_lod::multires::{Metric, Multires};
use tree_lod::order::CoverageParams;
use tree_lod::preview::{self, Camera, Lens, Mask, Pose as Stand, View};
use tree_lod::prune::{MakeParams, PrunedModel};
use tree_lod::quality::Distance;
use tree_lod::select::{self, DrawIndexed, Eye, Frame, Instance, InstanceLod, Occlusion, State};
use tree_mesh::io::gltf::{self, GlbOptions};
use tree_mesh::topology::examine;
use tree_mesh::{Look, Mesh, MeshParams};
use tree_model::Modeler;
use tree_model::particle::session::{PhotoModel, PhotoParams, Shot};
use tree_model::particle::{Matte, Photo, matting};
use tree_model::path::Preset;
use tree_model::plastic::{PlasticParams, PlasticTree, Pose, Response, Scene, Sky};
use tree_model::silhouette::read::from_mask;
use tree_model::silhouette::session::{Session, SilhouetteParams};
use tree_model::skeletonize::{SkeletonizeParams, skeletonize};
use tree_model::sketch::read::from_json;
use tree_model::sketch::session::{SketchModel, SketchParams};

/// A tree that any consumer can take.
fn assert_sound(tree: &Tree) {
    tree.skeleton().check().unwrap();
    assert!(tree.skeleton().len() > 2, "{} nodes", tree.skeleton().len());
    for leaf in tree.foliage().iter() {
        assert!(leaf.position.is_finite() && leaf.rotation.is_finite() && leaf.size > 0.0);
        assert!((leaf.node as usize) < tree.skeleton().len());
    }
}

/// A mesh of it, which must be right, its bark closed.
fn mesh_of(tree: &Tree) -> Mesh {
    let look = Look::built_in(tree.species()).unwrap_or_else(|_| Look::plain(tree.species()));
    let mesh = tree_mesh::build(tree, &look, &MeshParams::default(), &Control::default());
    let mesh = mesh.unwrap().mesh;
    mesh.check().unwrap();
    mesh.check_normals().unwrap();
    let bark = examine(&mesh.surfaces[0]).unwrap();
    assert!(bark.is_closed(), "{bark:?}");
    mesh
}

/// Few views: whether it works is the matter here.
fn pruned(mesh: &Mesh) -> PrunedModel {
    let around = Around { azimuths: 3, size: 64, ..Around::default() };
    let order = CoverageParams { around, ..CoverageParams::default() };
    let params = MakeParams { order: Some(order), ..MakeParams::default() };
    PrunedModel::make(mesh, &params, &Control::default()).unwrap()
}

/// Triangles at falling λ fall, and each level is a mesh that is right.
fn assert_falls(model: &PrunedModel) {
    let mut last = usize::MAX;
    for lambda in [1.0, 0.5, 0.2, 0.05] {
        let mesh = model.mesh_at(lambda).unwrap();
        mesh.check().unwrap();
        assert!(mesh.n_triangles() < last, "{} at {lambda} after {last}", mesh.n_triangles());
        last = mesh.n_triangles();
    }
}

/// A tree beside a wall whose near side stands at `x`, as the wall makes it.
fn walled(tree: Tree, x: f32) -> Tree {
    let control = Control::default();
    let model = Arc::new(PlasticTree::new(tree, &PlasticParams::default(), &control).unwrap());
    let mut scene = Scene::new(Sky::default(), Response::default()).unwrap();
    let id = scene.add_tree(model.clone(), Pose::default()).unwrap();
    scene.update(&control).unwrap();
    // Nothing moves what stands in the open.
    assert_eq!(&scene.adapted(id, &control).unwrap().tree, model.tree());
    let wall = Volume::box_solid(Vec3::new(0.0, -1.0, -50.0), Vec3::new(1.0, 50.0, 50.0)).unwrap();
    scene.add_obstacle(wall, Pose::at(Vec3::X * x)).unwrap();
    scene.update(&control).unwrap();
    let adapted = scene.adapted(id, &control).unwrap();
    assert!(adapted.report.farthest > 0.0 && adapted.report.n_pruned > 0);
    adapted.tree
}

/// Where a wall meets the outer branches.
fn within(tree: &Tree) -> f32 {
    0.4 * tree.skeleton().bounds().max.x
}

const WIDTH: u32 = 60;
const HEIGHT: u32 = 80;

/// A round crown on a trunk that ends above the picture's bottom.
fn photographed() -> Shot {
    let covered = |i: u32| {
        let (x, y) = ((i % WIDTH) as f32 + 0.5, (i / WIDTH) as f32 + 0.5);
        let crown = Vec2::new(x - 30.0, y - 28.0).length_squared() < 22.0 * 22.0;
        crown || ((28.0..32.0).contains(&x) && (28.0..74.0).contains(&y))
    };
    let alpha = (0..WIDTH * HEIGHT).map(|i| if covered(i) { 1.0 } else { 0.0 });
    Shot::new(Matte::new(WIDTH, HEIGHT, alpha.collect()).unwrap(), None, 0.0)
}

/// So few particles and voxels that a tree takes a moment.
fn quick() -> PhotoParams {
    let mut params = PhotoParams { height: 8.0, branches: 8, ..PhotoParams::default() };
    params.flow.particles = 60;
    params.density.resolution = 16;
    params.field.rows = 24;
    params.livewire.rows = 64;
    params
}

fn from_photo(shot: Shot) -> Tree {
    let model = PhotoModel { shots: vec![shot], params: quick() };
    let tree = model.model(Seed(1), &Control::default()).unwrap();
    assert_sound(&tree);
    assert!(!tree.foliage().is_empty());
    tree
}

#[test]
fn a_photographed_tree_bends_at_a_wall_and_becomes_levels() {
    let tree = from_photo(photographed());
    let side = within(&tree);
    let bent = walled(tree, side);
    assert_sound(&bent);
    let farthest = bent.skeleton().bounds().max.x;
    assert!(farthest <= side + 1e-3, "through the wall: {farthest} m, it stands at {side} m");
    assert_falls(&pruned(&mesh_of(&bent)));
}

#[test]
fn a_real_photograph_goes_the_same_way() {
    let path = "../shared/data/photos/cutout_pinnate_tree.png";
    let Ok(photo) = Photo::open(path, &Limits::default()) else {
        println!("skipped: {path} is not there");
        return;
    };
    let (matte, _) =
        matting::automatic(&photo, &matting::AutomaticParams::default(), &Control::default())
            .unwrap();
    let tree = from_photo(Shot::new(matte, Some(photo), 0.0));
    let side = within(&tree);
    let bent = walled(tree, side);
    assert!(bent.skeleton().bounds().max.x <= side + 1e-3);
    assert_falls(&pruned(&mesh_of(&bent)));
}

/// The drawing in `examples/bake`, grown.
fn sketched() -> Tree {
    let text = file::read_text("examples/bake/data/sapling.json".as_ref(), &Limits::default());
    let mut params = SketchParams { height: Some(4.0), ..SketchParams::default() };
    params.species = Some("maple".into());
    let model = SketchModel {
        drawing: from_json(&text.unwrap()).unwrap(),
        params,
        ..SketchModel::default()
    };
    model.model(Seed(6), &Control::default()).unwrap()
}

/// What the branch of this node bears, with its base at the origin and its tip above it.
fn upright(tree: &Tree, base: u32, tip: u32) -> Tree {
    let (skeleton, foliage) = (tree.skeleton(), tree.foliage());
    let origin = skeleton.positions()[base as usize];
    let along = skeleton.positions()[tip as usize] - origin;
    let up = Quat::from_rotation_arc(along.normalize(), Vec3::Y);
    let place = |p: Vec3| up * (p - origin);
    let mut now = vec![None; skeleton.len()];
    let mut builder = Skeleton::builder(Vec3::ZERO, skeleton.radii()[base as usize]).unwrap();
    now[base as usize] = Some(0);
    for (parent, node) in skeleton.segments() {
        if let Some(parent) = now[parent as usize] {
            let at = place(skeleton.positions()[node as usize]);
            now[node as usize] =
                Some(builder.add(parent, at, skeleton.radii()[node as usize]).unwrap());
        }
    }
    let mut leaves = tree_core::Foliage::default();
    for mut leaf in foliage.iter() {
        let Some(node) = now[leaf.node as usize] else { continue };
        (leaf.node, leaf.position, leaf.rotation) =
            (node, place(leaf.position), (up * leaf.rotation).normalize());
        leaves.push(leaf).unwrap();
    }
    Tree::new(builder.finish(), leaves, tree.species().clone()).unwrap()
}

/// A tree of about this height from the front.
fn front(tree: &Tree, height: f32) -> Mask {
    let target = Vec3::Y * 0.5 * height;
    let lens = Lens::Orthographic { height: 1.3 * height };
    let camera = Camera::Placed(Stand { eye: target + 10.0 * Vec3::Z, target, up: Vec3::Y, lens });
    let view = View { width: 200, height: 200, samples: 2, camera };
    preview::mask(&mesh_of(tree), &view, &Control::default()).unwrap()
}

#[test]
fn the_branches_of_a_sketched_tree_are_silhouettes_of_trees_of_their_own() {
    let tree = sketched();
    assert_sound(&tree);
    let axes = tree.skeleton().axes(Continuation::Thickest);
    let (sizes, distances) = (tree.skeleton().subtree_sizes(), tree.skeleton().distances_to_tip());
    let mut branches: Vec<_> = axes.iter().filter(|axis| axis.order == 1).collect();
    branches.sort_by_key(|axis| std::cmp::Reverse(sizes[axis.nodes[0] as usize]));
    assert!(branches.len() >= 3);
    for axis in &branches[..3] {
        let (base, tip) = (axis.nodes[0], *axis.nodes.last().unwrap());
        let branch = upright(&tree, base, tip);
        assert_sound(&branch);
        let height = distances[base as usize];
        let seen = front(&branch, height);
        let alpha = seen.coverage.iter().map(|&c| f32::from(c) / 255.0).collect();
        let matte = Matte::new(seen.width, seen.height, alpha).unwrap();
        let drawing = from_mask(&matte, 0.5).unwrap();
        let mut params = SilhouetteParams { height, ..SilhouetteParams::default() };
        params.grow.species = tree.species().clone();
        params.grow.depth = Some(2);
        let (session, _) = Session::of_drawing(&drawing.trees[0], params, Seed(2)).unwrap();
        let grown = session.tree(&Control::default()).unwrap().tree;
        assert_sound(&grown);
        // It is as high as what it was drawn after, and covers pixels where that one does.
        let size = grown.skeleton().bounds().size();
        assert!((0.5..1.5).contains(&(size.y / height)), "{} m for {height} m", size.y);
        let own = front(&grown, height);
        assert!(own.area() > 0.2 * seen.area(), "{} for {} pixels", own.area(), seen.area());
    }
}

/// Imported, read as a tree, bent by a wall, sorted, sent.
fn through_all(glb: &[u8]) {
    let control = Control::default();
    let mesh = gltf::from_slice(glb, &control).unwrap().mesh;
    let read = skeletonize(&mesh.parts(), &SkeletonizeParams::default(), &control).unwrap().tree;
    assert_sound(&read);
    let side = within(&read);
    let bent = walled(read, side);
    mesh_of(&bent);
    let model = Multires::new(&bent, &Metric::default(), &control).unwrap();
    // Every level is the beginning of the next one.
    let n = model.n_levels();
    let mut last = 0;
    for level in [1, n / 3, n].map(|level| level.max(1)) {
        let tree = model.tree_at(level).unwrap();
        assert_sound_prefix(&tree, &model);
        assert!(tree.skeleton().len() >= last);
        last = tree.skeleton().len();
    }
    assert_eq!(last, bent.skeleton().len());
    // What is decoded is what was sent, in whole steps of the precision; without its end it is its beginning.
    let params = StreamParams { precision: 1e-3 };
    let bytes = stream::encode(&model, usize::MAX, &params).unwrap();
    let (back, received) = stream::decode(&bytes, &Limits::default()).unwrap();
    assert!(received.is_complete && received.n_levels == n);
    let pairs = model.tree().skeleton().positions().iter().zip(back.tree().skeleton().positions());
    let apart = pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f32::max);
    assert!(apart <= 2e-3, "{apart} m apart");
    assert_eq!(model.tree().skeleton().parents(), back.tree().skeleton().parents());
    let received = |length| stream::decode(&bytes[..length], &Limits::default()).unwrap();
    let less = (0..bytes.len()).rev().map(received).find(|(_, received)| received.n_levels < n);
    let (cut, received) = less.unwrap();
    assert!(!received.is_complete);
    let (some, all) = (cut.tree().skeleton(), back.tree().skeleton());
    assert_eq!(some.positions(), &all.positions()[..some.len()]);
    assert_eq!(some.parents(), &all.parents()[..some.len()]);
}

fn assert_sound_prefix(tree: &Tree, of: &Multires) {
    tree.skeleton().check().unwrap();
    let (some, all) = (tree.skeleton(), of.tree().skeleton());
    assert_eq!(some.positions(), &all.positions()[..some.len()]);
    assert_eq!(some.parents(), &all.parents()[..some.len()]);
    let leaves = tree.foliage().len();
    assert_eq!(tree.foliage().positions(), &of.tree().foliage().positions()[..leaves]);
}

/// A small tree as glTF.
fn exported() -> Vec<u8> {
    let params = Preset::find("i").unwrap().params().unwrap();
    let tree = params.grow(Seed(5), &Control::default()).unwrap().tree;
    gltf::to_glb(&mesh_of(&tree), &GlbOptions::default()).unwrap()
}

#[test]
fn an_imported_tree_reacts_and_is_sent_level_by_level() {
    through_all(&exported());
}

#[test]
fn a_tree_nobody_here_made_goes_the_same_way() {
    let path = "../shared/data/meshes/nature_BirchTree_Dead_2.glb";
    match std::fs::read(path) {
        Ok(bytes) => through_all(&bytes),
        Err(_) => println!("skipped: {path} is not there"),
    }
}

/// A hundred rows of a hundred trees, ten metres apart, of two models.
fn forest() -> &'static (select::Scene, Vec<Instance>) {
    static FOREST: OnceLock<(select::Scene, Vec<Instance>)> = OnceLock::new();
    FOREST.get_or_init(|| {
        let grown = Preset::find("i").unwrap().params().unwrap();
        let grown = grown.grow(Seed(5), &Control::default()).unwrap().tree;
        let models: Vec<_> = [grown, from_photo(photographed())]
            .iter()
            .map(|tree| {
                let mut model =
                    pruned(&mesh_of(tree)).to_select_model(16, Distance::cook()).unwrap();
                // Half a crown is opaque for certain.
                let (center, radii) = (model.center, Vec3::splat(0.5 * model.radius));
                model.occluders.push(select::Occluder { center, radii });
                model.samples = vec![center, center + 0.4 * radii, center - 0.4 * radii];
                model
            })
            .collect();
        let place = |i: u32| Instance {
            model: i % 2,
            position: Vec3::new(10.0 * (i % 100) as f32 - 495.0, 0.0, -10.0 * (i / 100) as f32),
            rotation: Quat::from_rotation_y(i as f32),
            ..Instance::default()
        };
        let instances: Vec<Instance> = (0..10_000).map(place).collect();
        let scene = select::Scene::new(&models, &instances, &Control::default()).unwrap();
        (scene, instances)
    })
}

/// The camera of a frame: it walks into the forest.
fn eye(frame: u32) -> Eye {
    let at = Vec3::new(1.3 * frame as f32, 2.0, 15.0 - 4.0 * frame as f32);
    Eye {
        view: Mat4::from_translation(-at),
        projection: perspective_infinite_reverse(1.0, 1.5, 0.1),
    }
}

/// What is drawn in each of some frames.
fn walk(occlusion: Occlusion<'_>) -> Vec<(select::Selected, Vec<DrawIndexed>, Vec<InstanceLod>)> {
    let (scene, _) = forest();
    let mut state = State::new(scene, &Control::default()).unwrap();
    let frames = (0..12).map(|n| {
        let frame = Frame { eye: eye(n), occlusion, seconds: 0.02, cut: n == 0 };
        let selected = scene.select(&frame, &select::SceneParams::default(), &mut state).unwrap();
        let mut draws = vec![DrawIndexed::default(); scene.most_draws()];
        let mut rows = vec![InstanceLod::default(); scene.len()];
        let written = scene.draws(&state, &mut draws, &mut rows).unwrap();
        draws.truncate(written.draws);
        rows.truncate(written.instances);
        (selected, draws, rows)
    });
    frames.collect()
}

#[test]
fn ten_thousand_trees_are_selected_the_same_way_each_time() {
    let (scene, _) = forest();
    let first = walk(Occlusion::BuiltIn);
    for (selected, draws, rows) in &first {
        assert_eq!(selected.n_drawn + selected.n_culled, 10_000);
        assert!(selected.n_drawn > 1000 && selected.n_culled > 1000, "{selected:?}");
        assert_eq!(rows.len(), selected.n_drawn);
        let indices: u64 = draws.iter().map(|draw| u64::from(draw.index_count)).sum();
        assert_eq!(indices, selected.n_indices);
        assert!(indices <= scene.most_indices());
    }
    let again = walk(Occlusion::BuiltIn);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let alone = pool.install(|| walk(Occlusion::BuiltIn));
    assert!(first == again && first == alone, "frames differ");
    // What trees hide is drawn with less.
    let open = walk(Occlusion::None);
    let sum = |frames: &[(select::Selected, Vec<DrawIndexed>, Vec<InstanceLod>)]| -> u64 {
        frames.iter().map(|frame| frame.0.n_triangles).sum()
    };
    assert!(sum(&first) < sum(&open), "{} against {}", sum(&first), sum(&open));
}

#[test]
fn nothing_far_is_drawn_in_detail_and_nothing_near_without() {
    let (scene, instances) = forest();
    let mut state = State::new(scene, &Control::default()).unwrap();
    let frame = Frame { eye: eye(0), occlusion: Occlusion::None, seconds: 0.02, cut: true };
    scene.select(&frame, &select::SceneParams::default(), &mut state).unwrap();
    let from = frame.eye.view.inverse().transform_point3(Vec3::ZERO);
    let (mut near, mut far) = (0, 0);
    for (number, instance) in instances.iter().enumerate() {
        let Some(shown) = state.shown(scene, number) else { continue };
        let away = instance.position.distance(from);
        // Cook's λ = (1 − d)², from 10 to 500 m, with room for the crown's centre and the band.
        let d = ((away - 25.0 - 10.0) / 490.0).clamp(0.0, 1.0);
        let most = 1.06 * (1.0 - d) * (1.0 - d) + 0.02;
        assert!(shown.lambda <= most.max(0.03), "{} at {away} m", shown.lambda);
        near += u32::from(away < 30.0 && shown.lambda > 0.8);
        far += u32::from(away > 700.0);
    }
    assert!(near > 0 && far > 100, "{near} near, {far} far");
}

/// A tree without leaves is right too, wherever it goes.
#[test]
fn bare_trees_go_everywhere_but_into_pruning() {
    let species = Species { leaf_kinds: Vec::new(), ..Species::default() };
    let bare = Tree::bare(sketched().skeleton().clone(), species);
    let side = within(&bare);
    let bent = walled(bare, side);
    let mesh = mesh_of(&bent);
    let model = Multires::new(&bent, &Metric::default(), &Control::default()).unwrap();
    assert!(model.n_levels() > 3);
    let error = PrunedModel::make(&mesh, &MakeParams::default(), &Control::default()).unwrap_err();
    assert!(error.to_string().contains("foliage"), "{error}");
}
