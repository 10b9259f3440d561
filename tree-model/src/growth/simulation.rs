//! Year by year: all trees of a stand sense, share, grow and shed together.

use super::allocation::{Total, gather, share_out};
use super::finish::{Grown, YearReport};
use super::habit::Habit;
use super::params::{MAX_ITERATIONS, MAX_PLANTS};
use super::shoot::{Order, across, bud_direction};
use super::stem::{BUD, Budding, Metamer, Shoot, Stem};
use super::surroundings::{Found, Surroundings, World};
use crate::error::{ModelError, Result, check, check_finite};
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, ParameterError, Resource, Seed};

/// A tree to be, and where it stands.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct Plant {
    /// Its kind.
    pub habit: Habit,
    /// Where it stands, in metres. Default the origin.
    pub base: Vec3,
    /// Direction of its first internode; any length but 0. Default +Y.
    pub direction: Vec3,
}

impl Default for Plant {
    fn default() -> Self {
        Self { habit: Habit::default(), base: Vec3::ZERO, direction: Vec3::Y }
    }
}

/// A tree in the middle of its growth.
#[derive(Clone, Debug)]
pub(super) struct Growing {
    pub(super) habit: Habit,
    pub(super) stem: Stem,
    pub(super) seed: Seed,
    pub(super) years: Vec<YearReport>,
    /// Iterations it has grown for.
    age: u32,
    totals: Vec<Total>,
    vigour: Vec<f32>,
}

/// A stand of trees, grown iteration by iteration.
///
/// ```
/// use tree_model::growth::{Plant, Simulation, World};
/// use tree_model::tree_core::{Control, Seed};
/// let control = Control::default();
/// let mut stand =
///     Simulation::new(&World::default(), &[Plant::default()], Seed(1), &control)?;
/// for _ in 0..5 {
///     stand.step(&control)?;
/// }
/// let young = stand.grown(0, &control)?;
/// stand.step(&control)?;
/// assert!(stand.n_nodes() > young.tree.skeleton().len());
/// # Ok::<(), tree_model::ModelError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Simulation {
    plants: Vec<Growing>,
    surroundings: Surroundings,
    iteration: u32,
}

/// Grows several trees that compete for the same light or space; in the order they were planted.
///
/// # Errors
/// As [`Simulation::new`] and [`Simulation::step`], and of leaves and radii as
/// [`GrowthParams::grow`](super::GrowthParams::grow).
///
/// # Complexity
/// Linear in nodes times iterations; with obstacles also in the part of the lattice that trees reach.
pub fn grow_stand(
    world: &World,
    plants: &[Plant],
    iterations: u32,
    seed: Seed,
    control: &Control,
) -> Result<Vec<Grown>> {
    check("iterations", iterations, 0, MAX_ITERATIONS)?;
    let growing = control.part(0.0, 0.8);
    let mut simulation = Simulation::new(world, plants, seed, control)?;
    for iteration in 0..iterations {
        growing.report("growth", iteration as f32 / iterations as f32)?;
        simulation.step(&growing)?;
    }
    let finishing = control.part(0.8, 1.0);
    let n = plants.len().max(1) as f32;
    let grown = (0..plants.len()).map(|index| {
        finishing.report("leaves", index as f32 / n)?;
        simulation.grown(index, control)
    });
    let grown = grown.collect::<Result<Vec<_>>>()?;
    control.report("done", 1.0)?;
    Ok(grown)
}

