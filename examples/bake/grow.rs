//! A line of the manifest to a tree and how it is drawn.

use crate::manifest::{Line, Source, is_grammar};
use crate::resize::{bare, dressed, scaled};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tree_core::{Control, CoreError, Seed, Tree, file};
use tree_lod::LodError;
use tree_mesh::io::{self, ImportOptions};
use tree_mesh::{ErrorBound, LeafForm, LeafMesh, Look, MeshError, MeshParams};
use tree_model::lsystem::LSystem;
use tree_model::particle::finish::FinishParams;
use tree_model::particle::session::{PhotoModel, PhotoParams, Shot};
use tree_model::particle::{Photo, matting};
use tree_model::silhouette::read::{from_photo, from_svg};
use tree_model::silhouette::session::{Session, SilhouetteParams};
use tree_model::skeletonize::{SkeletonizeParams, skeletonize};
use tree_model::sketch::read as strokes;
use tree_model::sketch::session::{SketchModel, SketchParams};
use tree_model::{ModelError, Modeler, growth, path};

/// Why a tree was not baked.
#[derive(Debug, thiserror::Error)]
pub(crate) enum BakeError {
    #[error("{path}: {problem}")]
    Input { path: String, problem: String },
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error(transparent)]
    Mesh(#[from] MeshError),
    #[error(transparent)]
    Lod(#[from] LodError),
    #[error(transparent)]
    Core(#[from] CoreError),
    #[error("a defect of this program, please report it: {0}")]
    Panic(String),
}

/// A tree, ready to be meshed.
pub(crate) struct Grown {
    pub(crate) tree: Tree,
    pub(crate) look: Look,
    pub(crate) params: MeshParams,
    /// In sentences.
    pub(crate) warnings: Vec<String>,
}

impl Grown {
    fn of(tree: Tree) -> Result<Self, BakeError> {
        let look = Look::built_in(tree.species())?;
        Ok(Self { tree, look, params: MeshParams::default(), warnings: Vec::new() })
    }
}

/// Grows what a line asks for. Files are looked for in `folder`.
pub(crate) fn grow(line: &Line, folder: &Path, control: &Control) -> Result<Grown, BakeError> {
    let seed = Seed(line.seed);
    let mut grown = match &line.modeler {
        Source::Path(name) => {
            preset(path::Preset::find(name)?.params()?.model(seed, control)?, line)
        }
        Source::Lsystem(name) => {
            preset(lsystem(name, folder, control)?.model(seed, control)?, line)
        }
        Source::Growth(name) => {
            preset(growth::Preset::find(name)?.params().model(seed, control)?, line)
        }
        Source::Silhouette(path) => silhouette(line, &folder.join(path), control),
        Source::Sketch(path) => sketch(line, &folder.join(path), control),
        Source::Photo(paths) => photo(line, folder, paths, control),
        Source::Mesh(path) => mesh(line, &folder.join(path), control),
    }?;
    if line.bare {
        grown.tree = bare(grown.tree);
    }
    grown.tree = scaled(grown.tree, line.scale)?;
    Ok(grown)
}

/// A preset's tree, in the leaves of the species asked for.
fn preset(tree: Tree, line: &Line) -> Result<Grown, BakeError> {
    match &line.species {
        Some(name) => Grown::of(dressed(tree, FinishParams::find(name)?.species)?),
        None => Grown::of(tree),
    }
}

fn lsystem(name: &str, folder: &Path, control: &Control) -> Result<LSystem, BakeError> {
    if !is_grammar(name) {
        return Ok(LSystem::preset(name)?);
    }
    let path = folder.join(name);
    let text = file::read_text(&path, &control.limits)?;
    LSystem::parse(&text, &control.limits).map_err(|error| input(&path, &error))
}

fn silhouette(line: &Line, path: &Path, control: &Control) -> Result<Grown, BakeError> {
    let drawing = match extension(path).as_str() {
        "svg" => from_svg(&file::read_text(path, &control.limits)?),
        "png" | "jpg" | "jpeg" => from_photo(&Photo::open(path, &control.limits)?),
        _ => return Err(input(path, &"outlines are read from .svg, .png and .jpg")),
    };
    let drawing = drawing.map_err(|error| input(path, &error))?;
    let strokes = drawing.trees.first().ok_or_else(|| input(path, &"the drawing shows no tree"))?;
    let mut params = SilhouetteParams::default();
    params.height = line.height.unwrap_or(params.height);
    if let Some(name) = &line.species {
        params.grow.species = FinishParams::find(name)?.species;
    }
    let (session, report) = Session::of_drawing(strokes, params, Seed(line.seed))?;
    let mut grown = Grown::of(session.tree(control)?.tree)?;
    // A drawn leaf is cut out as it was drawn.
    if let Some(leaf) = session.plan().and_then(|plan| plan.leaf.as_ref()) {
        grown.look.leaves = Look::plain(grown.tree.species()).leaves;
        let form = Arc::new(LeafMesh::flat(&leaf.outline.points, &leaf.outline.triangles));
        grown.look.leaves.iter_mut().for_each(|kind| kind.form = LeafForm::Mesh(form.clone()));
    }
    let said = drawing.repairs.iter().map(ToString::to_string);
    grown.warnings = said.chain(report.repairs).chain(report.refused).collect();
    Ok(grown)
}

fn sketch(line: &Line, path: &Path, control: &Control) -> Result<Grown, BakeError> {
    let text = file::read_text(path, &control.limits)?;
    let drawing = match extension(path).as_str() {
        "svg" => strokes::from_svg(&text),
        "json" => strokes::from_json(&text),
        _ => return Err(input(path, &"sketches are read from .svg and .json")),
    };
    let drawing = drawing.map_err(|error| input(path, &error))?;
    let species = line.species.clone();
    let params = SketchParams { height: line.height, species, ..SketchParams::default() };
    Grown::of(
        SketchModel { drawing, params, ..SketchModel::default() }
            .model(Seed(line.seed), control)?,
    )
}

fn photo(
    line: &Line,
    folder: &Path,
    paths: &[PathBuf],
    control: &Control,
) -> Result<Grown, BakeError> {
    let (mut shots, mut warnings) = (Vec::new(), Vec::new());
    for (turn, path) in paths.iter().enumerate() {
        let photo = Photo::open(folder.join(path), &control.limits)?;
        let (matte, report) =
            matting::automatic(&photo, &matting::AutomaticParams::default(), control)
                .map_err(|error| input(path, &error))?;
        warnings
            .extend(report.warnings.iter().map(|warning| format!("{}: {warning}", path.display())));
        shots.push(Shot::new(matte, Some(photo), turn as f32 * std::f32::consts::FRAC_PI_2));
    }
    let mut params = PhotoParams::default();
    params.height = line.height.unwrap_or(params.height);
    params.finish = FinishParams::find(line.species.as_deref().unwrap_or("oak"))?;
    let tree = PhotoModel { shots, params }.model(Seed(line.seed), control)?;
    Ok(Grown { warnings, ..Grown::of(tree)? })
}

fn mesh(line: &Line, path: &Path, control: &Control) -> Result<Grown, BakeError> {
    let read = io::read(path, &ImportOptions { external: true }, control)
        .map_err(|error| input(path, &error))?;
    let made = skeletonize(&read.mesh.parts(), &SkeletonizeParams::default(), control)
        .map_err(|error| input(path, &error))?;
    let size = made.tree.skeleton().bounds().size().max_element() * line.scale;
    // Lengths in these are metres; a mesh may have any unit.
    let params = MeshParams {
        flare: 0.0,
        error: ErrorBound::Metres((3e-4 * size).clamp(1e-5, 1.0)),
        min_radius: (5e-5 * size).clamp(1e-5, 0.1),
        ..MeshParams::default()
    };
    if line.species.is_some() {
        return Ok(Grown { params, ..preset(made.tree, line)? });
    }
    let mut look = Look::plain(made.tree.species());
    for (leaf, &width) in look.leaves.iter_mut().zip(&made.report.leaf_widths) {
        leaf.width = width.clamp(0.05, 20.0);
    }
    Ok(Grown { tree: made.tree, look, params, warnings: Vec::new() })
}

fn extension(path: &Path) -> String {
    path.extension().map_or(String::new(), |end| end.to_string_lossy().to_lowercase())
}

fn input(path: &Path, problem: &impl ToString) -> BakeError {
    BakeError::Input { path: path.display().to_string(), problem: problem.to_string() }
}
