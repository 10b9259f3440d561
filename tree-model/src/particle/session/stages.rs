//! The stages of a session: each is done when it is first asked for, and again only after something it
//! depends on has changed.

use super::params::PhotoParams;
use super::report::{PhotoReport, PhotoTree, ViewReport};
use super::shot::{Attractor, Shot};
use crate::error::{ModelError, Result};
use crate::particle::align::disagreements;
use crate::particle::attractor::{AttractorGraph, from_strokes, livewire, silhouette_seeds};
use crate::particle::density::{carve, sample_points, solve};
use crate::particle::field::{DirectionField, direction_field};
use crate::particle::finish::{grow_crown, grow_wood};
use crate::particle::flow::{Flow, Forces, Traces, Way, run};
use crate::particle::view::are_of_one_side;
use crate::particle::{Grid, View};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Limits, Resource, Seed, Skeleton};

/// A trunk is no wider than this share of the tree's height: a baobab's. Wider ones come from the wrong scale of a
/// camera that the caller placed.
const WIDEST_TRUNK: f32 = 0.5;

/// Stages of the work, in the order in which they are done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Stage {
    /// Cameras: base, height and scale of each view.
    Views,
    /// Main branches in each view.
    Attractors,
    /// The density in space, and the way to the base through it.
    Density,
    /// The direction field of each view.
    Fields,
    /// The particles' traces.
    Flow,
    /// Branches.
    Wood,
    /// Twigs and leaves.
    Crown,
}

impl Stage {
    /// All stages, in order.
    pub const ALL: [Self; 7] = [
        Self::Views,
        Self::Attractors,
        Self::Density,
        Self::Fields,
        Self::Flow,
        Self::Wood,
        Self::Crown,
    ];

    /// The stages that use this one's result directly.
    const fn users(self) -> &'static [Self] {
        match self {
            Self::Views => &[Self::Attractors, Self::Density, Self::Fields],
            Self::Attractors => &[Self::Fields],
            Self::Density => &[Self::Flow, Self::Crown],
            Self::Fields => &[Self::Flow],
            Self::Flow => &[Self::Wood],
            Self::Wood => &[Self::Crown],
            Self::Crown => &[],
        }
    }
}

/// A tree in the making: photographs, parameters, and what has been made of them so far.
///
/// Every stage can be asked for by itself. What is there is kept, so that a change redoes only what comes
/// after it: painting density keeps the branches found in the images, another seed keeps density and fields.
#[derive(Clone, Debug)]
pub struct Session {
    pub(super) shots: Vec<Shot>,
    pub(super) params: PhotoParams,
    pub(super) seed: Seed,
    pub(super) views: Option<Vec<View>>,
    pub(super) attractors: Option<Vec<AttractorGraph>>,
    pub(super) density: Option<Grid>,
    way: Option<Way>,
    fields: Option<Vec<DirectionField>>,
    flow: Option<Flow>,
    wood: Option<Skeleton>,
    crown: Option<PhotoTree>,
    pub(super) report: PhotoReport,
    runs: [u32; Stage::ALL.len()],
}

impl Session {
    /// Begins with one photograph or more.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] without a shot, [`ModelError::View`] for a photograph of another size than its
    /// matte, and as [`PhotoParams::validate`].
    pub fn new(shots: Vec<Shot>, params: PhotoParams, seed: Seed) -> Result<Self> {
        crate::error::check("shots", shots.len() as f64, 1.0, 1000.0)?;
        shots.iter().enumerate().try_for_each(|(view, shot)| shot.check(view))?;
        params.validate()?;
        Ok(Self {
            shots,
            params,
            seed,
            views: None,
            attractors: None,
            density: None,
            way: None,
            fields: None,
            flow: None,
            wood: None,
            crown: None,
            report: PhotoReport::default(),
            runs: [0; Stage::ALL.len()],
        })
    }

    /// The photographs.
    #[must_use]
    pub fn shots(&self) -> &[Shot] {
        &self.shots
    }

    /// The parameters.
    #[must_use]
    pub fn params(&self) -> &PhotoParams {
        &self.params
    }

    /// The seed.
    #[must_use]
    pub fn seed(&self) -> Seed {
        self.seed
    }

