//! Triangles, materials and textures.

use crate::error::{MeshError, Result};
use crate::wind::Branch;
use glam::{Vec2, Vec3, Vec4};
use std::sync::Arc;
use tree_core::{Aabb, Hint, Part};

/// Triangles of one material, in columns. One surface becomes one glTF primitive.
///
/// Counter-clockwise triangles seen from outside, texture coordinates with the origin at the top
/// left of the image and v downwards (as glTF).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Vertex positions in metres.
    pub positions: Vec<Vec3>,
    /// Unit normals, one per vertex.
    pub normals: Vec<Vec3>,
    /// Texture coordinates, one per vertex. Bark repeats beyond 0 to 1.
    pub uvs: Vec<Vec2>,
    /// Unit tangents: the direction in which u grows along the surface, and in w the sign that makes
    /// `w * normal.cross(tangent)` point against v, up the picture (as glTF). Empty when there are none.
    pub tangents: Vec<Vec4>,
    /// A second set of texture coordinates, within 0 to 1, in which no two places of the whole mesh
    /// overlap: for light maps. Empty when there is none.
    pub uvs2: Vec<Vec2>,
    /// The branch each vertex moves with, an index into [`Mesh::branches`]. Empty when unknown.
    pub branches: Vec<u32>,
    /// Ambient occlusion, 0 (dark) to 1 (open), one per vertex. Empty when not computed.
    pub occlusion: Vec<f32>,
    /// For each vertex the first one that stands at the same point of the closed surface: itself,
    /// unless it is a copy at a seam of the texture. Empty when no vertex is a copy.
    pub welds: Vec<u32>,
    /// Leaves: where each leaf is attached. All have the same number of vertices,
    /// `positions.len() / anchors.len()`, and lie one after the other. Empty for bark.
    pub anchors: Vec<Vec3>,
    /// Three indices per triangle.
    pub indices: Vec<u32>,
    /// Index into [`Mesh::materials`].
    pub material: u32,
}

impl Surface {
    /// Number of triangles.
    #[must_use]
    pub fn n_triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// The box around the vertices; empty when there are none.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb::of_points(&self.positions)
    }

    /// Centre and radius in metres of a ball that holds every vertex: about the middle of the bounds,
    /// at most √3 times as large as the smallest. `None` when there are no vertices.
    #[must_use]
    pub fn bounding_sphere(&self) -> Option<(Vec3, f32)> {
        sphere(std::slice::from_ref(self))
    }

    /// Vertices of each leaf; `None` when the surface is not made of leaves.
    #[must_use]
    pub fn vertices_per_leaf(&self) -> Option<usize> {
        self.positions.len().checked_div(self.anchors.len())
    }
}

/// How a material treats the alpha of its texture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Alpha {
    /// Alpha is ignored.
    #[default]
    Opaque,
    /// Pixels with alpha below the cutoff (0 to 1) are not drawn.
    Mask(f32),
}

/// An image: RGBA, 8 bits, sRGB, straight alpha, rows from top to bottom.
#[derive(Clone, PartialEq, Eq)]
pub struct Texture {
    /// Name for people and files, without extension.
    pub name: String,
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `4 * width * height` bytes.
    pub pixels: Vec<u8>,
}

impl std::fmt::Debug for Texture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Texture({}, {} × {})", self.name, self.width, self.height)
    }
}

impl Texture {
    /// Checks that the pixels fill width and height.
    ///
    /// # Errors
    /// [`MeshError::Texture`].
    pub fn check(&self) -> Result<()> {
        // Sides of 32 bits: 64 would not hold four times their product.
        let expected = u128::from(self.width) * u128::from(self.height) * 4;
        if self.pixels.len() as u128 == expected && expected > 0 {
            return Ok(());
        }
        Err(MeshError::Texture {
            name: self.name.clone(),
            width: self.width,
            height: self.height,
            found: self.pixels.len(),
            expected: usize::try_from(expected.max(4)).unwrap_or(usize::MAX),
        })
    }
}

/// Looks of a surface, in glTF's metallic-roughness terms; nothing on a tree is metal.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name for people and files.
    pub name: String,
    /// Linear colour (0 or more; files hold up to 1) and alpha (0 to 1), multiplied with the texture.
    pub base_color: [f32; 4],
    /// Image wrapped on the surface; shared between materials and meshes.
    pub texture: Option<Arc<Texture>>,
    /// 0 mirror-like to 1 matt.
    pub roughness: f32,
    /// How texture alpha is used.
    pub alpha: Alpha,
    /// Whether back faces are drawn, with their normals turned over.
    pub double_sided: bool,
    /// Share of the light on one face that shines through the other, 0 to 1. Leaves have about 0.4.
    pub translucency: f32,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            name: "material".into(),
            base_color: [1.0; 4],
            texture: None,
            roughness: 0.9,
            alpha: Alpha::Opaque,
            double_sided: false,
            translucency: 0.0,
        }
    }
}

