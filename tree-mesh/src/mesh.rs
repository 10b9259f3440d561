//! Triangles, materials and textures.

use crate::error::{MeshError, Result};
use glam::{Vec2, Vec3};
use std::sync::Arc;
use tree_core::Aabb;

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
}

impl Mesh {
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

    /// Checks that the mesh can be drawn and written: columns of equal length, finite numbers,
    /// indices and materials that exist, looks within their ranges, textures filled.
    ///
    /// # Errors
    /// [`MeshError::Length`], [`MeshError::NotFinite`], [`MeshError::Dangling`] or
    /// [`MeshError::PartialTriangle`], naming surface and row; [`MeshError::Material`] or
    /// [`MeshError::Texture`].
    ///
    /// # Complexity
    /// One pass over all columns.
    pub fn check(&self) -> Result<()> {
        for (number, surface) in self.surfaces.iter().enumerate() {
            check_surface(number, surface, self.materials.len())?;
        }
        for (number, material) in self.materials.iter().enumerate() {
            check_material(number, material)?;
        }
        self.materials
            .iter()
            .filter_map(|material| material.texture.as_deref())
            .try_for_each(Texture::check)
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

fn check_surface(number: usize, surface: &Surface, n_materials: usize) -> Result<()> {
    let expected = surface.positions.len();
    for (field, found) in [("normals", surface.normals.len()), ("uvs", surface.uvs.len())] {
        if found != expected {
            return Err(MeshError::Length { surface: number, field, found, expected });
        }
    }
    let bad = |field, row: Option<usize>| match row {
        Some(index) => Err(MeshError::NotFinite { surface: number, field, index }),
        None => Ok(()),
    };
    bad("positions", surface.positions.iter().position(|v| !v.is_finite()))?;
    bad("normals", surface.normals.iter().position(|v| !v.is_finite()))?;
    bad("uvs", surface.uvs.iter().position(|v| !v.is_finite()))?;
    if !surface.indices.len().is_multiple_of(3) {
        return Err(MeshError::PartialTriangle { surface: number, found: surface.indices.len() });
    }
    let dangling = |what, found, count| MeshError::Dangling { surface: number, what, found, count };
    if let Some(&found) = surface.indices.iter().find(|&&i| i as usize >= expected) {
        return Err(dangling("vertex", found, expected));
    }
    if surface.material as usize >= n_materials {
        return Err(dangling("material", surface.material, n_materials));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> Mesh {
        let surface = Surface {
            positions: vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            normals: vec![Vec3::Z; 3],
            uvs: vec![Vec2::ZERO; 3],
            indices: vec![0, 1, 2],
            material: 0,
        };
        Mesh { surfaces: vec![surface], materials: vec![Material::default()] }
    }

    #[test]
    fn a_triangle_passes_and_is_counted() {
        let mesh = triangle();
        mesh.check().unwrap();
        assert_eq!((mesh.n_vertices(), mesh.n_triangles()), (3, 1));
        assert_eq!(mesh.bounds().max, Vec3::new(1.0, 1.0, 0.0));
    }

    #[test]
    fn each_flaw_has_its_own_error() {
        let spoil = |change: fn(&mut Mesh)| {
            let mut mesh = triangle();
            change(&mut mesh);
            mesh.check().unwrap_err()
        };
        let error = spoil(|m| m.surfaces[0].uvs.truncate(2));
        assert!(matches!(error, MeshError::Length { field: "uvs", found: 2, expected: 3, .. }));
        let error = spoil(|m| m.surfaces[0].normals[1] = Vec3::NAN);
        assert!(matches!(error, MeshError::NotFinite { field: "normals", index: 1, .. }));
        let error = spoil(|m| m.surfaces[0].indices[2] = 3);
        assert!(matches!(error, MeshError::Dangling { what: "vertex", found: 3, count: 3, .. }));
        let error = spoil(|m| m.surfaces[0].material = 1);
        assert!(matches!(error, MeshError::Dangling { what: "material", found: 1, .. }));
        let error = spoil(|m| m.surfaces[0].indices.push(0));
        assert!(matches!(error, MeshError::PartialTriangle { found: 4, .. }));
        let error = spoil(|m| {
            let texture = Texture { name: "t".into(), width: 2, height: 2, pixels: vec![0; 15] };
            m.materials[0].texture = Some(Arc::new(texture));
        });
        assert!(matches!(error, MeshError::Texture { found: 15, expected: 16, .. }));
    }

    #[test]
    fn a_look_outside_its_range_is_named_by_material_and_field() {
        type Change = (&'static str, fn(&mut Material));
        let changes: [Change; 8] = [
            ("base_color", |m| m.base_color[0] = f32::NAN),
            ("base_color", |m| m.base_color[1] = f32::INFINITY),
            ("base_color", |m| m.base_color[2] = -0.1),
            ("base_color", |m| m.base_color[3] = 1.1),
            ("roughness", |m| m.roughness = 1.5),
            ("alpha", |m| m.alpha = Alpha::Mask(f32::NAN)),
            ("translucency", |m| m.translucency = -1.0),
            ("translucency", |m| m.translucency = f32::INFINITY),
        ];
        for (wanted, change) in changes {
            let mut mesh = triangle();
            mesh.materials.push(Material::default());
            change(&mut mesh.materials[1]);
            match mesh.check() {
                Err(MeshError::Material { material: 1, field, .. }) => assert_eq!(field, wanted),
                other => panic!("{wanted}: {other:?}"),
            }
        }
        let mut bright = triangle();
        bright.materials[0].base_color[0] = 2.0;
        bright.check().unwrap();
        let error = bright.check_colors().unwrap_err();
        assert!(matches!(error, MeshError::Material { material: 0, found: 2.0, max: 1.0, .. }));
    }

    #[test]
    fn sides_whose_product_overflows_are_refused() {
        for (width, height) in [(u32::MAX, u32::MAX), (1 << 31, 1 << 31), (0, 1)] {
            let texture = Texture { name: "t".into(), width, height, pixels: Vec::new() };
            assert!(matches!(texture.check(), Err(MeshError::Texture { found: 0, .. })));
        }
    }
}
