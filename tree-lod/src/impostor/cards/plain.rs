//! Planes for programs without shaders of ours: light in the picture, and normals of a crown.

use super::{Cards, PLANES, Plane, mesh, planes};
use crate::error::Result;
use crate::impostor::boxes::LeafBox;
use crate::preview::Srgb;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};
use tree_mesh::{Alpha, Mesh, Surface, Texture};

/// Planes that are drawn of each box: all six at once would cover too much.
pub const PLAIN: usize = 3;
/// Mean light of all that is covered. Pictures are somewhat darker than bare leaves: those shade each other,
/// planes hardly do.
const EXPOSURE: f64 = 0.85;
/// Alpha from which on a texel is drawn. Three planes that cross cover more than one.
const CUTOFF: f32 = 0.62;
/// Light on the planes of the whole crown, against those of its parts: nothing else shades them.
const ALONE: f32 = 0.7;
/// How much brighter what stands out is, and how much darker what lies behind, of 1; texels by which it
/// must stand out for that; and texels around it that are looked at.
const CONTRAST: f32 = 0.55;
const RELIEF: f32 = 3.0;
const AROUND_TEXEL: usize = 2;
/// Light from straight below, where that from straight above is 1.
const BELOW: f32 = 0.4;
/// Part of a normal that looks to the viewer, against the part that looks out of the crown.
const TOWARD: f32 = 0.9;

/// Part of the height in the crown in a normal, and what is added for the sky.
const HIGH: f32 = 0.4;
const UPWARD: f32 = 0.3;

/// The picture with light in it, made when it is first asked for.
#[derive(Clone, Debug, Default)]
pub(super) struct Lit(OnceLock<Arc<Texture>>);

/// Whether it has been made yet is no part of the value.
impl PartialEq for Lit {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Cards {
    /// The planes of some boxes as a mesh for programs without shaders: [`PLAIN`] planes of each box that
    /// together look best from around and a little above, both sides of each as squares of their own. The
    /// picture is that of [`lit`](Self::lit); normals are those of a rounded crown, turned to the side that is
    /// seen.
    ///
    /// # Errors
    /// [`LodError::Impostor`](crate::LodError::Impostor) when there is no such box.
    ///
    /// # Complexity
    /// O(boxes); the first time, O(texels) besides.
    pub fn plain(&self, boxes: &[u32]) -> Result<Mesh> {
        let mut surface = Surface::default();
        let crown = self.boxes.get(0)?;
        for &number in boxes {
            let leaf_box = self.boxes.get(number)?;
            let faces = planes(leaf_box);
            for plane in best_planes(&faces) {
                for side in [1.0, -1.0] {
                    self.side(&mut surface, number, plane, &faces[plane], side, crown);
                }
            }
        }
        let mut material = mesh::material(self.lit());
        material.double_sided = false;
        material.alpha = Alpha::Mask(CUTOFF);
        Ok(Mesh { surfaces: vec![surface], materials: vec![material], ..Mesh::default() })
    }

    /// One side of a plane.
    fn side(
        &self,
        surface: &mut Surface,
        number: u32,
        plane: usize,
        face: &Plane,
        side: f32,
        crown: &LeafBox,
    ) {
        let first = surface.positions.len() as u32;
        let size = Vec2::new(self.color.width as f32, self.color.height as f32);
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let (right, up) = (face.right * face.half.x, face.up * face.half.y);
            let p = face.center + right * x + up * y;
            surface.positions.push(p);
            surface.normals.push(rounded(p, face.normal * side, crown));
            surface.uvs.push(self.place(number, plane, Vec2::new(x, y)) / size);
        }
        let corners = if side > 0.0 { [0, 1, 2, 0, 2, 3] } else { [0, 2, 1, 0, 3, 2] };
        surface.indices.extend(corners.map(|corner| first + corner));
    }

    /// The colours of [`color`](Self::color) with light: the share of the sky that is seen through the leaves around,
    /// by place and depth in the crown, and softly by the normal. Made when it is first asked for.
    ///
    /// # Complexity
    /// O(texels + cells of the crown), in parallel; then O(1).
    #[must_use]
    pub fn lit(&self) -> Arc<Texture> {
        let make = || Arc::new(self.shine());
        Arc::clone(self.lit.0.get_or_init(make))
    }