impl Simulation {
    /// Plants seedlings: a base and one internode each.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] or [`ModelError::NotFinite`], naming the field;
    /// [`ModelError::RootBlocked`] where a seedling stands in the obstacle; [`ModelError::Limit`];
    /// [`ModelError::Cancelled`].
    pub fn new(world: &World, plants: &[Plant], seed: Seed, control: &Control) -> Result<Self> {
        check("plants.len()", plants.len() as f64, 1, MAX_PLANTS as f64)?;
        world.validate()?;
        for (i, plant) in plants.iter().enumerate() {
            plant.validate().map_err(|error| in_plant(i, error))?;
        }
        control.limits.check(Resource::Nodes, 2 * plants.len() as u64)?;
        let ground = plants.iter().map(|plant| plant.base.y).fold(f32::INFINITY, f32::min);
        let mut surroundings = Surroundings::new(world, ground, seed)?;
        let growing = seed.stream("plants");
        let mut seedlings = Vec::with_capacity(plants.len());
        for (i, plant) in (0..).zip(plants) {
            control.check()?;
            let seedling = Growing::seedling(plant, growing.child(i))?;
            let [from, to] = [seedling.stem.positions[0], seedling.stem.positions[1]];
            if world.obstacle.as_ref().is_some_and(|obstacle| !obstacle.is_free(from, to)) {
                return Err(ModelError::RootBlocked { root: plant.base });
            }
            seedlings.push(seedling);
        }
        surroundings.add(&world.standing, &control.limits)?;
        let leaves: Vec<Vec3> = seedlings.iter().map(|plant| plant.stem.positions[1]).collect();
        surroundings.add(&leaves, &control.limits)?;
        Ok(Self { plants: seedlings, surroundings, iteration: 0 })
    }

    /// Iterations done.
    #[must_use]
    pub fn iteration(&self) -> u32 {
        self.iteration
    }

    /// Nodes of all trees, bases included.
    #[must_use]
    pub fn n_nodes(&self) -> usize {
        self.plants.iter().map(|plant| plant.stem.len()).sum()
    }

    /// Number of trees.
    #[must_use]
    pub fn n_plants(&self) -> usize {
        self.plants.len()
    }

    /// Light at a point as it is now: 0 to the world's brightness.
    #[must_use]
    pub fn light(&self, point: Vec3) -> f32 {
        self.surroundings.light(point, false)
    }

    /// One iteration: sense, share, grow, shed.
    ///
    /// # Errors
    /// [`ModelError::Limit`] before more nodes or voxels are made than allowed; [`ModelError::Cancelled`];
    /// [`ModelError::Parameter`] after [`MAX_ITERATIONS`]. The simulation is then as far as it got: its
    /// trees are valid, but other calls would go on from a half-done iteration.
    ///
    /// # Complexity
    /// O(nodes + new nodes · depth³) with shadows, O(buds · markers in sight) with markers.
    pub fn step(&mut self, control: &Control) -> Result<()> {
        check("iterations", self.iteration.saturating_add(1), 0, MAX_ITERATIONS)?;
        control.check()?;
        self.iteration += 1;
        for plant in &mut self.plants {
            plant.age += 1;
            plant.stem.age_buds(plant.age, plant.habit.bud_life);
        }
        let found = self.surroundings.sense(&self.plants, control)?;
        control.check()?;
        let surroundings = &self.surroundings;
        let plans: Vec<(Vec<Shoot>, Vec<bool>)> = self
            .plants
            .par_iter_mut()
            .zip(found)
            .map(|(plant, found)| {
                let shoots = plant.plan(&found, surroundings);
                (shoots, plant.weak())
            })
            .collect();
        let new = plans.iter().flat_map(|(shoots, _)| shoots).map(|s| s.metamers.len() as u64);
        let n_nodes = self.n_nodes() as u64 + new.sum::<u64>();
        control.limits.check(Resource::Nodes, n_nodes)?;
        control.check()?;
        let (mut grown, mut bare) = (Vec::new(), Vec::new());
        for (plant, (shoots, weak)) in self.plants.iter_mut().zip(plans) {
            plant.shed(&weak, &mut bare);
            plant.add(&shoots, &weak, &mut grown);
            plant.drop_leaves(&mut bare);
            plant.compact(&weak);
        }
        self.surroundings.add(&grown, &control.limits)?;
        self.surroundings.bare(&bare);
        Ok(())
    }

