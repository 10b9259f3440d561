//! The mesh as the renderer sees it: one numbering over all surfaces, and prepared materials.

use super::texture::{Pyramid, Srgb};
use crate::error::Result;
use glam::Vec3;
use rayon::prelude::*;
use std::sync::Arc;
use tree_core::{Control, LimitError, Resource};
use tree_mesh::{Alpha, Material, Mesh, Surface};

/// Triangle numbers from here on mean something else in a visibility buffer.
pub(super) const LAST_IDS: u32 = u32::MAX - 8;

#[derive(Debug)]
pub(crate) struct Scene<'a> {
    pub(crate) mesh: &'a Mesh,
    /// Number of the first vertex of each surface, and of all vertices at the end.
    pub(super) first_vertex: Vec<usize>,
    /// Number of the first triangle of each surface, and of all triangles at the end.
    pub(crate) first_triangle: Vec<u32>,
    /// One per material of the mesh.
    pub(super) skins: Vec<Skin>,
    pyramids: Vec<Pyramid>,
    pub(crate) srgb: &'static Srgb,
    /// Largest side of the box around all vertices, in metres.
    pub(crate) size: f32,
}

/// A prepared material.
#[derive(Clone, Copy, Debug)]
pub(super) struct Skin {
    pub(super) cover: Cover,
    pyramid: Option<usize>,
    pub(super) color: Vec3,
    pub(super) roughness: f32,
    pub(super) translucency: f32,
    pub(super) double_sided: bool,
}

/// What of a surface's triangles is drawn, for whoever needs no colours.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pattern<'a> {
    /// The texture whose alpha decides, unless all is drawn.
    pub(crate) pyramid: Option<&'a Pyramid>,
}

/// Which parts of a surface are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cover {
    All,
    None,
    Masked,
}

impl<'a> Scene<'a> {
    /// Checks the mesh and prepares its materials. Textures are prepared in parallel, each once
    /// however many materials share it.
    pub(crate) fn new(mesh: &'a Mesh, colors: bool, control: &Control) -> Result<Self> {
        mesh.check()?;
        let n_triangles = mesh.n_triangles() as u64;
        control.limits.check(Resource::Triangles, n_triangles)?;
        if n_triangles >= u64::from(LAST_IDS) {
            let (requested, cap) = (n_triangles, u64::from(LAST_IDS));
            return Err(LimitError { resource: Resource::Triangles, requested, cap }.into());
        }
        let (mut first_vertex, mut first_triangle) = (vec![0], vec![0]);
        let (mut vertices, mut triangles) = (0, 0);
        for surface in &mesh.surfaces {
            vertices += surface.positions.len();
            triangles += surface.n_triangles() as u32;
            first_vertex.push(vertices);
            first_triangle.push(triangles);
        }
        let srgb = Srgb::shared();
        let mut wanted = Vec::new();
        let skins = mesh.materials.iter().map(|material| Skin::new(material, colors, &mut wanted));
        let skins = skins.collect();
        let pyramids = wanted
            .into_par_iter()
            .map(|(material, cutoff)| {
                control.check()?;
                let texture = material.texture.as_deref();
                Ok(texture.map(|texture| Pyramid::new(texture, cutoff, colors, srgb)))
            })
            .collect::<Result<Vec<_>>>()?;
        Ok(Self {
            mesh,
            first_vertex,
            first_triangle,
            skins,
            pyramids: pyramids.into_iter().flatten().collect(),
            srgb,
            size: mesh.bounds().size().max_element(),
        })
    }

    pub(super) fn n_vertices(&self) -> usize {
        self.first_vertex.last().copied().unwrap_or(0)
    }

    pub(crate) fn n_triangles(&self) -> u32 {
        self.first_triangle.last().copied().unwrap_or(0)
    }

    /// Number of the surface of a triangle; `guess` is tried first.
    #[inline]
    pub(super) fn surface_of(&self, triangle: u32, guess: usize) -> usize {
        let has = |surface: usize| {
            self.first_triangle[surface] <= triangle && triangle < self.first_triangle[surface + 1]
        };
        if guess + 1 < self.first_triangle.len() && has(guess) {
            return guess;
        }
        self.first_triangle.partition_point(|&first| first <= triangle) - 1
    }

