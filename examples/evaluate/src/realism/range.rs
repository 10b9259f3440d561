//! The range of measured trees, and rows that hold trees of ours against it.
//!
//! A range goes from the least to the largest figure of the measured trees, both moved outwards by a quarter of
//! themselves, since five trees are not all trees; and to the ends of what is published, where the literature has
//! firm figures. A distribution is compared with that of the nearest measured tree (Kolmogorov-Smirnov); the most that is
//! allowed is the largest distance of a measured tree to the nearest of the others, a quarter more.

use super::figures::Figures;
use super::why;
use crate::statistics::{kolmogorov_smirnov, median};
use crate::table::{Aim, Row, Table};

/// By how much the figures of measured trees are moved outwards.
const WIDENED: f64 = 1.25;

/// A figure of a tree.
pub(super) struct Measure {
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) of: fn(&Figures) -> Option<f64>,
    /// What the literature has.
    published: Option<(f64, f64)>,
}

pub(super) const MEASURES: [Measure; 9] = [
    Measure {
        name: "bifurcation ratio",
        unit: "",
        of: |figures| figures.bifurcation,
        // Leopold 1971 (fir 4.8, ash 5.1 and less); Barker, Cumming & Horsfield 1973 (apple, birch: 3 to 5).
        published: Some((3.0, 5.0)),
    },
    Measure { name: "length ratio", unit: "", of: |figures| figures.length_ratio, published: None },
    Measure {
        name: "pipe exponent, median",
        unit: "",
        of: |figures| figures.pipe,
        // Leonardo 2; Murray 1927 2.49; Murray's law 3; measured by Bentley et al. 2013 and others 1.8 to 2.3.
        published: Some((1.8, 3.0)),
    },
    Measure { name: "lateral angle, median", unit: "degrees", of: Figures::angle, published: None },
    Measure {
        name: "lateral angle, quartiles apart",
        unit: "degrees",
        of: Figures::angle_spread,
        published: None,
    },
    Measure {
        name: "internode, median",
        unit: "% height",
        of: Figures::internode,
        published: None,
    },
    Measure {
        name: "internode, quartile ratio",
        unit: "",
        of: Figures::internode_spread,
        published: None,
    },
    Measure { name: "box dimension", unit: "", of: |figures| figures.dimension, published: None },
    Measure {
        name: "height to diameter",
        unit: "",
        of: |figures| figures.slenderness,
        // Of trees in the open to trees in dense stands: Wang, Titus & LeMay 1998.
        published: Some((30.0, 120.0)),
    },
];

/// A distribution of a tree.
struct Distribution {
    name: &'static str,
    of: fn(&Figures) -> Vec<f64>,
}

const DISTRIBUTIONS: [Distribution; 2] = [
    Distribution { name: "lateral angles, distance", of: |figures| figures.angles.clone() },
    Distribution { name: "internodes, distance", of: Figures::shape },
];

/// What is allowed.
pub(super) struct Ranges {
    measured: Vec<Figures>,
}

impl Ranges {
    pub(super) fn of(measured: Vec<Figures>) -> Self {
        Self { measured }
    }

    /// Least, median and largest of the measured trees, widened and with what is published.
    fn range(&self, measure: &Measure) -> (f64, f64, f64) {
        let found: Vec<f64> = self.measured.iter().filter_map(measure.of).collect();
        let (least, most) = found
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(least, most), &f| (least.min(f), most.max(f)));
        let (low, high) = measure.published.unwrap_or((f64::INFINITY, 0.0));
        ((least / WIDENED).min(low), median(&found), (most * WIDENED).max(high))
    }

    /// The largest distance that is allowed.
    fn apart(&self, distribution: &Distribution) -> f64 {
        let all: Vec<Vec<f64>> = self.measured.iter().map(distribution.of).collect();
        let worst = all.iter().enumerate().map(|(i, own)| {
            let others = all.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, other)| other);
            nearest(own, others).unwrap_or(0.0)
        });
        WIDENED * worst.fold(0.0, f64::max)
    }

    /// The rows of a tree.
    pub(super) fn rows(&self, table: &mut Table, case: &str, figures: &Figures) {
        for measure in &MEASURES {
            let Some(ours) = (measure.of)(figures) else { continue };
            let (least, middle, most) = self.range(measure);
            let (metric, unit, peer) = (measure.name, measure.unit, Some(middle));
            let row =
                Row { case, metric, paper: None, peer, ours, unit, aim: Aim::Within(least, most) };
            table.row_because(&row, why::reason(case, metric));
        }
        for distribution in &DISTRIBUTIONS {
            let own = (distribution.of)(figures);
            let all: Vec<Vec<f64>> = self.measured.iter().map(distribution.of).collect();
            let Some(ours) = nearest(&own, all.iter()) else { continue };
            let most = self.apart(distribution);
            let (metric, unit, aim) = (distribution.name, "KS", Aim::AtMost(most));
            let row = Row { case, metric, paper: None, peer: None, ours, unit, aim };
            table.row_because(&row, why::reason(case, metric));
        }
    }
}

/// The distance to the nearest of others; none of or to nothing.
fn nearest<'a>(own: &[f64], others: impl Iterator<Item = &'a Vec<f64>>) -> Option<f64> {
    let distance = |other: &Vec<f64>| kolmogorov_smirnov(own, other);
    others.filter(|other| !other.is_empty() && !own.is_empty()).map(distance).min_by(f64::total_cmp)
}
