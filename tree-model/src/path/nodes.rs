//! Step 1 of Xu & Mould's algorithm (1A to 1F): nodes strewn in a volume as a Poisson-disk
//! distribution, no two closer than a *separation*.
//!
//! The separation follows from the number of nodes asked for and the volume's measure, so that a
//! user names a budget instead of a length. Darts are thrown block by block: a block's darts see
//! the points of blocks thrown before it (Wei 2008, *Parallel Poisson disk sampling*, phase
//! groups). Blocks of one phase lie apart and can be thrown by different threads; each draws from
//! a stream of its own, so the result does not depend on the number of threads, and each works on
//! a few kilobytes, so the time per node does not grow with their number.
//!
//! Departure: the paper throws until it has exactly K nodes; we throw a fixed number of darts per
//! node, which gives K within about a tenth and always ends. A volume thinner than the separation
//! takes more, up to 2.8 K, because its nodes have fewer neighbours.

use crate::error::{ModelError, Result, check_finite};
use crate::path::grid::Grid;
use crate::path::obstacle::Obstacle;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::seed::uniform;
use tree_core::volume::Solid;
use tree_core::{Aabb, Control, Resource, Rng, Seed, Volume};

/// Nodes per cube of one separation that dart throwing settles at with [`DARTS_PER_NODE`] darts.
/// Jammed packings reach 0.73; closer to that, almost every dart is thrown in vain.
pub(crate) const FILL: f32 = 0.38;

/// Darts thrown inside the volume for each node wanted. Fewer leave holes, more cost time.
const DARTS_PER_NODE: f32 = 2.8;

/// Edge of a block in cells. A block and its rim must stay in a core's first-level cache.
const BLOCK: u32 = 12;

/// Most darts thrown into the bounding box for each node wanted. A volume thinner than its box by
/// more than this is strewn less densely, rather than thrown at for ever.
const MAX_BOX_DARTS_PER_NODE: f32 = 2000.0;

/// Most cells along one side of a block while darts are thrown; see [`Near`].
const MAX_NEAR_CELLS: f32 = 24.0;

/// Sectors up to this angle, in radians, have a tip too narrow for darts to hit.
const NARROW_ANGLE: f32 = 0.6;

/// A part of a union counts as thin when it would get fewer nodes than this for each separation of
/// its length.
const THIN_NODES: f32 = 3.0;

/// Darts thrown into a thin part for each separation of its length: a hole two separations long
/// stays with a chance of e to the −24.
const THIN_DARTS: f32 = 24.0;

/// Longest thin part, in separations, that gets darts of its own: each is compared with all others.
const MAX_THIN_LENGTH: f32 = 1000.0;

/// Tries to hit a thin part with one dart, and samples that estimate its measure.
const THIN_ATTEMPTS: u32 = 500;
const THIN_MEASURE_SAMPLES: u32 = 4000;

/// Samples that estimate the measure of a volume without a closed form.
const MEASURE_SAMPLES: u32 = 20_000;

/// Nodes of a search graph, sorted by grid cell so that neighbours lie close in memory.
#[derive(Clone, Debug)]
pub struct Nodes {
    /// Positions in metres.
    pub positions: Vec<Vec3>,
    /// No two strewn nodes are closer than this, in metres. Forced ones may be.
    pub separation: f32,
    /// For each forced position its node.
    pub forced: Vec<u32>,
    pub(crate) grid: Grid,
}

