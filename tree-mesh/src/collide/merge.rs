//! Links merged two at a time, always where it costs least.

use super::wood::{Frustum, Link, Wood};
use super::{Capsule, fit};
use crate::error::Result;
use glam::Vec3;
use std::cmp::Reverse;
use std::collections::{BTreeSet, BinaryHeap};
use tree_core::Control;

/// Links that one capsule stands for.
struct Group {
    balls: Vec<(Vec3, f32)>,
    capsule: Capsule,
    /// Groups it touches.
    touches: BTreeSet<usize>,
    /// Counts its changes, so that what the queue holds of older states is passed over.
    version: u32,
}

/// What a merger costs (as bits in the order of the numbers), and of which states of which groups.
type Merger = Reverse<(u64, [(usize, u32); 2])>;

struct Merging {
    /// `None` for groups that became part of another.
    groups: Vec<Option<Group>>,
    queue: BinaryHeap<Merger>,
}

/// Capsules of the links, at most `count`; fewer where fewer have less volume.
///
/// Groups that do not touch (stems apart at the ground) are merged last, each with the next.
pub(super) fn down_to(
    wood: &Wood,
    links: &[Link],
    count: usize,
    control: &Control,
) -> Result<Vec<Capsule>> {
    let mut merging = Merging::new(wood, links);
    let mut alive = links.len();
    loop {
        control.check()?;
        let Some(Reverse((cost, states))) = merging.queue.pop() else {
            if alive > count && merging.bridge() {
                continue;
            }
            break;
        };
        // Links in a row share their round ends: one capsule is smaller than two.
        if alive <= count && cost >= ordered(0.0) {
            break;
        }
        if states.iter().all(|&state| merging.is_current(state)) {
            let [(a, _), (b, _)] = states;
            merging.merge(a, b);
            alive -= 1;
        }
    }
    Ok(merging.groups.into_iter().flatten().map(|group| group.capsule).collect())
}

impl Merging {
    fn new(wood: &Wood, links: &[Link]) -> Self {
        let mut groups: Vec<Group> = links
            .iter()
            .map(|link| {
                let frusta = wood.frusta.get(link.first..link.end).unwrap_or_default();
                let balls: Vec<_> = frusta.iter().flat_map(Frustum::balls).collect();
                let capsule = fit::around(&balls);
                Group { balls, capsule, touches: BTreeSet::new(), version: 0 }
            })
            .collect();
        for (number, link) in links.iter().enumerate() {
            if link.below != number {
                groups[number].touches.insert(link.below);
                groups[link.below].touches.insert(number);
            }
        }
        let groups = groups.into_iter().map(Some).collect();
        let mut merging = Self { groups, queue: BinaryHeap::new() };
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
        group.balls.extend(gone.balls);
        group.capsule = fit::around(&group.balls);
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
                if let Some(Some(group)) = self.groups.get_mut(a) {
                    group.touches.insert(b);
                }
                if let Some(Some(group)) = self.groups.get_mut(b) {
                    group.touches.insert(a);
                }
                self.offer(a, b);
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
