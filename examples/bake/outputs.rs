//! A tree's files: the mesh, its levels, and what else is asked for.

use crate::grow::{BakeError, Grown};
use crate::manifest::{Line, Output};
use crate::store::Folder;
use serde_json::{Map, Value, json};
use tree_core::{Control, swc};
use tree_lod::hybrid::{Hybrid, HybridParams};
use tree_lod::impostor::octahedral::{Octahedral, OctahedralParams};
use tree_lod::multires::stream::{self, StreamParams};
use tree_lod::order::CoverageParams;
use tree_lod::preview::{self, Style, View};
use tree_lod::prune::{MakeParams, PrunedModel, Screen};
use tree_mesh::Mesh;
use tree_mesh::io::gltf::{self, GlbOptions};

/// Height of the screen in pixels that levels are made for.
const SCREEN: f32 = 1080.0;
/// Height in pixels of a tree that is near.
const NEAR: f32 = 1000.0;
/// Levels in the table beside a pruned model.
const TABLE: usize = 64;
/// Coordinates in a stream are whole multiples of this, in metres.
const PRECISION: f32 = 0.001;

/// What is made once and used by several outputs.
struct Made<'a> {
    line: &'a Line,
    grown: &'a Grown,
    mesh: Mesh,
    options: GlbOptions,
    pruned: Option<PrunedModel>,
    hybrid: Option<Hybrid>,
    triangles: Map<String, Value>,
    control: &'a Control,
}

/// Makes and writes every output of a line; what the report tells of them.
pub(crate) fn write(
    line: &Line,
    grown: &Grown,
    folder: &mut Folder,
    control: &Control,
) -> Result<Map<String, Value>, BakeError> {
    let mesh = tree_mesh::build(&grown.tree, &grown.look, &grown.params, control)?.mesh;
    let mut triangles = Map::new();
    triangles.insert("mesh".into(), json!(mesh.n_triangles()));
    let options = GlbOptions { name: line.name.clone(), ..GlbOptions::default() };
    let (pruned, hybrid) = (None, None);
    let mut made = Made { line, grown, mesh, options, pruned, hybrid, triangles, control };
    let mut wanted = line.outputs.clone();
    wanted.sort_unstable();
    wanted.dedup();
    for output in wanted {
        made.write(output, folder)?;
    }
    let mut report = Map::new();
    report.insert("nodes".into(), json!(grown.tree.skeleton().len()));
    report.insert("leaves".into(), json!(grown.tree.foliage().len()));
    report.insert("triangles".into(), Value::Object(made.triangles));
    report.insert("warnings".into(), json!(grown.warnings));
    Ok(report)
}

