//! The pattern of a system that was drawn: sketched branches in their domains, and added ones (sections 5.3 and 5.6).

use super::fence::Fence;
use super::frame::{Around, Frame};
use super::params::{GrowParams, LevelParams};
use super::pattern::{Child, Inner, Nodes, Pattern};
use super::shapes::Form;
use super::style::Styles;
use crate::error::Result;
use crate::silhouette::Line;
use crate::silhouette::branch::{Shape, Span};
use crate::silhouette::place::gibbs::MAX_SITES;
use crate::silhouette::place::{Domain, Site, arrange};
use crate::silhouette::plan::{END, Lateral, Origin, ROUND, System};
use crate::silhouette::sub::{SubParams, sub_outline};
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::f32::consts::{PI, TAU};
use tree_core::{Control, Resource, Seed};

/// Azimuths that are tried for an added branch.
const TURNS: u32 = 16;
/// Added branches begin no lower than this below the first sketched one, and no higher above the last.
const BEYOND: f32 = 0.03;

/// Makes patterns of drawn systems.
pub(super) struct Explicit<'a> {
    pub(super) styles: &'a mut Styles,
    pub(super) patterns: &'a mut Vec<Pattern>,
    pub(super) params: &'a GrowParams,
    pub(super) depth: u32,
    pub(super) fence: &'a Fence,
    /// The frame of the trunk's span, in space.
    pub(super) trunk: Frame,
    pub(super) control: &'a Control,
}

