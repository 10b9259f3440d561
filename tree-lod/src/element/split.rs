//! Triangles become elements.

use super::Elements;
use super::measure::measure;
use crate::error::{LodError, Result};
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::{Alpha, Mesh, Surface, topology};

/// Which surfaces of a mesh are pruned.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Foliage {
    /// Surfaces of leaves ([`Surface::anchors`]); where there are none, as in imported meshes, those
    /// whose material is alpha-tested, has two sides or is named after leaves. Default.
    #[default]
    Found,
    /// These, by number.
    Surfaces(Vec<u32>),
}

/// What one element is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Grain {
    /// A connected piece: a card, a leaflet of a compound leaf, a single leaf. Crossed cards and the
    /// two sides of a doubled card are elements of their own. Default: the finer, the better the
    /// pictures.
    #[default]
    Blade,
    /// A triangle, scaled about the centre of its blade. Half a card often stands for all of it: better
    /// pictures still, at the price of cut cards that are seen when one comes near.
    Triangle,
    /// A leaf with all its blades, where the mesh tells ([`Surface::anchors`]), otherwise as `Blade`.
    /// Nothing is ever half a leaf.
    Leaf,
}

/// Parts of names that tell leaves, as modellers call them.
const NAMES: [&str; 9] =
    ["leaf", "leaves", "foliage", "frond", "needle", "twig", "crown", "canopy", "blatt"];

impl Elements {
    /// Divides the foliage of a mesh into elements.
    ///
    /// # Errors
    /// What [`Mesh::check`] finds; [`LodError::Foliage`] when there is no foliage, or a surface that was
    /// named does not exist or is named twice; [`LodError::Limit`] over the limit of triangles.
    ///
    /// # Complexity
    /// O(triangles + vertices log vertices), in parallel over surfaces.
    pub fn of_mesh(
        mesh: &Mesh,
        foliage: &Foliage,
        grain: Grain,
        control: &Control,
    ) -> Result<Self> {
        mesh.check()?;
        control.limits.check(Resource::Triangles, mesh.n_triangles() as u64)?;
        let surfaces = chosen(mesh, foliage)?;
        let whole = if grain == Grain::Triangle { Grain::Blade } else { grain };
        let groups = surfaces
            .par_iter()
            .map(|&number| groups(&mesh.surfaces[number as usize], whole))
            .collect::<Result<Vec<_>>>()?;
        let mut elements = Self { surfaces, starts: vec![0], ..Self::default() };
        for (i, (of_triangle, n)) in groups.iter().enumerate() {
            elements.append(elements.surfaces[i], of_triangle, *n);
        }
        control.check()?;
        measure(mesh, &mut elements);
        if grain == Grain::Triangle {
            elements = elements.cut(mesh);
        }
        if elements.is_empty() {
            return Err(LodError::Foliage("the surfaces have no triangles"));
        }
        Ok(elements)
    }

    /// Every triangle by itself, with the centre of the element it was part of.
    fn cut(self, mesh: &Mesh) -> Self {
        let n = self.n_triangles();
        let of: Vec<usize> =
            (0..self.len()).flat_map(|element| self.rows(element).map(move |_| element)).collect();
        let mut cut = Self {
            surfaces: self.surfaces,
            surface: of.iter().map(|&element| self.surface[element]).collect(),
            starts: (0..=n as u32).collect(),
            triangles: self.triangles,
            ..Self::default()
        };
        measure(mesh, &mut cut);
        cut.centers = of.iter().map(|&element| self.centers[element]).collect();
        cut
    }

    /// Appends the elements of a surface: counting sort of its triangles.
    fn append(&mut self, surface: u32, of_triangle: &[u32], n: usize) {
        let first = self.triangles.len() as u32;
        let mut starts = vec![0_u32; n + 1];
        for &element in of_triangle {
            starts[element as usize + 1] += 1;
        }
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        self.starts.extend(starts[1..].iter().map(|start| first + start));
        self.triangles.resize(first as usize + of_triangle.len(), 0);
        for (triangle, &element) in of_triangle.iter().enumerate() {
            let at = &mut starts[element as usize];
            self.triangles[(first + *at) as usize] = triangle as u32;
            *at += 1;
        }
        self.surface.extend(std::iter::repeat_n(surface, n));
    }
}