impl Made<'_> {
    fn write(&mut self, output: Output, folder: &mut Folder) -> Result<(), BakeError> {
        match output {
            Output::Mesh => folder.put(".glb", &gltf::to_glb(&self.mesh, &self.options)?),
            Output::Levels if self.grown.tree.foliage().is_empty() => self.wood_levels(folder),
            Output::Levels => self.levels(folder),
            Output::Pruned => {
                let options = self.options.clone();
                let model = self.pruned()?;
                folder.put("_pruned.glb", &model.to_glb(&options)?)?;
                folder.put("_pruned.json", model.to_json(&model.levels(TABLE)?).as_bytes())
            }
            Output::Hybrid => self.hybrid(folder),
            Output::Octahedral => self.octahedral(folder),
            Output::Stream => {
                let params = StreamParams { precision: PRECISION };
                let hybrid = self.made_hybrid()?;
                folder.put(".trem", &stream::encode(hybrid.multires(), usize::MAX, &params)?)
            }
            Output::Skeleton => {
                let text = swc::write(self.grown.tree.skeleton(), &swc::SwcOptions::default())?;
                folder.put(".swc", text.as_bytes())
            }
            Output::Picture => {
                let (view, style) = (View::default(), Style::default());
                let picture = preview::render(&self.mesh, &view, &style, self.control)?;
                folder.put(".png", &picture.to_png()?)
            }
        }
    }

    fn levels(&mut self, folder: &mut Folder) -> Result<(), BakeError> {
        let (shares, options) = (self.line.shares(), self.options.clone());
        let model = self.pruned()?;
        let glb = model.to_glb_levels(&shares, &Screen::default(), &options)?;
        let count = |&share: &f32| Ok(model.mesh_at(share)?.n_triangles());
        let counts = shares.iter().map(count).collect::<Result<Vec<_>, BakeError>>()?;
        self.triangles.insert("levels".into(), json!(counts));
        folder.put("_levels.glb", &glb)
    }

    /// Of a tree without leaves: branch by branch, the most that stay within a share of the triangles.
    fn wood_levels(&mut self, folder: &mut Folder) -> Result<(), BakeError> {
        let (shares, options) = (self.line.shares(), self.options.clone());
        let size = 2.0 * self.mesh.bounding_sphere().map_or(0.0, |(_, radius)| radius);
        let full = self.mesh.clone();
        let hybrid = self.made_hybrid()?;
        let wood = hybrid.wood();
        let all = f64::from(wood.wood_indices(f32::INFINITY) / 3);
        let within = |share: f32| wood.level_of_wood((f64::from(share) * all) as u64) as f32;
        let mesh = |&share: &f32| {
            if share < 1.0 { Ok(wood.mesh_at(within(share))?) } else { Ok(full.clone()) }
        };
        let meshes = shares.iter().map(mesh).collect::<Result<Vec<Mesh>, BakeError>>()?;
        let screen = Screen::default();
        let mut levels = Vec::with_capacity(meshes.len());
        for (i, mesh) in meshes.iter().enumerate() {
            let next = shares.get(i + 1).map(|&next| screen.coverage(next, size)).transpose()?;
            levels.push(gltf::Level { coverage: next.unwrap_or(0.0), ..mesh.into() });
        }
        let glb = gltf::to_glb_levels(&levels, &options)?;
        let counts: Vec<usize> = meshes.iter().map(Mesh::n_triangles).collect();
        self.triangles.insert("levels".into(), json!(counts));
        folder.put("_levels.glb", &glb)
    }

    /// Branches by prefix, and pictures of leaves. A share of the triangles is what a tree of so many times the area on the
    /// screen needs.
    fn hybrid(&mut self, folder: &mut Folder) -> Result<(), BakeError> {
        let heights: Vec<f32> =
            self.line.shares().iter().map(|share| NEAR * share.sqrt()).collect();
        let options = self.options.clone();
        let hybrid = self.made_hybrid()?;
        let glb = hybrid.to_glb_levels(&heights, SCREEN, &options)?;
        let count = |&height: &f32| Ok(hybrid.n_triangles(&hybrid.choice_for_height(height)?));
        let counts = heights.iter().map(count).collect::<Result<Vec<_>, BakeError>>()?;
        self.triangles.insert("hybrid".into(), json!(counts));
        folder.put("_hybrid.glb", &glb)
    }

    fn octahedral(&self, folder: &mut Folder) -> Result<(), BakeError> {
        let baked = Octahedral::bake(&self.mesh, &OctahedralParams::default(), self.control)?;
        folder.put("_octahedral_color.png", &baked.color.to_png()?)?;
        folder.put("_octahedral_detail.png", &baked.detail.to_png()?)?;
        folder.put("_octahedral.json", baked.meta.to_json().as_bytes())
    }

    fn pruned(&mut self) -> Result<&PrunedModel, BakeError> {
        let mut params = MakeParams::default();
        if let Some(views) = self.line.views {
            let mut order = CoverageParams::default();
            order.around.azimuths = views;
            params.order = Some(order);
        }
        let (mesh, control) = (&self.mesh, self.control);
        made(&mut self.pruned, || Ok(PrunedModel::make(mesh, &params, control)?))
    }

    fn made_hybrid(&mut self) -> Result<&Hybrid, BakeError> {
        let (grown, control) = (self.grown, self.control);
        let params = HybridParams::default();
        made(&mut self.hybrid, || Ok(Hybrid::make(&grown.tree, &grown.look, &params, control)?))
    }
}

/// What is there already, else what `make` makes.
fn made<T>(
    slot: &mut Option<T>,
    make: impl FnOnce() -> Result<T, BakeError>,
) -> Result<&T, BakeError> {
    let value = match slot.take() {
        Some(value) => value,
        None => make()?,
    };
    Ok(slot.insert(value))
}
