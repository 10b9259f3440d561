//! Triangles to a tile.

use crate::preview::{Band, Draw, Part, Projector, Scene, Spot};
use glam::{Vec2, Vec3};

/// Marks a sample that sees nothing.
const NOTHING: u32 = u32::MAX;

/// The rectangle that is drawn, seen from `toward` in parallel projection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Window {
    /// Middle of the rectangle; depth is 0 here.
    pub(crate) center: Vec3,
    /// Unit vectors: to the right, up, and to the viewer.
    pub(crate) right: Vec3,
    pub(crate) up: Vec3,
    pub(crate) toward: Vec3,
    /// Half width and half height in metres, more than 0.
    pub(crate) half: Vec2,
}

/// A small image, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tile {
    pub(crate) side: u32,
    /// Covered share of each texel, 0 to 1.
    pub(crate) alpha: Vec<f32>,
    /// Linear colour without light; means nothing where alpha is 0.
    pub(crate) color: Vec<Vec3>,
    /// In the space of the tree, not of unit length where several surfaces share a texel.
    pub(crate) normal: Vec<Vec3>,
    /// Towards the viewer from the middle of the window, in metres.
    pub(crate) depth: Vec<f32>,
}

/// Sample buffers, kept between tiles.
#[derive(Debug, Default)]
pub(crate) struct Samples {
    depth: Vec<f32>,
    ids: Vec<u32>,
    spots: Vec<Spot>,
}

impl Window {
    /// Samples per metre to the right and up.
    fn scale(&self, side: u32) -> Vec2 {
        0.5 * side as f32 / self.half
    }

    /// The two directions of the picture may have different scales: they are part of the projector's
    /// axes, whose own scale is 1.
    fn projector(&self, side: u32) -> Projector {
        let scale = self.scale(side);
        Projector {
            eye: self.center,
            right: self.right * scale.x,
            up: self.up * scale.y,
            forward: -self.toward,
            scale: 1.0,
            center: Vec2::splat(0.5 * side as f32),
            near: f32::NEG_INFINITY,
            perspective: false,
            width: side,
            height: side,
        }
    }
}

/// Draws a part of the scene into a tile of `side`² texels, `samples`² samples each.
///
/// # Complexity
/// O(triangles + samples of all texels).
pub(crate) fn bake(
    scene: &Scene<'_>,
    part: &Part,
    window: &Window,
    side: u32,
    samples: u32,
    buffers: &mut Samples,
) -> Tile {
    let across = side * samples;
    let n = across as usize * across as usize;
    buffers.depth.clear();
    buffers.depth.resize(n, f32::NEG_INFINITY);
    buffers.ids.clear();
    buffers.ids.resize(n, NOTHING);
    let projector = window.projector(across);
    let mut band =
        Band { top: 0, width: across as i32, depth: &mut buffers.depth, ids: &mut buffers.ids };
    Draw { scene, projector: &projector, spots: &[] }.draw_part(
        part,
        &mut buffers.spots,
        &mut band,
    );
    let n_texels = side as usize * side as usize;
    let mut tile = Tile {
        side,
        alpha: vec![0.0; n_texels],
        color: vec![Vec3::ZERO; n_texels],
        normal: vec![Vec3::ZERO; n_texels],
        depth: vec![0.0; n_texels],
    };
    let mut seen = Vec::new();
    for texel in 0..n_texels {
        let at = [texel % side as usize, texel / side as usize].map(|t| t as u32);
        gather(buffers, at, across, samples, &mut seen);
        shade(scene, window, [across, samples], &seen, texel, &mut tile);
    }
    tile
}

/// What a texel sees of one triangle.
struct Seen {
    id: u32,
    count: u32,
    /// Sum of the places of its samples.
    at: [u32; 2],
    /// Sum of their depths.
    depth: f32,
}

