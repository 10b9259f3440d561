//! A frame: what is in view, and how finely it is drawn.
//!
//! 1. `cull`: tiles, then spheres, against the six planes of the view.
//! 2. Tiles are taken front to back; the built-in pass draws their occluders.
//! 3. `aim`: λ of the size on the screen (§7.2.5), times the share of sample points that is seen, at least
//!    0.1 (§7.4).
//! 4. `follow`: the share that is drawn comes after.
//!
//! §7.4 asks for "a hysteresis function" without naming one. Ours is a band of width ε above the aim: a share
//! within λ to λ (1 + ε) stays. One outside moves to the nearer end of the band with a time
//! constant, and in each frame by a limited share of itself. So less than was asked for is never drawn, but
//! while it is catching up.

use super::eye::{Eye, Lens};
use super::occlude::Occluders;
use super::scene::{Kept, LANES, Scene, TILE, Tile};
use super::state::State;
use super::visible::{DepthBuffer, Screen};
use crate::error::{Result, check_range};
use glam::{Vec3, Vec4};
use std::ops::Range;

/// A crown is small when its radius is less than this share of its distance, in a field of view of 60°: about
/// a twentieth of the picture's height across. Its points are tested half as often.
const SMALL: f32 = 0.03;

/// How shares of geometry follow what is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneParams {
    /// Least factor on λ of a tree that is hidden, 0.001 to 1. Default 0.1, as in §7.4.
    pub hidden: f32,
    /// Width of the band in which nothing changes, as a share of λ, 0 to 1. Default 0.05. Wider: calmer, but
    /// up to so much more is drawn.
    pub band: f32,
    /// Seconds in which λ comes nearer to its aim by two thirds, 0 (at once) to 60. Default 0.2.
    pub time: f32,
}

impl Default for SceneParams {
    fn default() -> Self {
        Self { hidden: 0.1, band: 0.05, time: 0.2 }
    }
}

impl SceneParams {
    /// Checks every field against its range.
    ///
    /// # Errors
    /// [`LodError::Parameter`](crate::LodError::Parameter), naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("hidden", self.hidden.into(), 0.001, 1.0)?;
        check_range("band", self.band.into(), 0.0, 1.0)?;
        check_range("time", self.time.into(), 0.0, 60.0)
    }
}

/// How it is found out what stands before a tree.
#[derive(Clone, Copy, Debug, Default)]
pub enum Occlusion<'a> {
    /// Not at all: every tree counts as seen.
    #[default]
    None,
    /// From depths the engine drew.
    Depth(DepthBuffer<'a>),
    /// From the models' [`occluders`](super::Model::occluders), drawn here; ground and houses hide nothing.
    BuiltIn,
}

/// One picture that is to be drawn.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The camera.
    pub eye: Eye,
    /// What hides trees.
    pub occlusion: Occlusion<'a>,
    /// Seconds since the last frame, 0 or more; at most 10⁶.
    pub seconds: f32,
    /// Whether the camera has jumped: all shares are then what they should be at once.
    pub cut: bool,
}

/// What a frame draws.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Selected {
    /// Instances in view.
    pub n_drawn: usize,
    /// Instances out of view.
    pub n_culled: usize,
    /// Instances in view of which some sample points are hidden. What is so far that it is drawn as coarsely
    /// as can be is not tested, and counts as seen.
    pub n_occluded: usize,
    /// Instances in view of which all are.
    pub n_hidden: usize,
    /// Indices drawn: what a vertex shader sees at most.
    pub n_indices: u64,
    /// Triangles drawn, if all are lists.
    pub n_triangles: u64,
}