/// Strews about `wanted` nodes inside `volume` and outside `obstacle`, and puts one node on each
/// of the `forced` positions.
///
/// # Errors
/// [`ModelError::NotFinite`] and [`ModelError::Parameter`] for `forced` and `obstacle`,
/// [`ModelError::EmptyVolume`] when the volume has no end or no dart hits it,
/// [`ModelError::Limit`] when `wanted` exceeds [`Limits::graph_nodes`](tree_core::Limits), or what 32 bits
/// number in a volume of this shape (500 million at the least).
///
/// # Complexity
/// O(wanted · share of the bounding box that the volume fills); 30 bytes a node.
pub fn strew(
    volume: &Volume,
    obstacle: Option<&Obstacle>,
    wanted: u32,
    forced: &[Vec3],
    seed: Seed,
    control: &Control,
) -> Result<Nodes> {
    control.limits.check(Resource::GraphNodes, u64::from(wanted))?;
    for (i, &point) in forced.iter().enumerate() {
        check_finite(format!("forced[{i}]"), point)?;
    }
    obstacle.map_or(Ok(()), Obstacle::validate)?;
    let empty = |problem| ModelError::EmptyVolume { field: "volume".into(), problem };
    let bounds = volume.bounds();
    if bounds.is_empty() {
        return Err(empty("its bounding box is empty"));
    }
    if !bounds.is_finite() {
        return Err(empty("it has no end; intersect it with a bounded solid"));
    }
    let measure = match volume.measure() {
        Some(measure) => measure,
        None => volume.estimate_measure(MEASURE_SAMPLES, control)?,
    };
    let box_measure = bounds.size().element_product();
    if !(measure > 0.0 && box_measure > 0.0) {
        return Err(empty("it has no inside"));
    }
    let separation = libm::cbrtf(FILL * measure / wanted.max(1) as f32);
    if !(box_measure.is_finite() && measure.is_finite() && separation > 0.0) {
        return Err(empty("it is too large or too small for single precision"));
    }
    let grid = Grid::new(bounds, separation, wanted.max(1))?;
    let field = Field {
        volume,
        obstacle,
        separation,
        bounds,
        hit_share: measure / box_measure,
        // Only where the whole volume is one block, or darts would fall into other blocks.
        sector: if grid.dims.iter().all(|&n| n <= BLOCK) { Sector::of(volume) } else { None },
        darts_per_m3: (DARTS_PER_NODE / measure).min(MAX_BOX_DARTS_PER_NODE / box_measure)
            * wanted as f32,
        grid: &grid,
    };
    let mut given = forced.to_vec();
    field.line_narrow_tip(&mut given);
    field.throw_thin_parts(&mut given, seed.stream("thin"), control)?;
    let points = field.throw_all(&given, seed, control)?;
    if points.len() == forced.len() {
        return Err(empty(
            "no dart hit it; is it thinner than a hair, or all inside the obstacle?",
        ));
    }
    Ok(sort_by_cell(&points, forced.len(), separation, grid))
}

/// What all blocks share.
struct Field<'a> {
    volume: &'a Volume,
    obstacle: Option<&'a Obstacle>,
    separation: f32,
    bounds: Aabb,
    darts_per_m3: f32,
    /// Share of the box that the volume fills.
    hit_share: f32,
    sector: Option<Sector>,
    grid: &'a Grid,
}

