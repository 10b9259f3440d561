//! The silhouette row by row: foot, trunk and crown.

use super::middle;
use super::parts::Mask;
use glam::Vec2;

/// How much higher a point counts, in heights of the tree, at half the tree's width from its middle: more
/// than low branches hang below the foot.
const ASIDE: f32 = 0.25;
/// The lowest share of the height: root flare and grass, of which the trunk's width is not taken.
const FLARE: f32 = 0.02;
/// The trunk is looked for in this lowest share of the height.
const LOWEST: f32 = 0.3;
/// A trunk is narrower than this share of the tree's width.
const NARROW: f32 = 0.3;
/// The crown begins where the silhouette is so many times as wide as the trunk,
const WIDER: f32 = 1.6;
/// and wider by this share of the tree's width,
const WIDER_BY: f32 = 0.03;
/// over this share of the height.
const OVER: f32 = 0.02;
/// Breast height in metres, and how far from it the trunk's width is still taken.
const BREAST: (f32, f32) = (1.3, 0.5);

/// What the rows of a tree's mask say, in cells.
pub(super) struct Profile {
    /// The lowest row of the trunk.
    pub(super) base_row: usize,
    /// The middle of the trunk's foot.
    pub(super) base_column: f32,
    pub(super) top: Vec2,
    /// The crown is above this row; the row below the base when there is no bare trunk.
    pub(super) crown_base: usize,
    pub(super) trunk_width: Option<f32>,
    /// Top left and bottom right of the crown.
    pub(super) crown: (Vec2, Vec2),
}

/// Column and row of the lowest point near the middle.
pub(super) fn foot(tree: &Mask) -> (usize, usize) {
    let reach = reaches(tree);
    let (top, bottom) = rows(&reach);
    let height = (bottom + 1 - top) as f32;
    let low = reach.iter().flatten().map(|r| r.0).min().unwrap_or(0);
    let width = reach.iter().flatten().map(|r| r.1).max().unwrap_or(1).max(low + 1) - low;
    let middle = middle_column(tree);
    let mut best = (f32::MIN, (0, bottom));
    for x in 0..tree.nx {
        let lowest = (0..tree.ny).rev().find(|&y| tree.covered[y * tree.nx + x]);
        let Some(y) = lowest else { continue };
        let aside = 2.0 * (x as f32 + 0.5 - middle) / width as f32;
        let score = y as f32 - ASIDE * height * aside * aside;
        if score > best.0 {
            best = (score, (x, y));
        }
    }
    best.1
}

impl Profile {
    /// Of a tree with its foot at this column and row, `height` metres high.
    pub(super) fn new(tree: &Mask, foot: (usize, usize), height: f32) -> Self {
        let reach = reaches(tree);
        let (top_row, _) = rows(&reach);
        let base_row = foot.1;
        let n_rows = base_row + 1 - top_row.min(base_row);
        let share = |share: f32| (share * n_rows as f32).ceil() as usize;
        let width = |y: usize| reach[y].map_or(0.0, |(left, right)| (right - left) as f32);
        let smooth = |y: usize| {
            let near: Vec<f32> =
                (y.saturating_sub(2)..(y + 3).min(base_row + 1)).map(width).collect();
            middle(&near)
        };
        let full = (top_row..=base_row).map(width).fold(1.0, f32::max);
        // The narrowest row above the flare; of equals the lowest.
        let lowest = base_row.saturating_sub(share(FLARE));
        let first = base_row.saturating_sub(share(LOWEST)).max(top_row);
        let narrow = (first..=lowest.max(first))
            .rev()
            .map(|y| (smooth(y), y))
            .reduce(|a, b| if b.0 < a.0 { b } else { a })
            .unwrap_or((full, base_row));
        let bare = narrow.0 > 0.0 && narrow.0 < NARROW * full;
        let crown_base = if bare {
            let limit = (WIDER * narrow.0).max(narrow.0 + WIDER_BY * full);
            let over = share(OVER).max(1);
            let wide = |y: usize| (y.saturating_sub(over - 1)..=y).all(|y| width(y) > limit);
            (top_row..=narrow.1).rev().find(|&y| wide(y)).map_or(top_row, |y| y + 1)
        } else {
            base_row + 1
        };
        let trunk = bare.then(|| trunk(tree, crown_base, lowest, base_row, n_rows, height));
        let base_column = trunk.map_or_else(|| run_near(tree, foot), |(_, column)| column);
        Self {
            base_row: trunk
                .map_or(base_row, |(width, column)| bottom_under(tree, column, width, base_row)),
            base_column,
            top: top_of(tree, top_row),
            crown_base,
            trunk_width: trunk.map(|(width, _)| width),
            crown: crown(&reach, top_row, crown_base),
        }
    }
}

