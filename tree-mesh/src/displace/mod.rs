//! Bark relief: points of a surface moved in and out by noise.
//!
//! 1. Copies at seams are welded ([`crate::topology`]). Each point moves along the mean of its
//!    triangles' normals, all copies by the same bits: a closed surface stays closed.
//! 2. How far is `amplitude`, but no more than a share of the local radius: that of a cone on the
//!    point's [`Branch`], from its radius at the pivot to nothing at the tip. Where branches meet the
//!    limit is evened out downwards over the neighbours, so that the relief of a bough fades towards
//!    its twigs.
//! 3. In and out is gradient noise of several octaves (Perlin 2002) at the place of the point in metres,
//!    longer along the branch than across: bark is fissured along the branch.
//! 4. Normals follow: the gradient of the height along the surface tilts them. Its change from branch to
//!    branch and the bend of the surface are left out, so this holds for relief lower than the radius.
//!    Tangents are made orthogonal again.
//!
//! The mesh should be finer than `scale`: points a wavelength apart only become rough.

mod noise;

use crate::error::{MeshError, Result};
use crate::mesh::Surface;
use crate::topology::welded;
use crate::wind::Branch;
use glam::{DVec3, Vec3, Vec4};
use rayon::prelude::*;
use tree_core::{Control, ParameterError, Seed};

/// Rounds in which limits are evened out between neighbours.
const ROUNDS: u32 = 2;

/// How bark is displaced. Lengths in metres.
///
/// ```
/// use tree_mesh::displace::DisplaceParams;
/// assert!(DisplaceParams { amplitude: 0.02, ..Default::default() }.validate().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplaceParams {
    /// Height of the highest ridges and depth of the deepest furrows, 0 to 10 m; most points move less
    /// than half as far. Default 1 cm.
    pub amplitude: f32,
    /// Wavelength across the branch, 0.1 mm to 100 m. Default 8 cm.
    pub scale: f32,
    /// How many times longer the relief is along the branch, 1 to 20. Default 3.
    pub stretch: f32,
    /// Layers of noise, each of half the wavelength and half the height, 1 to 8. Default 3. The cost
    /// grows with it.
    pub octaves: u32,
    /// Largest share of the local radius by which a point moves, 0 to 0.5. Default 0.15.
    pub share: f32,
    /// The local radius where the mesh has no branches, 0 to 1000 m. Default 10 cm.
    pub radius: f32,
    /// Points at or below this height in metres keep their height, so that the tree stands as it stood.
    /// Default 1 mm; `None` moves all points freely.
    pub ground: Option<f32>,
    /// Where the noise comes from.
    pub seed: Seed,
}

impl Default for DisplaceParams {
    fn default() -> Self {
        Self {
            amplitude: 0.01,
            scale: 0.08,
            stretch: 3.0,
            octaves: 3,
            share: 0.15,
            radius: 0.1,
            ground: Some(0.001),
            seed: Seed(0),
        }
    }
}

impl DisplaceParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`MeshError::Parameter`].
    pub fn validate(&self) -> Result<()> {
        let ground = self.ground.unwrap_or(0.0);
        let fields: [(&'static str, f64, f64, f64); 7] = [
            ("amplitude", self.amplitude.into(), 0.0, 10.0),
            ("scale", self.scale.into(), 1e-4, 100.0),
            ("stretch", self.stretch.into(), 1.0, 20.0),
            ("octaves", self.octaves.into(), 1.0, 8.0),
            ("share", self.share.into(), 0.0, 0.5),
            ("radius", self.radius.into(), 0.0, 1000.0),
            ("ground", ground.into(), -1e6, 1e6),
        ];
        for (field, found, min, max) in fields {
            // The bounds are decimals; the same decimal as f32 may lie half a step outside.
            let slack = f64::from(f32::EPSILON);
            if !(found >= min * (1.0 - slack * min.signum()) && found <= max * (1.0 + slack)) {
                return Err(ParameterError { field: field.into(), found, min, max }.into());
            }
        }
        Ok(())
    }
}