/// Surfaces and their materials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// What is drawn, in order.
    pub surfaces: Vec<Surface>,
    /// What the surfaces look like.
    pub materials: Vec<Material>,
    /// The branches that vertices move with in the wind, parents first. Empty for imported meshes.
    pub branches: Vec<Branch>,
}

impl Mesh {
    /// The surfaces as parts, one each and borrowed, for what reads a tree out of a mesh. Names, holes and faces are those of
    /// the materials; hints are [`Hint::Auto`].
    #[must_use]
    pub fn parts(&self) -> Vec<Part<'_>> {
        let material = |surface: &Surface| self.materials.get(surface.material as usize);
        self.surfaces
            .iter()
            .map(|surface| (surface, material(surface)))
            .map(|(surface, material)| Part {
                positions: &surface.positions,
                uvs: &surface.uvs,
                indices: &surface.indices,
                name: material.map_or("", |material| &material.name),
                hint: Hint::Auto,
                alpha_masked: material.is_some_and(|m| matches!(m.alpha, Alpha::Mask(_))),
                double_sided: material.is_some_and(|m| m.double_sided),
            })
            .collect()
    }

    /// Number of vertices of all surfaces.
    #[must_use]
    pub fn n_vertices(&self) -> usize {
        self.surfaces.iter().map(|surface| surface.positions.len()).sum()
    }

    /// Number of triangles of all surfaces.
    #[must_use]
    pub fn n_triangles(&self) -> usize {
        self.surfaces.iter().map(Surface::n_triangles).sum()
    }

    /// The box around all vertices; empty when there are none.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        self.surfaces
            .iter()
            .fold(Aabb::EMPTY, |aabb, surface| aabb.union(Aabb::of_points(&surface.positions)))
    }

    /// Centre and radius in metres of a ball that holds every vertex of all surfaces: about the middle
    /// of the bounds. `None` when there are no vertices.
    #[must_use]
    pub fn bounding_sphere(&self) -> Option<(Vec3, f32)> {
        sphere(&self.surfaces)
    }

    /// The surface of this number.
    ///
    /// # Errors
    /// [`MeshError::NoSurface`] when there is none.
    pub fn surface(&self, number: usize) -> Result<&Surface> {
        let count = self.surfaces.len();
        self.surfaces.get(number).ok_or(MeshError::NoSurface { found: number, count })
    }

    /// Checks that the mesh can be drawn and written: columns of equal length, finite numbers,
    /// indices and materials that exist, branches after those that carry them, looks within their
    /// ranges, textures filled.
    ///
    /// # Errors
    /// [`MeshError::Length`], [`MeshError::NotFinite`], [`MeshError::Dangling`] or
    /// [`MeshError::PartialTriangle`], naming surface and row; [`MeshError::BranchOrder`];
    /// [`MeshError::Material`] or [`MeshError::Texture`].
    ///
    /// # Complexity
    /// One pass over all columns.
    pub fn check(&self) -> Result<()> {
        for (number, surface) in self.surfaces.iter().enumerate() {
            check_surface(Some(number), surface, self.materials.len(), self.branches.len())?;
        }
        self.check_branches()?;
        for (number, material) in self.materials.iter().enumerate() {
            check_material(number, material)?;
        }
        self.materials
            .iter()
            .filter_map(|material| material.texture.as_deref())
            .try_for_each(Texture::check)
    }

    /// As [`check`](Self::check), of the columns of one surface only.
    ///
    /// # Errors
    /// As [`check`](Self::check) for columns, and [`MeshError::NoSurface`] when there is no such surface.
    pub fn check_surface(&self, number: usize) -> Result<()> {
        let surface = self.surface(number)?;
        check_surface(Some(number), surface, self.materials.len(), self.branches.len())
    }

    /// Checks that branches come after those that carry them, that only the first carries itself, and that
    /// their numbers are finite.
    ///
    /// # Errors
    /// [`MeshError::BranchOrder`] or [`MeshError::BranchNotFinite`], naming the first branch at fault.
    pub fn check_branches(&self) -> Result<()> {
        let finite = |b: &Branch| {
            let numbers = [b.length, b.radius, b.collar, b.phase, b.stiffness];
            b.pivot.is_finite() && b.axis.is_finite() && numbers.iter().all(|n| n.is_finite())
        };
        if let Some(branch) = self.branches.iter().position(|branch| !finite(branch)) {
            return Err(MeshError::BranchNotFinite { branch });
        }
        let late = |(row, branch): &(usize, &Branch)| branch.parent as usize >= (*row).max(1);
        match self.branches.iter().enumerate().find(late) {
            Some((row, branch)) => {
                Err(MeshError::BranchOrder { branch: row, parent: branch.parent })
            }
            None => Ok(()),
        }
    }

    /// Checks that no colour is brighter than 1: file formats rely on it, drawing does not.
    ///
    /// # Errors
    /// [`MeshError::Material`], naming the material.
    pub fn check_colors(&self) -> Result<()> {
        for (number, material) in self.materials.iter().enumerate() {
            for found in material.base_color {
                check_within(number, "base_color", found, 1.0)?;
            }
        }
        Ok(())
    }

    /// Checks that normals have unit length, within half a percent: file formats and engines rely
    /// on it, drawing does not.
    ///
    /// # Errors
    /// [`MeshError::NotUnit`], naming surface and row.
    pub fn check_normals(&self) -> Result<()> {
        for (number, surface) in self.surfaces.iter().enumerate() {
            let bad = |n: &Vec3| (n.length_squared() - 1.0).abs() > 0.01 || !n.is_finite();
            if let Some(index) = surface.normals.iter().position(bad) {
                return Err(MeshError::NotUnit {
                    surface: number,
                    index,
                    found: surface.normals[index].length(),
                });
            }
        }
        Ok(())
    }
}

