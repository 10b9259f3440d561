//! ez-tree 1.1 (npm, on node): whole trees, bark and leaf cards, of the same species.
//!
//! Its trees are recursive: every branch bears so many of the next level. It cannot be asked to grow without meshing.
//! Counts of triangles differ, so the aim is on triangles a second.

use super::ours::{Ours, Preset};
use super::program::{Absence, Language, Peer, Scratch, Told};
use super::wood::Wood;
use super::{Outcome, SECONDS, beside, memory, or_note};
use crate::table::{Aim, Table};
use serde::Deserialize;
use tree_mesh::Surface;

const PEER: Peer = Peer {
    name: "ez-tree",
    install: "npm install @dgreenheck/ez-tree@1.1.0 three@0.187.0, or examples/evaluate/peers/install.sh",
    language: Language::Node,
    script: "ez_tree.mjs",
};

/// Its preset, and ours of the species.
const PAIRS: [(&str, Preset); 8] = [
    ("Oak Large", Preset::Grammar("oak")),
    ("Oak Large", Preset::Path("oak")),
    ("Oak Large", Preset::Growth("oak")),
    ("Ash Large", Preset::Path("a")),
    // Conifers: ours of rules is a spruce.
    ("Pine Large", Preset::Grammar("spruce")),
    ("Pine Large", Preset::Path("e")),
    ("Pine Large", Preset::Growth("pine")),
    // Aspens are poplars.
    ("Aspen Large", Preset::Growth("poplar")),
];

#[derive(Deserialize)]
struct More {
    leaf_triangles: f64,
}

/// What a preset of theirs took, and its wood.
struct Theirs {
    told: Told<More>,
    wood: Surface,
}

pub(super) fn presets() -> impl Iterator<Item = Preset> + Clone {
    PAIRS.into_iter().map(|(_, preset)| preset)
}

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let scratch = Scratch::new("ez-tree")?;
    let mut last: Option<(&str, Theirs)> = None;
    for (theirs, preset) in PAIRS {
        if last.as_ref().is_none_or(|(name, _)| *name != theirs) {
            let Some(made) = or_note(ask(theirs, &scratch)) else {
                return Ok(());
            };
            last = Some((theirs, made));
        }
        let Some((_, made)) = &last else { continue };
        let case = format!("ez-tree {theirs}, {}", preset.name());
        rows(table, &case, made, &Ours::measure(preset, true)?)?;
    }
    Ok(())
}

fn ask(preset: &str, scratch: &Scratch) -> Result<Theirs, Absence> {
    let path = scratch.file("bark.ply");
    let told = PEER.ask(&[preset.as_ref(), SECONDS.to_string().as_ref(), path.as_ref()])?;
    let wood = Wood::read(&path).map_err(|error| PEER.broken(error))?;
    Ok(Theirs { told, wood })
}

fn rows(table: &mut Table, case: &str, peer: &Theirs, ours: &Ours) -> Outcome {
    let triangles = peer.wood.n_triangles() as f64 + peer.told.more.leaf_triangles;
    let rate = triangles / peer.told.seconds;
    let mut row = |metric, figures, unit, aim| beside(table, case, metric, figures, unit, aim);
    row("time to grow and mesh", [1e3 * peer.told.seconds, 1e3 * ours.seconds], "ms", Aim::None);
    row("triangles, wood and leaves", [triangles, ours.triangles()], "", Aim::None);
    let rates = [rate, ours.triangles() / ours.seconds];
    row("triangles a second, all", rates, "1/s", ours.aim(rate));
    let bark = ours.mesh.surfaces.first().ok_or("no bark")?;
    row("triangles of wood", [&peer.wood, bark].map(|s| s.n_triangles() as f64), "", Aim::None);
    Wood::rows(table, case, &Wood::of(&peer.wood)?, &Wood::of(bark)?);
    memory(table, case, peer.told.peak_bytes, ours.peak_bytes);
    Ok(())
}
