//! Links merged two at a time, always where it costs least.

use super::wood::{Link, Wood};
use super::{Capsule, fit};
use crate::error::Result;
use glam::Vec3;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};
use tree_core::Control;

/// Volume that a merger may add, as a share of the two capsules', to count as about as tight.
const TIGHT: f64 = 0.1;
/// Balls of a group, at most. Few trees have branches of as many nodes.
const BALLS_MAX: usize = 128;

/// Links that one capsule stands for.
struct Group {
    balls: Vec<(Vec3, f32)>,
    capsule: Capsule,
    /// Volume of its wood.
    volume: f64,
    /// Groups it touches.
    touches: BTreeSet<usize>,
    /// Counts its changes, so that what the queue holds of older states is passed over.
    version: u32,
}

/// What a merger costs (as bits in the order of the numbers), and of which states of which groups.
type Merger = Reverse<(u64, [(usize, u32); 2])>;

impl Group {
    /// Keeps the cost of a fit bounded: the ends of the capsule stand for very many balls.
    fn thin_out(&mut self) {
        if self.balls.len() > BALLS_MAX {
            let Capsule { a, b, radius } = self.capsule;
            self.balls = vec![(a, radius), (b, radius)];
        }
    }
}

struct Merging {
    /// `None` for groups that became part of another.
    groups: Vec<Option<Group>>,
    queue: BinaryHeap<Merger>,
    /// Groups left.
    alive: usize,
}

/// Capsules of the links, at most `count`; fewer where fewer have less volume.
///
/// 1. Links are merged as long as their common capsule fits about as well as their own: most branches
///    become one capsule, or one for each bend.
/// 2. Of those capsules the ones with least wood are left out, `budget` cubic metres of it altogether.
/// 3. The others are merged down to the number allowed. Groups that do not touch (stems apart at the
///    ground) are merged last, each with the next.
pub(super) fn down_to(
    wood: &Wood,
    links: &[Link],
    count: usize,
    budget: f64,
    control: &Control,
) -> Result<Vec<Capsule>> {
    let mut merging = Merging::new(wood, links);
    merging.run(control, |_, cost, apart| cost <= TIGHT * apart)?;
    merging.leave_out(budget);
    merging.run(control, |alive, cost, _| alive > count || cost < 0.0)?;
    while merging.alive > count && merging.bridge() {
        merging.run(control, |alive, _, _| alive > count)?;
    }
    Ok(merging.groups.into_iter().flatten().map(|group| group.capsule).collect())
}

impl Merging {
    fn new(wood: &Wood, links: &[Link]) -> Self {
        let mut groups: Vec<Group> = links
            .iter()
            .map(|link| {
                let balls = wood.balls(link);
                let capsule = fit::around(&balls);
                let mut group = Group {
                    balls,
                    capsule,
                    volume: link.volume,
                    touches: BTreeSet::new(),
                    version: 0,
                };
                group.thin_out();
                group
            })
            .collect();
        for (number, link) in links.iter().enumerate() {
            if link.below != number {
                groups[number].touches.insert(link.below);
                groups[link.below].touches.insert(number);
            }
        }
        let groups = groups.into_iter().map(Some).collect();
        let mut merging = Self { groups, queue: BinaryHeap::new(), alive: links.len() };
        for (number, link) in links.iter().enumerate() {
            if link.below != number {
                merging.offer(link.below, number);
            }
        }
        merging
    }

    fn group(&self, number: usize) -> Option<&Group> {
        self.groups.get(number)?.as_ref()
    }

    fn is_current(&self, (number, version): (usize, u32)) -> bool {
        self.group(number).is_some_and(|group| group.version == version)
    }

