//! Trees to bytes.

use super::super::adt::Adt;
use super::super::model::{End, Multires};
use super::code::{
    MAGIC, Step, Steps, TEXT_MAX, VERSION, expected, pack_turn, write_signed, write_text,
    write_unsigned,
};
use crate::error::{LodError, Result, check_range};
use crc32fast::Hasher;
use glam::Vec3;
use std::path::Path;
use tree_core::{CoreError, NO_PARENT, Tree, file};

/// Coordinates beyond this many metres have no steps.
const EXTENT_MAX: f64 = 1e6;

/// How a stream is written.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StreamParams {
    /// Precision of positions and leaf sizes in metres, 0 or 10⁻⁶ to 1; radii are eight times as precise,
    /// leaves are turned by at most 0.2°. 0, the default: exact, to the last bit, in two to three times
    /// the bytes.
    pub precision: f32,
}

impl StreamParams {
    /// Checks every field.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        if self.precision == 0.0 {
            return Ok(());
        }
        check_range("precision", self.precision.into(), 1e-6, 1.0)
    }
}

/// The first `n_levels` levels of a tree, at least one, at most all, as bytes.
///
/// # Errors
/// [`LodError::Parameter`] for a precision out of range, or coordinates beyond 1000 km where it is not 0;
/// [`LodError::Stream`] for names of more than 4096 bytes.
///
/// # Complexity
/// O(nodes + leaves).
pub fn encode(multires: &Multires, n_levels: usize, params: &StreamParams) -> Result<Vec<u8>> {
    let mut writer = Writer::new(multires, params)?;
    let mut before = End::default();
    for level in 1..=n_levels.clamp(1, multires.n_levels()) {
        let (nodes, leaves) = multires.counts(level);
        let end = End { nodes: nodes as u32, leaves: leaves as u32 };
        writer.level(before, end);
        before = end;
    }
    if before.nodes as usize == multires.tree().skeleton().len() {
        writer.end();
    }
    Ok(writer.bytes)
}

/// [`encode`] into a file, whole or not at all.
///
/// # Errors
/// The same, and [`LodError::Core`] when the file cannot be written.
///
/// # Complexity
/// O(nodes + leaves).
pub fn write_file(
    multires: &Multires,
    n_levels: usize,
    params: &StreamParams,
    path: &Path,
) -> Result<()> {
    let bytes = encode(multires, n_levels, params)?;
    file::write_atomic(path, |file| {
        file.write_all(&bytes).map_err(|error| CoreError::io(path, error).into())
    })
}

/// The same tree as one chain with brackets, in the same code, with one check at its end: what there is
/// without levels, to compare sizes with. Nothing reads it.
///
/// # Errors
/// As [`encode`].
///
/// # Complexity
/// O(nodes + leaves).
pub fn encode_chain(multires: &Multires, params: &StreamParams) -> Result<Vec<u8>> {
    let mut writer = Writer::new(multires, params)?;
    let adt = Adt::of_skeleton(multires.tree().skeleton());
    // Branches that are still to be written, and how many brackets are closed behind each.
    let mut open = vec![(0_u32, 0_usize)];
    while let Some((branch, closed)) = open.pop() {
        let nodes = adt.modules(branch);
        write_unsigned(&mut writer.bytes, nodes.len() as u64);
        nodes.iter().for_each(|&node| writer.node(node));
        let rows: Vec<_> =
            nodes.iter().flat_map(|&node| writer.leaves_of(node, node + 1)).collect();
        writer.leaves(&rows, nodes.first().copied().unwrap_or_default());
        // All children but the last are in brackets: '[' and ']'.
        let children = adt.children(branch);
        writer.bytes.push(children.len().min(255) as u8);
        if children.is_empty() {
            writer.bytes.extend(std::iter::repeat_n(b']', closed));
        }
        for (i, &child) in children.iter().rev().enumerate() {
            open.push((child, if i == 0 { closed } else { 1 }));
        }
    }
    writer.end();
    Ok(writer.bytes)
}

struct Writer<'a> {
    tree: &'a Tree,
    steps: Steps,
    bytes: Vec<u8>,
    check: Hasher,
    /// Bytes that the check has seen.
    checked: usize,
    /// What readers know of the nodes before: positions and radii as they come out.
    positions: Vec<Vec3>,
    radii: Vec<f32>,
}

impl<'a> Writer<'a> {
    fn new(multires: &'a Multires, params: &StreamParams) -> Result<Self> {
        params.validate()?;
        let tree = multires.tree();
        let steps = Steps { precision: params.precision };
        if !steps.is_exact() {
            let reach = |p: &Vec3| f64::from(p.abs().max_element());
            for p in tree.skeleton().positions().iter().chain(tree.foliage().positions()) {
                check_range("position", reach(p), 0.0, EXTENT_MAX)?;
            }
            for &length in tree.skeleton().radii().iter().chain(tree.foliage().sizes()) {
                check_range("radius or size", length.into(), 0.0, EXTENT_MAX)?;
            }
        }
        let n = tree.skeleton().len();
        let mut writer = Self {
            tree,
            steps,
            bytes: Vec::with_capacity(16 * n + 16 * tree.foliage().len()),
            check: Hasher::new(),
            checked: 0,
            positions: vec![Vec3::ZERO; n],
            radii: vec![0.0; n],
        };
        writer.head(multires)?;
        Ok(writer)
    }

