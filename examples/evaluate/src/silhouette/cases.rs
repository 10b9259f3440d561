//! What is drawn: the eight kinds of Table 1, and the outlines of the shared data.

use std::error::Error;
use std::f32::consts::PI;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tree_mesh::{LeafForm, LeafMesh, Look, Mesh, MeshParams};
use tree_model::particle::Photo;
use tree_model::particle::finish::FinishParams;
use tree_model::silhouette::grow::{GrowParams, Grown, LevelParams};
use tree_model::silhouette::place::Arrangement;
use tree_model::silhouette::plan::Plan;
use tree_model::silhouette::read::OutlineDrawing;
use tree_model::silhouette::read::{self, Kind as StrokeKind, Level, TreeStrokes};
use tree_model::silhouette::session::{PlayReport, Session, SilhouetteParams};
use tree_model::silhouette::stand::{Perspective, Stand, StandParams};
use tree_model::tree_core::glam::Vec2;
use tree_model::tree_core::{Control, Limits, Seed, Tree, file};

/// Where pictures go.
pub(super) const OUT: &str = "out/silhouettes";

/// A kind of tree of Table 1.
pub(super) struct Kind {
    pub(super) name: &'static str,
    /// Strokes and elements of the paper's.
    pub(super) strokes: f64,
    pub(super) elements: f64,
    /// Bark and leaf of ours.
    species: &'static str,
    /// How the branches on the trunk stand.
    arrangement: Arrangement,
}

/// Table 1.
pub(super) const KINDS: [Kind; 8] = [
    kind("poplar", (7.0, 53e3), "poplar", Arrangement::Spread),
    kind("pine", (7.0, 32e3), "pine", Arrangement::Whorled { per_node: 5, turn: PI / 5.0 }),
    kind("christmas_tree", (41.0, 40e3), "spruce", Arrangement::Spread),
    kind("palm", (29.0, 3800.0), "palm", Arrangement::golden()),
    kind("willow", (43.0, 35e3), "willow", Arrangement::Spread),
    kind("eucalyptus", (35.0, 1_294e3), "oak", Arrangement::Spread),
    kind("fern_forest", (280.0, 90e3), "oak", Arrangement::golden()),
    kind("stand", (220.0, 440e3), "oak", Arrangement::Spread),
];

const fn kind(
    name: &'static str,
    (strokes, elements): (f64, f64),
    species: &'static str,
    arrangement: Arrangement,
) -> Kind {
    Kind { name, strokes, elements, species, arrangement }
}

/// A drawing, and how it is to become trees.
pub(super) struct Case {
    pub(super) name: String,
    pub(super) trees: Vec<TreeStrokes>,
    pub(super) params: SilhouetteParams,
}

impl Kind {
    /// Our drawing of it.
    pub(super) fn case(&self) -> Result<Case, Box<dyn Error>> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../outlines");
        let text = file::read_text(&folder.join(format!("{}.svg", self.name)), &Limits::default())?;
        let mut grow = GrowParams::default();
        if let Ok(finish) = FinishParams::find(self.species) {
            grow.species = finish.species;
        }
        // The trunk has the kind's arrangement; levels beyond, the default.
        grow.levels = vec![
            LevelParams { arrangement: self.arrangement, ..LevelParams::default() },
            LevelParams::default(),
        ];
        let params = SilhouetteParams { grow, ..SilhouetteParams::default() };
        Ok(Case { name: self.name.into(), trees: read::from_svg(&text)?.trees, params })
    }
}

/// Outlines, masks and mattes of the shared data, in the order of names; none where it is not there.
pub(super) fn shared() -> Result<Vec<Case>, Box<dyn Error>> {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let mut paths = entries(&data.join("silhouettes"))?;
    let photos = entries(&data.join("photos"))?;
    paths.extend(photos.into_iter().filter(|path| name_of(path).starts_with("cutout_")));
    let mut cases = Vec::new();
    for path in paths {
        let drawing = match path.extension().and_then(|ending| ending.to_str()) {
            Some("svg") => read::from_svg(&file::read_text(&path, &Limits::default())?)?,
            Some("png") => read::from_photo(&Photo::open(&path, &Limits::default())?)?,
            _ => continue,
        };
        let params = SilhouetteParams::default();
        cases.push(Case { name: name_of(&path), trees: drawing.trees, params });
    }
    Ok(cases)
}