impl Field<'_> {
    /// Lines up nodes on the axis of a narrow sector, from its tip to where it is wide enough for
    /// chance: darts fall evenly in the volume, and next to none into the tip, where the root is.
    fn line_narrow_tip(&self, given: &mut Vec<Vec3>) {
        let Solid::Sector { apex, axis, angle, radius } = *self.volume.solid() else { return };
        if angle > NARROW_ANGLE {
            return;
        }
        let axis = axis.normalize_or_zero();
        let end = (self.separation / libm::sinf(angle)).min(radius);
        // Just above a separation apart: within reach of each other for any linking distance.
        let step = 1.05 * self.separation;
        given.extend(
            (1..).map(|i| i as f32 * step).take_while(|&t| t < end).map(|t| apex + t * axis),
        );
    }

    /// Adds nodes in the parts of a union that are thinner than a separation, as trunks are beside
    /// their crowns. By their measure they would get a few darts only, and the graph would fall
    /// apart; here they get as many as their length asks for.
    fn throw_thin_parts(&self, given: &mut Vec<Vec3>, seed: Seed, control: &Control) -> Result<()> {
        let parts = match self.volume.solid() {
            Solid::Union(parts) => parts.as_slice(),
            _ => std::slice::from_ref(self.volume),
        };
        for (number, part) in (0..).zip(parts) {
            let length = part.bounds().size().length() / self.separation;
            let measure = match part.measure() {
                Some(measure) => measure,
                None => part.estimate_measure(THIN_MEASURE_SAMPLES, control)?,
            };
            let expected = FILL * measure / (self.separation * self.separation * self.separation);
            if length > MAX_THIN_LENGTH || expected > THIN_NODES * length {
                continue;
            }
            let mut rng = seed.child(number).rng();
            for _ in 0..(THIN_DARTS * length).ceil() as u32 {
                let Some(dart) = part.sample(&mut rng, THIN_ATTEMPTS) else { break };
                let far = |p: &Vec3| p.distance_squared(dart) >= self.separation * self.separation;
                if given.iter().all(far) && !self.obstacle.is_some_and(|o| o.holds(dart)) {
                    given.push(dart);
                }
            }
        }
        Ok(())
    }

    /// All points, the forced ones first.
    fn throw_all(&self, forced: &[Vec3], seed: Seed, control: &Control) -> Result<Vec<Vec3>> {
        let blocks = self.grid.dims.map(|cells| cells.div_ceil(BLOCK));
        let number = |b: [u32; 3]| ((b[2] * blocks[1] + b[1]) * blocks[0] + b[0]) as usize;
        let n_blocks = blocks.iter().product::<u32>() as usize;
        let mut points: Vec<Vec<Vec3>> = vec![Vec::new(); n_blocks];
        let mut n_forced = vec![0_usize; n_blocks];
        for &point in forced {
            let block = number(self.grid.cell_of(point).map(|cell| cell / BLOCK));
            points[block].push(point);
            n_forced[block] += 1;
        }
        for phase in 0..8_u32 {
            let members: Vec<[u32; 3]> = all_blocks(blocks)
                .filter(|b| (b[0] & 1) | (b[1] & 1) << 1 | (b[2] & 1) << 2 == phase)
                .collect();
            let throw = |&b: &[u32; 3]| {
                control.check()?;
                let rim = self.rim(b, blocks, &points, number);
                let rng = seed.child(number(b) as u64).rng();
                Ok(self.throw_block(b, &points[number(b)], &rim, rng))
            };
            let thrown: Vec<Vec<Vec3>> = match members.as_slice() {
                [one] => vec![throw(one)?],
                many => many.par_iter().map(throw).collect::<Result<_>>()?,
            };
            for (b, block_points) in members.iter().zip(thrown) {
                points[number(*b)].extend(block_points);
            }
        }
        let mut all = forced.to_vec();
        all.reserve(points.iter().map(Vec::len).sum());
        for (block, skip) in points.iter().zip(n_forced) {
            all.extend_from_slice(&block[skip..]);
        }
        Ok(all)
    }

    /// The box of a block in metres.
    fn block_box(&self, block: [u32; 3]) -> Aabb {
        let corner = |b: [u32; 3]| {
            let cells = Vec3::from(b.map(|b| (b * BLOCK) as f32));
            self.grid.origin + cells * self.grid.cell
        };
        Aabb::new(corner(block), corner(block.map(|b| b + 1))).intersection(self.bounds)
    }

    /// Points of the blocks around that are near enough to matter.
    fn rim(
        &self,
        b: [u32; 3],
        blocks: [u32; 3],
        points: &[Vec<Vec3>],
        number: impl Fn([u32; 3]) -> usize,
    ) -> Vec<Vec3> {
        let near = self.block_box(b).grown(self.separation);
        let span = |axis: usize| b[axis].saturating_sub(1)..(b[axis] + 2).min(blocks[axis]);
        let mut rim = Vec::new();
        for z in span(2) {
            for y in span(1) {
                for x in span(0).filter(|&x| [x, y, z] != b) {
                    let block = &points[number([x, y, z])];
                    rim.extend(block.iter().copied().filter(|&p| near.contains(p)));
                }
            }
        }
        rim
    }

    /// Throws the darts of one block and returns those that stick.
    fn throw_block(&self, block: [u32; 3], own: &[Vec3], rim: &[Vec3], mut rng: Rng) -> Vec<Vec3> {
        let target = self.block_box(block);
        let radius = 0.5 * target.size().length();
        let apart = |distance: f32| distance > radius;
        if target.is_empty() || self.volume.distance(target.center()).is_some_and(apart) {
            return Vec::new();
        }
        let expected = self.darts_per_m3 * target.size().element_product();
        // The fraction of a dart is thrown with that chance, or small blocks would get none.
        let n_darts = expected + uniform(&mut rng, 0.0, 1.0);
        let mut near = Near::new(target, self.separation);
        for &point in own.iter().chain(rim) {
            near.add(point);
        }
        let n_given = near.points.len();
        let mut stick = |dart: Vec3, inside: &dyn Fn(Vec3) -> bool| {
            // Cheap tests first: the own cell turns down most darts.
            if !near.own_cell_hits(dart)
                && inside(dart)
                && near.is_free(dart)
                && !self.obstacle.is_some_and(|obstacle| obstacle.holds(dart))
            {
                near.add(dart);
            }
        };
        match self.sector {
            // All darts hit: as many as would have, of those thrown at the box.
            Some(sector) => {
                for _ in 0..(n_darts * self.hit_share) as u32 {
                    stick(sector.throw(&mut rng), &|_| true);
                }
            }
            None => {
                for _ in 0..n_darts as u32 {
                    let dart = Vec3::new(
                        uniform(&mut rng, target.min.x, target.max.x),
                        uniform(&mut rng, target.min.y, target.max.y),
                        uniform(&mut rng, target.min.z, target.max.z),
                    );
                    stick(dart, &|dart| self.volume.contains(dart));
                }
            }
        }
        near.points.split_off(n_given)
    }
}

/// A spherical sector to throw into without missing: the shape of most subgraphs, which fills a
/// quarter of its box.
#[derive(Clone, Copy)]
struct Sector {
    apex: Vec3,
    radius: f32,
    cosine: f32,
    /// The axis and two directions across it.
    axis: Vec3,
    across: [Vec3; 2],
}

