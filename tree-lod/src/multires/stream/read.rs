//! Bytes to trees, as they come.

use super::super::model::{End, Multires};
use super::code::{Bad, Cursor, MAGIC, Steps, VERSION, expected, unpack_turn};
use crate::error::{LodError, Result};
use crc32fast::Hasher;
use glam::{Quat, Vec3};
use std::path::Path;
use tree_core::{Foliage, Leaf, Limits, NO_PARENT, Resource, Skeleton, Species, Tree, file};

/// Most bytes of one level's length: what LEB128 needs for 64 bits.
const LENGTH_MAX: usize = 10;

/// Takes the bytes of a stream as they arrive, and gives the tree that they make so far.
#[derive(Clone, Debug)]
pub struct Reader {
    limits: Limits,
    /// Bytes that are not read yet.
    waiting: Vec<u8>,
    /// Bytes read before.
    before: u64,
    check: Hasher,
    head: Option<Head>,
    is_complete: bool,
    columns: Columns,
}

/// How much of a stream has arrived.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Received {
    /// Levels that are whole and checked.
    pub n_levels: usize,
    /// Levels of the whole stream; 0 while its head is not there.
    pub of: usize,
    /// Whether all has arrived, and its check holds.
    pub is_complete: bool,
    /// Bytes that have been read.
    pub n_bytes: u64,
}

#[derive(Clone, Debug)]
struct Head {
    steps: Steps,
    species: Species,
    n_levels: usize,
    n_nodes: usize,
    n_leaves: usize,
}

#[derive(Clone, Debug, Default)]
struct Columns {
    positions: Vec<Vec3>,
    radii: Vec<f32>,
    parents: Vec<u32>,
    leaves: Foliage,
    ends: Vec<End>,
}

/// Reads a stream, or what there is of it: levels up to the first that is cut off.
///
/// # Errors
/// [`LodError::Stream`] when not even the first level is whole, and for bytes that are no stream or have been
/// damaged; [`LodError::Limit`] for more nodes or leaves than allowed.
///
/// # Complexity
/// O(bytes).
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<(Multires, Received)> {
    let mut reader = Reader::new(limits);
    let received = reader.push(bytes)?;
    Ok((reader.multires()?, received))
}

/// [`decode`] of a file.
///
/// # Errors
/// The same, and [`LodError::Core`] when the file cannot be read; [`LodError::Limit`] also for a file that is
/// larger than allowed.
///
/// # Complexity
/// O(bytes).
pub fn read_file(path: &Path, limits: &Limits) -> Result<(Multires, Received)> {
    decode(&file::read_bytes(path, limits)?, limits)
}

impl Reader {
    /// A reader that nothing has reached yet. `limits`: nodes and leaves, asked for as the head
    /// arrives, and bytes of one level.
    #[must_use]
    pub fn new(limits: &Limits) -> Self {
        Self {
            limits: *limits,
            waiting: Vec::new(),
            before: 0,
            check: Hasher::new(),
            head: None,
            is_complete: false,
            columns: Columns::default(),
        }
    }

    /// Takes the next bytes, any number of them.
    ///
    /// # Errors
    /// [`LodError::Stream`] for bytes that are no stream, are damaged, or follow its end, and
    /// [`LodError::Limit`]; the levels before stay there, and the same comes again for more bytes.
    ///
    /// # Complexity
    /// O(bytes) together.
    pub fn push(&mut self, bytes: &[u8]) -> Result<Received> {
        self.waiting.extend_from_slice(bytes);
        let mut read = 0;
        let problem = loop {
            match self.next(read) {
                Ok(at) => read = at,
                Err(Stop::Wait) => break None,
                Err(Stop::Failed(problem)) => break Some(problem),
            }
        };
        self.waiting.drain(..read);
        self.before += read as u64;
        problem.map_or(Ok(self.received()), Err)
    }

