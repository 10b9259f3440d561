//! Sketches and branches drawn on paper, and views of a mesh that line up with them.

use image::{Rgba, RgbaImage};
use std::error::Error;
use tree_core::glam::{Vec2, Vec3};
use tree_lod::preview::{Camera, Lens, Picture, Pose, View};
use tree_mesh::Mesh;
use tree_model::sketch::clean::Cleaned;
use tree_model::sketch::crown::Crown;
use tree_model::sketch::{Branches, Drawing, Role};

/// What is left free around a tree, a share of its size.
const MARGIN: f32 = 0.04;

/// Blue-black ink, as drawn.
pub(crate) const INK: [u8; 3] = [30, 34, 60];
/// The trunk, branches and the crown.
const TRUNK: [u8; 3] = [150, 75, 30];
const BRANCH: [u8; 3] = [205, 120, 40];
const CROWN: [u8; 3] = [60, 150, 70];
/// The joined tree, and its forks and base.
const TREE: [u8; 3] = [190, 30, 40];
/// Faint: what others are drawn over.
const FAINT: [u8; 3] = [205, 205, 212];
/// Branches by their order.
const ORDERS: [[u8; 3]; 4] = [[110, 60, 30], [200, 90, 30], [60, 130, 190], [110, 170, 90]];
/// What grew.
const GROWN: [u8; 3] = [90, 150, 90];

/// Where the eye stands.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Side {
    /// As drawn: on +Z.
    Front,
    /// On +X.
    Right,
}

impl Side {
    /// A point in space on the paper: right and up.
    pub(crate) fn seen(self, point: Vec3) -> Vec2 {
        match self {
            Self::Front => Vec2::new(point.x, point.y),
            Self::Right => Vec2::new(-point.z, point.y),
        }
    }
}

/// A window on the plane of a view: what a picture shows.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    side: Side,
    /// In metres.
    low: Vec2,
    /// Pixels for a metre.
    scale: f32,
    pub(crate) width: u32,
    pub(crate) height: u32,
}

impl Frame {
    /// A frame of about `px` pixels along its longer side round the drawing and the tree.
    pub(crate) fn around(
        side: Side,
        cleaned: &Cleaned,
        drawing: &Drawing,
        mesh: &Mesh,
        px: u32,
    ) -> Self {
        let (mut low, mut high) = (Vec2::ZERO, Vec2::ZERO);
        let mut show = |point: Vec2| (low, high) = (low.min(point), high.max(point));
        let bounds = mesh.bounds();
        [bounds.min, bounds.max].into_iter().for_each(|corner| show(side.seen(corner)));
        for stroke in &drawing.strokes {
            for &point in stroke.points.iter().filter(|point| point.is_finite()) {
                let point = cleaned.plan.from_drawing(point);
                // From the side all of the drawing is one upright line.
                show(if side == Side::Front { point } else { point * Vec2::Y });
            }
        }
        Self::of(side, low, high, px)
    }

    /// A frame of about `px` pixels along its longer side round what lies between two corners, in metres.
    pub(crate) fn of(side: Side, low: Vec2, high: Vec2, px: u32) -> Self {
        let margin = MARGIN * (high - low).max_element();
        let (low, high) = (low - margin, high + margin);
        let scale = px as f32 / (high - low).max_element();
        let size = (scale * (high - low)).ceil().max(Vec2::ONE);
        Self { side, low, scale, width: size.x as u32, height: size.y as u32 }
    }

    fn pixel(&self, point: Vec2) -> Vec2 {
        let at = self.scale * (point - self.low);
        Vec2::new(at.x, self.height as f32 - at.y)
    }

    /// The view of a mesh that lines up.
    pub(crate) fn view(&self) -> View {
        let size = Vec2::new(self.width as f32, self.height as f32) / self.scale;
        let center = self.low + 0.5 * size;
        let far = 10.0 * size.max_element();
        let (target, away) = match self.side {
            Side::Front => (Vec3::new(center.x, center.y, 0.0), Vec3::Z),
            Side::Right => (Vec3::new(0.0, center.y, -center.x), Vec3::X),
        };
        let lens = Lens::Orthographic { height: size.y };
        let pose = Pose { eye: target + far * away, target, up: Vec3::Y, lens };
        View { width: self.width, height: self.height, samples: 3, camera: Camera::Placed(pose) }
    }
}

/// A sheet of white paper that shows a frame.
pub(crate) struct Paper {
    frame: Frame,
    image: RgbaImage,
}

impl Paper {
    pub(crate) fn new(frame: Frame) -> Self {
        let image = RgbaImage::from_pixel(frame.width, frame.height, Rgba([255; 4]));
        Self { frame, image }
    }

