//! Strokes are joined to one tree, the nearest first, as a minimum spanning tree grows (Prim 1957).
//!
//! A stroke joins by its end that is nearest to the tree; where both ends touch it, by the lower one. Where an end of
//! the tree lies much nearer to the stroke's middle, the stroke joins there, in two parts; so it does at a crossing
//! if it would hang in the air otherwise. Strokes that cross and are joined elsewhere do not join. O(strokes² +
//! strokes · points) at worst; boxes around runs of 16 segments leave out nearly all of it.

use super::line::{Line, Place};
use super::params::{CleanParams, Isolated};
use super::report::{CleanReport, RepairKind};
use super::root::{Root, second_root};
use super::tidy::Ink;
use crate::error::{ModelError, Result};
use glam::Vec2;
use tree_core::Control;

/// The middle of a stroke joins instead of an end where it is nearer than this share of the end's distance.
const MIDDLE: f32 = 0.25;

/// Ends that stick out beyond what they join are looked for along so many snapping distances, and along at most
/// [`STUB_SHARE`] of the stroke.
const STUB: f32 = 2.0;
/// See [`STUB`].
const STUB_SHARE: f32 = 0.3;

/// Gaps below this share of the height are not worth a word.
const UNTOLD: f32 = 0.005;

/// How one stroke joins the tree.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub(super) stroke: usize,
    /// The stroke it joins and where; none: it joins the base.
    pub(super) host: Option<(usize, Place)>,
    /// Its point by which it joins.
    pub(super) point: usize,
    /// Its points that stay, first and last.
    pub(super) range: (usize, usize),
}

/// The best ways of a waiting stroke to join so far.
#[derive(Clone, Default)]
struct Ways {
    joined: bool,
    /// By its first point and by its last: the host and the place there.
    ends: [Option<(usize, Place)>; 2],
    /// By its inside: the distance, the host, whether it is the host's last point, and its own point.
    inside: Option<(f32, usize, bool, usize)>,
    /// The end by which it stands on the ground beside the base, and its distance from the base.
    ground: Option<(bool, f32)>,
}

/// How a stroke joins, with the gap.
#[derive(Clone, Copy)]
enum Way {
    End(bool, usize, Place),
    Inside(usize, bool, usize),
    Ground(bool),
}

impl Ways {
    fn end(&self, last: bool) -> f32 {
        self.ends[usize::from(last)].map_or(f32::INFINITY, |(_, place)| place.distance)
    }

    /// Takes another stroke of the tree into account.
    fn offer(&mut self, line: &Line, host: usize, host_line: &Line) {
        for last in [false, true] {
            if let Some(place) = host_line.nearest(line.end(last), self.end(last)) {
                self.ends[usize::from(last)] = Some((host, place));
            }
        }
        for last in [false, true] {
            let best = self.inside.map_or(f32::INFINITY, |inside| inside.0);
            let below = best.min(MIDDLE * self.end(false).min(self.end(true)));
            if let Some(place) = line.nearest(host_line.end(last), below) {
                let point = place.segment as usize + usize::from(place.share > 0.5);
                self.inside = Some((place.distance, host, last, point));
            }
        }
    }

    fn best(&self, line: &Line, snap: f32) -> Option<(f32, Way)> {
        let (a, b) = (self.end(false), self.end(true));
        let lower = line.end(true).y > line.end(false).y;
        let last = if a.max(b) <= snap { lower } else { b < a };
        let (host, place) = self.ends[usize::from(last)]?;
        let gap = place.distance;
        if let Some((distance, host, host_last, point)) = self.inside
            && distance < MIDDLE * gap
        {
            return Some((distance, Way::Inside(host, host_last, point)));
        }
        match self.ground {
            Some((last, distance)) if gap > snap => Some((distance, Way::Ground(last))),
            _ => Some((gap, Way::End(last, host, place))),
        }
    }
}

/// Strokes that are being joined.
pub(super) struct Join<'a> {
    pub(super) inks: &'a [Ink],
    pub(super) lines: &'a [Line],
    pub(super) params: &'a CleanParams,
    pub(super) unit: f32,
}

