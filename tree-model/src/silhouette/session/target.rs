//! Which branch a stroke is about (sections 3.3 and 4.2).

use crate::silhouette::plan::{Lateral, System};
use crate::silhouette::{Line, Outline};

/// Points by which the length of a branch inside an outline is measured.
const SAMPLES: usize = 32;

/// All systems of a level of axes: 0 is the trunk's.
pub(super) fn systems(system: &mut System, level: u32) -> Vec<&mut System> {
    let mut out = vec![system];
    for _ in 0..level {
        out = out
            .into_iter()
            .flat_map(|system| &mut system.laterals)
            .filter_map(|lateral| lateral.system.as_deref_mut())
            .collect();
    }
    out
}

/// Metres of a branch inside an outline.
pub(super) fn length_inside(lateral: &Lateral, outline: &Outline) -> f32 {
    let at = |i: usize| lateral.line.at((i as f32 + 0.5) / SAMPLES as f32);
    let inside = (0..SAMPLES).filter(|&i| outline.contains(at(i))).count();
    lateral.line.length() * inside as f32 / SAMPLES as f32
}

/// How far a drawn line is from a branch: the mean distance of their ends over the branch's span.
pub(super) fn distance(lateral: &Lateral, line: &Line) -> f32 {
    let base = lateral.line.start().distance(line.start());
    let end = lateral.line.end().distance(line.end());
    0.5 * (base + end) / lateral.line.span().length().max(f32::MIN_POSITIVE)
}

/// The branch of an id, anywhere.
pub(super) fn find(system: &mut System, id: u32) -> Option<&mut Lateral> {
    for lateral in &mut system.laterals {
        if lateral.id == id {
            return Some(lateral);
        }
        if let Some(found) = lateral.system.as_deref_mut().and_then(|inner| find(inner, id)) {
            return Some(found);
        }
    }
    None
}

/// The system that bears the branch of an id, the index of it there, and the level of the system's axis.
pub(super) fn bearer(
    system: &mut System,
    id: u32,
    level: u32,
) -> Option<(&mut System, usize, u32)> {
    if let Some(index) = system.laterals.iter().position(|lateral| lateral.id == id) {
        return Some((system, index, level));
    }
    let inner = system.laterals.iter_mut().filter_map(|lateral| lateral.system.as_deref_mut());
    inner.into_iter().find_map(|inner| bearer(inner, id, level + 1))
}