    /// Merges, the least cost first, whatever `wanted` says yes to: by the number of groups left, the
    /// volume added, and the volume of the two capsules apart.
    fn run(&mut self, control: &Control, wanted: impl Fn(usize, f64, f64) -> bool) -> Result<()> {
        let mut later = Vec::new();
        while let Some(Reverse((cost, states))) = self.queue.pop() {
            control.check()?;
            let [(a, _), (b, _)] = states;
            let volume = |number| self.group(number).map_or(0.0, |group| group.capsule.volume());
            if !states.iter().all(|&state| self.is_current(state)) {
                continue;
            }
            if wanted(self.alive, unordered(cost), volume(a) + volume(b)) {
                self.merge(a, b);
            } else {
                later.push(Reverse((cost, states)));
            }
        }
        self.queue.extend(later);
        Ok(())
    }

    /// Leaves out groups, those with least wood first, as long as the sum of it is within the budget.
    /// What touched them touches each other then.
    fn leave_out(&mut self, mut budget: f64) {
        let alive = self
            .groups
            .iter()
            .enumerate()
            .filter_map(|(number, group)| group.as_ref().map(|group| (group.volume, number)));
        let mut order: Vec<(f64, usize)> = alive.collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (volume, number) in order {
            budget -= volume;
            if budget < 0.0 {
                break;
            }
            let Some(gone) = self.groups.get_mut(number).and_then(Option::take) else { continue };
            self.alive -= 1;
            let hub = gone.touches.first().copied();
            for &other in &gone.touches {
                if let Some(Some(group)) = self.groups.get_mut(other) {
                    group.touches.remove(&number);
                }
                if let Some(hub) = hub.filter(|&hub| hub != other) {
                    self.touch(hub, other);
                }
            }
        }
    }

    /// Lets two groups touch.
    fn touch(&mut self, a: usize, b: usize) {
        for (from, to) in [(a, b), (b, a)] {
            if let Some(Some(group)) = self.groups.get_mut(from) {
                group.touches.insert(to);
            }
        }
        self.offer(a, b);
    }

    /// Puts the merger of two groups into the queue.
    fn offer(&mut self, a: usize, b: usize) {
        let (Some(first), Some(second)) = (self.group(a), self.group(b)) else { return };
        let balls: Vec<_> = first.balls.iter().chain(&second.balls).copied().collect();
        let more = fit::around(&balls).volume() - first.capsule.volume() - second.capsule.volume();
        let states = [(a, first.version), (b, second.version)];
        self.queue.push(Reverse((ordered(more), states)));
    }

    /// Makes `b` part of `a`.
    fn merge(&mut self, a: usize, b: usize) {
        let Some(gone) = self.groups.get_mut(b).and_then(Option::take) else { return };
        for &other in &gone.touches {
            if let Some(Some(other)) = self.groups.get_mut(other) {
                other.touches.remove(&b);
                other.touches.insert(a);
            }
        }
        let Some(Some(group)) = self.groups.get_mut(a) else { return };
        self.alive -= 1;
        group.volume += gone.volume;
        group.balls.extend(gone.balls);
        group.capsule = fit::around(&group.balls);
        group.thin_out();
        group.touches.extend(gone.touches);
        group.touches.remove(&a);
        group.touches.remove(&b);
        group.version += 1;
        let touches: Vec<usize> = group.touches.iter().copied().collect();
        for other in touches {
            self.offer(a, other);
        }
    }

    /// Lets each group touch the next, when nothing that touches is left; false when there is only one.
    fn bridge(&mut self) -> bool {
        let alive: Vec<usize> =
            (0..self.groups.len()).filter(|&number| self.group(number).is_some()).collect();
        for pair in alive.windows(2) {
            if let &[a, b] = pair {
                self.touch(a, b);
            }
        }
        alive.len() > 1
    }
}

/// Bits that are in the order of the numbers, negative ones included.
fn ordered(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}

/// The number of [`ordered`].
fn unordered(bits: u64) -> f64 {
    f64::from_bits(if bits >> 63 == 1 { bits & !(1 << 63) } else { !bits })
}