    /// How much has arrived.
    #[must_use]
    pub fn received(&self) -> Received {
        Received {
            n_levels: self.columns.ends.len(),
            of: self.head.as_ref().map_or(0, |head| head.n_levels),
            is_complete: self.is_complete,
            n_bytes: self.before,
        }
    }

    /// The tree of all levels that have arrived.
    ///
    /// # Errors
    /// [`LodError::Stream`] when the first level is not there yet.
    ///
    /// # Complexity
    /// O(nodes + leaves).
    pub fn multires(&self) -> Result<Multires> {
        let (Some(head), false) = (&self.head, self.columns.ends.is_empty()) else {
            let problem = "it ends before its first level".into();
            let byte = self.before + self.waiting.len() as u64;
            return Err(LodError::Stream { byte, problem });
        };
        let columns = self.columns.clone();
        let skeleton = Skeleton::from_columns(columns.positions, columns.radii, columns.parents)?;
        let tree = Tree::new(skeleton, columns.leaves, head.species.clone())?;
        Ok(Multires::of_parts(tree, columns.ends))
    }

    /// Reads the head, a level or the end that begins at `at` of what is waiting, and tells where it ends.
    fn next(&mut self, at: usize) -> Result<usize, Stop> {
        let waiting = std::mem::take(&mut self.waiting);
        let result = match &self.head {
            None => self.head(&waiting, at),
            Some(head) if self.columns.ends.len() < head.n_levels => self.level(&waiting, at),
            Some(_) => self.end(&waiting, at),
        };
        self.waiting = waiting;
        result
    }

    fn head(&mut self, bytes: &[u8], at: usize) -> Result<usize, Stop> {
        let known = bytes.len().min(MAGIC.len());
        if bytes[..known] != MAGIC[..known] {
            return Err(self.fail(at, "this is no stream of a tree: it does not begin with 'TREM'"));
        }
        let mut cursor = Cursor::new(bytes, at);
        let head = read_head(&mut cursor).map_err(|bad| self.stop(cursor.at, bad))?;
        let read = cursor.at;
        let expected = cursor.array().map(u32::from_le_bytes).map_err(|_| Stop::Wait)?;
        self.check.update(&bytes[at..read]);
        if self.check.clone().finalize() != expected {
            return Err(self.fail(at, "the head is damaged"));
        }
        self.check.update(&bytes[read..cursor.at]);
        let limit = |resource, n: usize| self.limits.check(resource, n as u64);
        limit(Resource::Nodes, head.n_nodes).map_err(|e| Stop::Failed(e.into()))?;
        limit(Resource::Leaves, head.n_leaves).map_err(|e| Stop::Failed(e.into()))?;
        self.head = Some(head);
        Ok(cursor.at)
    }

    fn level(&mut self, bytes: &[u8], at: usize) -> Result<usize, Stop> {
        let Some(head) = &self.head else { return Err(Stop::Wait) };
        let mut cursor = Cursor::new(bytes, at);
        let length = match cursor.unsigned() {
            // A damaged length must not make it wait for, and keep, whatever comes.
            Ok(length) => match self.limits.check(Resource::InputBytes, length) {
                Ok(()) => length as usize,
                Err(error) => return Err(Stop::Failed(error.into())),
            },
            Err(Bad::Short) if bytes.len() - at < LENGTH_MAX => return Err(Stop::Wait),
            Err(_) => return Err(self.fail(at, "the length of a level is damaged")),
        };
        let start = cursor.at;
        cursor.take(length).map_err(|_| Stop::Wait)?;
        let end = cursor.at;
        let expected = cursor.array().map(u16::from_le_bytes).map_err(|_| Stop::Wait)?;
        let mut check = self.check.clone();
        check.update(&bytes[at..end]);
        if check.clone().finalize() as u16 != expected {
            return Err(self.fail(at, "a level is damaged"));
        }
        check.update(&bytes[end..cursor.at]);
        let mut inside = Cursor::new(&bytes[..end], start);
        let counts = (self.columns.positions.len(), self.columns.leaves.len());
        let result = self.columns.level(head, &mut inside);
        let whole = result.and_then(|()| {
            let rest = if inside.is_at_end() { Ok(()) } else { Err(WRONG_LENGTH) };
            rest.and_then(|()| self.columns.check(head))
        });
        if let Err(bad) = whole {
            self.columns.back_to(counts);
            let problem =
                if let Bad::Wrong(problem) = bad { problem } else { "a level is too short" };
            return Err(self.fail(inside.at, problem));
        }
        self.check = check;
        Ok(cursor.at)
    }

