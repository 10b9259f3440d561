//! From elements to tiers.

use super::Tier;
use super::alike::{self, Alike, Found};
use super::shape::Local;
use super::{blade, portion, shape};
use crate::element::Elements;
use crate::error::{LodError, Result, check_range};
use rayon::prelude::*;
use tree_core::{Control, Resource};
use tree_mesh::{Alpha, Mesh};

/// How elements are simplified.
#[derive(Clone, Debug, PartialEq)]
pub struct OutlineParams {
    /// Share of its triangles that an element has in each tier after the first, falling, 0 to 1, at
    /// most 16. Every element keeps at least one triangle, or two where a picture with a mask lies on
    /// it. Default 1/2, 1/4, 1/8, 1/16.
    pub shares: Vec<f32>,
    /// How far lengths of elements may differ, in lengths of a square of the same area, for them to be
    /// taken as alike and share one answer, 0 to 1. Default 0.08.
    pub alike: f32,
    /// Largest share of the triangles of the tier before that a tier may have; others are not worth their
    /// memory and are left out. 0 to 1. Default 0.9.
    pub worth: f32,
}

impl Default for OutlineParams {
    fn default() -> Self {
        Self { shares: vec![0.5, 0.25, 0.125, 0.0625], alike: 0.08, worth: 0.9 }
    }
}

/// Most tiers after the first.
const SHARES_MAX: usize = 16;
/// Fewest triangles with a mask on them: less than a card cuts the picture.
const MASKED_MIN: usize = 2;
/// Elements whose answers are joined at a time, between two looks at the control.
const PART: usize = 1 << 14;

impl OutlineParams {
    /// Checks all numbers.
    ///
    /// # Errors
    /// [`LodError::Parameter`], naming the field.
    pub fn validate(&self) -> Result<()> {
        check_range("outline.shares.len", self.shares.len() as f64, 0.0, SHARES_MAX as f64)?;
        let mut most = 1.0;
        for &share in &self.shares {
            check_range("outline.shares", share.into(), 0.0, most)?;
            most = share.into();
        }
        check_range("outline.alike", self.alike.into(), 0.0, 1.0)?;
        check_range("outline.worth", self.worth.into(), 0.0, 1.0)
    }
}

/// The model's elements, and the same with fewer and fewer triangles.
///
/// The first tier is the model as it is. No element has more triangles in a later tier than in an earlier
/// one. Elements without area keep all their triangles, and so do cards of two triangles with a mask.
///
/// # Errors
/// [`LodError::Parameter`]; what [`Mesh::check`] finds; [`LodError::Foliage`] when the elements are those
/// of another mesh; [`LodError::Limit`] over the limit of triangles, of all tiers together;
/// [`LodError::Cancelled`].
///
/// # Complexity
/// O(triangles × tiers); 5 to 10 ms for each distinct shape of 16 triangles, 0.15 s for one of 44, for
/// at most 24 shapes of each pattern of triangles (others are not searched); in parallel. Blades of more
/// than 64 triangles: O(n log n) and some looks.
pub fn tiers(
    mesh: &Mesh,
    elements: &Elements,
    params: &OutlineParams,
    control: &Control,
) -> Result<Vec<Tier>> {
    params.validate()?;
    check(mesh, elements)?;
    let most = elements.n_triangles() as u64 * (1 + params.shares.len() as u64);
    control.limits.check(Resource::Triangles, most)?;
    let full = Tier::full(mesh, elements);
    let masked: Vec<bool> = elements.surface.iter().map(|&s| is_masked(mesh, s)).collect();
    let least = |element: usize| if masked[element] { MASKED_MIN } else { 1 };
    control.report("outlines", 0.0)?;
    let found = alike::find(mesh, elements, &full, least, params.alike, control)?;
    control.report("outlines", 0.3)?;
    let answers = found
        .shapes
        .par_iter()
        .map(|alike| {
            control.check()?;
            Ok(answer(mesh, elements, &full, alike, &params.shares))
        })
        .collect::<Result<Vec<_>>>()?;
    control.report("outlines", 0.8)?;
    let mut tiers = vec![full];
    for number in 0..params.shares.len() {
        let tier = joined(&tiers[0], &found, &answers, number, control)?;
        let before = tiers.last().map_or(0, |tier| tier.triangles.len());
        if (tier.triangles.len() as f32) <= params.worth * before as f32 && before > 0 {
            tiers.push(tier);
        }
    }
    control.report("outlines", 1.0)?;
    Ok(tiers)
}

