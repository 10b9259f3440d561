//! One triangle to runs of pixels.
//!
//! A pixel belongs to a triangle when its middle does. Rows and runs are half open and an edge is always
//! followed downwards, so triangles that share an edge share no pixel and leave none out.

use glam::Vec2;

/// Calls `run(row, first, end)` for each row of the picture, `width` × `height`, in which the
/// triangle covers pixels `first..end`. Corners in pixels from the top left, finite.
#[inline]
pub(super) fn runs(
    corners: [Vec2; 3],
    width: u32,
    height: u32,
    mut run: impl FnMut(u32, u32, u32),
) {
    let [mut a, mut b, mut c] = corners;
    if a.y > b.y {
        std::mem::swap(&mut a, &mut b);
    }
    if b.y > c.y {
        std::mem::swap(&mut b, &mut c);
    }
    if a.y > b.y {
        std::mem::swap(&mut a, &mut b);
    }
    let (top, bottom) = (first_middle(a.y, height), first_middle(c.y, height));
    if top >= bottom {
        return;
    }
    let long = Edge::new(a, c);
    let (upper, lower) = (Edge::new(a, b), Edge::new(b, c));
    for row in top..bottom {
        let y = row as f32 + 0.5;
        let (s, t) = (long.at(y), if y < b.y { upper.at(y) } else { lower.at(y) });
        let (left, right) = if s < t { (s, t) } else { (t, s) };
        let (first, end) = (first_middle(left, width), first_middle(right, width));
        if first < end {
            run(row, first, end);
        }
    }
}

/// The first pixel whose middle is not before `t`, at most `size`.
#[inline]
fn first_middle(t: f32, size: u32) -> u32 {
    let t = (t - 0.5).clamp(-1.0, size as f32);
    // Rounds up; the cast cuts off towards zero.
    let whole = t as i32;
    (whole + i32::from(t > whole as f32)).max(0) as u32
}

/// x along an edge that runs downwards.
#[derive(Clone, Copy)]
struct Edge {
    from: Vec2,
    slope: f32,
}

impl Edge {
    #[inline]
    fn new(from: Vec2, to: Vec2) -> Self {
        let height = to.y - from.y;
        Self { from, slope: if height > 0.0 { (to.x - from.x) / height } else { 0.0 } }
    }

    #[inline]
    fn at(self, y: f32) -> f32 {
        self.from.x + (y - self.from.y) * self.slope
    }
}
