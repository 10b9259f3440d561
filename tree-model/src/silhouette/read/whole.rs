//! A whole silhouette becomes a trunk and a crown.

use super::border::{self, HALF};
use super::cells::{ALONG, Grid, MARGIN};
use super::trunk::Trunk;
use super::{Kind, Level, LevelStroke, ReadRepair, TreeStrokes};
use crate::error::{ModelError, Result};

/// Parts within this share of the size of each other are bridged.
const BRIDGE: f32 = 0.08;

/// Parts smaller than this share of the whole are specks.
const SPECK: f32 = 0.001;

/// A crown smaller than this share of the silhouette is none.
const LEAST_CROWN: f32 = 0.05;

/// What a trunk drawn in its own colour covers at least, as a share of the silhouette,
const LEAST_WOOD: f32 = 0.002;
/// and at most.
const MOST_WOOD: f32 = 0.8;

/// Gaps in the crown are closed over twice these shares of its size, the next where the last were not enough to make it one
/// part, and of a photograph smooth.
const GAPS: [f32; 7] = [0.0, 0.005, 0.01, 0.015, 0.02, 0.03, 0.045];

/// Gaps of twice so many cells are closed in a photograph before its trunk is looked for, which may not lead into a twig.
const FRAYED: f32 = 2.0;

/// A crown is one part when it holds this share of what is covered.
const ONE: f32 = 0.95;
/// A photograph's is, when it holds this share: its thin twigs cover little and reach far.
const ONE_FRAYED: f32 = 0.985;

/// Narrow ways into a drawn crown, highlights between its leaves, are closed up to twice this share of its size,
const WAY: f32 = 0.022;
/// where they cover so many squares of that width's half: corners between lobes do not.
const WAY_AREA: f32 = 6.0;

/// A border is smooth enough with at most so many corners,
const SMOOTH: usize = 110;
/// where none that lies within this share of the size of the line between others counts.
const DETAIL: f32 = 0.005;

/// Corners of a border within this share of the size of the line between others are left out.
const TOLERANCE: f32 = 0.0012;

/// A silhouette in cells.
pub(super) struct Silhouette {
    pub(super) grid: Grid,
    /// How much of each cell is covered, 0 to 1.
    pub(super) cover: Vec<f32>,
    /// How much is covered by what looks like a trunk; empty where nothing tells.
    pub(super) wood: Vec<f32>,
    /// Whether it comes from a photograph, of which details are to be smoothed away.
    pub(super) frayed: bool,
}

impl Silhouette {
    /// Its trunk and crown.
    ///
    /// # Errors
    /// [`ModelError::Silhouette`] where nothing is covered.
    pub(super) fn strokes(
        &self,
        name: &str,
        azimuth: f32,
        repairs: &mut Vec<ReadRepair>,
    ) -> Result<TreeStrokes> {
        let grid = &self.grid;
        let all: Vec<bool> = self.cover.iter().map(|&cover| cover >= HALF).collect();
        let solid = if self.frayed {
            self.solid(&grid.closed(&all, FRAYED), repairs)
        } else {
            self.solid(&all, repairs)
        };
        let covered = count(&solid);
        let stroke = |kind, points, what: &str| LevelStroke {
            level: Level::Number(0),
            kind,
            azimuth,
            points,
            name: what.into(),
        };
        let mut tree = TreeStrokes { name: name.into(), ..TreeStrokes::default() };
        let mut crown = all.clone();
        if let Some(trunk) = self.trunk(&solid) {
            trunk.take_from(grid, &mut crown);
            if count(&crown) as f32 > LEAST_CROWN * covered as f32 {
                tree.trunk_width = Some(trunk.width(grid));
                tree.strokes.push(stroke(Kind::Axis, trunk.line(grid), "trunk"));
            } else {
                crown = all;
            }
        }
        if tree.strokes.is_empty() {
            repairs.push(ReadRepair::NoTrunk);
        }
        let border = self.crown(&crown, repairs);
        if border.len() < 3 {
            let what = if name.is_empty() { "silhouette".into() } else { name.into() };
            let problem = "nothing in it is filled; fill the tree's shape".into();
            return Err(ModelError::Silhouette { what, problem });
        }
        tree.strokes.push(stroke(Kind::Outline, border, "crown"));
        Ok(tree)
    }

