//! The chordal axis of a border, as the tree of its triangles.

use super::border::Border;
use crate::plane::fill::{Fill, FillRule, NONE, sides};
use glam::DVec2;

/// A tree of triangles. Terminals can be taken off it.
pub(super) struct Mesh {
    /// Corners against the clock, as points of the border.
    corners: Vec<[u32; 3]>,
    /// The triangle across the side from corner i to corner i + 1, or [`NONE`].
    links: Vec<[u32; 3]>,
    at: Vec<DVec2>,
}

/// A terminal branch of the axis.
#[derive(Clone, Debug)]
pub(super) struct Terminal {
    /// Its triangles, from the end inwards, without the fork's.
    pub(super) path: Vec<u32>,
    /// The fork's triangle; [`NONE`] where there is no fork: the whole axis is this one line.
    pub(super) fork: u32,
    /// Its part of the border, against the clock from one point to another.
    pub(super) stretch: [u32; 2],
}

impl Mesh {
    /// The triangles inside a border; `None` where there are none. Holes, which smoothing may close off, are cut open, and
    /// of several parts the largest counts. O(m log m).
    pub(super) fn of(border: &Border) -> Option<Self> {
        let fill = Fill::of(std::slice::from_ref(&border.at), FillRule::NonZero)?;
        let places = places(&border.at, &fill.points);
        let corners: Vec<[u32; 3]> =
            fill.triangles.iter().map(|corners| corners.map(|c| places[c as usize])).collect();
        let mut links = fill.neighbours.clone();
        let (mut seen, mut parts) = (vec![NONE; links.len()], Vec::new());
        for first in 0..links.len() {
            if seen[first] == NONE {
                parts.push(reach(&mut links, &mut seen, first as u32, parts.len() as u32));
            }
        }
        let largest = (0..parts.len()).max_by_key(|&part| (parts[part], parts.len() - part))?;
        for (links, &part) in links.iter_mut().zip(&seen) {
            if part != largest as u32 {
                *links = [NONE; 3];
            }
        }
        Some(Self { corners, links, at: border.at.clone() })
    }

    /// The points of the border.
    pub(super) fn at(&self) -> &[DVec2] {
        &self.at
    }

    fn degree(&self, triangle: u32) -> usize {
        self.links[triangle as usize].iter().filter(|&&link| link != NONE).count()
    }

    /// All terminals. O(m).
    pub(super) fn terminals(&self) -> Vec<Terminal> {
        let ends = (0..self.links.len() as u32).filter(|&triangle| self.degree(triangle) == 1);
        ends.map(|end| self.terminal(end)).collect()
    }

    /// The terminal that ends with a triangle.
    pub(super) fn terminal(&self, end: u32) -> Terminal {
        let mut path = vec![end];
        let (mut before, mut at) = (NONE, end);
        loop {
            let on = self.links[at as usize].iter().position(|&l| l != NONE && l != before);
            // The other end of a line without forks.
            let Some(side) = on else {
                return Terminal { path, fork: NONE, stretch: [0, 0] };
            };
            let next = self.links[at as usize][side];
            if self.degree(next) > 2 {
                let stretch = self.stretch(at, next).unwrap_or([0, 0]);
                return Terminal { path, fork: next, stretch };
            }
            path.push(next);
            (before, at) = (at, next);
        }
    }

    /// The part of the border on this side of the chord between two triangles.
    pub(super) fn stretch(&self, outer: u32, inner: u32) -> Option<[u32; 2]> {
        let side = self.links[outer as usize].iter().position(|&link| link == inner)?;
        let corners = self.corners[outer as usize];
        Some([corners[(side + 1) % 3], corners[side]])
    }

    /// Takes a terminal off, up to its fork. O(its length).
    pub(super) fn remove(&mut self, path: &[u32], fork: u32) {
        for &triangle in path {
            self.links[triangle as usize] = [NONE; 3];
        }
        if let (Some(links), Some(&last)) = (self.links.get_mut(fork as usize), path.last()) {
            for link in links {
                if *link == last {
                    *link = NONE;
                }
            }
        }
    }

    /// The middle of the chord between two triangles.
    pub(super) fn chord(&self, outer: u32, inner: u32) -> Option<DVec2> {
        let [a, b] = self.stretch(outer, inner)?.map(|point| self.at[point as usize]);
        Some(0.5 * (a + b))
    }

    /// The circle through the corners of a triangle. As the triangles are Delaunay's, that of a fork fits into the outline.
    pub(super) fn circle(&self, triangle: u32) -> (DVec2, f64) {
        let [a, b, c] = self.corners[triangle as usize].map(|point| self.at[point as usize]);
        let (u, v) = (b - a, c - a);
        let cross = 2.0 * u.perp_dot(v);
        if cross == 0.0 {
            return (a, 0.0);
        }
        let turned = u.length_squared() * v - v.length_squared() * u;
        let to_centre = -turned.perp() / cross;
        (a + to_centre, to_centre.length())
    }

    /// Whether a place lies inside the border. O(m).
    pub(super) fn contains(&self, place: DVec2) -> bool {
        let crosses = |&(a, b): &(DVec2, DVec2)| {
            (a.y > place.y) != (b.y > place.y)
                && place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        sides(&self.at).filter(crosses).count() % 2 == 1
    }

    /// Distance from a place to the points of the border.
    pub(super) fn clearance(&self, place: DVec2) -> f64 {
        self.at.iter().map(|p| p.distance_squared(place)).fold(f64::INFINITY, f64::min).sqrt()
    }
}

/// The point of the border each corner is; of corners cut in where it crosses itself the nearest.
fn places(border: &[DVec2], corners: &[DVec2]) -> Vec<u32> {
    let order = |a: DVec2, b: DVec2| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y));
    let mut sorted: Vec<u32> = (0..border.len() as u32).collect();
    sorted.sort_by(|&i, &j| order(border[i as usize], border[j as usize]));
    let nearest = |corner: DVec2| {
        let away = |i: u32| border[i as usize].distance_squared(corner);
        (0..border.len() as u32).min_by(|&i, &j| away(i).total_cmp(&away(j))).unwrap_or(0)
    };
    let place = |&corner: &DVec2| {
        let found = sorted.binary_search_by(|&i| order(border[i as usize], corner));
        found.map_or_else(|_| nearest(corner), |row| sorted[row])
    };
    corners.iter().map(place).collect()
}

/// Marks everything that hangs together with a triangle, and cuts what closes a ring. How many that are.
fn reach(links: &mut [[u32; 3]], seen: &mut [u32], first: u32, part: u32) -> usize {
    let mut open = vec![(first, NONE)];
    let mut count = 0;
    seen[first as usize] = part;
    while let Some((triangle, from)) = open.pop() {
        count += 1;
        for side in 0..3 {
            let next = links[triangle as usize][side];
            if next == NONE || next == from {
                continue;
            }
            if seen[next as usize] == NONE {
                seen[next as usize] = part;
                open.push((next, triangle));
            } else {
                cut(links, triangle, next);
            }
        }
    }
    count
}

fn cut(links: &mut [[u32; 3]], one: u32, other: u32) {
    for (at, to) in [(one, other), (other, one)] {
        for link in &mut links[at as usize] {
            if *link == to {
                *link = NONE;
            }
        }
    }
}
