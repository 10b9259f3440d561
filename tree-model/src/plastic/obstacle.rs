//! Solids that trees meet: what they shade, and what grows into them.

use super::light::{Ball, Block, Convex, Plane};
use super::params::scene_error;
use super::pose::Pose;
use crate::error::Result;
use glam::{Mat3, Quat, Vec3};
use tree_core::{Aabb, Solid, Volume};

/// Cells along the longest side of a volume whose shadow is that of boxes.
const CELLS: u32 = 16;

/// A solid, in its own frame.
#[derive(Clone, Debug)]
pub(super) struct Obstacle {
    pub volume: Volume,
    /// Convex pieces that cast its shadow.
    pub pieces: Vec<Convex>,
    /// Whether they are all of it, and nothing else.
    pub exact: bool,
}

impl Obstacle {
    /// Balls, boxes, half-spaces, and these moved and turned, cast their exact shadow; of what is united each part; all others
    /// that of boxes, a sixteenth of their length fine.
    ///
    /// # Errors
    /// A volume without end that is no half-space, and one that holds nothing.
    pub(super) fn new(volume: Volume) -> Result<Self> {
        let mut pieces = Vec::new();
        let exact = take_apart(&volume, &mut pieces)?;
        if pieces.is_empty() {
            return Err(scene_error("obstacle", "the volume holds nothing"));
        }
        Ok(Self { volume, pieces, exact })
    }
}

/// An obstacle where it stands.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub volume: Volume,
    pub pose: Pose,
    /// In the world.
    pub pieces: Vec<Convex>,
    /// Whether the pieces are all of it.
    pub exact: bool,
    /// Around all of it; none where it has no end.
    pub ball: Option<Ball>,
}

impl Placed {
    pub(super) fn new(obstacle: &Obstacle, pose: Pose) -> Self {
        let pieces: Vec<Convex> =
            obstacle.pieces.iter().map(|piece| piece.moved(pose.rotation, pose.position)).collect();
        let ball = enclose(&pieces);
        Self { volume: obstacle.volume.clone(), pose, pieces, exact: obstacle.exact, ball }
    }

    /// Whether a point of the world lies inside.
    pub(super) fn contains(&self, point: Vec3) -> bool {
        self.near(point, 0.0) && self.volume.contains(self.pose.to_local(point))
    }

    /// Whether it may come within `margin` of the point.
    pub(super) fn near(&self, point: Vec3, margin: f32) -> bool {
        self.ball.is_none_or(|ball| {
            let far = ball.radius + margin;
            ball.center.distance_squared(point) <= far * far
        })
    }

    /// Whether it may come into the box; both in the world.
    pub(super) fn reaches_into(&self, bounds: &Aabb) -> bool {
        let (center, half) = (bounds.center(), bounds.size() * 0.5);
        let apart = |ball: &Ball| {
            let gap = ((ball.center - center).abs() - half).max(Vec3::ZERO);
            gap.length_squared() > ball.radius * ball.radius
        };
        if !self.exact {
            return self.ball.is_none_or(|ball| !apart(&ball));
        }
        self.pieces.iter().any(|piece| match piece {
            Convex::Ball(ball) => !apart(ball),
            Convex::Block(block) => {
                let turn = Mat3::from_quat(block.rotation);
                let span = turn.x_axis.abs() * block.half.x
                    + turn.y_axis.abs() * block.half.y
                    + turn.z_axis.abs() * block.half.z;
                (block.center - center).abs().cmple(span + half).all()
            }
            Convex::Plane(plane) => {
                (center - plane.point).dot(plane.normal) <= plane.normal.abs().dot(half)
            }
        })
    }

    /// Whether the segment between two points of the world runs through it.
    pub(super) fn meets(&self, a: Vec3, b: Vec3) -> bool {
        if self.pieces.len() > 1 && !self.near((a + b) * 0.5, 0.5 * a.distance(b)) {
            return false;
        }
        // The pieces of other volumes are a guess: they catch a wall thinner than the segment is long.
        let touched = self.pieces.iter().any(|piece| piece.meets(a, b));
        if self.exact {
            return touched;
        }
        if touched {
            STEPS.iter().any(|&at| self.contains(a.lerp(b, at)))
        } else {
            self.contains(b)
        }
    }
}

/// Where a segment is looked at that may run through a volume.
const STEPS: [f32; 9] = [1.0, 0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875, 0.0];

/// A ball around all pieces; none where one has no end.
fn enclose(pieces: &[Convex]) -> Option<Ball> {
    let mut bounds: Option<Aabb> = None;
    for piece in pieces {
        let ball = piece.ball()?;
        let around = Aabb::of_points(&[ball.center]).grown(ball.radius);
        bounds = Some(bounds.map_or(around, |b| b.union(around)));
    }
    let bounds = bounds?;
    let radius = bounds.size().length() * 0.5;
    Some(Ball { center: bounds.center(), radius, translucency: 0.0 })
}

