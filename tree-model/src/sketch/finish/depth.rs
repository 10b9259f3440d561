//! Smooth depth: what inference gives is a depth for each fork, and branches that bend there sharply as seen from the
//! side.

use crate::sketch::{Branches, Label};
use tree_core::NO_PARENT;

/// How far a point's depth moves in one pass towards that of the line between its neighbours.
const STEP: f32 = 0.5;

/// The same branches with their depths (z) smoothed along axes, `passes` times; x and y stay to the bit, and so do the
/// base and all tips. To be done before propagation: what grows, grows on the smooth branches.
///
/// # Complexity
/// O(points × passes).
#[must_use]
pub fn smooth_depth(branches: &Branches, passes: u32) -> Branches {
    let mut branches = branches.clone();
    let heirs = heirs(&branches);
    for _ in 0..passes {
        let before = branches.points.clone();
        let span = |segment: usize| {
            branches.starts[segment] as usize..branches.starts[segment + 1] as usize
        };
        for (segment, &heir) in heirs.iter().enumerate() {
            let run = span(segment);
            for at in run.start + 1..run.end {
                let above = if at + 1 < run.end {
                    at + 1
                } else {
                    match heir {
                        NO_PARENT => continue,
                        heir => span(heir as usize).start + 1,
                    }
                };
                let [a, b, c] = [at - 1, at, above].map(|i| before[i]);
                let (down, up) =
                    (a.truncate().distance(b.truncate()), b.truncate().distance(c.truncate()));
                let share = if down + up > 0.0 { down / (down + up) } else { 0.5 };
                branches.points[at].z = b.z + STEP * (a.z + share * (c.z - a.z) - b.z);
            }
            let parent = branches.parents[segment];
            if parent != NO_PARENT {
                let end = span(parent as usize).end - 1;
                branches.points[run.start] = branches.points[end];
            }
        }
    }
    branches
}

/// The child that goes on where each segment ends: the apical, or the first; [`NO_PARENT`] at tips.
fn heirs(branches: &Branches) -> Vec<u32> {
    let mut heirs = vec![NO_PARENT; branches.len()];
    for segment in (1..branches.len()).rev() {
        let heir = &mut heirs[branches.parents[segment] as usize];
        let apical = branches.labels[segment] == Label::Apical;
        let there = *heir != NO_PARENT && branches.labels[*heir as usize] == Label::Apical;
        if apical || !there {
            *heir = segment as u32;
        }
    }
    heirs
}
