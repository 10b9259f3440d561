//! Storeys: where on an axis its wall is opened for laterals.
//!
//! A storey is the strip of wall between two rings of the same number of sides. Each of its columns
//! (the wall between neighbouring sides) can be given to one lateral; a lateral takes one or several
//! side by side. What is taken away is a disc, and discs of different laterals share no triangle. So
//! whatever is set onto their rims, the whole stays one closed surface.
//!
//! Laterals are taken in the order of height. One that overlaps the storey below joins it if its
//! columns are free, else the storey is cut between the two, else the lateral is turned to the
//! nearest free column, else it moves up into a storey of its own.

use super::circle::Circles;
use super::curve::{Curve, Place, length_min};
use super::flare::Flare;
use glam::Vec3;
use std::f32::consts::TAU;

/// A hole takes a column of which it covers more than this share.
const COVER: f32 = 0.25;
/// Fewest sides of a storey, where the parameters allow them: a third of a ring is too coarse a hole.
const SIDES_MIN: u32 = 6;
/// Storeys may grow to this many times the height of their tallest hole by laterals that join.
const STRETCH: f32 = 1.6;
/// Two storeys share a ring when the gap between them is below this share of their mean height.
const GAP: f32 = 0.5;
/// Shortest storey and gap, in radii.
const HEIGHT_MIN: f32 = 0.03;
/// Lowest height of a hole in widths of a column: flatter triangles shade badly.
const SQUARE: f32 = 0.35;

/// A hole that a lateral wants.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wish {
    pub(crate) lateral: u32,
    pub(crate) center: f32,
    /// How far it reaches below and above its middle.
    pub(crate) reach: [f32; 2],
    pub(crate) half_width: f32,
    pub(crate) out: Vec3,
}

/// A strip of wall with holes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Storey {
    pub(crate) low: f32,
    pub(crate) high: f32,
    pub(crate) n_sides: u32,
    /// Columns taken.
    pub(crate) mask: u128,
    tallest: f32,
    last_centre: f32,
}

/// A hole that a lateral gets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Hole {
    pub(crate) lateral: u32,
    pub(crate) storey: u32,
    /// First column, and how many.
    pub(crate) column: u32,
    pub(crate) width: u32,
}

/// Storeys and holes of one axis; reused from axis to axis.
#[derive(Debug, Default)]
pub(crate) struct Storeys {
    pub(crate) storeys: Vec<Storey>,
    pub(crate) holes: Vec<Hole>,
    /// Laterals that were turned or moved up because their place was taken.
    pub(crate) n_moved: u32,
}

/// The wall that is divided.
pub(crate) struct Wall<'a> {
    pub(crate) curve: Curve<'a>,
    pub(crate) flare: Flare,
    pub(crate) circles: &'a Circles,
    /// From where to where holes may be, along the axis.
    pub(crate) low: f32,
    pub(crate) high: f32,
}

impl Storeys {
    /// Divides the wall. `wishes` must be sorted by `center`.
    pub(crate) fn divide(&mut self, wall: &Wall<'_>, wishes: &[Wish]) {
        self.storeys.clear();
        self.holes.clear();
        self.n_moved = 0;
        for wish in wishes {
            self.place(wall, wish);
        }
        self.fit(wall);
    }

    fn place(&mut self, wall: &Wall<'_>, wish: &Wish) {
        let center = wish.center.clamp(wall.low, wall.high);
        let place = wall.curve.at(center);
        let radius = place.station.radius * wall.flare.widest(center);
        let square = SQUARE * TAU * radius / wall.n_sides(&place) as f32;
        let [down, up] = wish.reach.map(|reach| reach.max(square).max(HEIGHT_MIN * radius));
        let half = 0.5 * (down + up);
        let below = self.storeys.len().checked_sub(2).map_or(wall.low, |i| self.storeys[i].high);
        let (low, high) = (center - down, center + up);
        let Some(last) = self.storeys.last_mut().filter(|last| low < last.high) else {
            self.start(wall, wish, &place, low, high);
            return;
        };
        let (column, width) = wall.columns(wish, &place, last.n_sides);
        let joined = last.high.max(high) - last.low.min(low).max(below);
        if last.mask & columns_mask(column, width, last.n_sides) == 0
            && joined <= STRETCH * last.tallest.max(high - low)
        {
            last.low = last.low.min(low).max(below);
            self.take(wish, column, width, high, center);
            return;
        }
        let cut = (0.5 * (last.high + low)).clamp(
            last.last_centre + 0.25 * (center - last.last_centre),
            center - 0.25 * (center - last.last_centre),
        );
        let shortest = HEIGHT_MIN * radius;
        if cut - last.low > shortest
            && high - cut > shortest
            && center - last.last_centre > 0.3 * half
        {
            last.high = cut;
            self.start(wall, wish, &place, cut, high);
            return;
        }
        self.n_moved += 1;
        match free_columns(last.mask, column, width, last.n_sides) {
            Some((column, width)) => self.take(wish, column, width, high, center),
            None => {
                let (low, high) = (last.high, last.high + (high - low));
                self.start(wall, wish, &place, low, high);
            }
        }
    }