    fn shine(&self) -> Texture {
        let srgb = Srgb::shared();
        let shades = self.shades();
        let mut pixels = self.color.pixels.clone();
        let (texels, _) = pixels.as_chunks_mut::<4>();
        let covered = texels.iter().zip(&shades).filter(|(texel, _)| texel[3] >= 128);
        let (sum, n) = covered.fold((0.0, 0_u64), |(s, n), (_, &v)| (s + f64::from(v), n + 1));
        let exposure = if sum > 0.0 { (EXPOSURE * n as f64 / sum) as f32 } else { 1.0 };
        let (width, size) = (self.color.width as usize, self.size as usize);
        texels.par_iter_mut().zip(&shades).enumerate().for_each(|(at, (texel, &shade))| {
            let tile = at / width / size * self.columns as usize + at % width / size;
            let alone = if tile < PLANES { ALONE } else { 1.0 };
            let lit = srgb.decode(*texel) * (exposure * alone * shade);
            let [r, g, b] = lit.to_array().map(|v| srgb.encode(v.min(1.0)));
            *texel = [r, g, b, texel[3]];
        });
        let (width, height) = (self.color.width, self.color.height);
        Texture { name: "cards".into(), width, height, pixels }
    }

    /// The light on each texel of the atlas; 0 where there is no tile.
    fn shades(&self) -> Vec<f32> {
        let light = self.crown.light();
        let (width, size) = (self.color.width as usize, self.size as usize);
        let mut shades = vec![0.0; width * self.color.height as usize];
        // A row of tiles at a time.
        shades.par_chunks_mut(width * size).enumerate().for_each(|(row, shades)| {
            for (at, shade) in shades.iter_mut().enumerate() {
                let (x, y) = (at % width, at / width);
                let tile = row * self.columns as usize + x / size;
                let Ok(leaf_box) = self.boxes.get((tile / PLANES) as u32) else { continue };
                let face = planes(leaf_box)[tile % PLANES];
                let [_, ny, _, depth] = self.detail_at(x, row * size + y);
                let p = self.position(&face, [x % size, y], depth);
                let soft = BELOW + (1.0 - BELOW) * (0.5 + 0.5 * ny);
                let texel = 2.0 * face.half.max_element() / self.inner();
                let above = self.relief([x, row * size + y], depth) * face.reach / texel;
                let relief = 1.0 + CONTRAST * (above / RELIEF).clamp(-1.0, 1.0);
                *shade = light.at(p) * soft * relief;
            }
        });
        shades
    }

    /// How far a texel lies above the mean of what is around it in its tile, in units of the depth.
    fn relief(&self, [x, y]: [usize; 2], depth: f32) -> f32 {
        let (width, size) = (self.color.width as usize, self.size as usize);
        let (texels, _) = self.color.pixels.as_chunks::<4>();
        let around = |t: usize| {
            let first = t / size * size;
            t.saturating_sub(AROUND_TEXEL).max(first)..(t + AROUND_TEXEL + 1).min(first + size)
        };
        let (mut sum, mut n) = (0.0, 0.0);
        for row in around(y) {
            for column in around(x) {
                if texels.get(row * width + column).is_some_and(|texel| texel[3] >= 128) {
                    sum += self.detail_at(column, row)[3];
                    n += 1.0;
                }
            }
        }
        if n > 0.0 { depth - sum / n } else { 0.0 }
    }

    /// Normal and depth of a texel, −1 to 1 each.
    fn detail_at(&self, x: usize, y: usize) -> [f32; 4] {
        let (texels, _) = self.detail.pixels.as_chunks::<4>();
        let texel = texels.get(y * self.detail.width as usize + x).copied().unwrap_or_default();
        texel.map(|v| f32::from(v) / 127.5 - 1.0)
    }

    /// The place of a texel of a tile in the space of the tree; depth as a share of the reach.
    fn position(&self, face: &Plane, texel: [usize; 2], depth: f32) -> Vec3 {
        let [x, y] = texel.map(|t| (t as f32 + 0.5 - self.gutter as f32) / self.inner());
        face.center
            + face.right * (face.half.x * (2.0 * x - 1.0))
            + face.up * (face.half.y * (1.0 - 2.0 * y))
            + face.normal * (face.reach * depth)
    }
}

/// The normal of a rounded crown at a place, seen from a side. It hardly looks down: what hangs low in a crown
/// sees as much sky from the side.
fn rounded(p: Vec3, side: Vec3, crown: &LeafBox) -> Vec3 {
    let out = (p - crown.center) / crown.half.max_element();
    let out = Vec3::new(out.x, HIGH * out.y + UPWARD, out.z);
    (out + TOWARD * side).try_normalize().unwrap_or(side)
}

/// Directions that planes are chosen for: around the horizon and a little above.
const AROUND: usize = 12;
const HEIGHTS: [(f32, f32); 3] = [(0.05, 1.0), (0.35, 0.6), (0.8, 0.25)];