    /// One part without holes.
    fn solid(&self, all: &[bool], repairs: &mut Vec<ReadRepair>) -> Vec<bool> {
        let grid = &self.grid;
        let parts = grid.parts(all);
        let covered: usize = parts.iter().map(Vec::len).sum();
        let least = (SPECK * covered as f32).ceil() as usize;
        let (mut solid, bridged) = grid.bridge(all, reach(), least);
        let lost = parts.iter().filter(|part| part.first().is_some_and(|&at| !solid[at]));
        let lost: Vec<usize> = lost.map(Vec::len).collect();
        let share = |cells: usize| cells as f32 / covered.max(1) as f32;
        // Specks of a photograph are not worth a word.
        if lost.iter().any(|&cells| cells >= least) {
            let (count, cells) = (lost.len(), lost.iter().sum());
            repairs.push(ReadRepair::PartsDropped { count, share: share(cells) });
        }
        if bridged > 0 && !self.frayed {
            repairs.push(ReadRepair::PartsBridged { count: bridged });
        }
        let filled = share(grid.fill_holes(&mut solid));
        if filled > SPECK {
            repairs.push(ReadRepair::HolesFilled { share: filled });
        }
        solid
    }

    /// The trunk: as its colour tells, or else by its shape.
    fn trunk(&self, solid: &[bool]) -> Option<Trunk> {
        if self.wood.len() == solid.len() {
            let wood = self.wood.iter().zip(solid).map(|(&wood, &inside)| wood >= HALF && inside);
            let wood: Vec<bool> = wood.collect();
            let all = (self.mass(solid), self.mass(&wood));
            let ((area, height), (part, low)) = all;
            if part > LEAST_WOOD * area && part < MOST_WOOD * area && low > height {
                let (wood, _) = self.grid.bridge(&wood, 1, 1);
                let full = self.grid.nx - 2 * MARGIN;
                if let Some(trunk) = Trunk::given(&self.grid, &wood, full as f32) {
                    return Some(trunk);
                }
            }
        }
        Trunk::of(&self.grid, solid).or_else(|| self.trunk_of_parts(solid))
    }

    /// The trunk of a silhouette whose parts are parted by gaps, which bridges do not make wide enough.
    fn trunk_of_parts(&self, solid: &[bool]) -> Option<Trunk> {
        let covers = |(&cover, &inside): (&f32, &bool)| cover >= HALF && inside;
        let parted: Vec<bool> = self.cover.iter().zip(solid).map(covers).collect();
        let one = |mask: &[bool]| {
            let parts = self.grid.parts(mask);
            parts.first().is_some_and(|part| part.len() as f32 >= ONE * count(mask) as f32)
        };
        if one(&parted) {
            return None;
        }
        let along = (self.grid.nx.max(self.grid.ny) - 2 * MARGIN) as f32;
        let closed = GAPS.iter().skip(1).map(|gap| self.grid.closed(&parted, gap * along));
        let mut joined = closed.into_iter().find(|mask| one(mask))?;
        self.grid.fill_holes(&mut joined);
        Trunk::of(&self.grid, &joined)
    }

    /// How many cells of a mask there are, and their mean row.
    fn mass(&self, mask: &[bool]) -> (f32, f32) {
        let (mut n, mut rows) = (0_usize, 0_usize);
        for at in (0..mask.len()).filter(|&at| mask[at]) {
            n += 1;
            rows += at / self.grid.nx;
        }
        (n as f32, rows as f32 / n.max(1) as f32)
    }