    /// How often a stage has been done so far.
    #[must_use]
    pub fn runs(&self, stage: Stage) -> u32 {
        self.runs[stage as usize]
    }

    /// Forgets the result of a stage and of all that depend on it, so that they are done again.
    pub fn redo_from(&mut self, stage: Stage) {
        match stage {
            Stage::Views => self.views = None,
            Stage::Attractors => self.attractors = None,
            Stage::Density => (self.density, self.way) = (None, None),
            Stage::Fields => self.fields = None,
            Stage::Flow => self.flow = None,
            Stage::Wood => self.wood = None,
            Stage::Crown => self.crown = None,
        }
        for &user in stage.users() {
            self.redo_from(user);
        }
    }

    /// Forgets the way to the base and what depends on it; the density stays.
    pub(super) fn forget_way(&mut self) {
        self.way = None;
        self.redo_from(Stage::Flow);
    }

    /// The views: mattes with cameras, one for each photograph. Where all are from one side, an imagined one
    /// from another side comes last; see [`PhotoParams::imagine`].
    ///
    /// # Errors
    /// [`ModelError::View`] naming a photograph in which no tree is found;
    /// [`ModelError::Parameter`] for a camera placed by the caller.
    pub fn views(&mut self, control: &Control) -> Result<&[View]> {
        if self.views.is_none() {
            control.report("views", 0.0)?;
            let views = self.find_views(control.limits)?;
            self.views = Some(views);
            self.runs[Stage::Views as usize] += 1;
        }
        Ok(self.views.as_deref().unwrap_or_default())
    }

    fn find_views(&mut self, limits: Limits) -> Result<Vec<View>> {
        let height = self.params.height;
        let mut views = Vec::with_capacity(self.shots.len());
        let mut alignments = Vec::with_capacity(self.shots.len());
        for (index, shot) in self.shots.iter().enumerate() {
            limits.check(Resource::Pixels, shot.matte.alpha().len() as u64)?;
            let (camera, alignment) = shot.place(index, height)?;
            let (matte, photo) = (shot.matte.clone(), shot.photo.clone());
            views.push(View { matte, photo, camera });
            alignments.push(alignment);
        }
        // Only what was aligned can be misaligned: the caller knows where the others were taken from.
        let aligned: Vec<_> = self
            .shots
            .iter()
            .zip(&alignments)
            .map(|(shot, found)| found.as_ref().filter(|_| shot.is_aligned()))
            .collect();
        self.report =
            PhotoReport { disagreements: disagreements(&aligned), ..PhotoReport::default() };
        self.report.views = aligned
            .iter()
            .map(|found| found.map_or_else(Vec::new, |found| found.warnings.clone()))
            .map(|warnings| ViewReport { warnings, ..ViewReport::default() })
            .collect();
        let found = || {
            views.iter().zip(&alignments).filter_map(|(view, found)| Some((view, found.as_ref()?)))
        };
        self.report.crown_base = found()
            .map(|(view, found)| (view.camera.base.y - found.crown_base) * view.camera.scale)
            .reduce(f32::min)
            .map_or(0.0, |least| least.clamp(0.0, height));
        let widths: Vec<f32> = found()
            .filter_map(|(view, found)| Some(found.trunk_width? * view.camera.scale))
            .filter(|&width| width <= WIDEST_TRUNK * height)
            .collect();
        let mean = widths.iter().sum::<f32>() / widths.len().max(1) as f32;
        self.report.trunk_radius = (!widths.is_empty()).then_some(0.5 * mean);
        if self.params.imagine && are_of_one_side(&views) {
            // At the far end of the ranges the side of a camera may lie beyond them.
            let side = views.first().map(View::turned);
            views.extend(side.filter(|side| side.camera.validate("side").is_ok()));
        }
        Ok(views)
    }

    /// Main branches in each view, an imagined one included; an empty graph where there are none.
    ///
    /// # Errors
    /// As [`views`](Self::views), [`livewire`] and [`from_strokes`].
    pub fn attractors(&mut self, control: &Control) -> Result<&[AttractorGraph]> {
        if self.attractors.is_none() {
            self.views(control)?;
            control.report("attractors", 0.15)?;
            let graphs = self.find_attractors(control)?;
            self.attractors = Some(graphs);
            self.runs[Stage::Attractors as usize] += 1;
        }
        Ok(self.attractors.as_deref().unwrap_or_default())
    }

