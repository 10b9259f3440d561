//! What buds sense: the world's part of the growth model.

use super::light::{Shadow, ShadowGrid};
use super::markers::{Markers, Space, Watcher};
use super::simulation::Growing;
use super::sky::Sky;
use super::stem::BUD;
use crate::error::{ModelError, Result, check, check_finite};
use crate::path::Obstacle;
use glam::Vec3;
use rayon::prelude::*;
use tree_core::{Control, Limits, Seed};

/// Spacing of the points from which the sky is looked at, in voxels or half perception radii.
const SKY_SPACING: f32 = 4.0;

/// How buds sense their surroundings.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Environment {
    /// By light: shadow propagation. Crowns fill from the outside and self-prune within.
    Shadow(Shadow),
    /// By space: markers. Branches keep apart, and a crown can be prescribed.
    Space(Space),
}

impl Default for Environment {
    fn default() -> Self {
        Self::Shadow(Shadow::default())
    }
}

/// Where trees grow. Nothing grows below the lowest base.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
pub struct World {
    /// How buds sense.
    pub environment: Environment,
    /// Towards the brightest point of the sky; any length but 0. Default +Y.
    pub light: Vec3,
    /// Light of the open sky, 0 (nothing grows) to 10. Default 1.
    pub brightness: f32,
    /// What no branch may enter, and what hides the sky. Default `None`.
    pub obstacle: Option<Obstacle>,
    /// Metamers that stand there already and shade, or take up space, as those of the plants do: neighbours, or a tree on which
    /// the plants are new branches. Default none.
    pub standing: Vec<Vec3>,
}

impl Default for World {
    fn default() -> Self {
        Self {
            environment: Environment::default(),
            light: Vec3::Y,
            brightness: 1.0,
            obstacle: None,
            standing: Vec::new(),
        }
    }
}

impl World {
    /// Checks all ranges.
    ///
    /// # Errors
    /// [`ModelError::Parameter`] or [`ModelError::NotFinite`], naming the field.
    pub fn validate(&self) -> Result<()> {
        match &self.environment {
            Environment::Shadow(shadow) => shadow.validate()?,
            Environment::Space(space) => space.validate()?,
        }
        check_finite("world.light", self.light)?;
        if self.light.try_normalize().is_none() {
            check("world.light.length()", self.light.length(), f32::MIN_POSITIVE, f32::MAX)?;
        }
        check("world.brightness", self.brightness, 0, 10)?;
        if let Some(place) = self.standing.iter().position(|point| !point.is_finite()) {
            return Err(ModelError::NotFinite { field: format!("world.standing[{place}]") });
        }
        self.obstacle.as_ref().map_or(Ok(()), Obstacle::validate)
    }
}

/// What the buds of one tree found, a row for each end.
#[derive(Clone, Debug, Default)]
pub(super) struct Found {
    pub(super) quality: Vec<f32>,
    /// Directions to the space won; empty where shadows decide.
    pub(super) pulls: Vec<Vec3>,
}

#[derive(Clone, Debug)]
enum Field {
    Shadows(Box<ShadowGrid>),
    Markers(Box<Markers>),
}

/// The world as it is at one time.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    field: Field,
    pub(super) sky: Sky,
    brightness: f32,
    pub(super) obstacle: Option<Obstacle>,
    pub(super) ground: f32,
}

impl Surroundings {
    pub(super) fn new(world: &World, ground: f32, seed: Seed) -> Result<Self> {
        world.validate()?;
        let obstacle = world.obstacle.as_ref();
        let (field, edge) = match &world.environment {
            Environment::Shadow(shadow) => {
                let grid = ShadowGrid::new(shadow, world.light)?;
                (Field::Shadows(Box::new(grid)), shadow.voxel)
            }
            Environment::Space(space) => {
                let markers = Markers::new(space, obstacle, ground, seed.stream("markers"))?;
                (Field::Markers(Box::new(markers)), 0.5 * space.perception)
            }
        };
        let sky = Sky::new(world.light, obstacle, SKY_SPACING * edge);
        let (brightness, obstacle) = (world.brightness, obstacle.cloned());
        Ok(Self { field, sky, brightness, obstacle, ground })
    }