/// The planes of a box that together face a viewer best: one after another, each the one that adds most.
fn best_planes(faces: &[Plane; PLANES]) -> [usize; PLAIN] {
    let mut views = Vec::with_capacity(AROUND * HEIGHTS.len());
    for (height, weight) in HEIGHTS {
        let level = (1.0 - height * height).max(0.0).sqrt();
        for i in 0..AROUND {
            let (sin, cos) = libm::sincosf(std::f32::consts::TAU * i as f32 / AROUND as f32);
            views.push((Vec3::new(level * cos, height, level * sin), weight));
        }
    }
    let mut chosen = [usize::MAX; PLAIN];
    let mut best = vec![0.0_f32; views.len()];
    for rank in 0..PLAIN {
        let gain = |plane: usize| -> f32 {
            let facing = |&(view, _): &(Vec3, f32)| faces[plane].normal.dot(view).abs();
            let more = |(view, &had): (&(Vec3, f32), &f32)| {
                let seen = facing(view);
                // What is seen edge-on shows as a line.
                view.1 * (seen.max(had) - had)
            };
            views.iter().zip(&best).map(more).sum()
        };
        let free = (0..PLANES).filter(|plane| !chosen[..rank].contains(plane));
        let next = free.map(|plane| (gain(plane), plane));
        let next = next.reduce(|a, b| if b.0 > a.0 + 1e-6 { b } else { a });
        chosen[rank] = next.map_or(rank, |(_, plane)| plane);
        for (had, (view, _)) in best.iter_mut().zip(&views) {
            *had = had.max(faces[chosen[rank]].normal.dot(*view).abs());
        }
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::LodError;
    use crate::impostor::cards::CardParams;
    use crate::impostor::tests::forked;
    use glam::Quat;
    use tree_core::Control;

    fn cards() -> Cards {
        let tree = forked(900);
        let params = CardParams { size: 32, samples: 2, gutter: 1 };
        let control = Control::default();
        Cards::bake(&tree.mesh, &tree.elements, &tree.boxes, &params, &control).unwrap()
    }

    #[test]
    fn planes_are_drawn_from_both_sides_with_normals_to_the_viewer() {
        let cards = cards();
        let all: Vec<u32> = (0..cards.boxes().boxes().len() as u32).collect();
        let mesh = cards.plain(&all).unwrap();
        mesh.check().unwrap();
        mesh.check_normals().unwrap();
        assert_eq!(mesh.n_triangles(), 4 * PLAIN * all.len());
        assert!(!mesh.materials[0].double_sided);
        let surface = &mesh.surfaces[0];
        // The crown's own planes: the light of a corner comes from the side that the square looks to.
        for corners in surface.indices[..12 * PLAIN / 2].as_chunks::<3>().0 {
            let [a, b, c] = corners.map(|i| surface.positions[i as usize]);
            let side = (b - a).cross(c - a).normalize();
            for i in corners {
                assert!(surface.normals[*i as usize].dot(side) > 0.3);
            }
        }
        assert!(matches!(cards.plain(&[1000]), Err(LodError::Impostor(_))));
    }

    #[test]
    fn an_upright_box_shows_its_upright_planes_first() {
        let leaf_box = LeafBox {
            parent: 0,
            level: 0,
            node: 0,
            center: Vec3::ZERO,
            half: Vec3::ONE,
            turn: Quat::IDENTITY,
            leaves: 0..0,
            own: 0..0,
            children: 0..0,
        };
        let mut upright = best_planes(&planes(&leaf_box))[..2].to_vec();
        upright.sort_unstable();
        assert_eq!(upright, [2, 3]);
    }

    #[test]
    fn light_darkens_and_colours_stay_as_they_are() {
        let cards = cards();
        let before = cards.color.clone();
        let lit = cards.lit();
        assert_eq!(cards.color, before);
        assert!(Arc::ptr_eq(&lit, &cards.lit()), "made once");
        let texels = lit.pixels.as_chunks::<4>().0.iter().zip(before.pixels.as_chunks::<4>().0);
        let (mut values, mut darker) = (std::collections::BTreeSet::new(), 0);
        for (lit, plain) in texels.filter(|(_, plain)| plain[3] >= 128) {
            assert_eq!(lit[3], plain[3]);
            values.insert(lit[1]);
            darker += usize::from(lit[1] < plain[1]);
        }
        assert!(values.len() > 10 && darker > 0, "one white leaf is as bright as another");
    }
}