impl Scene {
    /// Finds what is in view, and how finely it is drawn. `state` keeps it for
    /// [`draws`](Self::draws) and [`batches`](Self::batches).
    ///
    /// # Errors
    /// For matrices that are no camera, a depth buffer of the wrong size, parameters outside their range, and
    /// a state of another scene. The state is left as it was.
    ///
    /// # Complexity
    /// O(instances / 64) and about 100 ns for each in view; no allocation.
    pub fn select(
        &self,
        frame: &Frame<'_>,
        params: &SceneParams,
        state: &mut State,
    ) -> Result<Selected> {
        params.validate()?;
        check_range("seconds", frame.seconds.into(), 0.0, 1e6)?;
        state.check(self)?;
        let lens = frame.eye.lens()?;
        let depth = match &frame.occlusion {
            Occlusion::Depth(buffer) => Some(buffer.screen()?),
            _ => None,
        };
        self.cull(&lens, state);
        let pace = Pace::of(frame, params);
        state.frame = state.frame.wrapping_add(1);
        if matches!(frame.occlusion, Occlusion::BuiltIn) {
            self.occlude(&lens, state);
        }
        Ok(self.decide(&lens, frame, depth, &pace, state))
    }

    /// Lists the rows in view, tile by tile, front to back.
    fn cull(&self, lens: &Lens, state: &mut State) {
        state.tiles.clear();
        state.drawn.clear();
        for (number, tile) in self.tiles.iter().enumerate() {
            if tile.place(lens) != Place::Outside {
                let distance = (0.5 * (tile.low + tile.high) - lens.position).length_squared();
                // Bits of positive floats are in the order of the floats.
                state.tiles.push((distance.to_bits(), number as u32));
            }
        }
        state.tiles.sort_unstable();
        for &(_, number) in &state.tiles {
            let Some(tile) = self.tiles.get(number as usize) else { continue };
            let first = number as usize * TILE;
            let end = self.len().min(first + TILE);
            if tile.place(lens) == Place::Inside {
                state.drawn.extend(first as u32..end as u32);
                continue;
            }
            let margins = tile.margins(lens);
            let rows = (first..end).zip(margins);
            state.drawn.extend(rows.filter(|(_, m)| *m >= 0.0).map(|(row, _)| row as u32));
        }
    }

    fn occlude(&self, lens: &Lens, state: &mut State) {
        state.occluders.clear();
        let rows = Occluders::rows(lens);
        for &row in &state.drawn {
            if let Some((row, model)) = self.row(row) {
                state.occluders.draw(model, row, lens.position, &rows);
            }
        }
    }

    fn decide(
        &self,
        lens: &Lens,
        frame: &Frame<'_>,
        depth: Option<Screen<'_>>,
        pace: &Pace,
        state: &mut State,
    ) -> Selected {
        let State { memory, drawn, occluders, frame: now, .. } = state;
        let screen = match frame.occlusion {
            Occlusion::BuiltIn => Some(occluders.screen(*lens)),
            _ => depth,
        };
        let mut found = Selected {
            n_drawn: drawn.len(),
            n_culled: self.len() - drawn.len(),
            ..Selected::default()
        };
        for &number in drawn.iter() {
            let Some((row, model)) = self.row(number) else { continue };
            let Some(memory) = memory.get_mut(number as usize) else { continue };
            let new = frame.cut || memory.frame != now.wrapping_sub(1);
            memory.frame = *now;
            let distance = lens.distance((row.crown - lens.position).length()) * row.per_scale;
            let lambda = model.lambda(distance);
            memory.seen = match &screen {
                Some(screen) if lambda > model.least() => {
                    let small = row.crown_radius * row.per_scale < SMALL * distance;
                    let groups = model.groups(*now, number, new, small);
                    screen.test(model, row, memory.seen, groups)
                }
                // What is drawn as coarsely as can be need not be tested.
                _ => u64::MAX,
            };
            let visible = model.visible(memory.seen);
            let aim = model.within(lambda * visible.max(pace.hidden));
            memory.lambda = if new { aim } else { pace.follow(memory.lambda, aim) };
            let from = if new { model.sought(memory.lambda) } else { memory.level.into() };
            let level = model.level(memory.lambda, from);
            memory.level = level as u16;
            found.n_occluded += usize::from(visible < 1.0);
            found.n_hidden += usize::from(visible == 0.0);
            found.n_indices += model.levels.get(level).map_or(0, |step| step.indices);
        }
        found.n_triangles = found.n_indices / 3;
        found
    }