/// Takes the volume apart as far as its shadow is known exactly, and says whether that was all of it.
fn take_apart(volume: &Volume, pieces: &mut Vec<Convex>) -> Result<bool> {
    let mut whole = true;
    match volume.solid() {
        Solid::Sphere { center, radius } => {
            pieces.push(Convex::Ball(Ball { center: *center, radius: *radius, translucency: 0.0 }));
        }
        Solid::Box { min, max } => pieces.push(Convex::Block(Block {
            center: (*min + *max) * 0.5,
            half: (*max - *min) * 0.5,
            rotation: Quat::IDENTITY,
        })),
        Solid::HalfSpace { point, normal } => {
            pieces.push(Convex::Plane(Plane { point: *point, normal: normal.normalize() }));
        }
        Solid::Union(parts) => {
            for part in parts {
                whole &= take_apart(part, pieces)?;
            }
        }
        Solid::Transformed { volume: inner, world_from_local } => {
            let (scale, rotation, offset) = world_from_local.to_scale_rotation_translation();
            // Only what keeps angles and lengths keeps boxes boxes.
            if (scale - Vec3::ONE).abs().max_element() < 1e-4 {
                let first = pieces.len();
                whole = take_apart(inner, pieces)?;
                for piece in &mut pieces[first..] {
                    *piece = piece.moved(rotation, offset);
                }
            } else {
                boxes(volume, pieces)?;
                whole = false;
            }
        }
        _ => {
            boxes(volume, pieces)?;
            whole = false;
        }
    }
    Ok(whole)
}

/// Fills the volume with boxes: cells that it holds, joined along x, then y, then z.
fn boxes(volume: &Volume, pieces: &mut Vec<Convex>) -> Result<()> {
    let bounds = volume.bounds();
    if bounds.is_empty() {
        return Ok(());
    }
    if !bounds.is_finite() {
        return Err(scene_error(
            "obstacle",
            "the volume has no end: only half-spaces, and unions with them, may have none",
        ));
    }
    let size = bounds.size();
    let longest = size.max_element().max(f32::MIN_POSITIVE);
    let count = |side: f32| (libm::ceilf(side / longest * CELLS as f32) as u32).clamp(1, CELLS);
    let n = [count(size.x), count(size.y), count(size.z)];
    let cell = Vec3::new(size.x / n[0] as f32, size.y / n[1] as f32, size.z / n[2] as f32);
    let margin = 0.5 * cell.min_element();
    let holds = |x: u32, y: u32, z: u32| {
        let at = bounds.min + cell * (Vec3::new(x as f32, y as f32, z as f32) + 0.5);
        // Thin walls that pass between the middles of cells count too.
        volume.contains(at) || volume.distance(at).is_some_and(|d| d <= margin)
    };
    let index = |x: u32, y: u32, z: u32| ((z * n[1] + y) * n[0] + x) as usize;
    let mut filled = vec![false; (n[0] * n[1] * n[2]) as usize];
    for z in 0..n[2] {
        for y in 0..n[1] {
            for x in 0..n[0] {
                filled[index(x, y, z)] = holds(x, y, z);
            }
        }
    }
    for z in 0..n[2] {
        for y in 0..n[1] {
            for x in 0..n[0] {
                if !filled[index(x, y, z)] {
                    continue;
                }
                let end_x = (x..n[0]).take_while(|&i| filled[index(i, y, z)]).count() as u32 + x;
                let row = |j: u32, k: u32| (x..end_x).all(|i| filled[index(i, j, k)]);
                let end_y = (y..n[1]).take_while(|&j| row(j, z)).count() as u32 + y;
                let sheet = |k: u32| (y..end_y).all(|j| row(j, k));
                let end_z = (z..n[2]).take_while(|&k| sheet(k)).count() as u32 + z;
                for k in z..end_z {
                    for j in y..end_y {
                        for i in x..end_x {
                            filled[index(i, j, k)] = false;
                        }
                    }
                }
                let corner = |x: u32, y: u32, z: u32| {
                    bounds.min + cell * Vec3::new(x as f32, y as f32, z as f32)
                };
                let (low, high) = (corner(x, y, z), corner(end_x, end_y, end_z));
                pieces.push(Convex::Block(Block {
                    center: (low + high) * 0.5,
                    half: (high - low) * 0.5,
                    rotation: Quat::IDENTITY,
                }));
            }
        }
    }
    Ok(())
}

impl Placed {
    /// Sorts obstacles by where they stand, so that the order in which they came does not show.
    pub(super) fn key(&self) -> Vec<u32> {
        let (p, q) = (self.pose.position, self.pose.rotation);
        let mut key = vec![p.x, p.y, p.z, q.x, q.y, q.z, q.w];
        if let Some(ball) = self.ball {
            key.extend([ball.center.x, ball.center.y, ball.center.z, ball.radius]);
        }
        key.into_iter().map(f32::to_bits).collect()
    }
}