fn sphere(surfaces: &[Surface]) -> Option<(Vec3, f32)> {
    let points = || surfaces.iter().flat_map(|surface| &surface.positions);
    let bounds = points().fold(Aabb::EMPTY, |bounds, &p| bounds.including(p));
    if bounds.is_empty() {
        return None;
    }
    let center = bounds.center();
    let far = points().fold(0.0_f32, |far, p| far.max(p.distance_squared(center)));
    Some((center, far.sqrt()))
}

fn check_material(number: usize, material: &Material) -> Result<()> {
    let [r, g, b, alpha] = material.base_color;
    for color in [r, g, b] {
        check_within(number, "base_color", color, f32::MAX)?;
    }
    check_within(number, "base_color", alpha, 1.0)?;
    check_within(number, "roughness", material.roughness, 1.0)?;
    if let Alpha::Mask(cutoff) = material.alpha {
        check_within(number, "alpha", cutoff, 1.0)?;
    }
    check_within(number, "translucency", material.translucency, 1.0)
}

fn check_within(material: usize, field: &'static str, found: f32, max: f32) -> Result<()> {
    if (0.0..=max).contains(&found) {
        return Ok(());
    }
    Err(MeshError::Material { material, field, found, min: 0.0, max })
}

pub(crate) fn check_surface(
    number: Option<usize>,
    surface: &Surface,
    n_materials: usize,
    n_branches: usize,
) -> Result<()> {
    let expected = surface.positions.len();
    let length = |field, found, optional: bool| {
        if found == expected || (optional && found == 0) {
            return Ok(());
        }
        Err(MeshError::Length { surface: number, field, found, expected })
    };
    length("normals", surface.normals.len(), false)?;
    length("uvs", surface.uvs.len(), false)?;
    length("tangents", surface.tangents.len(), true)?;
    length("uvs2", surface.uvs2.len(), true)?;
    length("branches", surface.branches.len(), true)?;
    length("occlusion", surface.occlusion.len(), true)?;
    length("welds", surface.welds.len(), true)?;
    if expected.checked_rem(surface.anchors.len()).is_some_and(|rest| rest != 0) {
        let found = surface.anchors.len();
        return Err(MeshError::Length { surface: number, field: "anchors", found, expected });
    }
    let bad = |field, row: Option<usize>| match row {
        Some(index) => Err(MeshError::NotFinite { surface: number, field, index }),
        None => Ok(()),
    };
    bad("positions", surface.positions.iter().position(|v| !v.is_finite()))?;
    bad("normals", surface.normals.iter().position(|v| !v.is_finite()))?;
    bad("uvs", surface.uvs.iter().position(|v| !v.is_finite()))?;
    bad("tangents", surface.tangents.iter().position(|v| !v.is_finite()))?;
    bad("uvs2", surface.uvs2.iter().position(|v| !v.is_finite()))?;
    bad("occlusion", surface.occlusion.iter().position(|v| !v.is_finite()))?;
    bad("anchors", surface.anchors.iter().position(|v| !v.is_finite()))?;
    if !surface.indices.len().is_multiple_of(3) {
        return Err(MeshError::PartialTriangle { surface: number, found: surface.indices.len() });
    }
    let exists =
        |what, rows: &[u32], count: usize| match rows.iter().find(|&&i| i as usize >= count) {
            Some(&found) => Err(MeshError::Dangling { surface: number, what, found, count }),
            None => Ok(()),
        };
    exists("vertex", &surface.indices, expected)?;
    exists("welded vertex", &surface.welds, expected)?;
    exists("branch", &surface.branches, n_branches)?;
    exists("material", &[surface.material], n_materials)
}

#[cfg(test)]
#[path = "mesh_tests.rs"]
mod tests;
