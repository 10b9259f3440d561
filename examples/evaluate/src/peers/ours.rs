//! Our trees beside theirs: presets of three modelers.

use super::{CASE, Outcome, fastest};
use crate::measure::peak_bytes;
use crate::table::Aim;
use std::hint::black_box;
use tree_core::{Control, Seed, Tree};
use tree_mesh::{Look, Mesh, MeshParams, build};
use tree_model::{growth, lsystem, path};

const SEED: Seed = Seed(1);

/// A preset: which modeler, which name.
#[derive(Clone, Copy)]
pub(super) enum Preset {
    Path(&'static str),
    Growth(&'static str),
    Grammar(&'static str),
}

impl Preset {
    /// Whether rules expand it, as in the peers.
    const fn by_rules(self) -> bool {
        matches!(self, Self::Grammar(_))
    }

    pub(super) fn name(self) -> String {
        match self {
            Self::Path(name) => format!("path {name}"),
            Self::Growth(name) => format!("growth {name}"),
            Self::Grammar(name) => format!("lsystem {name}"),
        }
    }

    /// With leaves, or the wood alone. (Leaves of L-systems are in their grammars: they are dropped there.)
    pub(super) fn grow(self, leafy: bool) -> Outcome<Tree> {
        let control = Control::default();
        let tree = match self {
            Self::Path(name) => {
                let mut params = path::Preset::find(name)?.params()?;
                params.roots = None;
                params.leaves = params.leaves.filter(|_| leafy);
                params.grow(SEED, &control)?.tree
            }
            Self::Growth(name) => {
                let mut params = growth::Preset::find(name)?.params();
                params.habit.leaves = params.habit.leaves.filter(|_| leafy);
                params.grow(SEED, &control)?.tree
            }
            Self::Grammar(name) => {
                lsystem::Preset::find(name)?.system()?.grow(SEED, &control)?.tree
            }
        };
        Ok(if leafy || tree.foliage().is_empty() {
            tree
        } else {
            Tree::bare(tree.skeleton().clone(), tree.species().clone())
        })
    }

    fn case(self, leafy: bool) -> String {
        format!("{CASE}{}:{}", self.name(), if leafy { "leafy" } else { "bare" })
    }
}

/// The mesh without textures: theirs are left out too.
pub(super) fn mesh(tree: &Tree, params: &MeshParams) -> Outcome<Mesh> {
    Ok(build(tree, &Look::plain(tree.species()), params, &Control::default())?.mesh)
}

/// What ours took.
pub(super) struct Ours {
    preset: Preset,
    /// To grow and to mesh.
    pub(super) seconds: f64,
    /// To mesh alone.
    pub(super) mesh_seconds: f64,
    pub(super) peak_bytes: Option<u64>,
    pub(super) mesh: Mesh,
}

impl Ours {
    pub(super) fn measure(preset: Preset, leafy: bool) -> Outcome<Self> {
        let params = MeshParams::default();
        let peak_bytes = peak_bytes(&preset.case(leafy));
        let (seconds, tree) = fastest(|| {
            let tree = preset.grow(leafy)?;
            black_box(mesh(&tree, &params)?);
            Ok(tree)
        })?;
        let (mesh_seconds, mesh) = fastest(|| mesh(&tree, &params))?;
        Ok(Self { preset, seconds, mesh_seconds, peak_bytes, mesh })
    }

    /// "Not slower than the peer" in growing and meshing, where the work is of one kind.
    pub(super) fn aim(&self, rate: f64) -> Aim {
        if self.preset.by_rules() { Aim::AtLeast(rate) } else { Aim::None }
    }

    pub(super) fn triangles(&self) -> f64 {
        self.mesh.surfaces.iter().map(|surface| surface.n_triangles()).sum::<usize>() as f64
    }
}

/// Does what a case of [`peak_bytes`] names, if it is one of ours.
pub(crate) fn build_case(case: &str) -> Outcome {
    let Some(case) = case.strip_prefix(CASE) else {
        return Ok(());
    };
    if super::meshoptimizer::build_case(case)?
        || super::matting::build_case(case)?
        || super::lpy::build_case(case)?
    {
        return Ok(());
    }
    let presets = super::ez_tree::presets().chain(super::modular_tree::presets());
    let find = |leafy| presets.clone().find(|p| p.case(leafy).strip_prefix(CASE) == Some(case));
    let (preset, leafy) = find(true)
        .map(|preset| (preset, true))
        .or_else(|| find(false).map(|preset| (preset, false)))
        .ok_or_else(|| format!("no case {case}"))?;
    black_box(mesh(&preset.grow(leafy)?, &MeshParams::default())?);
    Ok(())
}
