//! One-way analysis of variance of two groups, and the critical value of F (§7.2.4 asks whether the
//! mean differs between two views).

/// Terms of the continued fraction; it converges in about √(a + b) of them.
const TERMS: u32 = 500;
/// Halvings of the interval in which the critical value is sought.
const HALVINGS: u32 = 200;

/// F and its degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Anova {
    /// Variance between the groups over that within them; infinite when groups differ and nothing
    /// varies within them, 0 when nothing varies at all.
    pub(super) f: f64,
    /// Values less 2; between the groups there is 1.
    pub(super) within: u32,
}

/// F of two groups of at least one value each, three in all. `None` for less, or values that are not finite.
pub(super) fn anova(a: &[f64], b: &[f64]) -> Option<Anova> {
    let n = a.len() + b.len();
    if a.is_empty() || b.is_empty() || n < 3 || !a.iter().chain(b).all(|x| x.is_finite()) {
        return None;
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let all = (a.iter().sum::<f64>() + b.iter().sum::<f64>()) / n as f64;
    let between: f64 =
        [a, b].iter().map(|g| g.len() as f64 * (mean(g) - all) * (mean(g) - all)).sum();
    let inner = |g: &[f64]| g.iter().map(|x| (x - mean(g)) * (x - mean(g))).sum::<f64>();
    let within = (n - 2) as u32;
    let noise = (inner(a) + inner(b)) / f64::from(within);
    // A ratio of nothing to nothing is no difference.
    let f = if between == 0.0 { 0.0 } else { between / noise };
    Some(Anova { f, within })
}

/// The F that chance exceeds with probability `alpha` (0 to 1, ends excluded).
pub(super) fn critical(alpha: f64, between: u32, within: u32) -> f64 {
    let (mut low, mut high) = (0.0, 1e9);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if exceedance(middle, between, within) > alpha { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Probability that F is larger than `f` by chance.
pub(super) fn exceedance(f: f64, between: u32, within: u32) -> f64 {
    let (between, within) = (f64::from(between), f64::from(within));
    incomplete_beta(0.5 * within, 0.5 * between, within / (within + between * f.max(0.0)))
}

/// The regularised incomplete beta function Iₓ(a, b), by its continued fraction (DLMF 8.17.22).
fn incomplete_beta(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return x.clamp(0.0, 1.0);
    }
    // The fraction converges fast below its mean only.
    if x > (a + 1.0) / (a + b + 2.0) {
        return 1.0 - incomplete_beta(b, a, 1.0 - x);
    }
    let log = libm::lgamma(a + b) - libm::lgamma(a) - libm::lgamma(b)
        + a * libm::log(x)
        + b * libm::log(1.0 - x);
    libm::exp(log) * fraction(a, b, x) / a
}

/// 1 / (1 + d₁ / (1 + d₂ / (1 + …))), from the far end.
fn fraction(a: f64, b: f64, x: f64) -> f64 {
    let mut value = 1.0;
    for i in (1..=TERMS).rev() {
        let m = f64::from(i / 2);
        let d = if i % 2 == 0 {
            m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
        } else {
            -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0))
        };
        value = 1.0 + d / value;
    }
    1.0 / value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn critical_values_are_those_of_the_tables() {
        for (alpha, between, within, table) in [
            (0.05, 1, 36, 4.113), // the thesis's, 4.11
            (0.05, 1, 10, 4.965),
            (0.05, 1, 1, 161.448),
            (0.01, 1, 30, 7.562),
            (0.05, 3, 20, 3.098),
            (0.05, 1, 1000, 3.851),
        ] {
            let found = critical(alpha, between, within);
            assert!((found - table).abs() < 6e-4 * table, "F({between}, {within}) is {found}");
        }
    }

    #[test]
    fn f_of_two_groups_is_the_square_of_their_t() {
        // Means 2 and 4, variances 1 and 1: t² = 4 / (1/3 + 1/3).
        let found = anova(&[1.0, 2.0, 3.0], &[3.0, 4.0, 5.0]).unwrap();
        assert!((found.f - 6.0).abs() < 1e-12 && found.within == 4, "{found:?}");
    }

    #[test]
    fn equal_groups_do_not_differ_and_steady_ones_differ_for_certain() {
        assert_eq!(anova(&[2.0, 2.0], &[2.0, 2.0]).unwrap().f, 0.0);
        assert_eq!(anova(&[2.0, 2.0], &[3.0, 3.0]).unwrap().f, f64::INFINITY);
        assert_eq!(anova(&[2.0], &[3.0]), None);
        assert_eq!(anova(&[2.0, f64::NAN], &[3.0]), None);
    }
}