impl Sector {
    fn of(volume: &Volume) -> Option<Self> {
        let Solid::Sector { apex, axis, angle, radius } = *volume.solid() else { return None };
        let axis = axis.try_normalize()?;
        let across = axis.any_orthonormal_pair();
        let cosine = libm::cosf(angle);
        Some(Self { apex, radius, cosine, axis, across: [across.0, across.1] })
    }

    /// A point uniform in the sector, without a transcendental function.
    #[inline]
    fn throw(&self, rng: &mut Rng) -> Vec3 {
        // The height of a point on a spherical cap is uniform (Archimedes), and the largest of three
        // uniform numbers is distributed as the cube root of one.
        let up = uniform(rng, self.cosine, 1.0);
        let mut unit = || uniform(rng, 0.0, 1.0);
        let distance = self.radius * unit().max(unit()).max(unit());
        let [x, y] = loop {
            let [x, y] = [uniform(rng, -1.0, 1.0), uniform(rng, -1.0, 1.0)];
            let squared = x * x + y * y;
            if squared > 1e-6 && squared <= 1.0 {
                let scale = ((1.0 - up * up).max(0.0) / squared).sqrt();
                break [scale * x, scale * y];
            }
        };
        self.apex + distance * (up * self.axis + x * self.across[0] + y * self.across[1])
    }
}

fn all_blocks(blocks: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    (0..blocks[2])
        .flat_map(move |z| (0..blocks[1]).flat_map(move |y| (0..blocks[0]).map(move |x| [x, y, z])))
}

/// The points in and around one block, in cells of at least one separation, each a linked list.
/// Where the grid has few cells for its points (a thin slanted volume), so have its blocks, and
/// their cells are longer than a separation.
struct Near {
    origin: Vec3,
    per_metre: f32,
    dims: [u32; 3],
    reach_squared: f32,
    first: Vec<u32>,
    next: Vec<u32>,
    points: Vec<Vec3>,
}

const NONE: u32 = u32::MAX;

impl Near {
    fn new(target: Aabb, separation: f32) -> Self {
        let cell = separation.max(target.size().max_element() / MAX_NEAR_CELLS);
        // One cell of rim on every side, and one more that is never filled, so that the 27 cells
        // around a dart always exist.
        let dims = target.size().to_array().map(|side| (side / cell) as u32 + 4);
        Self {
            origin: target.min - 1.5 * cell,
            per_metre: cell.recip(),
            dims,
            reach_squared: separation * separation,
            first: vec![NONE; dims.iter().product::<u32>() as usize],
            next: Vec::new(),
            points: Vec::new(),
        }
    }

    #[inline]
    fn cell(&self, point: Vec3) -> [u32; 3] {
        let cell = ((point - self.origin) * self.per_metre).to_array();
        std::array::from_fn(|i| (cell[i] as u32).clamp(1, self.dims[i] - 2))
    }

    #[inline]
    fn index(&self, x: u32, y: u32, z: u32) -> usize {
        ((z * self.dims[1] + y) * self.dims[0] + x) as usize
    }

    fn add(&mut self, point: Vec3) {
        let [x, y, z] = self.cell(point);
        let index = self.index(x, y, z);
        self.next.push(self.first[index]);
        self.first[index] = self.points.len() as u32;
        self.points.push(point);
    }

    /// Whether a point in the dart's own cell is closer than the separation.
    fn own_cell_hits(&self, dart: Vec3) -> bool {
        let [x, y, z] = self.cell(dart);
        self.hits(self.index(x, y, z), dart)
    }

    /// Whether no point is closer than the separation.
    fn is_free(&self, dart: Vec3) -> bool {
        let [x, y, z] = self.cell(dart);
        for dz in z - 1..=z + 1 {
            for dy in y - 1..=y + 1 {
                let row = self.index(x - 1, dy, dz);
                if (row..row + 3).any(|cell| self.hits(cell, dart)) {
                    return false;
                }
            }
        }
        true
    }

    #[inline]
    fn hits(&self, cell: usize, dart: Vec3) -> bool {
        let mut at = self.first[cell];
        while at != NONE {
            if self.points[at as usize].distance_squared(dart) < self.reach_squared {
                return true;
            }
            at = self.next[at as usize];
        }
        false
    }
}

/// Counting sort by grid cell.
fn sort_by_cell(points: &[Vec3], n_forced: usize, separation: f32, mut grid: Grid) -> Nodes {
    let cells: Vec<u32> = points.iter().map(|&p| grid.number_of(p)).collect();
    let order = grid.fill(&cells);
    let mut positions = vec![Vec3::ZERO; points.len()];
    let mut forced = vec![0; n_forced];
    for (point, &slot) in order.iter().enumerate() {
        positions[slot as usize] = points[point];
        if let Some(entry) = forced.get_mut(point) {
            *entry = slot;
        }
    }
    Nodes { positions, separation, forced, grid }
}
