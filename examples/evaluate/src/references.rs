//! Measured trees of the shared data: laser scans that others' programs made cylinders or skeletons of, and a tree
//! digitised by hand.
//!
//! * `archi_tree1` (`aRchi`) and `itsme_tree2` (`TreeQSM`): cylinders fitted to the points, each radius for itself.
//! * `puu1` and `cherry` (`PlantScan3D`): skeletons of scans; that program finds radii by a pipe model.
//! * `walnut`: noylum2, every position and diameter measured on the tree.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use tree_core::Skeleton;
use tree_core::glam::DVec3;

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A piece of wood, z up, metres.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cylinder {
    pub(crate) start: DVec3,
    pub(crate) end: DVec3,
    /// 0 where it is not known.
    pub(crate) radius: f64,
    /// Index of the cylinder below, which comes first.
    parent: Option<usize>,
}

/// Where the shared data are, if they are there.
pub(crate) fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data")
}

/// A forked broadleaved tree of 22 m, without leaves.
pub(crate) fn archi(data: &Path) -> Outcome<Vec<Cylinder>> {
    let names =
        ["startX", "startY", "startZ", "endX", "endY", "endZ", "radius_cyl", "cyl_ID", "parent_ID"];
    let rows = table_of(&data.join("skeletons/archi_tree1_qsm.csv"), &names)?;
    let index: BTreeMap<i64, usize> =
        rows.iter().enumerate().map(|(i, row)| (row[7] as i64, i)).collect();
    let at = |r: &[f64], i: usize| DVec3::new(r[i], r[i + 1], r[i + 2]);
    let cylinder = |r: &Vec<f64>| Cylinder {
        start: at(r, 0),
        end: at(r, 3),
        radius: r[6],
        parent: index.get(&(r[8] as i64)).copied(),
    };
    Ok(rows.iter().map(cylinder).collect())
}

/// A tall tropical tree, of which only the thick wood is there.
pub(crate) fn itsme(data: &Path) -> Outcome<Vec<Cylinder>> {
    let names = [
        "start_x", "start_y", "start_z", "axis_x", "axis_y", "axis_z", "length", "radius", "parent",
    ];
    let rows = table_of(&data.join("skeletons/itsme_tree2_qsm.csv"), &names)?;
    let at = |r: &[f64], i: usize| DVec3::new(r[i], r[i + 1], r[i + 2]);
    let cylinder = |r: &Vec<f64>| Cylinder {
        start: at(r, 0),
        end: at(r, 0) + r[6] * at(r, 3),
        radius: r[7],
        // Rows from 1; 0 for none.
        parent: (r[8] as usize).checked_sub(1),
    };
    Ok(rows.iter().map(cylinder).collect())
}

/// A young tree of 5 m, in great detail.
pub(crate) fn puu(data: &Path) -> Outcome<Vec<Cylinder>> {
    swc(&data.join("skeletons/puu1_reference.swc"))
}

/// A cherry of 5 m from an orchard.
pub(crate) fn cherry(data: &Path) -> Outcome<Vec<Cylinder>> {
    swc(&data.join("skeletons/cherry_plantscan3d.swc"))
}

/// A walnut of 8 m.
pub(crate) fn walnut(data: &Path) -> Outcome<Vec<Cylinder>> {
    mtg(&data.join("skeletons/walnut_noylum2.mtg"))
}

/// The skeleton of a measured tree: y up, its base at the origin. A node is the end of a cylinder and has its radius.
pub(crate) fn skeleton(cylinders: &[Cylinder]) -> Outcome<Skeleton> {
    let first = cylinders.first().ok_or("no cylinders")?;
    let place = |at: DVec3| {
        let at = at - first.start;
        DVec3::new(at.x, at.z, -at.y).as_vec3()
    };
    let mut builder = Skeleton::builder(place(first.start), first.radius as f32)?;
    for cylinder in cylinders {
        let parent = cylinder.parent.map_or(0, |parent| parent as u32 + 1);
        builder.add(parent, place(cylinder.end), cylinder.radius as f32)?;
    }
    Ok(builder.finish())
}