/// Whether the elements are rows of this mesh.
fn check(mesh: &Mesh, elements: &Elements) -> Result<()> {
    mesh.check()?;
    let n = elements.len();
    let fits = elements.surface.len() == n
        && elements.areas.len() == n
        && elements.starts.len() == n + 1
        && elements.starts.is_sorted()
        && elements.starts.first() == Some(&0)
        && elements.starts.last().is_some_and(|&end| end as usize == elements.n_triangles())
        && (0..n).all(|element| {
            mesh.surfaces.get(elements.surface[element] as usize).is_some_and(|surface| {
                let n = surface.n_triangles();
                elements.triangles_of(element).iter().all(|&row| (row as usize) < n)
            })
        });
    if fits { Ok(()) } else { Err(LodError::Foliage("the elements are those of another mesh")) }
}

fn is_masked(mesh: &Mesh, surface: u32) -> bool {
    let material = &mesh.materials[mesh.surfaces[surface as usize].material as usize];
    material.alpha != Alpha::Opaque && material.texture.is_some()
}

/// Triangles of the local vertices of a shape, in every tier.
fn answer(
    mesh: &Mesh,
    elements: &Elements,
    full: &Tier,
    alike: &Alike,
    shares: &[f32],
) -> Vec<Vec<[u32; 3]>> {
    let element = alike.element as usize;
    let all = full.of(element);
    let local = Local::of(all);
    let positions = &mesh.surfaces[elements.surface[element] as usize].positions;
    let points: Vec<_> = local.vertices.iter().map(|&v| positions[v as usize]).collect();
    let blades = shape::blades(&points, &local.triangles);
    let n = all.len();
    let targets: Vec<usize> = shares
        .iter()
        .map(|share| ((n as f32 * share).round() as usize).clamp(alike.least.min(n), n))
        .collect();
    let portions: Vec<Vec<usize>> =
        targets.iter().map(|&target| portion::divided(&blades, target)).collect();
    let mut out: Vec<Vec<[u32; 3]>> = vec![Vec::new(); shares.len()];
    for (i, blade) in blades.iter().enumerate() {
        let of_blade: Vec<usize> = portions.iter().map(|portion| portion[i]).collect();
        for (tier, triangles) in
            out.iter_mut().zip(blade::simplified(blade, &of_blade, alike.search))
        {
            tier.extend(triangles.iter().map(|t| t.map(|p| blade.vertices[p as usize])));
        }
    }
    // Nothing saved, or nothing left: what was there before stays.
    let mut before = local.triangles;
    for tier in &mut out {
        if tier.is_empty() || tier.len() >= before.len() {
            tier.clone_from(&before);
        }
        before.clone_from(tier);
    }
    out
}

/// The tier of this number, for all elements.
fn joined(
    full: &Tier,
    found: &Found,
    answers: &[Vec<Vec<[u32; 3]>>],
    number: usize,
    control: &Control,
) -> Result<Tier> {
    let mut tier = Tier { starts: vec![0], triangles: Vec::new() };
    for (part, of) in found.of.chunks(PART).enumerate() {
        control.check()?;
        let of_element = |(i, &shape): (usize, &u32)| {
            let all = full.of(part * PART + i);
            let Some(answer) = answers.get(shape as usize) else { return all.to_vec() };
            let vertices = Local::vertices(all);
            answer[number].iter().map(|t| t.map(|v| vertices[v as usize])).collect()
        };
        let parts: Vec<Vec<[u32; 3]>> =
            of.par_iter().enumerate().with_min_len(256).map(of_element).collect();
        for triangles in parts {
            tier.triangles.extend(triangles);
            tier.starts.push(tier.triangles.len() as u32);
        }
    }
    Ok(tier)
}
