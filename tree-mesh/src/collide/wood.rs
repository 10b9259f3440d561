//! The thick wood of a skeleton, as frusta and as links.

use super::CapsuleParams;
use glam::Vec3;
use std::collections::BTreeSet;
use std::ops::Range;
use tree_core::Skeleton;

/// Links an axis is cut into, at most. What is finer is merged again anyhow.
const LINKS_PER_AXIS: usize = 16;
/// Links that merging starts with, at most, but for stems apart at the ground: it compares every link
/// with all that touch it.
const LINKS_MAX: usize = 512;
/// Share of the volume held in reserve: capsules are fitted with rounding, shares are measured at points.
const RESERVE: f64 = 0.003;
/// No link.
const NONE: usize = usize::MAX;

/// A truncated cone.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frustum {
    pub(super) a: Vec3,
    pub(super) b: Vec3,
    pub(super) radius_a: f32,
    pub(super) radius_b: f32,
}

impl Frustum {
    pub(super) fn volume(&self) -> f64 {
        let (a, b) = (f64::from(self.radius_a), f64::from(self.radius_b));
        let length = f64::from(self.a.distance(self.b));
        std::f64::consts::FRAC_PI_3 * length * (a * a + a * b + b * b)
    }

    /// The balls that the capsule around the frustum must hold.
    pub(super) fn balls(&self) -> [(Vec3, f32); 2] {
        [(self.a, self.radius_a), (self.b, self.radius_b)]
    }
}

/// All frusta thick enough, axis by axis, from base to tip.
#[derive(Debug, Default)]
pub(super) struct Wood {
    pub(super) frusta: Vec<Frustum>,
    /// Runs along axes: first frustum, one past the last, and the frustum of the parent axis they rest
    /// on ([`NONE`] for the lowest). Parents come first.
    runs: Vec<(usize, usize, usize)>,
}

/// A stretch of one run, and what was folded into it.
#[derive(Clone, Debug)]
pub(super) struct Link {
    /// Its frusta.
    pub(super) parts: Vec<Range<usize>>,
    /// The link below, on the same axis or the one that carries it; itself when there is none.
    pub(super) below: usize,
    pub(super) volume: f64,
}

/// Gathers the wood and says above which radius.
pub(super) fn gather(skeleton: &Skeleton, params: &CapsuleParams) -> (Wood, f32) {
    let thickest = skeleton.radii().iter().fold(0.0_f32, |most, &radius| most.max(radius));
    let min_radius = if thickest >= params.min_radius { params.min_radius } else { 0.5 * thickest };
    let axes = skeleton.axes(params.continuation);
    let (positions, radii) = (skeleton.positions(), skeleton.radii());
    let mut wood = Wood::default();
    // The frustum that ends at each node, to find what a lateral rests on.
    let mut ending = vec![NONE; skeleton.len()];
    for axis in axes.iter() {
        let start = axis.nodes.first().copied().unwrap_or(0);
        let fork = skeleton.parent(start);
        let mut last = fork.unwrap_or(start);
        let mut last_radius = radii[start as usize];
        let mut run = (wood.frusta.len(), fork.map_or(NONE, |fork| ending[fork as usize]));
        for &node in axis.nodes {
            let (a, b) = (positions[last as usize], positions[node as usize]);
            let radius = radii[node as usize];
            let thick = last_radius.min(radius) >= min_radius && radius.max(last_radius) > 0.0;
            if thick && a != b {
                wood.frusta.push(Frustum { a, b, radius_a: last_radius, radius_b: radius });
            } else if !thick {
                // Thicker wood further up starts a run of its own.
                wood.close(run);
                run = (wood.frusta.len(), NONE);
            }
            // A node at the same place rests where the one before does.
            ending[node as usize] = match (thick, a != b) {
                (true, true) => wood.frusta.len() - 1,
                (true, false) => ending[last as usize],
                _ => NONE,
            };
            (last, last_radius) = (node, radius);
        }
        wood.close(run);
    }
    (wood, min_radius)
}