/// Moves the points of `surface`, and tilts its normals and tangents. `branches` are those of its
/// mesh; without, or for a surface without the column, the relief runs up and down.
///
/// # Errors
/// [`MeshError::Parameter`]; as [`welded`] for a surface that is not valid; [`MeshError::Dangling`] for
/// a branch that is not there; [`MeshError::Leaves`] for leaves; [`MeshError::Cancelled`]. The surface
/// is then as it was.
///
/// # Complexity
/// O(points · octaves + triangles); about 80 bytes a point. Parallel.
pub fn displace(
    surface: &mut Surface,
    branches: &[Branch],
    displacement: &DisplaceParams,
    control: &Control,
) -> Result<()> {
    displacement.validate()?;
    if !surface.anchors.is_empty() {
        return Err(MeshError::Leaves { found: surface.anchors.len() });
    }
    let points = welded(surface)?;
    let known = branches.len();
    if let Some(&found) = surface.branches.iter().find(|&&b| known > 0 && b as usize >= known) {
        return Err(MeshError::Dangling { surface: None, what: "branch", found, count: known });
    }
    let triangles = points.triangles(surface);
    let places: Vec<Vec3> = points.first.iter().map(|&v| surface.positions[v as usize]).collect();
    control.check()?;
    let branch = |point: usize| {
        let number = surface.branches.get(points.first[point] as usize)?;
        branches.get(*number as usize)
    };
    let mut limits: Vec<f32> = (0..places.len())
        .into_par_iter()
        .map(|point| displacement.limit(branch(point), places[point]))
        .collect();
    even_out(&mut limits, &triangles);
    let directions = directions(&places, &triangles);
    control.check()?;
    let moves: Vec<Move> = (0..places.len())
        .into_par_iter()
        .map(|point| {
            let axis = branch(point).map_or(Vec3::Y, |branch| branch.axis);
            displacement.at(places[point], axis, directions[point], limits[point])
        })
        .collect();
    control.check()?;
    apply(surface, &points.of_vertex, &moves);
    Ok(())
}

/// What happens to a point.
#[derive(Clone, Copy, Debug)]
struct Move {
    to: Vec3,
    /// Gradient of the height in space.
    slope: Vec3,
}

impl DisplaceParams {
    /// How far the point may move.
    fn limit(&self, branch: Option<&Branch>, place: Vec3) -> f32 {
        let radius = branch.map_or(self.radius, |branch| {
            if branch.length <= 0.0 {
                return 0.0;
            }
            let along = place.distance(branch.pivot) / branch.length;
            branch.radius * (1.0 - along).max(0.0)
        });
        self.amplitude.min(self.share * radius)
    }

    fn at(&self, place: Vec3, axis: Vec3, direction: Vec3, limit: f32) -> Move {
        if limit <= 0.0 {
            return Move { to: place, slope: Vec3::ZERO };
        }
        let (axis, scale) = (axis.normalize_or(Vec3::Y).as_dvec3(), f64::from(self.scale));
        let less = 1.0 - 1.0 / f64::from(self.stretch);
        // The place in wavelengths; the same map, transposed, brings the gradient back.
        let squeeze = |v: DVec3| (v - axis * (less * axis.dot(v))) / scale;
        let found = noise::fbm(squeeze(place.as_dvec3()), self.seed, self.octaves);
        let height = limit * found.value as f32;
        let mut to = place + direction * height;
        if self.ground.is_some_and(|ground| place.y <= ground) {
            to.y = place.y;
        }
        Move { to, slope: limit * squeeze(found.gradient).as_vec3() }
    }
}

/// Lowers limits to the mean of a point and its neighbours.
fn even_out(limits: &mut [f32], triangles: &[[u32; 3]]) {
    for _ in 0..ROUNDS {
        let mut sums: Vec<(f32, f32)> = limits.iter().map(|&limit| (limit, 1.0)).collect();
        for triangle in triangles {
            let all: f32 = triangle.iter().map(|&point| limits[point as usize]).sum();
            for &point in triangle {
                let sum = &mut sums[point as usize];
                sum.0 += 0.5 * (all - limits[point as usize]);
                sum.1 += 1.0;
            }
        }
        for (limit, (sum, n)) in limits.iter_mut().zip(sums) {
            *limit = limit.min(sum / n);
        }
    }
}

/// Mean normals of points, weighted by area.
fn directions(places: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; places.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|point| places[point as usize].as_dvec3());
        let normal = (b - a).cross(c - a);
        for &point in triangle {
            sums[point as usize] += normal;
        }
    }
    sums.into_par_iter().map(|sum| sum.normalize_or_zero().as_vec3()).collect()
}

fn apply(surface: &mut Surface, of_vertex: &[u32], moves: &[Move]) {
    let positions = surface.positions.par_iter_mut().zip(&mut surface.normals).zip(of_vertex);
    positions.for_each(|((position, normal), &point)| {
        let Move { to, slope } = moves[point as usize];
        *position = to;
        let along = slope - *normal * normal.dot(slope);
        *normal = (*normal - along).normalize_or(*normal);
    });
    let tangents = surface.tangents.par_iter_mut().zip(&surface.normals);
    tangents.for_each(|(tangent, normal): (&mut Vec4, &Vec3)| {
        let along = tangent.truncate();
        let across = along - *normal * normal.dot(along);
        let unit = across.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
        *tangent = unit.extend(tangent.w);
    });
}

#[cfg(test)]
mod tests;