impl Join<'_> {
    /// The joints of all strokes, in an order in which hosts come first.
    pub(super) fn run(
        &self,
        root: &Root,
        report: &mut CleanReport,
        control: &Control,
    ) -> Result<Vec<Joint>> {
        let n = self.lines.len();
        let snap = self.params.snap * self.unit;
        let base = self.lines[root.stroke].points.get(root.point).copied().unwrap_or_default();
        let mut ways = vec![Ways::default(); n];
        for (way, line) in ways.iter_mut().zip(self.lines) {
            let end = second_root(&line.points, base, self.unit);
            way.ground = end.map(|last| (last, line.end(last).distance(base)));
        }
        let all = |stroke: usize| (0, self.lines[stroke].points.len() - 1);
        let (stroke, point) = (root.stroke, root.point);
        let mut joints = vec![Joint { stroke, host: None, point, range: all(stroke) }];
        ways[stroke].joined = true;
        if point > 0 && point + 1 == self.lines[stroke].points.len() {
            report.add(self.inks[stroke].stroke, RepairKind::TurnedRound);
        }
        let mut new = stroke;
        loop {
            control.check()?;
            let mut best: Option<(f32, usize, Way)> = None;
            for (i, way) in ways.iter_mut().enumerate().filter(|(_, way)| !way.joined) {
                way.offer(&self.lines[i], new, &self.lines[new]);
                if let Some((gap, how)) = way.best(&self.lines[i], snap)
                    && best.is_none_or(|best| gap < best.0)
                {
                    best = Some((gap, i, how));
                }
            }
            let Some((gap, next, how)) = best else { break };
            let joint = match how {
                Way::End(..) if gap > snap => self
                    .crossing(next, gap, &joints, report)
                    .map_or_else(|| self.bridge(next, gap, how, report), |joint| Ok(Some(joint)))?,
                _ if gap > self.params.reach * self.unit => self.bridge(next, gap, how, report)?,
                _ => Some(self.joint(next, gap, how, report)),
            };
            ways[next].joined = true;
            let Some(joint) = joint else { continue };
            joints.push(joint);
            new = next;
        }
        Ok(joints)
    }

    /// Joins over a gap, or does what is asked for strokes that are isolated.
    fn bridge(
        &self,
        stroke: usize,
        gap: f32,
        how: Way,
        report: &mut CleanReport,
    ) -> Result<Option<Joint>> {
        let (share, index) = (gap / self.unit, self.inks[stroke].stroke);
        if share <= self.params.reach || self.params.isolated == Isolated::Bridge {
            return Ok(Some(self.joint(stroke, gap, how, report)));
        }
        if self.params.isolated == Isolated::Drop {
            report.add(index, RepairKind::Isolated(share));
            return Ok(None);
        }
        Err(ModelError::Stroke {
            stroke: format!("strokes[{index}]"),
            problem: format!(
                "is {:.1} % of the drawing's height away from the rest, at most {:.1} % (clean.reach) is bridged",
                100.0 * share,
                100.0 * self.params.reach
            ),
        })
    }

    fn joint(&self, stroke: usize, gap: f32, how: Way, report: &mut CleanReport) -> Joint {
        let line = &self.lines[stroke];
        let top = line.points.len() - 1;
        let share = gap / self.unit;
        let index = self.inks[stroke].stroke;
        let (host, point, range) = match how {
            Way::End(last, host, place) => {
                let (trimmed, place) = self.trim(stroke, last, host, place);
                let cut =
                    if last { &line.points[top - trimmed..] } else { &line.points[..=trimmed] };
                let kind = match () {
                    () if trimmed > 0 => {
                        let share = super::tidy::length(cut) / self.unit;
                        RepairKind::Trimmed(self.inks[host].stroke, share)
                    }
                    () if share > self.params.snap => RepairKind::Bridged(share),
                    () => RepairKind::Snapped(share),
                };
                if trimmed > 0 || share > UNTOLD {
                    report.add(index, kind);
                }
                let range = if last { (0, top - trimmed) } else { (trimmed, top) };
                (Some((host, place)), if last { range.1 } else { range.0 }, range)
            }
            Way::Inside(host, host_last, point) => {
                report.add(index, RepairKind::Split);
                if share > self.params.snap {
                    report.add(index, RepairKind::Bridged(share));
                }
                let segment = if host_last { self.lines[host].points.len() - 2 } else { 0 };
                let share = f32::from(u8::from(host_last));
                let place = Place { segment: segment as u32, share, distance: gap };
                (Some((host, place)), point, (0, top))
            }
            Way::Ground(last) => {
                report.add(index, RepairKind::SecondRoot(share));
                (None, if last { top } else { 0 }, (0, top))
            }
        };
        Joint { stroke, host, point, range }
    }

    /// How many points at an end stick out beyond the host, and where the stroke then joins.
    fn trim(&self, stroke: usize, last: bool, host: usize, place: Place) -> (usize, Place) {
        let line = &self.lines[stroke];
        let snap = self.params.snap * self.unit;
        if place.distance > snap {
            return (0, place);
        }
        let most = (STUB * snap).min(STUB_SHARE * super::tidy::length(&line.points));
        let at = |i: usize| line.points[if last { line.points.len() - 1 - i } else { i }];
        let mut best = (0, place);
        let mut walked = 0.0;
        for i in 1..line.points.len() - 1 {
            walked += at(i - 1).distance(at(i));
            if walked > most {
                break;
            }
            if let Some(place) = self.lines[host].nearest(at(i), best.1.distance) {
                best = (i, place);
            }
        }
        if best.1.distance < 0.5 * place.distance { best } else { (0, place) }
    }

    /// Where a stroke whose ends are in the air comes much nearer to the tree between them.
    fn crossing(
        &self,
        stroke: usize,
        gap: f32,
        joints: &[Joint],
        report: &mut CleanReport,
    ) -> Option<Joint> {
        let points = &self.lines[stroke].points;
        let mut below = MIDDLE * gap;
        let mut best = None;
        for joint in joints {
            let host = &self.lines[joint.stroke];
            for (point, &p) in points.iter().enumerate() {
                if let Some(place) = host.nearest(p, below) {
                    below = place.distance;
                    best = Some((joint.stroke, place, point));
                }
            }
        }
        let (host, place, point) = best?;
        report.add(self.inks[stroke].stroke, RepairKind::Split);
        Some(Joint { stroke, host: Some((host, place)), point, range: (0, points.len() - 1) })
    }
}