    /// The border of the crown.
    fn crown(&self, crown: &[bool], repairs: &mut Vec<ReadRepair>) -> Vec<glam::Vec2> {
        let grid = &self.grid;
        let size = (grid.nx.max(grid.ny) - 2 * MARGIN) as f32 * grid.cell;
        let covered = count(crown);
        // The photograph's own details go first.
        let first = usize::from(self.frayed);
        let mut ring = Vec::new();
        for (i, &gap) in GAPS.iter().enumerate().skip(first) {
            let distance = gap * size / grid.cell;
            let closed = if gap > 0.0 { grid.closed(crown, distance) } else { crown.to_vec() };
            let largest = grid.parts(&closed).into_iter().next().unwrap_or_default();
            let held = largest.iter().filter(|&&at| crown[at]).count() as f32;
            let is_last = i + 1 == GAPS.len();
            let one = if self.frayed { ONE_FRAYED } else { ONE };
            if held < one * covered as f32 && !is_last {
                continue;
            }
            let (mut one, _) = grid.bridge(&closed, reach(), (SPECK * covered as f32) as usize + 1);
            grid.fill_holes(&mut one);
            if self.frayed {
                // Twigs are thinner than the lobes that the whole distance would take away.
                let open = grid.opened(&one, (0.5 * distance).max(1.0));
                one = if open.contains(&true) { open } else { one };
            } else {
                self.close_ways(&mut one, WAY * size / grid.cell);
            }
            ring = border::border(grid, &self.levels(&one));
            let smooth = !self.frayed || border::simplified(&ring, DETAIL * size).len() <= SMOOTH;
            if smooth || is_last {
                if i > first {
                    repairs.push(ReadRepair::GapsClosed { width: 2.0 * gap * size });
                }
                break;
            }
        }
        let tolerance = if self.frayed { 2.0 * TOLERANCE } else { TOLERANCE };
        border::simplified(&ring, tolerance * size)
    }

    /// Closes narrow ways into a mask.
    fn close_ways(&self, mask: &mut Vec<bool>, distance: f32) {
        let closed = self.grid.closed(mask, distance);
        let filled: Vec<bool> = closed.iter().zip(&*mask).map(|(&c, &m)| c && !m).collect();
        for part in self.grid.parts(&filled) {
            if part.len() as f32 > WAY_AREA * distance * distance {
                part.into_iter().for_each(|at| mask[at] = true);
            }
        }
        self.grid.fill_holes(mask);
        *mask = self.grid.bridge(mask, 0, 1).0;
    }

    /// Levels whose border is that of a mask: how far cells are covered, where that agrees with the mask.
    fn levels(&self, mask: &[bool]) -> Vec<f32> {
        if self.frayed {
            return self.smoothed(mask);
        }
        let level = |(&inside, &cover): (&bool, &f32)| match (inside, cover >= HALF) {
            (true, false) => 1.0,
            (false, true) => 0.0,
            _ => cover,
        };
        mask.iter().zip(&self.cover).map(level).collect()
    }

    /// A mask smoothed over the cells beside each cell, twice.
    fn smoothed(&self, mask: &[bool]) -> Vec<f32> {
        let mut levels: Vec<f32> = mask.iter().map(|&cell| f32::from(u8::from(cell))).collect();
        for step in [1, self.grid.nx, 1, self.grid.nx] {
            // The margin is empty: what lies beyond does not matter.
            let at = |i: Option<usize>| i.and_then(|i| levels.get(i)).copied().unwrap_or(0.0);
            levels = (0..levels.len())
                .map(|i| {
                    0.25 * at(i.checked_sub(step)) + 0.5 * levels[i] + 0.25 * at(Some(i + step))
                })
                .collect();
        }
        levels
    }
}

fn count(mask: &[bool]) -> usize {
    mask.iter().filter(|&&cell| cell).count()
}

/// How many cells are bridged.
fn reach() -> usize {
    (BRIDGE * ALONG as f32) as usize
}