fn chosen(mesh: &Mesh, foliage: &Foliage) -> Result<Vec<u32>> {
    let all = 0..mesh.surfaces.len() as u32;
    let surface = |&number: &u32| &mesh.surfaces[number as usize];
    let found = match foliage {
        Foliage::Surfaces(numbers) => {
            let mut numbers = numbers.clone();
            numbers.sort_unstable();
            if numbers.windows(2).any(|pair| pair[0] == pair[1]) {
                return Err(LodError::Foliage("a surface is named twice"));
            }
            if numbers.last().is_some_and(|&last| last as usize >= mesh.surfaces.len()) {
                return Err(LodError::Foliage("a surface is named that the mesh does not have"));
            }
            numbers
        }
        Foliage::Found => {
            let leaves: Vec<u32> =
                all.clone().filter(|number| !surface(number).anchors.is_empty()).collect();
            if leaves.is_empty() {
                all.filter(|number| looks_like_leaves(mesh, surface(number))).collect()
            } else {
                leaves
            }
        }
    };
    if found.is_empty() {
        return Err(LodError::Foliage("no surface looks like leaves: name the surfaces to prune"));
    }
    Ok(found)
}

fn looks_like_leaves(mesh: &Mesh, surface: &Surface) -> bool {
    let material = &mesh.materials[surface.material as usize];
    let name = material.name.to_lowercase();
    surface.n_triangles() > 0
        && (matches!(material.alpha, Alpha::Mask(_))
            || material.double_sided
            || NAMES.iter().any(|part| name.contains(part)))
}

/// The element of each triangle, and their number.
fn groups(surface: &Surface, grain: Grain) -> Result<(Vec<u32>, usize)> {
    let (triangles, _) = surface.indices.as_chunks::<3>();
    if grain == Grain::Leaf
        && let Some(per_leaf) = surface.vertices_per_leaf()
    {
        let leaf = |triangle: &[u32; 3]| triangle[0] / per_leaf as u32;
        return Ok(numbered(triangles.iter().map(leaf), surface.anchors.len()));
    }
    let points = topology::welded(surface)?;
    let point = |vertex: u32| points.of_vertex[vertex as usize];
    // A card that is there twice, back to back, has the same points: the copies must not be joined,
    // or one of them could not be dropped. Vertices join only within a leaf or a connected piece.
    let mut parents: Vec<u32> = (0..surface.positions.len() as u32).collect();
    for triangle in triangles {
        join(&mut parents, triangle[0], triangle[1]);
        join(&mut parents, triangle[1], triangle[2]);
    }
    if !separate_cards(surface) {
        let per_leaf = surface.vertices_per_leaf().unwrap_or(usize::MAX);
        for (vertex, &of) in points.of_vertex.iter().enumerate() {
            let first = points.first[of as usize];
            if vertex / per_leaf == first as usize / per_leaf && point(first) == of {
                join(&mut parents, first, vertex as u32);
            }
        }
    }
    let root = |triangle: &[u32; 3]| root(&parents, triangle[0]);
    Ok(numbered(triangles.iter().map(root), surface.positions.len()))
}

/// Whether every connected run of vertices is already a whole piece: quads and outlines whose copies
/// at a point belong to other cards. Where triangles share no vertex at all (a soup), points must join
/// them.
fn separate_cards(surface: &Surface) -> bool {
    surface.positions.len() < surface.indices.len()
}

/// Numbers groups in the order in which they first appear.
fn numbered(groups: impl Iterator<Item = u32>, n: usize) -> (Vec<u32>, usize) {
    const NONE: u32 = u32::MAX;
    let mut number_of = vec![NONE; n];
    let mut count = 0;
    let of = groups.map(|group| {
        let number = &mut number_of[group as usize];
        if *number == NONE {
            *number = count;
            count += 1;
        }
        *number
    });
    (of.collect(), count as usize)
}

fn root(parents: &[u32], mut vertex: u32) -> u32 {
    while parents[vertex as usize] != vertex {
        vertex = parents[vertex as usize];
    }
    vertex
}

/// Joins two trees, the later root under the earlier one, and shortens the ways.
fn join(parents: &mut [u32], a: u32, b: u32) {
    let (a, b) = (shortened(parents, a), shortened(parents, b));
    parents[a.max(b) as usize] = a.min(b);
}

fn shortened(parents: &mut [u32], mut vertex: u32) -> u32 {
    while parents[vertex as usize] != vertex {
        let above = parents[parents[vertex as usize] as usize];
        parents[vertex as usize] = above;
        vertex = above;
    }
    vertex
}