    fn end(&mut self, bytes: &[u8], at: usize) -> Result<usize, Stop> {
        if self.is_complete {
            let more = bytes.len() > at;
            let failed = || self.fail(at, "bytes follow the end of the stream");
            return Err(if more { failed() } else { Stop::Wait });
        }
        let mut cursor = Cursor::new(bytes, at);
        let expected = cursor.array().map(u32::from_le_bytes).map_err(|_| Stop::Wait)?;
        if self.check.clone().finalize() != expected {
            return Err(self.fail(at, "the whole is damaged"));
        }
        self.is_complete = true;
        Ok(cursor.at)
    }

    fn fail(&self, at: usize, problem: &str) -> Stop {
        let byte = self.before + at as u64;
        Stop::Failed(LodError::Stream { byte, problem: problem.into() })
    }

    fn stop(&self, at: usize, bad: Bad) -> Stop {
        match bad {
            Bad::Short => Stop::Wait,
            Bad::Wrong(problem) => self.fail(at, problem),
        }
    }
}

const WRONG_LENGTH: Bad = Bad::Wrong("a level is longer than what is in it");

enum Stop {
    /// For more bytes.
    Wait,
    Failed(LodError),
}

fn read_head(cursor: &mut Cursor<'_>) -> Result<Head, Bad> {
    cursor.take(MAGIC.len())?;
    if cursor.array()? != [VERSION] {
        return Err(Bad::Wrong("its version is not 1, the only one that is known"));
    }
    let precision = f32::from_le_bytes(cursor.array()?);
    if !(precision == 0.0 || (1e-6..=1.0).contains(&precision)) {
        return Err(Bad::Wrong("its precision must be 0, or 10⁻⁶ to 1 m"));
    }
    let (name, bark) = (cursor.text()?, cursor.text()?);
    let n_kinds = cursor.count()?;
    if n_kinds > u32::from(u16::MAX) + 1 {
        return Err(Bad::Wrong("more than 65,536 kinds of leaves"));
    }
    let leaf_kinds = (0..n_kinds).map(|_| cursor.text()).collect::<Result<_, _>>()?;
    let counts = [cursor.count()?, cursor.count()?, cursor.count()?];
    let [n_levels, n_nodes, n_leaves] = counts.map(|count| count as usize);
    if n_levels == 0 || n_nodes < n_levels {
        return Err(Bad::Wrong("a tree has at least a level, and a level at least a node"));
    }
    let species = Species { name, bark, leaf_kinds };
    Ok(Head { steps: Steps { precision }, species, n_levels, n_nodes, n_leaves })
}

impl Columns {
    fn level(&mut self, head: &Head, cursor: &mut Cursor<'_>) -> Result<(), Bad> {
        let first = self.positions.len();
        let fork = match first.checked_sub(1) {
            None => NO_PARENT,
            Some(last) => {
                let back = cursor.count()? as usize;
                last.checked_sub(back).ok_or(Bad::Wrong("a fork is before the root"))? as u32
            }
        };
        let n_nodes = cursor.count()? as usize;
        if n_nodes == 0 || n_nodes > head.n_nodes - first {
            return Err(Bad::Wrong("a level has no nodes, or more than the head tells"));
        }
        for i in 0..n_nodes {
            let parent = if i == 0 { fork } else { self.positions.len() as u32 - 1 };
            self.node(head.steps, parent, cursor)?;
        }
        let n_leaves = cursor.count()? as usize;
        if n_leaves > head.n_leaves - self.leaves.len() {
            return Err(Bad::Wrong("a level has more leaves than the head tells"));
        }
        let (mut node, mut size) = (first as u32, 0.0);
        for _ in 0..n_leaves {
            let leaf = self.leaf(head, node, size, cursor)?;
            (node, size) = (leaf.node, leaf.size);
            self.leaves.push(leaf).map_err(|_| Bad::Wrong("a leaf is not finite"))?;
        }
        let (nodes, leaves) = (self.positions.len() as u32, self.leaves.len() as u32);
        self.ends.push(End { nodes, leaves });
        Ok(())
    }

