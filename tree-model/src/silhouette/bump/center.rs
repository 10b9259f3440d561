//! Central point, direction and radius of bumps.

use super::border::Border;
use super::mesh::Mesh;
use super::stand::{End, disc};
use super::{Bump, Outline};
use glam::{DVec2, Vec2};

/// A disc still touches the tip when its radius comes this near to its distance, as a share: tips are uneven.
const TOUCHES: f64 = 1.15;

/// A disc wider than this share of the width the bump stands on is no more the bump's.
const WIDEST: f64 = 0.6;

/// The direction is measured from at least this share of the bump's width, and of its radius, farther in.
const REACH: [f64; 2] = [0.35, 0.7];

/// Tips are sought this many steps of the border on either side of where they are after smoothing.
const SHARP: f64 = 3.0;

/// Passes of smoothing along the axis: the middles of chords zigzag a little.
const PASSES: usize = 3;

/// The bump at an end of the axis. O(length of its axis · m + n).
pub(super) fn bump(outline: &Outline, border: &Border, mesh: &Mesh, end: &End) -> Bump {
    let line = axis(mesh, end);
    let tip = mesh.at()[end.tip as usize];
    let mut at = 0;
    let mut radius = 0.0;
    for (i, &place) in line.iter().enumerate() {
        let free = mesh.clearance(place);
        if place.distance(tip) > TOUCHES * free || free > WIDEST * end.neck {
            break;
        }
        (at, radius) = (i, free);
    }
    let center = line[at];
    let reach = (REACH[0] * end.neck).max(REACH[1] * radius);
    let behind = line[at..].iter().find(|p| p.distance(center) >= reach);
    // A bump flatter than its disc has its centre where it begins.
    let (from, to) = match behind {
        Some(&behind) => (behind, center),
        None => (line[line.len() - 1], tip),
    };
    let tangent = (to - from).try_normalize().or((tip - from).try_normalize());
    let radius = border.frame.length(radius);
    let body = border.frame.to_drawing(end.body.0);
    let smoothed = border.frame.to_drawing(tip);
    let tip = sharp(outline, border, end.tip, body).unwrap_or(smoothed);
    Bump {
        center: border.frame.to_drawing(center),
        tip,
        tangent: tangent.map_or(Vec2::Y, DVec2::as_vec2).normalize_or(Vec2::Y),
        radius,
        stretch: stretch(border, end.stretch),
    }
}

/// The one bump of an outline on which nothing stands out: about its widest place, its tip at the top. O(m² + n).
pub(super) fn whole(outline: &Outline, border: &Border, mesh: &Mesh) -> Bump {
    let paths = mesh.terminals().into_iter().take(1).map(|terminal| terminal.path);
    let discs =
        paths.flat_map(|path| path.windows(2).map(|pair| disc(mesh, pair)).collect::<Vec<_>>());
    let middle = mesh.at().iter().sum::<DVec2>() / mesh.at().len().max(1) as f64;
    let none = (middle, mesh.clearance(middle));
    let widest = discs.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or(none);
    let center = border.frame.to_drawing(widest.0);
    let (mut top, mut at, mut along) = (center, 0.0, 0.0);
    for (from, to) in outline.sides() {
        if from.y > top.y {
            (top, at) = (from, along);
        }
        along += f64::from(from.distance(to));
    }
    let half = (at + 0.5 * border.length) % border.length;
    Bump {
        center,
        tip: top,
        tangent: (top - center).normalize_or(Vec2::Y),
        radius: border.frame.length(widest.1),
        stretch: [half as f32, (half + border.length) as f32],
    }
}

/// The axis from the tip inwards to the middle of the disc that the end stands on.
fn axis(mesh: &Mesh, end: &End) -> Vec<DVec2> {
    let mut line = vec![mesh.at()[end.tip as usize]];
    line.extend(end.path.windows(2).filter_map(|pair| mesh.chord(pair[0], pair[1])));
    line.push(end.body.0);
    for _ in 0..PASSES {
        let before = line.clone();
        for (point, around) in line.iter_mut().skip(1).zip(before.windows(3)) {
            *point = 0.25 * (around[0] + 2.0 * around[1] + around[2]);
        }
    }
    line
}

/// The point of the outline about a point of the border that is farthest from `body`: smoothing rounds tips. O(n).
fn sharp(outline: &Outline, border: &Border, tip: u32, body: Vec2) -> Option<Vec2> {
    let near = border.along(tip);
    let mut along = 0.0;
    let mut best: Option<Vec2> = None;
    for (from, to) in outline.sides() {
        let side = f64::from(from.distance(to));
        // Corners about the tip, and where there are none the side it lies on.
        let on = ((near - along) % border.length + border.length) % border.length;
        let mut add = |point: Vec2| {
            if best.is_none_or(|best| point.distance(body) > best.distance(body)) {
                best = Some(point);
            }
        };
        if on.min(border.length - on) <= SHARP * border.step() {
            add(from);
        }
        if on <= side {
            add(from.lerp(to, (on / side) as f32));
        }
        along += side;
    }
    best
}

/// A stretch of the border along the outline, in metres.
fn stretch(border: &Border, [from, to]: [u32; 2]) -> [f32; 2] {
    let (from, to) = (border.along(from), border.along(to));
    let to = if to < from { to + border.length } else { to };
    let round = if from >= border.length { border.length } else { 0.0 };
    [(from - round) as f32, (to - round) as f32]
}
