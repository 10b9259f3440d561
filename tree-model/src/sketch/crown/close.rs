//! Strokes of a crown become closed loops (figure 4.15).

use super::super::footprint::convex_hull;
use super::{CrownParams, CrownRepair, CrownReport, is_good, unite};
use glam::Vec2;
use std::f32::consts::{PI, TAU};

/// With more open strokes than this, ends are not joined pair by pair: they are ordered round the crown at once.
const MOST_STROKES: usize = 500;

/// Ends closer than this share of a loop's length are one point.
const SAME_PLACE: f32 = 1e-5;

/// Angles that differ by less are the same.
const SAME_ANGLE: f32 = 1e-4;

/// A line being put together of strokes.
struct Line {
    /// The first stroke in it.
    stroke: usize,
    points: Vec<Vec2>,
}

impl Line {
    fn ends(&self) -> [Vec2; 2] {
        let first = self.points.first().copied().unwrap_or_default();
        [first, self.points.last().copied().unwrap_or_default()]
    }

    fn gap(&self) -> f32 {
        let [first, last] = self.ends();
        first.distance(last)
    }
}

/// Closed loops of crown strokes.
pub(super) fn loops(
    strokes: &[Vec<Vec2>],
    branches: &[Vec2],
    params: &CrownParams,
    report: &mut CrownReport,
) -> Vec<Vec<Vec2>> {
    let lines = clean(strokes, report);
    let (mut closed, open) = part(lines, params, report);
    let open = join(open, params.join, report);
    let (more, open) = part(open, params, report);
    closed.extend(more);
    let open = drop_details(open, &closed, report);
    let is_free = |point: &&Vec2| !closed.iter().any(|polygon| unite::contains(polygon, **point));
    let free: Vec<Vec2> = branches.iter().filter(is_free).copied().collect();
    closed.extend(ring(open, &free, report));
    closed
}

/// Leaves out bad and repeated points, and strokes that have no length then.
fn clean(strokes: &[Vec<Vec2>], report: &mut CrownReport) -> Vec<Line> {
    let mut lines = Vec::new();
    for (stroke, drawn) in strokes.iter().enumerate() {
        let mut points: Vec<Vec2> = drawn.iter().copied().filter(is_good).collect();
        let count = drawn.len() - points.len();
        if count > 0 {
            report.repairs.push(CrownRepair::PointsDropped { stroke, count });
        }
        points.dedup();
        if points.len() < 2 {
            report.repairs.push(CrownRepair::StrokeDropped { stroke });
        } else {
            lines.push(Line { stroke, points });
        }
    }
    lines
}

/// Parts lines with close ends, which are loops, from open ones.
fn part(
    lines: Vec<Line>,
    params: &CrownParams,
    report: &mut CrownReport,
) -> (Vec<Vec<Vec2>>, Vec<Line>) {
    let (mut closed, mut open) = (Vec::new(), Vec::new());
    for line in lines {
        let length: f32 = line.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        let gap = line.gap();
        if line.points.len() < 3 || gap > params.gap * length {
            open.push(line);
            continue;
        }
        let mut points = line.points;
        if gap <= SAME_PLACE * length {
            points.pop();
        } else {
            report.repairs.push(CrownRepair::Closed { stroke: line.stroke, gap });
        }
        closed.push(points);
    }
    (closed, open)
}

