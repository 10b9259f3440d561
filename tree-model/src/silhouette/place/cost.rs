//! The cost of an arrangement (section 5.4, equations 1 to 4), and how it changes when one branch moves.
//!
//! Between two branches f = 1 / (1 + α d) with d = √(Δũ² + Δθ̃²) on the cyclic unit square, and the distance from
//! the nearest privileged position, `d_pattern` = min(`d_ang`, γ − `d_ang`) / γ with `d_ang` = (Δθ − `d_node` φ) mod γ.
//!
//! `d_node` is a difference of node numbers, so θ less its node's part of the turn, by γ, is a number of each branch
//! alone: its phase. `d_pattern` is then the distance of two phases on a circle of length 1, which is as short to reckon as
//! Δθ̃, and `d_node` never sees the cyclic Δũ: a stem's last node is not next to its first.
//!
//! Columns of f32 and sums in eight lanes, in a fixed order: the same bits on every platform. A row costs O(N), about a
//! nanosecond for each other branch; no matrix is kept, only the sum of each row.

/// Sums run side by side, for the compiler to use vector registers.
const LANES: usize = 8;

/// Adding and taking away 1.5 · 2²³ rounds an f32 below 2²² to a whole number; `f32::round` is a call that vectors cannot
/// make without SSE 4.
const ROUND: f32 = 12_582_912.0;

/// The nearest distance on a circle of length 1, signed.
#[inline(always)]
fn round_off(x: f32) -> f32 {
    x - ((x + ROUND) - ROUND)
}

/// A branch as the cost sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Spot {
    /// Share of the parent's length.
    pub(super) along: f32,
    /// Azimuth in turns, 0 to 1.
    pub(super) turn: f32,
    /// Phase in the pattern, 0 to 1: azimuth less what its node is turned, by γ.
    pub(super) phase: f32,
}

/// Weights of the cost.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weights {
    /// α: how quickly closeness stops to matter.
    pub(super) reach: f32,
    /// w1.
    pub(super) closeness: f32,
    /// w2.
    pub(super) pattern: f32,
    /// Weight of the distance from phase 0, for arrangements with a fixed plane.
    pub(super) fixed: f32,
}

/// All branches in columns, with what each adds to the cost.
pub(super) struct Columns {
    weights: Weights,
    along: Vec<f32>,
    turn: Vec<f32>,
    phase: Vec<f32>,
    /// 1 for a branch, 0 for padding and for the branch whose row is summed.
    counts: Vec<f32>,
    /// Sum of each branch's row.
    rows: Vec<f32>,
    /// F.
    total: f64,
}

impl Columns {
    /// O(N²), once.
    pub(super) fn new(spots: &[Spot], weights: Weights) -> Self {
        let padded = spots.len().next_multiple_of(LANES);
        let column = |value: fn(&Spot) -> f32| {
            let mut column: Vec<f32> = spots.iter().map(value).collect();
            column.resize(padded, 0.0);
            column
        };
        let mut columns = Self {
            weights,
            along: column(|s| s.along),
            turn: column(|s| s.turn),
            phase: column(|s| s.phase),
            counts: column(|_| 1.0),
            rows: Vec::new(),
            total: 0.0,
        };
        columns.rows = (0..spots.len()).map(|i| columns.row(i, spots[i])).collect();
        let alone = |spot: &Spot| f64::from(columns.alone(*spot));
        let rows: f64 = columns.rows.iter().map(|&row| f64::from(row)).sum();
        // Pairs are in two rows, what a branch costs alone is in one.
        columns.total = 0.5 * (rows + spots.iter().map(alone).sum::<f64>());
        columns
    }

    pub(super) fn total(&self) -> f64 {
        self.total
    }

    /// What branch `i` costs where it is. O(1).
    pub(super) fn here(&self, i: usize) -> f32 {
        self.rows[i]
    }

    /// What branch `i` would cost at a spot. O(N).
    pub(super) fn row(&mut self, i: usize, spot: Spot) -> f32 {
        self.counts[i] = 0.0;
        let mut sums = [0.0_f32; LANES];
        let columns = self.along.chunks_exact(LANES).zip(self.turn.chunks_exact(LANES));
        let others = self.phase.chunks_exact(LANES).zip(self.counts.chunks_exact(LANES));
        for ((along, turn), (phase, counts)) in columns.zip(others) {
            for lane in 0..LANES {
                let other = Spot { along: along[lane], turn: turn[lane], phase: phase[lane] };
                sums[lane] += counts[lane] * pair(self.weights, spot, other);
            }
        }
        self.counts[i] = 1.0;
        sums.iter().sum::<f32>() + self.alone(spot)
    }

    /// Moves branch `i`, whose row is `row` there, and brings the other rows up to date. O(N).
    pub(super) fn replace(&mut self, i: usize, spot: Spot, row: f32) {
        let old = Spot { along: self.along[i], turn: self.turn[i], phase: self.phase[i] };
        self.total += f64::from(row) - f64::from(self.rows[i]);
        for (j, sum) in self.rows.iter_mut().enumerate() {
            let other = Spot { along: self.along[j], turn: self.turn[j], phase: self.phase[j] };
            *sum += pair(self.weights, spot, other) - pair(self.weights, old, other);
        }
        (self.along[i], self.turn[i], self.phase[i]) = (spot.along, spot.turn, spot.phase);
        self.rows[i] = row;
    }

    /// What a branch costs without any other.
    fn alone(&self, spot: Spot) -> f32 {
        self.weights.fixed * round_off(spot.phase).abs()
    }
}

/// g of two branches.
#[inline(always)]
fn pair(weights: Weights, a: Spot, b: Spot) -> f32 {
    let (along, turn) = (round_off(a.along - b.along), round_off(a.turn - b.turn));
    let distance = (along * along + turn * turn).sqrt();
    weights.closeness / (1.0 + weights.reach * distance)
        + weights.pattern * round_off(a.phase - b.phase).abs()
}