fn entries(folder: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    if !folder.is_dir() {
        eprintln!("no outlines: {} is not there", folder.display());
        return Ok(Vec::new());
    }
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path()));
    let mut paths = entries.collect::<Result<Vec<_>, _>>()?;
    paths.sort();
    Ok(paths)
}

fn name_of(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// A tree's session, what became of its strokes, and where it stands.
pub(super) type Planted = (Session, PlayReport, Vec2);

impl Case {
    /// Sessions of all its trees, the tallest as tall as the parameters say, and where each stands in
    /// the drawing: metres to the right of the first, and up the page from it.
    pub(super) fn sessions(&self) -> Result<Vec<Planted>, Box<dyn Error>> {
        let grounds: Vec<(Vec2, f32)> = self.trees.iter().map(ground).collect();
        let tallest = grounds.iter().map(|&(_, height)| height).fold(0.0, f32::max);
        let scale = self.params.height / tallest;
        let first = grounds.first().map_or(Vec2::ZERO, |&(base, _)| base);
        let mut out = Vec::new();
        if self.trees.len() > 1 {
            // Those without details borrow.
            let drawing = OutlineDrawing { trees: self.trees.clone(), ..Default::default() };
            let params = StandParams {
                silhouette: self.params.clone(),
                perspective: Perspective::Flat,
                ..StandParams::default()
            };
            let stand = Stand::of_drawing(&drawing, &params, Seed(1), &Control::default())?;
            for tree in stand.trees {
                let (base, _) = grounds[tree.index];
                out.push((
                    tree.session,
                    tree.strokes,
                    scale * (base - first) * Vec2::new(1.0, -1.0),
                ));
            }
            return Ok(out);
        }
        for (i, (tree, (base, height))) in self.trees.iter().zip(grounds).enumerate() {
            let params = SilhouetteParams { height: scale * height, ..self.params.clone() };
            let (session, report) = Session::of_drawing(tree, params, Seed(1).child(i as u64))?;
            out.push((session, report, scale * (base - first) * Vec2::new(1.0, -1.0)));
        }
        Ok(out)
    }
}

/// The base of a tree in its drawing, and its height there.
fn ground(tree: &TreeStrokes) -> (Vec2, f32) {
    let coarse = || tree.strokes.iter().filter(|stroke| stroke.level == Level::Number(0));
    let points = || coarse().flat_map(|stroke| &stroke.points);
    let (low, high) = points()
        .fold((Vec2::INFINITY, Vec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    let trunk = coarse().find(|stroke| stroke.kind == StrokeKind::Axis);
    let foot =
        trunk.and_then(|stroke| stroke.points.iter().copied().max_by(|a, b| a.y.total_cmp(&b.y)));
    (foot.unwrap_or(Vec2::new(0.5 * (low.x + high.x), high.y)), high.y - low.y)
}

/// The first tree of one of [`KINDS`].
pub(crate) fn tree(name: &str) -> Result<Tree, Box<dyn Error>> {
    let kind = KINDS.iter().find(|kind| kind.name == name).ok_or("no such drawing")?;
    let sessions = kind.case()?.sessions()?;
    let (session, _, _) = sessions.first().ok_or("an empty drawing")?;
    Ok(session.tree(&Control::default())?.tree)
}

/// The tree in space, and its mesh.
pub(super) fn mesh(session: &Session) -> Result<(Grown, Mesh), Box<dyn Error>> {
    let control = Control::default();
    let grown = session.tree(&control)?;
    let plan = session.plan().ok_or("no crown")?;
    let look = look(plan, &grown.tree)?;
    let mesh = tree_mesh::build(&grown.tree, &look, &MeshParams::default(), &control)?.mesh;
    Ok((grown, mesh))
}

/// The species' look; a drawn leaf is cut out as it was drawn.
fn look(plan: &Plan, tree: &Tree) -> Result<Look, Box<dyn Error>> {
    let mut look = Look::built_in(tree.species())?;
    let Some(leaf) = &plan.leaf else { return Ok(look) };
    look.leaves = Look::plain(tree.species()).leaves;
    for kind in &mut look.leaves {
        let mesh = LeafMesh::flat(&leaf.outline.points, &leaf.outline.triangles);
        kind.form = LeafForm::Mesh(Arc::new(mesh));
    }
    Ok(look)
}