/// The rows of a table with a line of names, columns by name.
fn table_of(path: &Path, names: &[&str]) -> Outcome<Vec<Vec<f64>>> {
    let text = std::fs::read_to_string(path)?;
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let column = |name: &&str| header.iter().position(|h| h == name).ok_or("a column is missing");
    let columns = names.iter().map(column).collect::<Result<Vec<_>, _>>()?;
    let mut rows = Vec::new();
    for line in lines {
        let words: Vec<&str> = line.split(',').collect();
        let number = |&at: &usize| words.get(at).unwrap_or(&"").trim().parse::<f64>();
        rows.push(columns.iter().map(number).collect::<Result<Vec<_>, _>>()?);
    }
    Ok(rows)
}

/// Nodes one by one, as a file may list them.
#[derive(Default)]
struct Nodes {
    /// Position, and the cylinder that ends there.
    nodes: Vec<(DVec3, Option<usize>)>,
    cylinders: Vec<Cylinder>,
}

impl Nodes {
    fn add(&mut self, at: DVec3, radius: f64, parent: Option<usize>) -> usize {
        let below = parent.and_then(|parent| self.nodes.get(parent).copied());
        let cylinder = below.map(|(start, parent)| {
            self.cylinders.push(Cylinder { start, end: at, radius, parent });
            self.cylinders.len() - 1
        });
        self.nodes.push((at, cylinder));
        self.nodes.len() - 1
    }
}

/// The text is read here: nodes without radius are no SWC to our reader.
fn swc(path: &Path) -> Outcome<Vec<Cylinder>> {
    let text = std::fs::read_to_string(path)?;
    let mut rows: BTreeMap<i64, (DVec3, f64, i64)> = BTreeMap::default();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let n = line.split_whitespace().map(str::parse::<f64>).collect::<Result<Vec<_>, _>>()?;
        let [id, _, x, y, z, radius, parent] = n[..] else { return Err("seven columns".into()) };
        rows.insert(id as i64, (DVec3::new(x, y, z), radius, parent as i64));
    }
    let (mut nodes, mut index) = (Nodes::default(), BTreeMap::default());
    for (id, (at, radius, parent)) in rows {
        let node = nodes.add(at, radius, index.get(&parent).copied());
        index.insert(id, node);
    }
    Ok(nodes.cylinders)
}

/// A multiscale tree graph (Godin & Caraglio 1998) as the walnut's file has it: an entity in column k goes with the last
/// one of column k - 1, or with `^` with the last one of its own; `/` is a part of it, `<` its successor, `+` a
/// branch on it. Axes (A) have a base, segments (S, U) have an upper end in centimetres and a diameter in millimetres.
fn mtg(path: &Path) -> Outcome<Vec<Cylinder>> {
    let text = std::fs::read_to_string(path)?;
    let mut lines = text.lines().skip_while(|line| !line.starts_with("ENTITY-CODE"));
    let header: Vec<&str> = lines.next().unwrap_or_default().split('\t').collect();
    let column = |name: &str| header.iter().position(|h| *h == name).ok_or("a column is missing");
    let (first, x, diameter) = (column("Dist")?, column("XX")?, column("TopDia")?);
    let mut nodes = Nodes::default();
    // The last node of each column.
    let mut last: Vec<Option<usize>> = Vec::new();
    for line in lines {
        let words: Vec<&str> = line.split('\t').collect();
        let code = words.iter().take(first).position(|word| !word.trim().is_empty());
        let Some(k) = code else { continue };
        let code = words[k].trim();
        let column = if code.starts_with('^') { Some(k) } else { k.checked_sub(1) };
        let below = column.and_then(|k| last.get(k).copied().flatten());
        let number = |at: usize| words.get(at).and_then(|word| word.trim().parse::<f64>().ok());
        let is_axis = code.trim_start_matches(['^', '/', '<', '+']).starts_with('A');
        let node = match (number(x), number(x + 1), number(x + 2)) {
            // Of axes only the tree's own base is a node: the others begin on theirs.
            (Some(x), Some(y), Some(z)) if !is_axis || nodes.nodes.is_empty() => {
                let radius = number(diameter).unwrap_or(0.0) / 2000.0;
                Some(nodes.add(0.01 * DVec3::new(x, y, z), radius, below))
            }
            _ => below,
        };
        last.resize(k, None);
        last.push(node);
    }
    Ok(nodes.cylinders)
}