    /// A row and its model.
    #[inline]
    pub(super) fn row(&self, number: u32) -> Option<(&super::scene::Row, &Kept)> {
        let row = self.rows.get(number as usize)?;
        Some((row, self.models.get(row.model as usize)?))
    }
}

/// Where a tile lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    Outside,
    Across,
    Inside,
}

impl Tile {
    fn place(&self, lens: &Lens) -> Place {
        let center = 0.5 * (self.low + self.high) - lens.position;
        let half = 0.5 * (self.high - self.low);
        let mut place = Place::Inside;
        for plane in lens.planes {
            let normal: Vec3 = plane.truncate();
            let middle = normal.dot(center) + plane.w;
            let reach = normal.abs().dot(half);
            if middle + reach + self.largest < 0.0 {
                return Place::Outside;
            }
            if middle - reach < 0.0 {
                place = Place::Across;
            }
        }
        place
    }

    /// How far each sphere reaches into the view; below 0 where it does not.
    fn margins(&self, lens: &Lens) -> [f32; TILE] {
        let mut margins = [f32::INFINITY; TILE];
        let eye = lens.position;
        for Vec4 { x, y, z, w } in lens.planes {
            let centers = self.x.iter().zip(&self.y).zip(&self.z);
            for ((least, ((px, py), pz)), radius) in
                margins.iter_mut().zip(centers).zip(&self.radius)
            {
                let inside = x * (px - eye.x) + y * (py - eye.y) + z * (pz - eye.z) + w;
                let margin = inside + radius;
                // f32::min would look for NaN, of which there are none.
                *least = if margin < *least { margin } else { *least };
            }
        }
        margins
    }
}

impl Kept {
    /// λ for a distance in a field of view of 60°.
    #[inline]
    fn lambda(&self, distance: f32) -> f32 {
        self.distance.lambda((distance - self.near) * self.per_range)
    }

    /// λ of the coarsest level.
    #[inline]
    fn least(&self) -> f32 {
        self.levels.first().map_or(1.0, |step| step.lambda)
    }

    /// A share that the levels have.
    #[inline]
    fn within(&self, lambda: f32) -> f32 {
        lambda.max(self.least()).min(self.levels.last().map_or(1.0, |step| step.lambda))
    }

    /// The level for λ, by bisection.
    fn sought(&self, lambda: f32) -> usize {
        self.levels.partition_point(|step| step.lambda < lambda)
    }

    /// The points of an instance whose turn it is: all of a new one, four of others, and of small ones
    /// four in every other frame.
    #[inline]
    fn groups(&self, frame: u32, row: u32, new: bool, small: bool) -> Range<usize> {
        let turn = if small { frame / 2 } else { frame }.wrapping_add(row / 2);
        let group = (turn % self.points.len().max(1) as u32) as usize;
        match (new, small && (frame ^ row) & 1 == 1) {
            (true, _) => 0..self.points.len(),
            (false, true) => 0..0,
            (false, false) => group..group + 1,
        }
    }

    /// Share of the points that are seen; 1 when there are none.
    #[inline]
    pub(super) fn visible(&self, seen: u64) -> f32 {
        let n = self.points.len() * LANES;
        if n == 0 {
            return 1.0;
        }
        let seen = seen & (u64::MAX >> (64 - n.min(64)));
        seen.count_ones() as f32 / n as f32
    }
}

/// How far shares move in this frame.
struct Pace {
    hidden: f32,
    band: f32,
    /// Share of the way.
    step: f32,
    /// Most of itself that a share grows by.
    most: f32,
}

impl Pace {
    fn of(frame: &Frame<'_>, params: &SceneParams) -> Self {
        let times = if params.time > 0.0 { frame.seconds / params.time } else { f32::INFINITY };
        Self {
            hidden: params.hidden,
            band: params.band,
            step: 1.0 - libm::expf(-times),
            most: times,
        }
    }

    #[inline]
    fn follow(&self, lambda: f32, aim: f32) -> f32 {
        let to = if aim > lambda { aim } else { lambda.min(aim * (1.0 + self.band)) };
        let moved = lambda + self.step * (to - lambda);
        moved.min(lambda * (1.0 + self.most)).max(lambda / (1.0 + self.most))
    }
}