/// Positions, parents and strokes of the nodes of joined strokes, base first, in units of the drawing.
pub(super) type Nodes = (Vec<Vec2>, Vec<u32>, Vec<u32>);

/// Makes nodes of joined strokes: their points, and one more where a stroke joins another between two points that are
/// not within `same`.
pub(super) fn nodes(inks: &[Ink], lines: &[Line], joints: &[Joint], same: f32) -> Nodes {
    let mut guests: Vec<Vec<(Place, usize)>> = vec![Vec::new(); lines.len()];
    for joint in joints {
        if let Some((host, place)) = joint.host {
            guests[host].push((place, joint.stroke));
        }
    }
    let (mut positions, mut parents, mut strokes) = (Vec::new(), Vec::new(), Vec::new());
    // The node that each stroke joins.
    let mut below = vec![0_u32; lines.len()];
    for joint in joints {
        let line = &lines[joint.stroke];
        let (stops, at) = stops(line, joint, &mut guests[joint.stroke], same);
        let mut push = |position: Vec2, parent: u32| {
            positions.push(position);
            parents.push(parent);
            strokes.push(inks[joint.stroke].stroke);
            (positions.len() - 1) as u32
        };
        let start = stops.get(at).map_or(Vec2::ZERO, |stop| stop.0);
        let first = if parents_is_root(joint, joints) {
            push(start, tree_core::NO_PARENT)
        } else {
            push(start, below[joint.stroke])
        };
        let mut serve = |stop: &(Vec2, Vec<usize>), node: u32| {
            for &guest in &stop.1 {
                below[guest] = node;
            }
        };
        if let Some(stop) = stops.get(at) {
            serve(stop, first);
        }
        let mut before = first;
        for stop in stops.iter().skip(at + 1) {
            before = push(stop.0, before);
            serve(stop, before);
        }
        before = first;
        for stop in stops[..at.min(stops.len())].iter().rev() {
            before = push(stop.0, before);
            serve(stop, before);
        }
    }
    (positions, parents, strokes)
}

/// Whether a joint is the first one: the tree's own beginning.
fn parents_is_root(joint: &Joint, joints: &[Joint]) -> bool {
    joints.first().is_some_and(|first| first.stroke == joint.stroke)
}

/// The stops along a stroke from its first point that stays to its last, with the strokes that join at each, and which
/// of them is the one by which it joins itself.
fn stops(
    line: &Line,
    joint: &Joint,
    guests: &mut [(Place, usize)],
    same: f32,
) -> (Vec<(Vec2, Vec<usize>)>, usize) {
    guests.sort_by(|(a, i), (b, k)| {
        a.segment.cmp(&b.segment).then(a.share.total_cmp(&b.share)).then(i.cmp(k))
    });
    let (low, high) = joint.range;
    let mut guests = guests.iter().peekable();
    let mut stops: Vec<(Vec2, Vec<usize>)> = Vec::new();
    let (mut at, mut early) = (0, Vec::new());
    for i in low..=high {
        if i == joint.point {
            at = stops.len();
        }
        let here = line.points[i];
        stops.push((here, std::mem::take(&mut early)));
        let next = line.points.get(i + 1).copied().unwrap_or(here);
        // What would join beyond an end joins at the end.
        while let Some((place, guest)) =
            guests.next_if(|g| (g.0.segment as usize) <= i || i == high)
        {
            let beyond = (place.segment as usize) < i || i == high;
            let position = if beyond { here } else { line.position(place) };
            match stops.last_mut() {
                Some(stop) if stop.0.distance(position) <= same => stop.1.push(*guest),
                _ if next.distance(position) <= same => early.push(*guest),
                _ => stops.push((position, vec![*guest])),
            }
        }
    }
    (stops, at)
}