/// First column covered in each row, and the one after the last.
fn reaches(tree: &Mask) -> Vec<Option<(usize, usize)>> {
    (0..tree.ny)
        .map(|y| {
            let row = tree.row(y);
            let left = row.iter().position(|&covered| covered)?;
            let after = row.iter().rposition(|&covered| covered).map_or(left, |last| last) + 1;
            Some((left, after))
        })
        .collect()
}

/// First and last covered row.
fn rows(reach: &[Option<(usize, usize)>]) -> (usize, usize) {
    let top = reach.iter().position(Option::is_some).unwrap_or(0);
    (top, reach.iter().rposition(Option::is_some).unwrap_or(0))
}

/// The column with half of the tree on either side.
fn middle_column(tree: &Mask) -> f32 {
    let mut columns = vec![0.0_f64; tree.nx];
    for row in tree.alpha.chunks_exact(tree.nx) {
        columns.iter_mut().zip(row).for_each(|(sum, &alpha)| *sum += f64::from(alpha));
    }
    let half = 0.5 * columns.iter().sum::<f64>();
    let mut sum = 0.0;
    let passed = columns.iter().take_while(|&&column| {
        sum += column;
        sum < half
    });
    passed.count() as f32 + 0.5
}

/// Width of the bare trunk at about breast height, and the column of its middle at its lowest rows.
fn trunk(
    tree: &Mask,
    crown_base: usize,
    lowest: usize,
    base_row: usize,
    n_rows: usize,
    height: f32,
) -> (f32, f32) {
    let metres = height / n_rows as f32;
    // Mass and middle of a row: the row holds nothing but trunk.
    let measure = |y: usize| {
        let row = &tree.alpha[y * tree.nx..(y + 1) * tree.nx];
        let mass: f32 = row.iter().sum();
        let moment: f32 = row.iter().enumerate().map(|(x, a)| (x as f32 + 0.5) * a).sum();
        (mass, moment / mass.max(1e-6))
    };
    let bare: Vec<usize> = (crown_base.min(lowest)..=lowest).collect();
    let above = |y: usize| (base_row - y.min(base_row)) as f32 * metres;
    let breast: Vec<usize> =
        bare.iter().copied().filter(|&y| (above(y) - BREAST.0).abs() <= BREAST.1).collect();
    let at = if breast.is_empty() { &bare } else { &breast };
    let width = middle(&at.iter().map(|&y| measure(y).0).collect::<Vec<_>>());
    let n_low = ((OVER * 2.0 * n_rows as f32) as usize).max(1);
    let low: Vec<f32> = bare.iter().rev().take(n_low).map(|&y| measure(y).1).collect();
    (width, middle(&low))
}

/// The lowest row covered under the trunk.
fn bottom_under(tree: &Mask, column: f32, width: f32, base_row: usize) -> usize {
    let first = (column - 0.5 * width).floor().clamp(0.0, tree.nx as f32 - 1.0) as usize;
    let last = (column + 0.5 * width).ceil().clamp(first as f32 + 1.0, tree.nx as f32) as usize;
    let under = |y: &usize| tree.row(*y)[first..last].iter().any(|&covered| covered);
    (0..tree.ny).rev().find(under).unwrap_or(base_row)
}

/// The middle of the covered run that holds the foot.
fn run_near(tree: &Mask, (column, row): (usize, usize)) -> f32 {
    let row = tree.row(row);
    let left = row[..column].iter().rev().take_while(|&&covered| covered).count();
    let right = row[column..].iter().take_while(|&&covered| covered).count();
    0.5 * ((column - left) as f32 + (column + right.max(1)) as f32)
}

fn top_of(tree: &Mask, row: usize) -> Vec2 {
    let columns: Vec<f32> =
        (0..tree.nx).filter(|&x| tree.row(row)[x]).map(|x| x as f32 + 0.5).collect();
    Vec2::new(middle(&columns), row as f32)
}

fn crown(reach: &[Option<(usize, usize)>], top: usize, end: usize) -> (Vec2, Vec2) {
    let end = end.clamp(top + 1, reach.len().max(top + 1));
    let rows = reach.get(top..end).unwrap_or(&[]).iter().flatten();
    let (left, right) =
        rows.fold((usize::MAX, 0), |(left, right), row| (left.min(row.0), right.max(row.1)));
    (Vec2::new(left.min(right) as f32, top as f32), Vec2::new(right as f32, end as f32))
}