    /// New nodes: their leaves shade, or their bodies take up space.
    pub(super) fn add(&mut self, points: &[Vec3], limits: &Limits) -> Result<()> {
        self.sky.cover(points);
        match &mut self.field {
            Field::Shadows(grid) => grid.cast(points, limits),
            Field::Markers(markers) => markers.occupy(points, limits),
        }
    }

    /// Nodes that have lost their leaves. Space that was taken once stays empty.
    pub(super) fn bare(&mut self, points: &[Vec3]) {
        if let Field::Shadows(grid) = &mut self.field {
            grid.lift(points);
        }
    }

    /// Light at a point, 0 to the brightness; `own` shadows at the point itself do not count.
    pub(super) fn light(&self, point: Vec3, own: bool) -> f32 {
        let sky = self.brightness * response(self.sky.at(point).share);
        let shadow = match &self.field {
            Field::Shadows(grid) => {
                let own = if own { grid.shadow().strength } else { 0.0 };
                (grid.at(point) - own).max(0.0)
            }
            Field::Markers(_) => 0.0,
        };
        (sky - shadow).max(0.0)
    }

    /// The direction to grow in from a point for most light, by the shadows and by the sky; at most of
    /// length 1. `pull` is what a bud has won of space, which then takes the place of shadows.
    pub(super) fn pull(&self, point: Vec3, pull: Option<Vec3>) -> Vec3 {
        let near = match (&self.field, pull) {
            (Field::Shadows(grid), None) => grid.brighter(point),
            (_, pull) => pull.unwrap_or(Vec3::ZERO),
        };
        // Beside a wall about a third of the mean direction is missing.
        let away = self.sky.at(point).mean - self.sky.open().mean;
        (near + SKY_PULL * away).clamp_length_max(1.0)
    }

    /// What the buds of all plants find.
    pub(super) fn sense(&mut self, plants: &[Growing], control: &Control) -> Result<Vec<Found>> {
        let Self { field: Field::Markers(markers), sky, brightness, .. } = self else {
            return Ok(plants.iter().map(|plant| self.sense_light(plant)).collect());
        };
        let mut watchers = Vec::new();
        for plant in plants {
            plant.each_bud(|node, slot| {
                let direction = plant.bud_direction(node, slot);
                watchers.push(Watcher { position: plant.stem.positions[node], direction });
            });
        }
        control.check()?;
        let mut won = markers.compete(&watchers, &control.limits)?.into_iter();
        let found = plants.iter().map(|plant| {
            let n_ends = plant.stem.ends().len();
            let mut found = Found { quality: vec![0.0; n_ends], pulls: vec![Vec3::ZERO; n_ends] };
            plant.each_bud(|node, slot| {
                let row = node * plant.stem.width() + slot;
                let pull = won.next().unwrap_or(Vec3::ZERO);
                found.pulls[row] = pull;
                if pull != Vec3::ZERO {
                    let share = sky.at(plant.stem.positions[node]).share;
                    found.quality[row] = *brightness * response(share);
                }
            });
            found
        });
        Ok(found.collect())
    }

    fn sense_light(&self, plant: &Growing) -> Found {
        let stem = &plant.stem;
        let mut quality = vec![0.0; stem.ends().len()];
        quality
            .par_chunks_exact_mut(stem.width())
            .enumerate()
            .with_min_len(1024)
            .filter(|(node, _)| stem.has_bud(*node))
            .for_each(|(node, row)| {
                let light = self.light(stem.positions[node], plant.is_leafy(node));
                for (quality, &end) in row.iter_mut().zip(stem.ends_of(node)) {
                    if end == BUD {
                        *quality = light;
                    }
                }
            });
        Found { quality, pulls: Vec::new() }
    }
}

/// What leaves make of a share of the sky: they saturate, and half of it is worth five sixths of the whole.
fn response(share: f32) -> f32 {
    share * (1.0 + SATURATION) / (share + SATURATION)
}

/// Share of the sky whose worth is half of what endless light would give. Without saturation a tree beside a wall,
/// which sees half of the sky, would stop growing at the vigour of a healthy tree.
const SATURATION: f32 = 0.25;

/// Weight of the missing part of the sky against the shadows nearby.
const SKY_PULL: f32 = 2.0;
