//! Where trees grow, and how their buds sense it.

use crate::border::{Failure, Result, Versioned, call, get_opt, init, tree_status, vec3s};
use crate::path::obstacle;
use crate::volume::tree_volume;
use glam::Vec3;
use tree_model::growth::{Environment, Shadow, Space, World};
use tree_model::tree_core::{Limits, Resource};

/// How buds sense their surroundings: one of the `TREE_GROWTH_BY_` constants.
pub type tree_growth_environment = u32;
/// By light: leaves shade what is below them. Crowns fill from the outside and self-prune within. The default.
pub const TREE_GROWTH_BY_LIGHT: u32 = 0;
/// By space: buds compete for markers of free space. Branches keep apart, and a crown can be prescribed.
pub const TREE_GROWTH_BY_SPACE: u32 = 1;

/// Where trees grow. Nothing grows below the lowest base. Begin with `tree_growth_world_init`.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tree_growth_world {
    /// `sizeof(tree_growth_world)`.
    pub struct_size: usize,
    /// By space: where there are markers, the crown. Default NULL: everywhere.
    pub crown: *const tree_volume,
    /// What no branch may enter, and what hides the sky. Default NULL.
    pub obstacle: *const tree_volume,
    /// `n_standing` points: metamers that stand there already and shade, or take up space, as those of the plants do:
    /// neighbours, or a tree on which the plants are new branches. Default NULL.
    pub standing: *const f32,
    /// Default 0.
    pub n_standing: usize,
    /// How buds sense. Default `TREE_GROWTH_BY_LIGHT`.
    pub environment: tree_growth_environment,
    /// By light: edge of a voxel in metres, 0.001 to 100; about one and a half internodes. Default 0.2.
    pub shadow_voxel: f32,
    /// By light: shadow in the voxel of the one who casts it, 0 to 4; the open sky gives a light of 1. Default 0.12.
    pub shadow_strength: f32,
    /// By light: what divides the shadow with each layer down, 1 to 10. Default 1.4.
    pub shadow_falloff: f32,
    /// By light: layers below its own that a metamer shades, 0 to 32; cost grows with the cube. Default 7.
    pub shadow_depth: u32,
    /// By light: how many voxels a bud looks around for the brighter side, 1 to 8; cost grows with the cube. Default 3.
    pub shadow_reach: u32,
    /// By space: radius in metres within which a node leaves no marker, 0.001 to 100; about two internodes. Default 0.24.
    pub space_occupancy: f32,
    /// By space: how far a bud sees in metres, 0.001 to 100; four to six internodes. Default 0.6.
    pub space_perception: f32,
    /// By space: half the angle of a bud's view in radians, 0.01 to π. Default π/4.
    pub space_angle: f32,
    /// By space: markers in a cube of the perception radius, 0.1 to 4096. Default 50.
    pub space_density: f32,
    /// Towards the brightest point of the sky; any length but 0. Default 0, 1, 0.
    pub light: [f32; 3],
    /// Light of the open sky, 0 (nothing grows) to 10. Default 1.
    pub brightness: f32,
    /// Distance to keep from the obstacle in metres, 0 or more. Default 0.
    pub clearance: f32,
    /// 0.
    pub reserved: u32,
}

// SAFETY: repr(C), begins with its size, and holds numbers and pointers only.
unsafe impl Versioned for tree_growth_world {
    const NAME: &'static str = "tree_growth_world";
    const FIRST: usize = size_of::<Self>();
    fn default_value() -> Self {
        Self::of(&World::default())
    }
}

impl tree_growth_world {
    /// The world in C's form, but for its volumes; fields of the other way of sensing have their defaults.
    pub(super) fn of(world: &World) -> Self {
        let (mut shadow, mut space) = (Shadow::default(), Space::default());
        let environment = match &world.environment {
            Environment::Shadow(own) => {
                shadow = *own;
                TREE_GROWTH_BY_LIGHT
            }
            Environment::Space(own) => {
                space = own.clone();
                TREE_GROWTH_BY_SPACE
            }
        };
        Self {
            struct_size: size_of::<Self>(),
            crown: std::ptr::null(),
            obstacle: std::ptr::null(),
            environment,
            shadow_voxel: shadow.voxel,
            shadow_strength: shadow.strength,
            shadow_falloff: shadow.falloff,
            shadow_depth: shadow.depth,
            shadow_reach: shadow.reach,
            space_occupancy: space.occupancy,
            space_perception: space.perception,
            space_angle: space.angle,
            space_density: space.density,
            light: world.light.to_array(),
            brightness: world.brightness,
            standing: std::ptr::null(),
            n_standing: 0,
            clearance: 0.0,
            reserved: 0,
        }
    }

    /// The world in Rust's form, not yet checked against its ranges.
    pub(super) unsafe fn rust(&self, name: &str) -> Result<World> {
        let part = |field: &str| format!("{name}.{field}");
        let environment = match self.environment {
            TREE_GROWTH_BY_LIGHT => Environment::Shadow(Shadow {
                voxel: self.shadow_voxel,
                strength: self.shadow_strength,
                falloff: self.shadow_falloff,
                depth: self.shadow_depth,
                reach: self.shadow_reach,
            }),
            TREE_GROWTH_BY_SPACE => Environment::Space(Space {
                occupancy: self.space_occupancy,
                perception: self.space_perception,
                angle: self.space_angle,
                density: self.space_density,
                crown: unsafe { get_opt(self.crown, &part("crown")) }?
                    .map(|crown| crown.rust().clone()),
            }),
            other => {
                return Err(Failure::not_one_of(&part("environment"), other, "TREE_GROWTH_BY_"));
            }
        };
        Ok(World {
            environment,
            light: Vec3::from(self.light),
            brightness: self.brightness,
            obstacle: unsafe { obstacle(self.obstacle, self.clearance, &part("obstacle")) }?,
            standing: unsafe {
                let (limits, name) = (Limits::default(), part("standing"));
                vec3s(self.standing, self.n_standing, &limits, Resource::Nodes, &name)?.to_vec()
            },
        })
    }
}

/// Makes `world`, of `size` bytes, the default: open and lit from above.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_growth_world_init(
    world: *mut tree_growth_world,
    size: usize,
) -> tree_status {
    call(|| unsafe { init(world, size) })
}
