//! The trees of the evaluation.

use super::{Outcome, SEED};
use std::collections::BTreeMap;
use std::path::PathBuf;
use tree_core::glam::Vec3;
use tree_core::{Control, Limits, Skeleton, Species, Tree, file, swc};
use tree_model::lsystem::LSystem;
use tree_model::path;

/// A named tree.
pub(super) struct Case {
    pub(super) name: String,
    pub(super) tree: Tree,
}

/// Where a tree comes from.
enum Source {
    /// A preset of L-systems.
    System(&'static str),
    /// A preset of least-cost paths.
    Path(&'static str),
    /// A drawing of ours.
    Outline(&'static str),
    /// A scan, and what it is called.
    Scan(&'static str, &'static str),
}

use Source::{Outline, Path, Scan, System};

/// What the default metric was chosen with, and all else is measured with: leafy species of ours, bare ones of the
/// books, another modeler, a scan.
const TEN: [Source; 10] = [
    System("oak"),
    System("birch"),
    System("spruce"),
    System("willow"),
    System("honda-a"),
    System("aono-kunii-a"),
    System("ternary-a"),
    Path("oak"),
    Path("c"),
    Scan("cherry", "cherry_plantscan3d.swc"),
];

/// Others, that no metric was chosen with.
const HELD_OUT: [Source; 10] = [
    System("fern"),
    System("honda-d"),
    System("aono-kunii-c"),
    System("ternary-c"),
    Path("f"),
    Path("l"),
    Outline("poplar"),
    Outline("willow"),
    Scan("puu1", "puu1_reference.swc"),
    Scan("archi", "archi_tree1_qsm.csv"),
];

/// The trees that levels are measured with; scans where they are there.
pub(super) fn ten() -> Outcome<Vec<Case>> {
    made(&TEN)
}

/// Trees that no metric was chosen with.
pub(super) fn held_out() -> Outcome<Vec<Case>> {
    made(&HELD_OUT)
}

fn made(sources: &[Source]) -> Outcome<Vec<Case>> {
    let mut cases = Vec::new();
    for source in sources {
        let (name, tree) = match *source {
            System(name) => {
                (name.into(), LSystem::preset(name)?.grow(SEED, &Control::default())?.tree)
            }
            Path(name) => {
                let params = path::Preset::find(name)?.params()?;
                (format!("path {name}"), params.grow(SEED, &Control::default())?.tree)
            }
            Outline(name) => (format!("outline {name}"), crate::silhouette::tree(name)?),
            Scan(name, file) => match scan(file)? {
                Some(tree) => (format!("{name}, scanned"), tree),
                None => continue,
            },
        };
        cases.push(Case { name, tree });
    }
    Ok(cases)
}

/// A scanned tree of the shared data; none where they are not there.
fn scan(name: &str) -> Outcome<Option<Tree>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/skeletons");
    let path = folder.join(name);
    if !path.exists() {
        eprintln!("{name}: not there, left out");
        return Ok(None);
    }
    let limits = Limits::default();
    let skeleton = if name.ends_with(".swc") {
        swc::read_file(&path, &swc::SwcOptions::default(), &limits)?.skeleton
    } else {
        cylinders(&file::read_text(&path, &limits)?)?
    };
    Ok(Some(Tree::bare(skeleton, Species::default())))
}

/// A table of cylinders: starts, ends, numbers of their own and of their parents, and radii; metres, Z up.
fn cylinders(text: &str) -> Outcome<Skeleton> {
    let mut rows = text.lines();
    let names: Vec<&str> = rows.next().unwrap_or_default().split(',').collect();
    let column = |name: &str| names.iter().position(|&n| n == name).ok_or("a column is missing");
    let columns =
        ["startX", "startY", "startZ", "endX", "endY", "endZ", "radius_cyl", "parent_ID", "cyl_ID"];
    let columns = columns.map(column).into_iter().collect::<Result<Vec<_>, _>>()?;
    let mut builder = None;
    // The node at the end of each cylinder, by its number; 0 is the foot of the first.
    let mut nodes = BTreeMap::from([(0_u32, 0_u32)]);
    for row in rows {
        let cells: Vec<&str> = row.split(',').collect();
        let cell = |i: usize| -> Outcome<f32> {
            Ok(cells.get(columns[i]).ok_or("a cell is missing")?.parse()?)
        };
        let point =
            |i: usize| -> Outcome<Vec3> { Ok(Vec3::new(cell(i)?, cell(i + 2)?, -cell(i + 1)?)) };
        let (radius, parent, number) = (cell(6)?, cell(7)? as u32, cell(8)? as u32);
        let skeleton = match &mut builder {
            Some(skeleton) => skeleton,
            none => none.insert(Skeleton::builder(point(0)?, radius)?),
        };
        let bearer = *nodes.get(&parent).ok_or("a parent is missing")?;
        nodes.insert(number, skeleton.add(bearer, point(3)?, radius)?);
    }
    Ok(builder.ok_or("no cylinders")?.finish())
}