    /// The three rows of the surface that `triangle` joins.
    #[inline]
    pub(super) fn rows(&self, surface: usize, triangle: u32) -> [usize; 3] {
        let at = 3 * (triangle - self.first_triangle[surface]) as usize;
        let indices = &self.mesh.surfaces[surface].indices;
        [indices[at] as usize, indices[at + 1] as usize, indices[at + 2] as usize]
    }

    #[inline]
    pub(crate) fn surface(&self, number: usize) -> &'a Surface {
        &self.mesh.surfaces[number]
    }

    #[inline]
    pub(super) fn skin(&self, surface: usize) -> &Skin {
        &self.skins[self.mesh.surfaces[surface].material as usize]
    }

    #[inline]
    pub(super) fn pyramid(&self, skin: &Skin) -> Option<&Pyramid> {
        skin.pyramid.map(|number| &self.pyramids[number])
    }

    /// Share of a surface's area that is drawn, if its texture is spread over it.
    pub(crate) fn drawn_share(&self, surface: usize) -> f32 {
        match self.pattern(surface) {
            None => 0.0,
            Some(Pattern { pyramid }) => pyramid.map_or(1.0, Pyramid::covered),
        }
    }

    /// What of a surface is drawn; none when nothing is.
    #[inline]
    pub(crate) fn pattern(&self, surface: usize) -> Option<Pattern<'_>> {
        let skin = self.skin(surface);
        match skin.cover {
            Cover::None => None,
            Cover::All => Some(Pattern { pyramid: None }),
            Cover::Masked => Some(Pattern { pyramid: self.pyramid(skin) }),
        }
    }

    pub(super) fn vertices(&self) -> impl Iterator<Item = Vec3> + '_ {
        self.mesh.surfaces.iter().flat_map(|surface| surface.positions.iter().copied())
    }
}

/// Brought into 0 to 1; NaN becomes 0.
fn unit(v: f32) -> f32 {
    if v > 0.0 { v.min(1.0) } else { 0.0 }
}

impl Skin {
    /// `wanted` collects textures with their cutoffs; equal ones are shared.
    fn new<'a>(
        material: &'a Material,
        colors: bool,
        wanted: &mut Vec<(&'a Material, u16)>,
    ) -> Self {
        let alpha = unit(material.base_color[3]);
        let cutoff = match material.alpha {
            Alpha::Opaque => 0,
            // The texture's alpha is multiplied with the colour's: the cutoff is divided by it.
            Alpha::Mask(cutoff) if unit(cutoff) > 0.0 => {
                let share = unit(cutoff) / alpha.max(1e-6);
                libm::ceilf(255.0 * share.min(2.0)) as u16
            }
            Alpha::Mask(_) => 0,
        };
        let cover = match (&material.texture, cutoff) {
            (_, 0) => Cover::All,
            (_, 256..) => Cover::None,
            (None, _) => Cover::All,
            (Some(_), _) => Cover::Masked,
        };
        let needed = match cover {
            Cover::All => colors,
            Cover::None => false,
            Cover::Masked => true,
        };
        let pyramid = material.texture.as_ref().filter(|_| needed).map(|texture| {
            let same = |(other, other_cutoff): &(&Material, u16)| {
                *other_cutoff == cutoff
                    && other.texture.as_ref().is_some_and(|other| Arc::ptr_eq(other, texture))
            };
            wanted.iter().position(same).unwrap_or_else(|| {
                wanted.push((material, cutoff));
                wanted.len() - 1
            })
        });
        let [r, g, b, _] = material.base_color.map(|v| if v > 0.0 { v.min(4.0) } else { 0.0 });
        Self {
            cover,
            pyramid,
            color: Vec3::new(r, g, b),
            roughness: unit(material.roughness),
            translucency: unit(material.translucency),
            double_sided: material.double_sided,
        }
    }
}