    fn find_attractors(&mut self, control: &Control) -> Result<Vec<AttractorGraph>> {
        let views = self.views.as_deref().unwrap_or_default();
        let params = &self.params;
        let quiet = control.part(0.15, 0.15);
        let found: Vec<Result<(AttractorGraph, ViewReport)>> = views
            .par_iter()
            .zip(&self.shots)
            .enumerate()
            .map(|(index, (view, shot))| {
                let base = view.camera.base;
                let mut report = ViewReport::default();
                let wire = |seeds: &[_], report: &mut ViewReport| {
                    let (graph, found) = livewire(
                        &view.matte,
                        view.photo.as_ref(),
                        base,
                        seeds,
                        &params.livewire,
                        &quiet,
                    )?;
                    report.livewire = Some(found);
                    Ok(graph)
                };
                let graph = match &shot.attractor {
                    Attractor::Livewire => {
                        let seed = params.attractor_seed.child(index as u64);
                        let seeds = silhouette_seeds(
                            &view.matte,
                            base,
                            params.branches,
                            &params.seeds,
                            seed,
                            &quiet,
                        )?;
                        wire(&seeds, &mut report)
                    }
                    Attractor::Seeds(seeds) => wire(seeds, &mut report),
                    Attractor::Strokes(strokes) => {
                        let (graph, found) = from_strokes(strokes, base, &params.strokes, &quiet)?;
                        report.strokes = Some(found);
                        Ok(graph)
                    }
                    Attractor::Graph(graph) => Ok(graph.clone()),
                    Attractor::None => Ok(AttractorGraph::default()),
                };
                let graph: AttractorGraph =
                    graph.map_err(|error: ModelError| error.in_view(index))?;
                report.attracts = !graph.is_empty();
                Ok((graph, report))
            })
            .collect();
        let mut graphs = Vec::with_capacity(views.len());
        for (found, report) in found.into_iter().zip(&mut self.report.views) {
            let (graph, ViewReport { livewire, strokes, attracts, .. }) = found?;
            (report.livewire, report.strokes, report.attracts) = (livewire, strokes, attracts);
            graphs.push(graph);
        }
        if views.len() > graphs.len()
            && let (Some(first), Some(side)) = (graphs.first(), views.last())
        {
            graphs.push(first.mirrored(side.camera.size.x));
        }
        Ok(graphs)
    }

    /// The density in space, optical depth per metre.
    ///
    /// # Errors
    /// As [`views`](Self::views), [`carve`] and [`solve`].
    pub fn density(&mut self, control: &Control) -> Result<&Grid> {
        if self.density.is_none() {
            self.views(control)?;
            control.report("density", 0.3)?;
            let views = self.views.as_deref().unwrap_or_default();
            let quiet = control.part(0.3, 0.5);
            let params = &self.params.density;
            let (views, carved) = match carve(views, params, &quiet) {
                // Where an imagined side leaves nothing of the tree, the photographs do without it.
                Err(ModelError::View { .. }) if views.len() > self.shots.len() => {
                    let views = &views[..self.shots.len()];
                    (views, carve(views, params, &quiet)?)
                }
                carved => (views, carved?),
            };
            let (grid, report) = solve(&carved, views, params, &quiet)?;
            self.report.density = report;
            self.density = Some(grid);
            self.way = None;
            self.runs[Stage::Density as usize] += 1;
        }
        self.density.as_ref().ok_or_else(missing)
    }