/// Joins open lines at ends within `share` of the size of all, the closest ends first.
fn join(lines: Vec<Line>, share: f32, report: &mut CrownReport) -> Vec<Line> {
    let all = || lines.iter().flat_map(|line| &line.points).copied();
    let size = (all().fold(Vec2::NEG_INFINITY, Vec2::max) - all().fold(Vec2::INFINITY, Vec2::min))
        .max_element();
    if lines.len() < 2 || lines.len() > MOST_STROKES {
        return lines;
    }
    // End 2i is the first of line i, end 2i + 1 its last.
    let ends: Vec<Vec2> = lines.iter().flat_map(Line::ends).collect();
    let mut pairs = Vec::new();
    for (i, a) in ends.iter().enumerate() {
        for (j, b) in ends.iter().enumerate().skip(i + 1) {
            let distance = a.distance(*b);
            if i / 2 != j / 2 && distance <= share * size {
                pairs.push((distance, i, j));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    let mut mates: Vec<Option<usize>> = vec![None; ends.len()];
    for (_, i, j) in pairs {
        if mates[i].is_none() && mates[j].is_none() {
            (mates[i], mates[j]) = (Some(j), Some(i));
            report.repairs.push(CrownRepair::Joined { count: 1 });
        }
    }
    sum_joints(report);
    thread(&lines, &mates)
}

/// One line in the report for all joints.
fn sum_joints(report: &mut CrownReport) {
    let is_joint = |repair: &CrownRepair| matches!(repair, CrownRepair::Joined { .. });
    let count = report.repairs.iter().filter(|repair| is_joint(repair)).count();
    report.repairs.retain(|repair| !is_joint(repair));
    if count > 0 {
        report.repairs.push(CrownRepair::Joined { count });
    }
}

/// Puts lines together by the mates of their ends: first those that have a free end, then rings.
fn thread(lines: &[Line], mates: &[Option<usize>]) -> Vec<Line> {
    let mut seen = vec![false; lines.len()];
    let mut out = Vec::new();
    let free = (0..mates.len()).filter(|&end| mates[end].is_none());
    for start in free.chain(0..mates.len()) {
        if seen[start / 2] {
            continue;
        }
        let mut line = Line { stroke: start / 2, points: Vec::new() };
        line.stroke = lines[start / 2].stroke;
        let mut end = start;
        while !seen[end / 2] {
            seen[end / 2] = true;
            let points = lines[end / 2].points.iter().copied();
            if end % 2 == 0 {
                line.points.extend(points);
            } else {
                line.points.extend(points.rev());
            }
            // On from the line's other end.
            let Some(next) = mates[end ^ 1] else { break };
            end = next;
        }
        out.push(line);
    }
    out
}

/// Leaves out open lines inside a loop: strokes that suggest leaves.
fn drop_details(open: Vec<Line>, closed: &[Vec<Vec2>], report: &mut CrownReport) -> Vec<Line> {
    let inside = |line: &Line| {
        let all_in = |polygon: &Vec<Vec2>| line.points.iter().all(|&p| unite::contains(polygon, p));
        closed.iter().any(all_in)
    };
    let (details, kept): (Vec<Line>, Vec<Line>) = open.into_iter().partition(inside);
    for line in details {
        report.repairs.push(CrownRepair::DetailDropped { stroke: line.stroke });
    }
    kept
}

/// A line seen from the crown's centre, running against the clock.
struct Arc {
    points: Vec<Vec2>,
    /// Directions of its ends, the second above the first by how far it winds.
    from: f32,
    to: f32,
}

/// One loop of all open lines, ordered round the middle of lines and branches.
fn ring(open: Vec<Line>, branches: &[Vec2], report: &mut CrownReport) -> Option<Vec<Vec2>> {
    if open.is_empty() {
        return None;
    }
    let all = open.iter().flat_map(|line| &line.points).chain(branches);
    let hull = convex_hull(&all.copied().collect::<Vec<_>>());
    let center = unite::centroid(&hull)?;
    let mut arcs: Vec<Arc> = open.into_iter().map(|line| arc(line.points, center)).collect();
    let middle = |arc: &Arc| (0.5 * (arc.from + arc.to)).rem_euclid(TAU);
    arcs.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
    let mut out = Vec::new();
    for (i, here) in arcs.iter().enumerate() {
        let next = &arcs[(i + 1) % arcs.len()];
        out.extend_from_slice(&here.points);
        out.extend(bridge(here, next, center, branches, report));
    }
    Some(out)
}

fn arc(mut points: Vec<Vec2>, center: Vec2) -> Arc {
    let wind = |points: &[Vec2]| -> f32 {
        let turn = |pair: &[Vec2]| {
            let (a, b) = (pair[0] - center, pair[1] - center);
            libm::atan2f(a.perp_dot(b), a.dot(b))
        };
        points.windows(2).map(turn).sum()
    };
    let mut turned = wind(&points);
    if turned < 0.0 {
        points.reverse();
        turned = -turned;
    }
    let from = points.first().map_or(0.0, |&p| angle(p - center));
    Arc { points, from, to: from + turned }
}

fn angle(direction: Vec2) -> f32 {
    libm::atan2f(direction.y, direction.x).rem_euclid(TAU)
}

/// The corners between the end of one arc and the beginning of the next: the convex hull of both and of the branches
/// that lie in the gap, outside of its chord.
fn bridge(
    here: &Arc,
    next: &Arc,
    center: Vec2,
    branches: &[Vec2],
    report: &mut CrownReport,
) -> Vec<Vec2> {
    let (Some(&end), Some(&start)) = (here.points.last(), next.points.first()) else {
        return Vec::new();
    };
    let gap = (next.from - here.to).rem_euclid(TAU);
    // The next stroke begins where this one already was: they overlap.
    let overlap = gap + (here.to - here.from) > TAU + SAME_ANGLE || gap > TAU - SAME_ANGLE;
    let in_gap = |point: Vec2| {
        let outside = (start - end).perp_dot(point - end) < 0.0;
        let turned = (angle(point - center) - here.to).rem_euclid(TAU);
        outside && (gap > PI || turned <= gap)
    };
    let mut around = vec![end, start];
    if !overlap {
        around.extend(branches.iter().copied().filter(|&point| in_gap(point)));
    }
    let round_branches = around.len() > 2;
    report.repairs.push(CrownRepair::GapClosed { gap: end.distance(start), round_branches });
    let mut hull = convex_hull(&around);
    let Some(first) = hull.iter().position(|&corner| corner == end) else { return Vec::new() };
    hull.rotate_left(first);
    hull.iter().skip(1).take_while(|&&corner| corner != start).copied().collect()
}
