//! Small changes to a simplified blade, as long as they help.
//!
//! 1. A vertex moves to a neighbour in the full blade that is not used yet. So triangles can reach
//!    points within the blade, such as those of the midrib.
//! 2. An edge between two triangles is flipped.
//!
//! A change is made when the judge's error becomes smaller and no triangle turns over.

use super::judge::Judge;
use super::shape::Blade;
use glam::Vec3;

/// Most triangles for which this is worth its time.
const TRIANGLES_MAX: usize = 64;
/// Rounds over all vertices and edges at most; three are usual.
const ROUNDS_MAX: usize = 6;
/// Least cosine between the normals of a triangle before and after a change.
const TURN_MIN: f32 = 0.3;
/// Least gain that a change is made for: less may be luck of the pixels.
const GAIN_MIN: f32 = 5e-4;
/// Smallest area of a triangle, of a blade of area 1.
const AREA_MIN: f32 = 1e-5;

/// A simplified blade and its error.
#[derive(Clone)]
pub(super) struct Way {
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) error: f32,
}

/// `way` with all changes that help. `up` is the side that all triangles of a disc show.
///
/// # Complexity
/// O(triangles) looks of the judge in each round.
pub(super) fn polished(blade: &Blade, judge: &Judge<'_>, mut way: Way, up: Option<Vec3>) -> Way {
    if way.triangles.len() > TRIANGLES_MAX {
        return way;
    }
    let neighbours = neighbours(blade);
    for _ in 0..ROUNDS_MAX {
        let before = way.error;
        for pair in &neighbours {
            try_move(blade, judge, &mut way, *pair, up);
        }
        for i in 0..way.triangles.len() {
            for j in i + 1..way.triangles.len() {
                try_flip(blade, judge, &mut way, (i, j), up);
            }
        }
        if way.error >= before {
            break;
        }
    }
    way
}

/// Both directions of all edges.
fn neighbours(blade: &Blade) -> Vec<(u32, u32)> {
    let sides = |&[a, b, c]: &[u32; 3]| [(a, b), (b, a), (b, c), (c, b), (c, a), (a, c)];
    let mut pairs: Vec<_> = blade.triangles.iter().flat_map(sides).collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

fn try_move(
    blade: &Blade,
    judge: &Judge<'_>,
    way: &mut Way,
    (from, to): (u32, u32),
    up: Option<Vec3>,
) {
    let mut seen = false;
    for triangle in &way.triangles {
        seen |= triangle.contains(&from);
        if triangle.contains(&to) {
            return;
        }
    }
    if !seen {
        return;
    }
    let moved = |t: &[u32; 3]| t.map(|v| if v == from { to } else { v });
    let fits = way
        .triangles
        .iter()
        .filter(|t| t.contains(&from))
        .all(|t| fits(blade, blade.cross(*t), moved(t), up));
    if fits {
        take_if_better(judge, way, way.triangles.iter().map(moved).collect());
    }
}

fn try_flip(
    blade: &Blade,
    judge: &Judge<'_>,
    way: &mut Way,
    (i, j): (usize, usize),
    up: Option<Vec3>,
) {
    let Some([a, b, c, d]) = across(way.triangles[i], way.triangles[j]) else { return };
    if way.triangles.iter().any(|t| t.contains(&c) && t.contains(&d)) {
        return;
    }
    let old = blade.cross(way.triangles[i]) + blade.cross(way.triangles[j]);
    let flipped = [[a, d, c], [d, b, c]];
    if flipped.iter().all(|&t| fits(blade, old, t, up)) {
        let mut triangles = way.triangles.clone();
        (triangles[i], triangles[j]) = (flipped[0], flipped[1]);
        take_if_better(judge, way, triangles);
    }
}

/// The common edge of two triangles, as the first has it, and the corner of each across it.
fn across(first: [u32; 3], second: [u32; 3]) -> Option<[u32; 4]> {
    let turns = |t: [u32; 3]| [[t[0], t[1], t[2]], [t[1], t[2], t[0]], [t[2], t[0], t[1]]];
    turns(first).into_iter().find_map(|[a, b, c]| {
        let other = turns(second).into_iter().find(|&[p, q, _]| (p, q) == (b, a))?;
        (other[2] != c).then_some([a, b, c, other[2]])
    })
}

fn fits(blade: &Blade, old: Vec3, triangle: [u32; 3], up: Option<Vec3>) -> bool {
    let new = blade.cross(triangle);
    let size = new.length();
    size > AREA_MIN
        && new.dot(old) > TURN_MIN * size * old.length()
        && up.is_none_or(|up| new.dot(up) > TURN_MIN * size)
}

fn take_if_better(judge: &Judge<'_>, way: &mut Way, triangles: Vec<[u32; 3]>) {
    let most = way.error - GAIN_MIN;
    let error = judge.error(&triangles, most);
    if error < most {
        *way = Way { triangles, error };
    }
}
