//! Groups of occurrences that look alike: k-means (Lloyd 1982) from seeds far apart (k-means++, Arthur
//! & Vassilvitskii 2007), weighted by leaves, and the member nearest to each mean.

use super::describe::{Descriptor, Form, LENGTH};
use crate::error::Result;
use rayon::prelude::*;
use tree_core::seed::uniform;
use tree_core::{Control, Seed};

/// Rounds of moving the means; few move after that.
const ROUNDS: usize = 12;

/// Group of each occurrence, and the occurrence that stands for each group.
#[derive(Clone, Debug, Default)]
pub(super) struct Groups {
    pub(super) of: Vec<u32>,
    pub(super) medoids: Vec<u32>,
}

/// At most `n_max` groups. The same for any number of threads.
pub(super) fn group(forms: &[Form], n_max: usize, seed: Seed, control: &Control) -> Result<Groups> {
    let mut means = seeds(forms, n_max.min(forms.len()), seed, control)?;
    let mut of = assign(forms, &means);
    for _ in 0..ROUNDS {
        control.check()?;
        move_means(forms, &of, &mut means);
        let next = assign(forms, &means);
        if next == of {
            break;
        }
        of = next;
    }
    Ok(medoids(forms, &of, &means))
}

fn apart(a: &Descriptor, b: &Descriptor) -> f32 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

fn weight(form: &Form) -> f64 {
    1.0 + f64::from(form.n_leaves)
}

/// Each seed is drawn with a chance that grows with its weight and squared distance to those before.
fn seeds(forms: &[Form], n: usize, seed: Seed, control: &Control) -> Result<Vec<Descriptor>> {
    let mut rng = seed.stream("twigs").rng();
    let mut nearest = vec![f32::INFINITY; forms.len()];
    let mut seeds: Vec<Descriptor> = Vec::with_capacity(n);
    while seeds.len() < n {
        control.check()?;
        let chance = |(form, &near): (&Form, &f32)| weight(form) * f64::from(near.min(1e6));
        let sum: f64 = forms.iter().zip(&nearest).map(chance).sum();
        if sum <= 0.0 {
            // All others are exactly like one of the seeds.
            break;
        }
        let mut left = f64::from(uniform(&mut rng, 0.0, 1.0)) * sum;
        let drawn = forms.iter().zip(&nearest).find(|&pair| {
            left -= chance(pair);
            left <= 0.0 && chance(pair) > 0.0
        });
        let Some((drawn, _)) = drawn.or(forms.iter().zip(&nearest).next_back()) else { break };
        seeds.push(drawn.descriptor);
        let near = nearest.par_iter_mut().zip(forms);
        near.for_each(|(near, form)| *near = near.min(apart(&form.descriptor, &drawn.descriptor)));
    }
    Ok(seeds)
}

fn assign(forms: &[Form], means: &[Descriptor]) -> Vec<u32> {
    let nearest = |form: &Form| {
        let distances = means.iter().map(|mean| apart(&form.descriptor, mean)).enumerate();
        distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(group, _)| group as u32)
    };
    forms.par_iter().map(nearest).collect()
}

fn move_means(forms: &[Form], of: &[u32], means: &mut [Descriptor]) {
    let mut sums = vec![([0.0_f64; LENGTH], 0.0_f64); means.len()];
    for (form, &group) in forms.iter().zip(of) {
        if let Some((sum, total)) = sums.get_mut(group as usize) {
            let weight = weight(form);
            sum.iter_mut().zip(form.descriptor).for_each(|(s, v)| *s += weight * f64::from(v));
            *total += weight;
        }
    }
    for (mean, (sum, total)) in means.iter_mut().zip(sums).filter(|(_, (_, total))| *total > 0.0) {
        mean.iter_mut().zip(sum).for_each(|(mean, sum)| *mean = (sum / total) as f32);
    }
}

/// The member nearest to each mean; groups without members are left out.
fn medoids(forms: &[Form], of: &[u32], means: &[Descriptor]) -> Groups {
    let mut nearest: Vec<Option<(f32, u32)>> = vec![None; means.len()];
    for (number, (form, &group)) in forms.iter().zip(of).enumerate() {
        let (Some(slot), Some(mean)) = (nearest.get_mut(group as usize), means.get(group as usize))
        else {
            continue;
        };
        let distance = apart(&form.descriptor, mean);
        if slot.is_none_or(|(least, _)| distance < least) {
            *slot = Some((distance, number as u32));
        }
    }
    let mut medoids = Vec::new();
    let mut renamed = vec![0; means.len()];
    for (group, nearest) in nearest.iter().enumerate() {
        if let Some((_, medoid)) = nearest {
            renamed[group] = medoids.len() as u32;
            medoids.push(*medoid);
        }
    }
    let rename = |&group: &u32| renamed.get(group as usize).copied().unwrap_or(0);
    Groups { of: of.iter().map(rename).collect(), medoids }
}
