//! Space colonisation (Palubicki et al. 2009, section 4.1; Runions et al. 2007): markers of free space that
//! buds compete for.
//!
//! A node takes all markers within an occupancy radius away. Of the others, a bud perceives those within a
//! perception radius and angle about its direction; each goes to the nearest of the buds that perceive it.
//! A bud that gets any has space, and its best direction is the mean of the directions to them.

use super::lattice::Lattice;
use crate::error::{Result, check};
use crate::path::Obstacle;
use glam::{IVec3, Vec3};
use std::f32::consts::PI;
use tree_core::{Limits, Seed, Volume};

/// Most markers in a cell on average, so that a slip in the density does not fill the memory.
const MAX_PER_CELL: f32 = 4096.0;
/// Coordinates of cells stay this far from the end of an i32.
const MAX_CELL: f32 = 1e9;

/// How free space is marked and perceived.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Space {
    /// Radius in metres within which a node leaves no marker, 0.001 to 100. About two internodes.
    /// Default 0.24.
    pub occupancy: f32,
    /// How far a bud sees in metres, 0.001 to 100. Four to six internodes. Default 0.6.
    pub perception: f32,
    /// Half the angle of a bud's view in radians, 0.01 to π. Default π/4.
    pub angle: f32,
    /// Markers in a cube of the perception radius, 0.1 to 4096. Default 50.
    pub density: f32,
    /// Where there are markers: the crown. Default `None`: everywhere.
    pub crown: Option<Volume>,
}

impl Default for Space {
    fn default() -> Self {
        Self { occupancy: 0.24, perception: 0.6, angle: 0.25 * PI, density: 50.0, crown: None }
    }
}

