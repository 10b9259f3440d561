//! Planes for programs without shaders of ours: light in the picture, and normals of a crown.

use super::{Cards, PLANES, Plane, mesh, planes};
use crate::error::Result;
use crate::impostor::boxes::LeafBox;
use crate::preview::Srgb;
use glam::{Vec2, Vec3};
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};
use tree_mesh::{Mesh, Surface, Texture};

/// Planes that are drawn of each box: all six at once would cover too much.
pub const PLAIN: usize = 3;
/// Light on a place that sees half the sky: pictures are as bright, on average, as the leaves they show.
const EXPOSURE: f32 = 1.0;
/// Light from straight below, where that from straight above is 1.
const BELOW: f32 = 0.55;
/// Part of a normal that looks to the viewer, against the part that looks out of the crown.
const TOWARD: f32 = 0.9;

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
        let light = self.crown.light();
        let mut pixels = self.color.pixels.clone();
        let width = self.color.width as usize;
        let stride = 4 * width * self.size as usize;
        let (detail, _) = self.detail.pixels.as_chunks::<4>();
        // A row of tiles at a time.
        pixels.par_chunks_mut(stride).enumerate().for_each(|(row, rows)| {
            for column in 0..self.columns as usize {
                let tile = row * self.columns as usize + column;
                let Ok(leaf_box) = self.boxes.get((tile / PLANES) as u32) else { return };
                let face = planes(leaf_box)[tile % PLANES];
                for i in 0..(self.size * self.size) as usize {
                    let (x, y) = (i % self.size as usize, i / self.size as usize);
                    let at = y * width + column * self.size as usize + x;
                    let Some(texel) = rows.get_mut(4 * at..4 * at + 3) else { continue };
                    let found = detail.get(row * self.size as usize * width + at);
                    let [_, ny, _, depth] =
                        found.copied().unwrap_or_default().map(|v| f32::from(v) / 127.5 - 1.0);
                    let p = self.position(&face, [x, y], depth);
                    let soft = BELOW + (1.0 - BELOW) * (0.5 + 0.5 * ny);
                    let shine = EXPOSURE * light.at(p) * soft;
                    for byte in texel {
                        let linear = srgb.decode([*byte; 4]).x;
                        *byte = srgb.encode((linear * shine).min(1.0));
                    }
                }
            }
        });
        let (width, height) = (self.color.width, self.color.height);
        Texture { name: "cards".into(), width, height, pixels }
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

/// The normal of a rounded crown at a place, seen from a side.
fn rounded(p: Vec3, side: Vec3, crown: &LeafBox) -> Vec3 {
    let half = crown.half.max_element();
    let out = (p - crown.center) / half;
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
