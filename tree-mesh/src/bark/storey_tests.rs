use super::super::curve::{Drawing, Station, carry};
use super::*;
use crate::params::MeshParams;
use proptest::prelude::*;

/// An upright pole of this radius and height 1.
struct Pole {
    drawing: Drawing,
    circles: Circles,
}

impl Pole {
    fn new(radius: f32, sides: u32) -> Self {
        let params = MeshParams { min_sides: sides, max_sides: sides, ..Default::default() };
        let mut drawing = Drawing::default();
        let at = |h: f32| Station { position: Vec3::Y * h, radius, along: 0.0 };
        drawing.raw.extend([at(0.0), at(1.0)]);
        assert!(drawing.draw(&params));
        carry(&drawing.nodes, &mut drawing.frames, Vec3::X);
        Self { drawing, circles: Circles::new(&params) }
    }

    fn wall(&self) -> Wall<'_> {
        let curve = Curve {
            nodes: &self.drawing.nodes,
            slopes: &self.drawing.slopes,
            frames: &self.drawing.frames,
            fit: MeshParams::default().fit,
            pointed: false,
        };
        Wall { curve, flare: Flare::NONE, circles: &self.circles, low: 0.02, high: 0.98 }
    }

    fn divide(&self, wishes: &[Wish]) -> Storeys {
        let mut storeys = Storeys::default();
        storeys.divide(&self.wall(), wishes);
        assert_eq!(storeys.holes.len(), wishes.len(), "everyone gets a hole");
        let mut floor = 0.0;
        for (number, storey) in storeys.storeys.iter().enumerate() {
            assert!(storey.low >= floor && storey.high > storey.low, "{:?}", storeys.storeys);
            assert!(storey.high <= 0.981, "{:?}", storeys.storeys);
            floor = storey.high;
            let mut taken = 0;
            for hole in storeys.holes.iter().filter(|hole| hole.storey as usize == number) {
                let columns = columns_mask(hole.column, hole.width, storey.n_sides);
                assert_eq!(taken & columns, 0, "no column is taken twice");
                taken |= columns;
            }
            assert_eq!(taken, storey.mask);
        }
        storeys
    }
}

fn wish(lateral: u32, center: f32, radius: f32, angle: f32) -> Wish {
    let out = Vec3::new(libm::cosf(angle), 0.0, -libm::sinf(angle));
    Wish { lateral, center, reach: [radius; 2], half_width: radius, out }
}

#[test]
fn a_hole_covers_its_lateral_in_height_and_width() {
    let storeys = Pole::new(0.1, 12).divide(&[wish(7, 0.5, 0.04, 0.26)]);
    let (storey, hole) = (storeys.storeys[0], storeys.holes[0]);
    assert!(storey.low <= 0.46 && storey.high >= 0.54);
    // Sides of 30°: from -0.33 to 0.85 in angle, columns 0 and 1 cover -0.0 to 1.05.
    assert!(hole.width >= 1 && columns_mask(hole.column, hole.width, 12) & 1 == 1, "{hole:?}");
    assert_eq!((hole.lateral, storeys.n_moved), (7, 0));
}

#[test]
fn a_whorl_shares_one_storey() {
    let wishes: Vec<_> = (0..5).map(|i| wish(i, 0.5, 0.03, 1.256 * i as f32)).collect();
    let storeys = Pole::new(0.1, 16).divide(&wishes);
    assert_eq!((storeys.storeys.len(), storeys.n_moved), (1, 0));
}

#[test]
fn laterals_one_above_the_other_get_storeys_that_meet() {
    let storeys = Pole::new(0.1, 16).divide(&[wish(0, 0.4, 0.05, 0.0), wish(1, 0.46, 0.05, 0.0)]);
    assert_eq!(storeys.storeys.len(), 2);
    assert_eq!(storeys.storeys[0].high, storeys.storeys[1].low);
}

#[test]
fn ten_laterals_in_one_place_are_moved_apart() {
    let wishes: Vec<_> = (0..10).map(|i| wish(i, 0.5, 0.1, 0.0)).collect();
    let storeys = Pole::new(0.1, 3).divide(&wishes);
    assert!(storeys.n_moved >= 7, "{}", storeys.n_moved);
}

proptest! {
    #[test]
    fn any_wishes_fit_the_wall(
        mut wishes in prop::collection::vec((-0.5_f32..1.5, 0.001_f32..2.0, -4.0_f32..4.0), 0..60),
        sides in 3..40_u32,
    ) {
        wishes.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wishes: Vec<_> = wishes
            .into_iter()
            .enumerate()
            .map(|(i, (center, radius, angle))| wish(i as u32, center, radius, angle))
            .collect();
        Pole::new(0.1, sides).divide(&wishes);
    }
}