    fn start(&mut self, wall: &Wall<'_>, wish: &Wish, place: &Place, low: f32, high: f32) {
        let n_sides = wall.n_sides(place);
        self.storeys.push(Storey {
            low,
            high,
            n_sides,
            mask: 0,
            tallest: high - low,
            last_centre: place.station.along,
        });
        let (column, width) = wall.columns(wish, place, n_sides);
        self.take(wish, column, width, high, place.station.along);
    }

    /// Gives columns of the last storey to a lateral.
    fn take(&mut self, wish: &Wish, column: u32, width: u32, high: f32, center: f32) {
        let number = self.storeys.len() as u32 - 1;
        if let Some(last) = self.storeys.last_mut() {
            last.mask |= columns_mask(column, width, last.n_sides);
            last.high = last.high.max(high);
            last.tallest = last.tallest.max(2.0 * (high - center));
            last.last_centre = last.last_centre.max(center);
        }
        self.holes.push(Hole { lateral: wish.lateral, storey: number, column, width });
    }

    /// Pushes storeys apart and into the wall.
    fn fit(&mut self, wall: &Wall<'_>) {
        let Some(first) = self.storeys.first() else { return };
        let base = wall.curve.at(first.low).station;
        let room = (wall.high - wall.low) / (4 * self.storeys.len() + 2) as f32;
        let shortest = (HEIGHT_MIN * base.radius).max(length_min(base.position)).min(room);
        let mut floor = wall.low;
        let mut below: Option<u32> = None;
        for i in 0..self.storeys.len() {
            let mean = self.storeys[i].high - self.storeys[i].low;
            let storey = &mut self.storeys[i];
            let same = below == Some(storey.n_sides);
            // Either on the ring of the storey below, or clear of it.
            storey.low = if same && storey.low - floor < GAP * mean {
                floor
            } else {
                storey.low.max(floor + shortest)
            };
            storey.high = storey.high.max(storey.low + shortest);
            floor = storey.high;
            below = Some(storey.n_sides);
        }
        if floor > wall.high {
            self.squeeze(wall, floor);
        }
    }

    /// Presses storeys that reach beyond the wall together: those far down the least.
    fn squeeze(&mut self, wall: &Wall<'_>, top: f32) {
        let excess = top - wall.high;
        // From where on the squeezing is at most to a half; the whole wall if that is not enough.
        let from = (wall.high - excess).max(wall.low);
        let scale = (wall.high - from) / (top - from);
        let press = |at: f32| if at > from { from + (at - from) * scale } else { at };
        for storey in &mut self.storeys {
            (storey.low, storey.high) = (press(storey.low), press(storey.high));
        }
    }
}

impl Wall<'_> {
    /// Sides of a storey.
    fn n_sides(&self, place: &Place) -> u32 {
        let n = self.circles.n_sides(place.station.radius, place.station.along, &self.flare);
        n.max(SIDES_MIN).min(self.circles.max_sides())
    }

    /// The columns that a hole covers, of `n` sides: the first and how many, at most half of them.
    fn columns(&self, wish: &Wish, place: &Place, n: u32) -> (u32, u32) {
        let frame = self.curve.frame(&place.station, place.tangent);
        let angle = libm::atan2f(wish.out.dot(frame.binormal()), wish.out.dot(frame.normal));
        let radius = place.station.radius * self.flare.widest(place.station.along);
        let radius = radius * self.circles.reach(n);
        let half = libm::asinf((wish.half_width / radius).min(1.0)) * n as f32 / TAU;
        let middle = angle * n as f32 / TAU;
        let first = (middle - half + COVER).floor();
        let end = (middle + half - COVER).ceil();
        let most = (n / 2).max(1) as f32;
        let width = (end - first).clamp(1.0, most);
        let first = if width < end - first { (middle - 0.5 * width).round() } else { first };
        // Too thin to cover any: the column it stands in.
        let first = if end <= first { middle.floor() } else { first };
        ((first as i32).rem_euclid(n as i32) as u32, width as u32)
    }
}

/// The bits of columns `first` to `first + width`, round the ring.
pub(crate) fn columns_mask(first: u32, width: u32, n: u32) -> u128 {
    (first..first + width).fold(0, |mask, column| mask | 1 << (column % n))
}

/// Free columns as near as can be to the wanted ones, fewer if need be; `None` when all are taken.
fn free_columns(mask: u128, column: u32, width: u32, n: u32) -> Option<(u32, u32)> {
    if mask.count_ones() >= n {
        return None;
    }
    (1..=width).rev().find_map(|width| {
        let shifts = (0..n).map(|i| if i % 2 == 0 { i / 2 } else { n - i.div_ceil(2) });
        shifts
            .map(|shift| (column + shift) % n)
            .find(|&first| mask & columns_mask(first, width, n) == 0)
            .map(|first| (first, width))
    })
}

#[cfg(test)]
#[path = "storey_tests.rs"]
mod tests;
