//! How far trees of every modeler are from measured ones.
//!
//! All trees, measured and ours, go through the same measures ([`figures`]). What measured trees show is widened to
//! the range that ours are held against ([`range`]); trees that cannot be in it say why ([`why`]).

mod boxes;
mod figures;
mod range;
mod trees;
mod why;

use crate::references;
use crate::table::{Aim, Row, Table};
use figures::Figures;
use range::{MEASURES, Ranges};
use std::error::Error;

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// One row for each measure of each tree; says so and gives none where there is no shared data.
pub(crate) fn evaluate(table: &mut Table) -> Outcome {
    let data = references::data();
    if !data.join("skeletons").is_dir() {
        eprintln!("no shared data: no measured trees to compare with");
        return Ok(());
    }
    let measured = [
        ("archi", references::archi(&data)?),
        ("itsme", references::itsme(&data)?),
        ("puu", references::puu(&data)?),
        ("cherry", references::cherry(&data)?),
        ("walnut", references::walnut(&data)?),
    ];
    let mut figures = Vec::new();
    for (name, cylinders) in measured {
        let found = Figures::of(&references::skeleton(&cylinders)?);
        let case = format!("measured {name}");
        for measure in &MEASURES {
            if let Some(ours) = (measure.of)(&found) {
                let (metric, unit, aim) = (measure.name, measure.unit, Aim::None);
                table.row(&Row { case: &case, metric, paper: None, peer: None, ours, unit, aim });
            }
        }
        figures.push(found);
    }
    let ranges = Ranges::of(figures);
    trees::each(&mut |case, skeleton| ranges.rows(table, case, &Figures::of(skeleton)))?;
    Ok(())
}