fn gather(buffers: &Samples, [x, y]: [u32; 2], across: u32, samples: u32, seen: &mut Vec<Seen>) {
    seen.clear();
    for row in y * samples..(y + 1) * samples {
        for column in x * samples..(x + 1) * samples {
            let sample = row as usize * across as usize + column as usize;
            let id = buffers.ids[sample];
            if id == NOTHING {
                continue;
            }
            let depth = buffers.depth[sample];
            match seen.iter_mut().find(|entry| entry.id == id) {
                Some(entry) => {
                    entry.count += 1;
                    entry.at = [entry.at[0] + column, entry.at[1] + row];
                    entry.depth += depth;
                }
                None => seen.push(Seen { id, count: 1, at: [column, row], depth }),
            }
        }
    }
}

/// Each triangle is shaded once, in the middle of its samples.
fn shade(
    scene: &Scene<'_>,
    window: &Window,
    [across, samples]: [u32; 2],
    seen: &[Seen],
    texel: usize,
    tile: &mut Tile,
) {
    let total: u32 = seen.iter().map(|entry| entry.count).sum();
    if total == 0 {
        return;
    }
    let per_texel = samples * samples;
    let scale = window.scale(across);
    let middle = 0.5 * across as f32;
    let (mut color, mut normal, mut depth) = (Vec3::ZERO, Vec3::ZERO, 0.0);
    for entry in seen {
        let n = entry.count as f32;
        let x = (entry.at[0] as f32 / n + 0.5 - middle) / scale.x;
        let y = (middle - entry.at[1] as f32 / n - 0.5) / scale.y;
        let origin = window.center + window.right * x + window.up * y;
        let one_scale = (scale.x * scale.y).sqrt();
        let ray = (origin, -window.toward);
        let hit = scene.hit(entry.id, ray, false, one_scale, 1.0 / per_texel as f32);
        color += hit.albedo.min(Vec3::ONE) * n;
        normal += hit.normal * n;
        depth += entry.depth;
    }
    let n = total as f32;
    tile.alpha[texel] = n / per_texel as f32;
    tile.color[texel] = color / n;
    tile.normal[texel] = normal / n;
    tile.depth[texel] = depth / n;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impostor::tests::{card, mesh_of};
    use tree_core::Control;

    const FRONT: Window = Window {
        center: Vec3::ZERO,
        right: Vec3::X,
        up: Vec3::Y,
        toward: Vec3::Z,
        half: Vec2::new(2.0, 1.0),
    };

    fn baked(cards: &[(Vec3, f32)]) -> Tile {
        let mesh = mesh_of(cards.iter().map(|&(at, size)| card(at, size)));
        let scene = Scene::new(&mesh, true, &Control::default()).unwrap();
        let all = Part::new(&scene, 0..scene.n_triangles());
        bake(&scene, &all, &FRONT, 16, 4, &mut Samples::default())
    }

    #[test]
    fn a_card_stands_where_it_is_in_a_window_of_two_scales() {
        // A metre is 4 texels across and 8 up.
        let tile = baked(&[(Vec3::new(1.0, 0.5, 0.3), 0.5)]);
        let covered = |x: u32, y: u32| tile.alpha[(y * 16 + x) as usize];
        assert_eq!(
            (covered(12, 4), covered(11, 2), covered(3, 4), covered(12, 11)),
            (1.0, 1.0, 0.0, 0.0)
        );
        let area: f32 = tile.alpha.iter().sum();
        assert!((area - 32.0).abs() < 1e-3, "{area}");
        assert!((tile.depth[4 * 16 + 12] - 0.3).abs() < 1e-5);
        assert_eq!(tile.normal[4 * 16 + 12], Vec3::Z);
    }

    #[test]
    fn the_nearer_card_is_seen() {
        let tile = baked(&[(Vec3::new(0.0, 0.0, -0.3), 1.0), (Vec3::new(0.0, 0.0, 0.2), 1.0)]);
        assert!((tile.depth[8 * 16 + 8] - 0.2).abs() < 1e-5);
    }
}