    /// The tree as it is now, with radii, leaves and ages.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] for an index beyond the plants; of radii and leaves as
    /// [`GrowthParams::grow`](super::GrowthParams::grow).
    ///
    /// # Complexity
    /// O(nodes + leaves).
    pub fn grown(&self, index: usize, control: &Control) -> Result<Grown> {
        let n_plants = self.plants.len() as f64;
        let Some(plant) = self.plants.get(index) else {
            let (found, min, max) = (index as f64, 0.0, n_plants - 1.0);
            return Err(ParameterError { field: "index".into(), found, min, max }.into());
        };
        plant.finish(control)
    }
}

impl Plant {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] or [`ModelError::NotFinite`], naming the field.
    pub fn validate(&self) -> Result<()> {
        self.habit.validate()?;
        check_finite("base", self.base)?;
        check("base.length()", self.base.length(), 0, 1e6)?;
        check_finite("direction", self.direction)?;
        check("direction.length()", self.direction.length(), 1e-6, f32::MAX)
    }
}

impl Growing {
    fn seedling(plant: &Plant, seed: Seed) -> Result<Self> {
        let habit = plant.habit.clone();
        let direction = plant.direction.normalize_or(Vec3::Y);
        let side = across(direction);
        let base = Metamer { position: plant.base, direction, side };
        let mut stem = Stem::new(base, habit.buds.per_node() as usize);
        let first = Metamer { position: plant.base + habit.internode * direction, ..base };
        let shoot = Shoot { node: 0, slot: 0, metamers: vec![first], blocked: false };
        stem.append(&shoot, 0, budding(&habit));
        let (years, totals, vigour) = (Vec::new(), Vec::new(), Vec::new());
        Ok(Self { habit, stem, seed, years, age: 0, totals, vigour })
    }

    /// Iterations it has grown for.
    pub(super) fn age(&self) -> u32 {
        self.age
    }

    pub(super) fn each_bud(&self, mut visit: impl FnMut(usize, usize)) {
        for node in 0..self.stem.len() {
            for (slot, _) in self.stem.ends_of(node).iter().enumerate().filter(|&(_, &e)| e == BUD)
            {
                visit(node, slot);
            }
        }
    }

    pub(super) fn bud_direction(&self, node: usize, slot: usize) -> Vec3 {
        match slot {
            0 => self.stem.directions[node],
            _ => bud_direction(&self.metamer(node), &self.habit, slot, self.habit.angle),
        }
    }

    fn metamer(&self, node: usize) -> Metamer {
        Metamer {
            position: self.stem.positions[node],
            direction: self.stem.directions[node],
            side: self.stem.sides[node],
        }
    }

    /// Whether a node's leaves shade. The base has none.
    pub(super) fn is_leafy(&self, node: usize) -> bool {
        node > 0 && self.age.saturating_sub(self.stem.born[node]) <= self.habit.leaf_life
    }

    /// Shares vigour by what the buds found, and grows the shoots that follow from it.
    fn plan(&mut self, found: &Found, surroundings: &Surroundings) -> Vec<Shoot> {
        gather(&self.stem, &found.quality, &mut self.totals);
        let light = self.totals[0].light;
        let base = self.habit.vigour * light;
        let sensed = (found.quality.as_slice(), self.totals.as_slice());
        share_out(&self.stem, &self.habit.allocation, self.age, base, sensed, &mut self.vigour);
        let orders = self.orders(found);
        let stream = self.seed.child(u64::from(self.age));
        let shoots: Vec<Shoot> = orders
            .par_iter()
            .with_min_len(64)
            .map(|order| {
                let bud = order.node as usize * self.stem.width() + order.slot;
                let mut rng = stream.child(bud as u64).rng();
                let from = self.metamer(order.node as usize);
                order.grow(from, &self.habit, surroundings, &mut rng)
            })
            .collect();
        self.years.push(YearReport {
            light,
            n_buds: self.totals[0].n_buds,
            n_shoots: shoots.iter().filter(|shoot| !shoot.metamers.is_empty()).count() as u32,
            n_blocked: shoots.iter().filter(|shoot| shoot.blocked).count() as u32,
            ..YearReport::default()
        });
        shoots
    }