    /// Draws a line through points in metres, `width` pixels wide.
    pub(crate) fn line(&mut self, points: &[Vec2], width: f32, ink: [u8; 3]) {
        let dot = [points.first().copied(); 2];
        if let (1, [Some(a), Some(b)]) = (points.len(), dot) {
            self.segment(a, b, width, ink);
        }
        for pair in points.windows(2) {
            self.segment(pair[0], pair[1], width, ink);
        }
    }

    fn segment(&mut self, a: Vec2, b: Vec2, width: f32, ink: [u8; 3]) {
        let (a, b) = (self.frame.pixel(a), self.frame.pixel(b));
        let reach = 0.5 * width + 1.0;
        let most = Vec2::new(self.frame.width as f32 - 1.0, self.frame.height as f32 - 1.0);
        let low = (a.min(b) - reach).clamp(Vec2::ZERO, most).as_uvec2();
        let high = (a.max(b) + reach).clamp(Vec2::ZERO, most).as_uvec2();
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                let p = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
                let along = b - a;
                let share =
                    ((p - a).dot(along) / along.length_squared().max(1e-12)).clamp(0.0, 1.0);
                let cover = (0.5 * width + 0.5 - p.distance(a + share * along)).clamp(0.0, 1.0);
                let pixel = self.image.get_pixel_mut(x, y);
                for (old, new) in pixel.0.iter_mut().zip(ink) {
                    *old = (f32::from(*old) + cover * (f32::from(new) - f32::from(*old))) as u8;
                }
            }
        }
    }

    /// The drawing as it came, in one colour.
    pub(crate) fn drawing(
        &mut self,
        drawing: &Drawing,
        cleaned: &Cleaned,
        width: f32,
        ink: [u8; 3],
    ) {
        for stroke in &drawing.strokes {
            let good = stroke.points.iter().filter(|point| point.is_finite());
            let mut line: Vec<Vec2> = good.map(|&p| cleaned.plan.from_drawing(p)).collect();
            if stroke.closed {
                line.extend(line.first().copied());
            }
            self.line(&line, width, ink);
        }
    }

    /// The drawing, faint, what clean-up made of it over that: the crown's lines, the joined tree, its forks and base.
    pub(crate) fn cleaned(&mut self, drawing: &Drawing, cleaned: &Cleaned, crown: Option<&Crown>) {
        self.drawing(drawing, cleaned, 5.0, FAINT);
        for line in &cleaned.crown {
            self.line(line, 2.0, CROWN);
        }
        for polygon in crown.map_or(&[][..], Crown::polygons) {
            let closed: Vec<Vec2> = polygon.iter().chain(polygon.first()).copied().collect();
            self.line(&closed, 1.0, [20, 90, 30]);
        }
        let (positions, parents) = (cleaned.plan.positions(), cleaned.plan.parents());
        let mut fan = vec![0_u32; positions.len()];
        for (node, &parent) in parents.iter().enumerate().skip(1) {
            fan[parent as usize] += 1;
            let stroke = cleaned.plan.strokes()[node] as usize;
            let trunk = drawing.strokes.get(stroke).is_some_and(|s| s.role == Some(Role::Trunk));
            let ink = if trunk { TRUNK } else { BRANCH };
            self.line(&[positions[parent as usize], positions[node]], 2.0, ink);
        }
        for (&position, _) in positions.iter().zip(&fan).filter(|(_, fan)| **fan > 1) {
            self.line(&[position], 5.0, TREE);
        }
        self.line(&[positions[0]], 9.0, TREE);
    }

    /// Segments, coloured by order; from the `n_drawn`-th on they grew.
    pub(crate) fn branches(&mut self, branches: &Branches, n_drawn: usize) {
        let orders = branches.orders();
        let skipped = usize::from(branches.has_imagined_root());
        for segment in (skipped..branches.len()).rev() {
            let line: Vec<Vec2> =
                branches.points(segment).iter().map(|&p| self.frame.side.seen(p)).collect();
            if segment >= n_drawn {
                self.line(&line, 1.0, GROWN);
            } else {
                self.line(&line, 2.5, ORDERS[(orders[segment] as usize).min(ORDERS.len() - 1)]);
                self.line(&line[line.len() - 1..], 5.0, INK);
            }
        }
    }

    pub(crate) fn picture(self) -> Picture {
        Picture {
            width: self.frame.width,
            height: self.frame.height,
            pixels: self.image.into_raw(),
        }
    }
}

/// The drawings of a file by its extension: one of an SVG or JSON file, one a line of NDJSON.
pub(crate) fn read_drawings(
    path: &std::path::Path,
    text: &str,
) -> Result<Vec<Drawing>, Box<dyn Error>> {
    use tree_model::sketch::read;
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    Ok(match extension.as_deref() {
        Some("svg") => vec![read::from_svg(text)?],
        Some("json") => vec![read::from_json(text)?],
        Some("ndjson") => read::from_ndjson(text)?,
        _ => return Err(format!("{}: .svg, .json or .ndjson is wanted", path.display()).into()),
    })
}