    fn head(&mut self, multires: &Multires) -> Result<()> {
        self.bytes.extend_from_slice(&MAGIC);
        self.bytes.push(VERSION);
        self.bytes.extend_from_slice(&self.steps.precision.to_le_bytes());
        let species = self.tree.species();
        let names = [&species.name, &species.bark];
        for name in names.into_iter().chain(&species.leaf_kinds) {
            if name.len() > TEXT_MAX {
                let problem = "a name is longer than 4096 bytes".into();
                return Err(LodError::Stream { byte: self.bytes.len() as u64, problem });
            }
        }
        names.iter().for_each(|name| write_text(&mut self.bytes, name));
        write_unsigned(&mut self.bytes, species.leaf_kinds.len() as u64);
        species.leaf_kinds.iter().for_each(|name| write_text(&mut self.bytes, name));
        let (nodes, leaves) = multires.counts(usize::MAX);
        for count in [multires.n_levels(), nodes, leaves] {
            write_unsigned(&mut self.bytes, count as u64);
        }
        self.end();
        Ok(())
    }

    /// One level: nodes and leaves between two ends.
    fn level(&mut self, before: End, end: End) {
        let start = self.bytes.len();
        if before.nodes > 0 {
            let fork = self.tree.skeleton().parents()[before.nodes as usize];
            write_unsigned(&mut self.bytes, u64::from(before.nodes - 1 - fork));
        }
        write_unsigned(&mut self.bytes, u64::from(end.nodes - before.nodes));
        (before.nodes..end.nodes).for_each(|node| self.node(node));
        let rows: Vec<_> = (before.leaves..end.leaves).collect();
        self.leaves(&rows, before.nodes);
        let mut length = Vec::with_capacity(2);
        write_unsigned(&mut length, (self.bytes.len() - start) as u64);
        self.bytes.splice(start..start, length);
        let check = self.check() as u16;
        self.bytes.extend_from_slice(&check.to_le_bytes());
    }

    fn node(&mut self, node: u32) {
        let skeleton = self.tree.skeleton();
        let parent = skeleton.parents()[node as usize];
        let (expected, thick) = self.expected(parent);
        let step = self.steps.positions();
        let (p, mut known) = (skeleton.positions()[node as usize], Vec3::ZERO);
        for axis in 0..3 {
            known[axis] = self.number(step, p[axis], expected[axis]);
        }
        self.positions[node as usize] = known;
        let radius = skeleton.radii()[node as usize];
        self.radii[node as usize] = self.number(self.steps.radii(), radius, thick);
    }

    /// Where a child of this node is expected, and how thick.
    fn expected(&self, parent: u32) -> (Vec3, f32) {
        if parent == NO_PARENT {
            return (Vec3::ZERO, 0.0);
        }
        let grandparent = self.tree.skeleton().parents()[parent as usize];
        expected(&self.positions, &self.radii, parent, grandparent)
    }

    /// Rows of the leaves on a range of nodes.
    fn leaves_of(&self, first: u32, end: u32) -> std::ops::Range<u32> {
        let before =
            |end: u32| self.tree.foliage().nodes().partition_point(|&node| node < end) as u32;
        before(first)..before(end)
    }

    fn leaves(&mut self, rows: &[u32], first_node: u32) {
        write_unsigned(&mut self.bytes, rows.len() as u64);
        let (mut node, mut size) = (first_node, 0.0);
        let leaves = rows.iter().filter_map(|&row| self.tree.foliage().get(row as usize));
        for leaf in leaves {
            write_unsigned(&mut self.bytes, u64::from(leaf.node.wrapping_sub(node)));
            node = leaf.node;
            write_unsigned(&mut self.bytes, leaf.kind.into());
            let base = self.positions[node as usize];
            for axis in 0..3 {
                self.number(self.steps.positions(), leaf.position[axis], base[axis]);
            }
            size = self.number(self.steps.positions(), leaf.size, size);
            if self.steps.is_exact() {
                let turn = leaf.rotation.to_array();
                turn.iter().for_each(|x| self.bytes.extend_from_slice(&x.to_le_bytes()));
            } else {
                self.bytes.extend_from_slice(&pack_turn(leaf.rotation).to_le_bytes());
            }
        }
    }

    /// Writes how a number differs from what was expected, and gives it as it will be read.
    fn number(&mut self, step: Step, x: f32, expected: f32) -> f32 {
        let code = step.code(x);
        write_signed(&mut self.bytes, code - step.code(expected));
        step.value(code).unwrap_or(x)
    }

    /// The CRC-32 of all bytes so far.
    fn check(&mut self) -> u32 {
        self.check.update(&self.bytes[self.checked..]);
        self.checked = self.bytes.len();
        self.check.clone().finalize()
    }

    fn end(&mut self) {
        let check = self.check();
        self.bytes.extend_from_slice(&check.to_le_bytes());
    }
}