impl Wood {
    fn close(&mut self, (first, below): (usize, usize)) {
        if first < self.frusta.len() {
            self.runs.push((first, self.frusta.len(), below));
        }
    }

    pub(super) fn volume(&self) -> f64 {
        self.frusta.iter().map(Frustum::volume).sum()
    }

    /// Cuts every run into links of about equal length, parents first.
    fn cut(&self) -> Vec<Link> {
        let mut links: Vec<Link> = Vec::new();
        let mut link_of = vec![NONE; self.frusta.len()];
        for &(first, end, rests_on) in &self.runs {
            let run = self.frusta.get(first..end).unwrap_or_default();
            let lengths = run.iter().map(|frustum| frustum.a.distance(frustum.b));
            let whole: f32 = lengths.sum();
            let most = whole / LINKS_PER_AXIS as f32;
            let mut below = link_of.get(rests_on).copied().unwrap_or(NONE);
            let (mut start, mut length) = (first, 0.0);
            for (number, frustum) in (first..end).zip(run) {
                length += frustum.a.distance(frustum.b);
                if length >= most || number + 1 == end {
                    let volume =
                        self.frusta[start..=number].iter().map(Frustum::volume).sum::<f64>();
                    let own = links.len();
                    link_of[start..=number].fill(own);
                    let rests = if below == NONE { own } else { below };
                    links.push(Link {
                        parts: std::iter::once(start..number + 1).collect(),
                        below: rests,
                        volume,
                    });
                    (below, start, length) = (own, number + 1, 0.0);
                }
            }
        }
        links
    }

    /// Links to begin with: should there be too many, those with least volume at the ends of the
    /// hierarchy are folded into those they rest on.
    pub(super) fn links(&self) -> Vec<Link> {
        let mut links = self.cut();
        let mut resting = vec![0_u32; links.len()];
        for (number, link) in links.iter().enumerate() {
            if link.below != number {
                resting[link.below] += 1;
            }
        }
        let key = |number: usize, link: &Link| (link.volume.to_bits(), number);
        let all = links.iter().enumerate().filter(|&(number, _)| resting[number] == 0);
        let mut ends: BTreeSet<(u64, usize)> =
            all.map(|(number, link)| key(number, link)).collect();
        let mut gone = vec![false; links.len()];
        let mut left = links.len();
        while left > LINKS_MAX {
            let Some((_, number)) = ends.pop_first() else { break };
            let below = links[number].below;
            if below == number {
                continue;
            }
            let parts = std::mem::take(&mut links[number].parts);
            links[below].parts.extend(parts);
            links[below].volume += links[number].volume;
            gone[number] = true;
            left -= 1;
            resting[below] -= 1;
            if resting[below] == 0 {
                ends.insert(key(below, &links[below]));
            }
        }
        renumber(links, &gone)
    }

    /// Volume that may be left out while this share is held.
    pub(super) fn budget(&self, share: f32) -> f64 {
        self.volume() * (1.0 - f64::from(share) - RESERVE).max(0.0)
    }

    /// The ends of a link's frusta, each once.
    pub(super) fn balls(&self, link: &Link) -> Vec<(Vec3, f32)> {
        let parts = link.parts.iter().filter_map(|part| self.frusta.get(part.clone()));
        let mut balls: Vec<_> = parts.flatten().flat_map(Frustum::balls).collect();
        balls.dedup();
        balls
    }
}

/// The links that stay, by their new numbers. What something rests on always stays.
fn renumber(links: Vec<Link>, gone: &[bool]) -> Vec<Link> {
    let mut numbers = vec![0; links.len()];
    let mut kept: Vec<Link> = Vec::new();
    for (number, link) in links.into_iter().enumerate() {
        if !gone[number] {
            numbers[number] = kept.len();
            kept.push(Link { below: numbers[link.below], ..link });
        }
    }
    kept
}