    fn node(&mut self, steps: Steps, parent: u32, cursor: &mut Cursor<'_>) -> Result<(), Bad> {
        let (expected, thick) = match self.parents.get(parent as usize) {
            Some(&grandparent) => expected(&self.positions, &self.radii, parent, grandparent),
            None => (Vec3::ZERO, 0.0),
        };
        let mut position = Vec3::ZERO;
        for axis in 0..3 {
            position[axis] = number(steps.positions(), expected[axis], cursor)?;
        }
        let radius = number(steps.radii(), thick, cursor)?;
        if radius < 0.0 {
            return Err(Bad::Wrong("a radius is below 0"));
        }
        self.positions.push(position);
        self.radii.push(radius);
        self.parents.push(parent);
        Ok(())
    }

    fn leaf(
        &self,
        head: &Head,
        node: u32,
        size: f32,
        cursor: &mut Cursor<'_>,
    ) -> Result<Leaf, Bad> {
        let node = node.checked_add(cursor.count()?).ok_or(NO_NODE)?;
        let base = *self.positions.get(node as usize).ok_or(NO_NODE)?;
        let kind = cursor.count()?;
        if kind as usize >= head.species.leaf_kinds.len() {
            return Err(Bad::Wrong("a leaf has a kind that is not there"));
        }
        let mut position = Vec3::ZERO;
        for axis in 0..3 {
            position[axis] = number(head.steps.positions(), base[axis], cursor)?;
        }
        let size = number(head.steps.positions(), size, cursor)?;
        let rotation = if head.steps.is_exact() {
            let mut parts = [0.0; 4];
            for part in &mut parts {
                *part = f32::from_le_bytes(cursor.array()?);
            }
            Quat::from_array(parts)
        } else {
            unpack_turn(u32::from_le_bytes(cursor.array()?))
        };
        Ok(Leaf { node, position, rotation, size, kind: kind as u16 })
    }

    /// Once all levels are there, so are all nodes and leaves.
    fn check(&self, head: &Head) -> Result<(), Bad> {
        let all = self.ends.len() == head.n_levels;
        let counts = (self.positions.len(), self.leaves.len());
        if all && counts != (head.n_nodes, head.n_leaves) {
            return Err(Bad::Wrong("nodes or leaves are missing"));
        }
        Ok(())
    }

    /// Forgets what a damaged level has left behind.
    fn back_to(&mut self, (n_nodes, n_leaves): (usize, usize)) {
        self.positions.truncate(n_nodes);
        self.radii.truncate(n_nodes);
        self.parents.truncate(n_nodes);
        self.ends.truncate(self.ends.partition_point(|end| end.nodes as usize <= n_nodes));
        if self.leaves.len() > n_leaves {
            let kept: Vec<Leaf> = self.leaves.iter().take(n_leaves).collect();
            // What was in a foliage goes into one.
            self.leaves = Foliage::try_from(kept).unwrap_or_default();
        }
    }
}

const NO_NODE: Bad = Bad::Wrong("a leaf is on a node that is not there");

fn number(step: super::code::Step, expected: f32, cursor: &mut Cursor<'_>) -> Result<f32, Bad> {
    let code = step.code(expected).checked_add(cursor.signed()?);
    code.and_then(|code| step.value(code)).ok_or(Bad::Wrong("a number is not finite"))
}