    /// The buds with a vigour of 1 and more.
    fn orders(&self, found: &Found) -> Vec<Order> {
        let mut orders = Vec::new();
        self.each_bud(|node, slot| {
            let row = node * self.stem.width() + slot;
            let vigour = self.vigour[row];
            if vigour < 1.0 {
                return;
            }
            let n_metamers = vigour.min(self.habit.max_shoot as f32) as u32;
            // All of the vigour makes length, but no more than twice that of a whole one.
            let stretch = (vigour / n_metamers as f32).min(2.0);
            orders.push(Order {
                node: node as u32,
                slot,
                n_metamers,
                internode: self.habit.internode * stretch,
                axis_order: self.stem.orders[node].saturating_add(u8::from(slot > 0)),
                pull: found.pulls.get(row).copied(),
            });
        });
        orders
    }

    /// Which nodes lie on branches that find too little light for their size, by the sums of this iteration.
    fn weak(&self) -> Vec<bool> {
        let stem = &self.stem;
        let mut weak = vec![false; stem.len()];
        for node in 1..stem.len() {
            let parent = stem.parents[node] as usize;
            let is_branch = stem.ends_of(parent).first() != Some(&(node as u32));
            let total = &self.totals[node];
            weak[node] = weak[parent]
                || is_branch
                    && self.age - stem.born[node] >= self.habit.shedding_age
                    && total.light < self.habit.shedding * total.n_metamers as f32;
        }
        weak
    }

    /// Notes the leaves that go with the shed nodes and would have lasted beyond this iteration.
    fn shed(&self, weak: &[bool], bare: &mut Vec<Vec3>) {
        let is_leafy = |node: usize| self.age - self.stem.born[node] < self.habit.leaf_life;
        let shed = (1..weak.len()).filter(|&node| weak[node] && is_leafy(node));
        bare.extend(shed.map(|node| self.stem.positions[node]));
    }

    /// Appends the shoots, but for those on branches that are shed.
    fn add(&mut self, shoots: &[Shoot], weak: &[bool], grown: &mut Vec<Vec3>) {
        let budding = budding(&self.habit);
        let first = self.stem.len();
        for shoot in shoots.iter().filter(|shoot| !weak[shoot.node as usize]) {
            self.stem.append(shoot, self.age, budding);
        }
        grown.extend_from_slice(&self.stem.positions[first..]);
    }

    /// Notes the leaves that end with this iteration.
    fn drop_leaves(&self, bare: &mut Vec<Vec3>) {
        let last = (1..self.stem.len())
            .filter(|&node| self.age - self.stem.born[node] == self.habit.leaf_life);
        bare.extend(last.map(|node| self.stem.positions[node]));
    }

    /// Removes what was shed.
    fn compact(&mut self, weak: &[bool]) {
        let n_shed = weak.iter().filter(|&&weak| weak).count();
        if n_shed > 0 {
            let is_kept = |node| !weak.get(node).copied().unwrap_or(false);
            let keep: Vec<bool> = (0..self.stem.len()).map(is_kept).collect();
            self.stem.retain(&keep);
        }
        if let Some(year) = self.years.last_mut() {
            year.n_nodes = self.stem.len() as u32;
            year.n_shed = n_shed as u32;
        }
    }
}

fn budding(habit: &Habit) -> Budding {
    Budding { zone: habit.bud_zone, max_order: habit.max_order }
}

/// The same error, its field named as part of a plant.
fn in_plant(index: usize, error: ModelError) -> ModelError {
    match error {
        ModelError::Parameter(error) => error.within(&format!("plants[{index}]")).into(),
        ModelError::NotFinite { field } => {
            ModelError::NotFinite { field: format!("plants[{index}].{field}") }
        }
        other => other,
    }
}