    /// The direction field of each view.
    ///
    /// # Errors
    /// As [`attractors`](Self::attractors) and [`direction_field`].
    pub fn fields(&mut self, control: &Control) -> Result<&[DirectionField]> {
        if self.fields.is_none() {
            self.attractors(control)?;
            control.report("fields", 0.5)?;
            let views = self.views.as_deref().unwrap_or_default();
            let graphs = self.attractors.as_deref().unwrap_or_default();
            let quiet = control.part(0.5, 0.5);
            let fields: Result<Vec<_>> = views
                .par_iter()
                .zip(graphs)
                .map(|(View { camera, .. }, graph)| {
                    direction_field(graph, camera.size, camera.base, &self.params.field, &quiet)
                })
                .collect();
            self.fields = Some(fields?);
            self.runs[Stage::Fields as usize] += 1;
        }
        Ok(self.fields.as_deref().unwrap_or_default())
    }

    /// The particles' traces.
    ///
    /// # Errors
    /// As [`density`](Self::density), [`fields`](Self::fields), [`sample_points`] and [`run`].
    pub fn traces(&mut self, control: &Control) -> Result<&Traces> {
        if self.flow.is_none() {
            self.density(control)?;
            self.fields(control)?;
            control.report("particles", 0.5)?;
            self.flow = Some(self.let_flow(control)?);
            self.runs[Stage::Flow as usize] += 1;
        }
        self.flow.as_ref().map(|flow| &flow.traces).ok_or_else(missing)
    }

    fn let_flow(&mut self, control: &Control) -> Result<Flow> {
        let density = self.density.as_ref().ok_or_else(missing)?;
        let params = &self.params.flow;
        if self.way.is_none() {
            self.way = Some(Way::new(density, params, control)?);
        }
        let way = self.way.as_ref().ok_or_else(missing)?;
        let views = self.views.as_deref().unwrap_or_default();
        let fields = self.fields.as_deref().unwrap_or_default();
        let fields: Vec<_> =
            views.iter().zip(fields).map(|(view, field)| (view.camera, field)).collect();
        let crown_base = self.report.crown_base;
        // The bare trunk is dense as well, but nothing sprouts from it.
        let sprouts = |point: Vec3| f32::from(u8::from(point.y >= crown_base));
        let seed = self.seed.stream("particles");
        let starts = match sample_points(density, params.particles, sprouts, seed, control) {
            // Nothing is dense above the trunk: then the trunk is all there is.
            Err(ModelError::Parameter(_)) => {
                sample_points(density, params.particles, |_| 1.0, seed, control)
            }
            other => other,
        }?;
        let forces = Forces::new(&fields, way, params);
        let flow = run(&starts, self.params.height, &forces, params, &control.part(0.5, 0.7))?;
        self.report.flow = flow.report;
        Ok(flow)
    }

    /// Branches without twigs.
    ///
    /// # Errors
    /// As [`traces`](Self::traces) and [`grow_wood`].
    pub fn wood(&mut self, control: &Control) -> Result<&Skeleton> {
        if self.wood.is_none() {
            self.traces(control)?;
            control.report("branches", 0.7)?;
            let flow = self.flow.as_ref().ok_or_else(missing)?;
            let (height, trunk) = (self.params.height, self.report.trunk_radius);
            let wood = grow_wood(&flow.traces, height, trunk, &self.params.finish, control)?;
            self.wood = Some(wood);
            self.runs[Stage::Wood as usize] += 1;
        }
        self.wood.as_ref().ok_or_else(missing)
    }

    /// The tree.
    ///
    /// # Errors
    /// As [`wood`](Self::wood) and [`grow_crown`].
    pub fn tree(&mut self, control: &Control) -> Result<&PhotoTree> {
        if self.crown.is_none() {
            self.wood(control)?;
            let wood = self.wood.as_ref().ok_or_else(missing)?;
            let density = self.density.as_ref().ok_or_else(missing)?;
            let views = self.views.as_deref().unwrap_or_default();
            let (tree, report) = grow_crown(
                wood,
                density,
                views,
                self.params.height,
                &self.params.finish,
                self.seed.stream("crown"),
                &control.part(0.7, 1.0),
            )?;
            self.report.crown = report;
            self.crown = Some(PhotoTree { tree, report: self.report.clone() });
            self.runs[Stage::Crown as usize] += 1;
        }
        self.crown.as_ref().ok_or_else(missing)
    }
}

/// A stage that was just done is there; this keeps the type system content without a panic.
fn missing() -> ModelError {
    ModelError::Picture { problem: "a stage before has not been done".into() }
}
