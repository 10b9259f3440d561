//! modular-tree 5.6 (`PyPI`, written in C++): the wood of trees, grown and meshed.
//!
//! Its presets are those of its add-on's quick generation: a trunk with one level of branches that split. It has no
//! leaves outside of Blender, so ours are bare too (L-systems derive theirs and drop them). It has 32 sides on every
//! branch, thick or thin; ours has as many as 3 mm of error ask for.

use super::ours::{Ours, Preset};
use super::program::{Absence, Language, Peer, Scratch, Told};
use super::wood::Wood;
use super::{Outcome, SECONDS, beside, memory, or_note};
use crate::table::{Aim, Table};
use serde::Deserialize;
use tree_mesh::Surface;

const PEER: Peer = Peer {
    name: "modular-tree",
    install: "pip install modular-tree==5.6.0 numpy, or examples/evaluate/peers/install.sh",
    language: Language::Python,
    script: "modular_tree.py",
};

/// Its preset, and ours of the species; without one, of no species in particular.
const PAIRS: [(&str, Preset); 5] = [
    ("default", Preset::Grammar("birch")),
    ("oak", Preset::Grammar("oak")),
    ("oak", Preset::Path("oak")),
    // Conifers: ours of rules is a spruce.
    ("pine", Preset::Grammar("spruce")),
    ("pine", Preset::Path("e")),
];

#[derive(Deserialize)]
struct More {
    mesh_seconds: f64,
}

pub(super) fn presets() -> impl Iterator<Item = Preset> + Clone {
    PAIRS.into_iter().map(|(_, preset)| preset)
}

pub(super) fn evaluate(table: &mut Table) -> Outcome {
    let scratch = Scratch::new("modular-tree")?;
    let mut last: Option<(&str, Told<More>, Surface)> = None;
    for (theirs, preset) in PAIRS {
        if last.as_ref().is_none_or(|(name, ..)| *name != theirs) {
            let Some((told, wood)) = or_note(ask(theirs, &scratch)) else {
                return Ok(());
            };
            last = Some((theirs, told, wood));
        }
        let Some((_, told, wood)) = &last else { continue };
        let case = format!("modular-tree {theirs}, {}", preset.name());
        rows(table, &case, told, wood, &Ours::measure(preset, false)?)?;
    }
    Ok(())
}

fn ask(preset: &str, scratch: &Scratch) -> Result<(Told<More>, Surface), Absence> {
    let path = scratch.file("bark.ply");
    let told = PEER.ask(&[preset.as_ref(), SECONDS.to_string().as_ref(), path.as_ref()])?;
    let wood = Wood::read(&path).map_err(|error| PEER.broken(error))?;
    let Told { more: More { mesh_seconds }, seconds, .. } = &told;
    if !(0.0..=*seconds).contains(mesh_seconds) || *mesh_seconds == 0.0 {
        return Err(
            PEER.broken(format!("it says that it meshes in {mesh_seconds} s of {seconds} s"))
        );
    }
    Ok((told, wood))
}

fn rows(table: &mut Table, case: &str, told: &Told<More>, wood: &Surface, ours: &Ours) -> Outcome {
    let bark = ours.mesh.surfaces.first().ok_or("no bark")?;
    let [theirs, own] = [wood, bark].map(|surface| surface.n_triangles() as f64);
    let mut row = |metric, figures, unit, aim| beside(table, case, metric, figures, unit, aim);
    row("time to grow and mesh", [1e3 * told.seconds, 1e3 * ours.seconds], "ms", Aim::None);
    row("time to mesh", [1e3 * told.more.mesh_seconds, 1e3 * ours.mesh_seconds], "ms", Aim::None);
    row("triangles of wood", [theirs, own], "", Aim::None);
    let rates = [theirs / told.seconds, own / ours.seconds];
    row("triangles a second, all", rates, "1/s", ours.aim(rates[0]));
    let rates = [theirs / told.more.mesh_seconds, own / ours.mesh_seconds];
    row("triangles a second, mesh", rates, "1/s", Aim::AtLeast(rates[0]));
    Wood::rows(table, case, &Wood::of(wood)?, &Wood::of(bark)?);
    memory(table, case, told.peak_bytes, ours.peak_bytes);
    Ok(())
}
