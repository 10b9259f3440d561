//! Triangles become elements.

use super::Elements;
use super::measure::measure;
use crate::error::{LodError, Result};
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::{Alpha, Mesh, Surface, topology};

/// Which surfaces of a mesh are pruned.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum LeafSurfaces {
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
    /// A connected piece: a card, a leaflet of a compound leaf, a single leaf. Crossed cards, and the
    /// two sides of a doubled card that has its own vertices, are elements of their own. Default: the finer, the better the
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
    /// O(triangles log triangles + vertices log vertices), in parallel over surfaces.
    pub fn of_mesh(
        mesh: &Mesh,
        foliage: &LeafSurfaces,
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

fn chosen(mesh: &Mesh, foliage: &LeafSurfaces) -> Result<Vec<u32>> {
    let all = 0..mesh.surfaces.len() as u32;
    let surface = |&number: &u32| &mesh.surfaces[number as usize];
    let found = match foliage {
        LeafSurfaces::Surfaces(numbers) => {
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
        LeafSurfaces::Found => {
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
    // Vertices of a triangle belong together, and copies of a vertex at a seam that the mesh tells.
    let mut parents: Vec<u32> = (0..surface.positions.len() as u32).collect();
    for triangle in triangles {
        join(&mut parents, triangle[0], triangle[1]);
        join(&mut parents, triangle[1], triangle[2]);
    }
    for (vertex, &weld) in surface.welds.iter().enumerate() {
        join(&mut parents, vertex as u32, weld);
    }
    join_soup(surface, triangles, &mut parents)?;
    // Copies of a card back to back have the same points: positions alone would join them, and neither could
    // be dropped without the other.
    for vertex in 0..parents.len() {
        parents[vertex] = parents[parents[vertex] as usize];
    }
    let root = |triangle: &[u32; 3]| parents[triangle[0] as usize];
    Ok(numbered(triangles.iter().map(root), surface.positions.len()))
}

/// Joins triangles that share no vertex with any other, as some programs write all of them, where they
/// have an edge in common. The two sides of a doubled card of such triangles become one.
fn join_soup(surface: &Surface, triangles: &[[u32; 3]], parents: &mut [u32]) -> Result<()> {
    let mut uses = vec![0_u8; surface.positions.len()];
    for &vertex in triangles.as_flattened() {
        uses[vertex as usize] = uses[vertex as usize].saturating_add(1);
    }
    let lone = |triangle: &&[u32; 3]| triangle.iter().all(|&vertex| uses[vertex as usize] == 1);
    if !triangles.iter().any(|triangle| lone(&triangle)) {
        return Ok(());
    }
    let points = topology::welded(surface)?.of_vertex;
    let per_leaf = surface.vertices_per_leaf().unwrap_or(usize::MAX);
    let mut edges: Vec<(u32, u32, u32)> = Vec::new();
    for &[a, b, c] in triangles.iter().filter(lone) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (p, q) = (points[from as usize], points[to as usize]);
            edges.push((p.min(q), p.max(q), a));
        }
    }
    edges.sort_unstable();
    for pair in edges.windows(2) {
        let same_leaf = pair[0].2 as usize / per_leaf == pair[1].2 as usize / per_leaf;
        if (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1) && same_leaf {
            join(parents, pair[0].2, pair[1].2);
        }
    }
    Ok(())
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
