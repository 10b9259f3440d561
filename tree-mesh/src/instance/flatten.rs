//! Instances written out: one plain mesh.

use super::{InstancedTree, Twig};
use crate::error::{MeshError, Result};
use crate::mesh::{Mesh, Surface};
use crate::wind::Branch;
use glam::{Quat, Vec3};
use tree_core::{Control, Resource};

/// Where an instance stands.
#[derive(Clone, Copy)]
struct Place {
    translation: Vec3,
    rotation: Quat,
    scale: f32,
    branch: u32,
}

impl Place {
    fn point(&self, p: Vec3) -> Vec3 {
        self.translation + self.rotation * (p * self.scale)
    }
}

impl Twig {
    fn places(&self) -> impl Iterator<Item = Place> + '_ {
        let turns = self.translations.iter().zip(&self.rotations);
        let rest = self.scales.iter().zip(&self.branches);
        turns.zip(rest).map(|((&translation, &rotation), (scale, &branch))| Place {
            translation,
            rotation,
            scale: scale.x,
            branch,
        })
    }
}

impl InstancedTree {
    /// One plain mesh: surfaces as the base has them, with the instances' triangles behind. Columns that
    /// not all parts have, and light-map coordinates, are left out. Every instance gets branches of its
    /// own, carried by the branch it stands on.
    ///
    /// # Errors
    /// [`MeshError::Limit`] and [`MeshError::TooManyVertices`] before memory is asked for,
    /// [`MeshError::Cancelled`], or as [`InstancedTree::check`] where a part was changed and is not valid.
    ///
    /// # Complexity
    /// Linear in the vertices of the result.
    pub fn flatten(&self, control: &Control) -> Result<Mesh> {
        self.check()?;
        self.check_size(control)?;
        let mut mesh = self.base.clone();
        for twig in &self.twigs {
            for place in twig.places() {
                control.check()?;
                let first_branch = mesh.branches.len() as u32;
                let carrier = mesh
                    .branches
                    .get(place.branch as usize)
                    .map_or(0, |b| b.level.saturating_add(1));
                mesh.branches.extend(twig.mesh.branches.iter().enumerate().map(|(i, branch)| {
                    let parent = match i {
                        0 => place.branch,
                        _ => first_branch + branch.parent,
                    };
                    put_branch(branch, place, parent, carrier)
                }));
                for (out, surface) in mesh.surfaces.iter_mut().zip(&twig.mesh.surfaces) {
                    put(out, surface, place, first_branch);
                }
            }
        }
        for surface in &mut mesh.surfaces {
            drop_partial(surface);
        }
        mesh.check()?;
        Ok(mesh)
    }

    fn check_size(&self, control: &Control) -> Result<()> {
        let mut triangles = self.base.n_triangles() as u64;
        for twig in &self.twigs {
            triangles = triangles.saturating_add(
                (twig.mesh.n_triangles() as u64).saturating_mul(twig.translations.len() as u64),
            );
        }
        control.limits.check(Resource::Triangles, triangles)?;
        for (number, surface) in self.base.surfaces.iter().enumerate() {
            let repeated = self.twigs.iter().filter_map(|twig| {
                let vertices = twig.mesh.surfaces.get(number)?.positions.len() as u64;
                Some(vertices.saturating_mul(twig.translations.len() as u64))
            });
            let found = repeated.fold(surface.positions.len() as u64, u64::saturating_add);
            let max = u64::from(u32::MAX) - 1;
            if found > max {
                return Err(MeshError::TooManyVertices { surface: Some(number), found, max });
            }
        }
        Ok(())
    }
}

fn put_branch(branch: &Branch, place: Place, parent: u32, levels: u32) -> Branch {
    Branch {
        parent,
        level: branch.level.saturating_add(levels),
        pivot: place.point(branch.pivot),
        axis: place.rotation * branch.axis,
        length: branch.length * place.scale,
        radius: branch.radius * place.scale,
        ..*branch
    }
}

fn put(out: &mut Surface, twig: &Surface, place: Place, first_branch: u32) {
    let first = out.positions.len() as u32;
    out.positions.extend(twig.positions.iter().map(|&p| place.point(p)));
    out.normals.extend(twig.normals.iter().map(|&n| (place.rotation * n).normalize_or(n)));
    out.uvs.extend(&twig.uvs);
    let turned = |t: &glam::Vec4| (place.rotation * t.truncate()).extend(t.w);
    out.tangents.extend(twig.tangents.iter().map(turned));
    out.branches.extend(twig.branches.iter().map(|b| first_branch + b));
    out.occlusion.extend(&twig.occlusion);
    out.welds.extend(twig.welds.iter().map(|w| first + w));
    out.anchors.extend(twig.anchors.iter().map(|&p| place.point(p)));
    out.indices.extend(twig.indices.iter().map(|i| first + i));
}

/// Empties columns that some parts did not have.
fn drop_partial(surface: &mut Surface) {
    let n = surface.positions.len();
    surface.uvs2.clear();
    if surface.tangents.len() != n {
        surface.tangents.clear();
    }
    if surface.branches.len() != n {
        surface.branches.clear();
    }
    if surface.occlusion.len() != n {
        surface.occlusion.clear();
    }
    if surface.welds.len() != n {
        surface.welds.clear();
    }
}