impl Explicit<'_> {
    /// The pattern of a system in the frame of its span; `level` is that of its axis. Returns its number.
    pub(super) fn pattern(&mut self, system: &System, level: u32, seed: Seed) -> Result<u32> {
        let rules = self.params.level(level);
        let form = Form::of_system(system);
        let sites = self.sites(system, (level, &rules), seed)?;
        let (sketched, added) = sites.split_at(system.laterals.len());
        let places: Vec<f32> = sites.iter().map(|site| site.along).collect();
        let nodes = Nodes::of(&system.axis, &places);
        let mut pattern = Pattern { line: nodes.points(rules.spiral), ..Pattern::default() };
        for (lateral, site) in system.laterals.iter().zip(sketched) {
            let child = self.sketched(system, lateral, site, level, seed)?;
            pattern.children.extend(child);
        }
        for (child, form) in self.added(system, &form, added, (level, &rules), seed) {
            let form = self.styles.add_form(form);
            pattern.children.push(Child { form, ..child });
        }
        pattern.n_without_room = (sites.len() - pattern.children.len()) as u32;
        for child in &mut pattern.children {
            let (t, _) = system.axis.nearest(child.frame.origin.truncate());
            child.node = nodes.nearest(t);
            child.frame.origin = pattern.line[child.node as usize];
        }
        self.patterns.push(pattern);
        Ok(self.patterns.len() as u32 - 1)
    }

    /// Where branches stand: the sketched ones first.
    fn sites(
        &self,
        system: &System,
        (level, rules): (u32, &LevelParams),
        seed: Seed,
    ) -> Result<Vec<Site>> {
        let places = || system.laterals.iter().map(|lateral| lateral.t);
        let low = places().fold(1.0, f32::min) - BEYOND;
        let high = places().fold(0.0, f32::max) + BEYOND;
        let n = system.laterals.len();
        let n_added = (rules.density * n as f32 + 0.5) as usize;
        let n_added = n_added.min((MAX_SITES as usize).saturating_sub(n));
        self.control.limits.check(Resource::Nodes, (n + n_added) as u64)?;
        let mut domains: Vec<Domain> = system
            .laterals
            .iter()
            .map(|lateral| {
                let pinned = lateral.azimuth.map(|azimuth| [azimuth; 2]);
                let azimuth =
                    pinned.or_else(|| self.domain(lateral, level)).unwrap_or([side(lateral); 2]);
                Domain { along: [lateral.t, lateral.t], azimuth }
            })
            .collect();
        let free = Domain { along: [low.max(0.0), high.min(1.0)], azimuth: [0.0, TAU] };
        domains.extend(std::iter::repeat_n(free, n_added));
        let seed = seed.stream("azimuths");
        Ok(arrange(&domains, &rules.arrangement, &self.params.gibbs, seed, self.control)?.sites)
    }

    /// Where round the axis a sketched branch may stand. On the trunk the profile must have room for its end: of the domain, or
    /// of a wider one, the widest part where it has; `None` where it has none.
    fn domain(&self, lateral: &Lateral, level: u32) -> Option<[f32; 2]> {
        /// How much wider, and how wide at most in radians.
        const WIDER: f32 = 1.3;
        const WIDEST: f32 = 1.2;
        let half = self.params.domain;
        if level > 0 {
            return Some([side(lateral) - half, side(lateral) + half]);
        }
        self.domain_within(lateral, half)
            .or_else(|| self.domain_within(lateral, (WIDER * half).min(WIDEST)))
    }

    fn domain_within(&self, lateral: &Lateral, half: f32) -> Option<[f32; 2]> {
        /// Azimuths that are tried, on either side of the plane and in it.
        const TRIED: i32 = 8;
        let side = side(lateral);
        let end = lateral.line.end();
        let across = end.x - lateral.line.start().x;
        let off = |i: i32| half * i as f32 / TRIED as f32;
        let fits = |i: i32| {
            let depth = across * libm::tanf(off(i));
            self.fence.is_in_profile(self.trunk.point(Vec3::new(end.x, end.y, depth)))
        };
        let (mut best, mut run) = ((0, 0), 0);
        for i in -TRIED..=TRIED + 1 {
            if i <= TRIED && fits(i) {
                run += 1;
                continue;
            }
            // Of two as wide one or the other, by the branch's name: not all to the front.
            if run > best.1 || (run > 0 && run == best.1 && lateral.id.is_multiple_of(2)) {
                best = (i - 1, run);
            }
            run = 0;
        }
        let (last, n) = best;
        (n > 0).then(|| [side + off(last + 1 - n), side + off(last)])
    }

    /// A sketched branch: seen from the front it is as it was drawn.
    fn sketched(
        &mut self,
        system: &System,
        lateral: &Lateral,
        site: &Site,
        level: u32,
        seed: Seed,
    ) -> Result<Option<Child>> {
        let base = lateral.line.start();
        let along = system.axis.tangent(lateral.t);
        let right = -along.perp();
        let off = if lateral.azimuth.is_some() { 0.0 } else { site.azimuth - side(lateral) };
        let stretch = 1.0 / libm::cosf(off).max(0.1);
        let map = |point: Vec2| {
            let from = point - base;
            base + from.dot(along) * along + stretch * from.dot(right) * right
        };
        let points = lateral.line.points().iter().map(|&point| map(point)).collect();
        let Some(line) = Line::new(points) else { return Ok(None) };
        let Some(outline) = lateral.outline.transformed(map) else { return Ok(None) };
        let spans = Span::new(line.start(), line.end(), lateral.left);
        let Some((span, shape)) = spans.zip(Shape::of(&line, &outline, lateral.left)) else {
            return Ok(None);
        };
        let outwards = if lateral.left { -right } else { right };
        let angle = libm::atan2f(line.span().dot(outwards), line.span().dot(along));
        let inner = match &lateral.system {
            Some(inner) if level + 1 < self.depth => {
                let mut inner = inner.clone();
                inner.carry(&|point: Vec2| span.to_frame(map(point)));
                let seed = seed.stream("branch").child(u64::from(lateral.id));
                Inner::Pattern(self.pattern(&inner, level + 1, seed)?)
            }
            _ => Inner::Style(self.styles.for_lateral(lateral, level + 1)),
        };
        let turn = Around::new(along, site.azimuth).turn(angle);
        let frame = Frame { origin: base.extend(0.0), turn, scale: span.length() };
        let form = self.styles.add_form(Form::of(&shape));
        // Where the profile has no room for what was drawn, the drawing is followed.
        let is_free = lateral.azimuth.is_some() || self.domain(lateral, level).is_none();
        // Finer branches that were only inferred may be fenced in.
        let is_sketched = level == 0 || lateral.origin == Origin::Drawn;
        Ok(Some(Child { node: 0, frame, form, inner, is_sketched, is_free }))
    }

    /// Added branches: copies of the nearest sketched ones, as long as the pseudo-surface of revolution has room.
    fn added(
        &self,
        system: &System,
        form: &Form,
        sites: &[Site],
        (level, rules): (u32, &LevelParams),
        seed: Seed,
    ) -> Vec<(Child, Form)> {
        let grow = |(i, site): (usize, &Site)| {
            let vary = seed.stream("lengths").unit(i as u64) - 0.5;
            let nearest = system.laterals.iter().min_by(|a, b| {
                let distance = |l: &Lateral| {
                    let turned = site.azimuth - l.azimuth.unwrap_or(side(l));
                    (l.t - site.along).abs() + 0.05 * (1.0 - libm::cosf(turned))
                };
                distance(a).total_cmp(&distance(b))
            })?;
            let shape = nearest.shape()?;
            let base = system.axis.at(site.along);
            let angle = system.angles.at(site.along) - shape.leaving();
            let share = END * (1.0 + rules.jitter * (vary - 0.25));
            let standing = |azimuth: f32| {
                let turn = Around::new(system.axis.tangent(site.along), azimuth).turn(angle);
                let room = form.room(base, turn * Vec3::Y, azimuth)?;
                Some((azimuth, Frame { origin: base.extend(0.0), turn, scale: share * room }))
            };
            let is_seen_inside = |&(_, frame): &(f32, Frame)| {
                level > 0 || self.fence.contains(self.trunk.point(frame.point(Vec3::Y)))
            };
            // Where outlines have bays, branches towards and away from the viewer would hang in them: the nearest azimuth
            // that has not is taken.
            let turns = (0..TURNS).map(|i| site.azimuth + turn_by(i));
            let better = turns.filter_map(standing).find(is_seen_inside);
            let (azimuth, frame) = better.or_else(|| standing(site.azimuth))?;
            let fitted = fitted(form, &shape, base, frame.scale * (frame.turn * Vec3::Y), azimuth);
            let inner = Inner::Style(self.styles.for_lateral(nearest, level + 1));
            let child =
                Child { node: 0, frame, form: 0, inner, is_sketched: false, is_free: false };
            Some((child, Form::of(&fitted.unwrap_or(shape))))
        };
        sites.par_iter().enumerate().filter_map(grow).collect()
    }
}

/// The azimuth of the side a branch was drawn on.
fn side(lateral: &Lateral) -> f32 {
    if lateral.left { PI } else { 0.0 }
}

/// The turns that are tried in order: none, then to either side.
fn turn_by(i: u32) -> f32 {
    let step = TAU / TURNS as f32 * i.div_ceil(2) as f32;
    if i.is_multiple_of(2) { step } else { -step }
}

/// A shape whose outline shares the edge of the pseudo-surface at an azimuth, as a sub-silhouette does in the plane.
fn fitted(form: &Form, shape: &Shape, base: Vec2, way: Vec3, azimuth: f32) -> Option<Shape> {
    let profile = form.profile(azimuth)?;
    let (sin, cos) = libm::sincosf(azimuth);
    let base = Vec2::new(base.x * cos, base.y);
    let end = base + Vec2::new(way.x * cos + way.z * sin, way.y);
    let line = shape.line_on(&Span::new(base, end, false)?)?;
    let radius = ROUND * line.span().length();
    let outline = sub_outline(&profile, &line, radius, None, &SubParams::default()).outline;
    Shape::of(&line, &outline, false)
}