impl Space {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`](crate::ModelError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check("space.occupancy", self.occupancy, 0.001_f32, 100)?;
        check("space.perception", self.perception, 0.001_f32, 100)?;
        check("space.angle", self.angle, 0.01_f32, PI)?;
        check("space.density", self.density, 0.1_f32, MAX_PER_CELL)
    }
}

/// A bud that looks for space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Watcher {
    /// Where it is.
    pub(crate) position: Vec3,
    /// Where it looks; a unit vector.
    pub(crate) direction: Vec3,
}

/// The markers of one cell: a part of the columns.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    /// One more than the row of its first marker; 0 for a cell nobody has looked at.
    start: u32,
    len: u32,
}

/// Who has a marker.
#[derive(Clone, Copy, Debug)]
struct Claim {
    distance: f32,
    watcher: u32,
}

const UNCLAIMED: Claim = Claim { distance: f32::INFINITY, watcher: u32::MAX };

/// All markers that were ever looked at.
#[derive(Clone, Debug)]
pub(crate) struct Markers {
    space: Space,
    seed: Seed,
    obstacle: Option<Obstacle>,
    /// No markers below this height.
    ground: f32,
    edge: f32,
    cells: Lattice<Cell>,
    positions: Vec<Vec3>,
    claims: Vec<Claim>,
}

impl Markers {
    /// None yet; each cell gets its own from `seed` when it is first looked at. None lie in the obstacle,
    /// outside the crown or below `ground`.
    ///
    /// # Errors
    /// As [`Space::validate`].
    pub(crate) fn new(
        space: &Space,
        obstacle: Option<&Obstacle>,
        ground: f32,
        seed: Seed,
    ) -> Result<Self> {
        space.validate()?;
        Ok(Self {
            space: space.clone(),
            seed,
            obstacle: obstacle.cloned(),
            ground,
            edge: 0.5 * space.perception.max(space.occupancy),
            cells: Lattice::new(),
            positions: Vec::new(),
            claims: Vec::new(),
        })
    }

    fn range(&self, point: Vec3, radius: f32) -> (IVec3, IVec3) {
        let cell = |corner: Vec3| {
            let cell = (corner / self.edge).floor();
            cell.clamp(Vec3::splat(-MAX_CELL), Vec3::splat(MAX_CELL)).as_ivec3()
        };
        (cell(point - radius), cell(point + radius))
    }

    /// Makes sure that all cells within `radius` of `point` have their markers.
    fn look(&mut self, point: Vec3, radius: f32, limits: &Limits) -> Result<()> {
        let (low, high) = self.range(point, radius);
        self.cells.cover(low, high, limits)?;
        for cell in cells(low, high) {
            let place = self.cells.place(cell);
            if self.cells.cells()[place].start == 0 {
                let start = self.positions.len() as u32 + 1;
                self.strew(cell);
                let len = self.positions.len() as u32 + 1 - start;
                self.cells.cells_mut()[place] = Cell { start, len };
            }
        }
        Ok(())
    }

    fn strew(&mut self, cell: IVec3) {
        let stream = [cell.x, cell.y, cell.z]
            .iter()
            .fold(self.seed, |stream, &n| stream.child(u64::from(n as u32)));
        let share = self.edge / self.space.perception;
        let mean = (self.space.density * share * share * share).min(MAX_PER_CELL);
        let count = (mean + stream.unit(0)) as u64;
        let low = cell.as_vec3() * self.edge;
        for marker in 0..count {
            let unit = |axis| stream.unit(3 * marker + axis);
            let position = low + self.edge * Vec3::new(unit(1), unit(2), unit(3));
            let free = position.y >= self.ground
                && self.space.crown.as_ref().is_none_or(|crown| crown.contains(position))
                && self.obstacle.as_ref().is_none_or(|obstacle| !obstacle.holds(position));
            if free {
                self.positions.push(position);
                self.claims.push(UNCLAIMED);
            }
        }
    }

    /// Takes all markers near `points` away.
    ///
    /// # Errors
    /// [`ModelError::Limit`](crate::ModelError::Limit) when the cells looked at would be too many.
    ///
    /// # Complexity
    /// O(points · markers within the occupancy radius).
    pub(crate) fn occupy(&mut self, points: &[Vec3], limits: &Limits) -> Result<()> {
        let radius = self.space.occupancy;
        for &point in points {
            self.look(point, radius, limits)?;
            let (low, high) = self.range(point, radius);
            for cell in cells(low, high) {
                let place = self.cells.place(cell);
                let Cell { start, mut len } = self.cells.cells()[place];
                let first = start.saturating_sub(1);
                let mut row = first;
                while row < first + len {
                    if self.positions[row as usize].distance_squared(point) < radius * radius {
                        len -= 1;
                        self.positions.swap(row as usize, (first + len) as usize);
                    } else {
                        row += 1;
                    }
                }
                self.cells.cells_mut()[place].len = len;
            }
        }
        Ok(())
    }

    /// Lets the watchers compete: for each the direction to the space it has won, zero for none. Of two
    /// that are equally near to a marker the first gets it.
    ///
    /// # Errors
    /// As [`occupy`](Self::occupy).
    ///
    /// # Complexity
    /// O(watchers · markers within the perception radius).
    pub(crate) fn compete(&mut self, watchers: &[Watcher], limits: &Limits) -> Result<Vec<Vec3>> {
        let radius = self.space.perception;
        for watcher in watchers {
            self.look(watcher.position, radius, limits)?;
        }
        let narrow = libm::cosf(self.space.angle);
        let mut claimed = Vec::new();
        for (number, watcher) in (0..).zip(watchers) {
            let (low, high) = self.range(watcher.position, radius);
            for cell in cells(low, high) {
                let Cell { start, len } = self.cells.get(cell);
                let first = start.saturating_sub(1) as usize;
                for row in first..first + len as usize {
                    let away = self.positions[row] - watcher.position;
                    let distance = away.length();
                    if distance >= radius || away.dot(watcher.direction) < narrow * distance {
                        continue;
                    }
                    let claim = &mut self.claims[row];
                    if distance < claim.distance {
                        if claim.watcher == u32::MAX {
                            claimed.push(row);
                        }
                        *claim = Claim { distance, watcher: number };
                    }
                }
            }
        }
        let mut won = vec![Vec3::ZERO; watchers.len()];
        for row in claimed {
            let claim = std::mem::replace(&mut self.claims[row], UNCLAIMED);
            let winner = claim.watcher as usize;
            won[winner] += (self.positions[row] - watchers[winner].position).normalize_or_zero();
        }
        Ok(won.into_iter().zip(watchers).map(|(sum, w)| direction(sum, w)).collect())
    }
}

/// The mean direction; a watcher whose markers pull evenly to all sides goes on as it looks.
fn direction(sum: Vec3, watcher: &Watcher) -> Vec3 {
    if sum == Vec3::ZERO { sum } else { sum.normalize_or(watcher.direction) }
}

fn cells(low: IVec3, high: IVec3) -> impl Iterator<Item = IVec3> {
    (low.x..=high.x).flat_map(move |x| {
        (low.y..=high.y).flat_map(move |y| (low.z..=high.z).map(move |z| IVec3::new(x, y, z)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn markers() -> Markers {
        let space = Space { perception: 1.0, occupancy: 0.4, ..Default::default() };
        Markers::new(&space, None, f32::NEG_INFINITY, Seed(3)).unwrap()
    }

    const UP: Watcher = Watcher { position: Vec3::ZERO, direction: Vec3::Y };

    #[test]
    fn a_lone_bud_finds_space_ahead() {
        let won = markers().compete(&[UP], &Limits::default()).unwrap();
        assert!(won[0].y > 0.9 && won[0].is_normalized(), "{won:?}");
    }

    #[test]
    fn the_nearer_bud_gets_the_space() {
        let near = Watcher { position: Vec3::new(0.0, 0.5, 0.0), direction: Vec3::Y };
        let far = Watcher { position: Vec3::new(0.0, -0.45, 0.0), direction: Vec3::Y };
        let mut both = markers();
        both.occupy(&[Vec3::new(0.0, 0.1, 0.0), Vec3::ZERO], &Limits::default()).unwrap();
        let won = both.compete(&[far, near], &Limits::default()).unwrap();
        assert!(won[1].y > 0.0, "{won:?}");
        let again = both.compete(&[far, near], &Limits::default()).unwrap();
        assert_eq!(won, again, "claims last for one competition");
    }

    #[test]
    fn occupied_space_and_obstacles_hold_no_markers() {
        let mut taken = markers();
        let ahead: Vec<Vec3> = (0..12).map(|i| Vec3::new(0.0, 0.1 * i as f32, 0.0)).collect();
        let wide = Space { occupancy: 1.0, perception: 1.0, ..Default::default() };
        taken.space = wide.clone();
        taken.occupy(&ahead, &Limits::default()).unwrap();
        assert_eq!(taken.compete(&[UP], &Limits::default()).unwrap(), [Vec3::ZERO]);
        let ceiling =
            Obstacle { volume: Volume::half_space(Vec3::ZERO, -Vec3::Y).unwrap(), clearance: 0.0 };
        let mut under = Markers::new(&wide, Some(&ceiling), -9.0, Seed(3)).unwrap();
        let up = under.compete(&[UP], &Limits::default()).unwrap();
        assert_eq!(up, [Vec3::ZERO]);
    }
}
