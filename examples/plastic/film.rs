//! The whole act as one glTF file that moves: trees as they came in, each main node a joint.

use crate::draw;
use std::error::Error;
use std::path::Path;
use tree_core::glam::{Quat, Vec3};
use tree_core::{Control, Tree};
use tree_mesh::io::gltf::{GlbOptions, JointPose, Motion, write_glb_moving};
use tree_mesh::{Mesh, Surface};
use tree_model::plastic::{PlasticTree, Scene, TreeId};

/// Seconds from frame to frame.
const STEP: f32 = 0.25;

/// What dies shrinks to this share: programs divide by it.
const GONE: f32 = 1e-3;

pub(crate) struct Film {
    mesh: Mesh,
    motion: Motion,
    /// Each tree with the nodes of the input that are joints.
    cast: Vec<(TreeId, Vec<u32>)>,
    has_wall: bool,
}

impl Film {
    /// Everything in the scene as it came in.
    pub(crate) fn new(
        scene: &Scene,
        trees: &[TreeId],
        wall: Option<(Vec3, Vec3)>,
        control: &Control,
    ) -> Result<Self, Box<dyn Error>> {
        let mut film = Self {
            mesh: Mesh::default(),
            motion: Motion::default(),
            cast: Vec::new(),
            has_wall: wall.is_some(),
        };
        for &id in trees {
            let model = scene.model(id)?;
            let (joints, of_node) = joints(model);
            let first = film.motion.joints.len();
            if first + joints.len() >= usize::from(u16::MAX) {
                return Err("the trees have too many main nodes for one skin".into());
            }
            let mesh = draw::leafy(model.tree(), control)?;
            for surface in &mesh.surfaces {
                let joint = |node: u32| first as u16 + of_node[node as usize];
                let nodes = nodes(model.tree(), surface);
                film.motion.surfaces.push(nodes.into_iter().map(joint).collect());
            }
            let positions = model.tree().skeleton().positions();
            film.motion.joints.extend(joints.iter().map(|&node| positions[node as usize]));
            film.cast.push((id, joints));
            draw::append(&mut film.mesh, mesh, |point| point);
        }
        if let Some((low, high)) = wall {
            let block = draw::block(low, high);
            let joint = film.motion.joints.len() as u16;
            let n = block.surfaces.iter().map(|surface| surface.positions.len());
            film.motion.surfaces.extend(n.map(|n| vec![joint; n]));
            film.motion.joints.push(Vec3::ZERO);
            draw::append(&mut film.mesh, block, |point| point);
        }
        Ok(film)
    }

    /// The scene as it is now, the wall `at` so far along x.
    pub(crate) fn take(&mut self, scene: &Scene, at: f32) -> Result<(), Box<dyn Error>> {
        let mut poses = Vec::with_capacity(self.motion.joints.len());
        for (id, joints) in &self.cast {
            let (motions, pose) = (scene.motions(*id)?, scene.pose(*id)?);
            for &node in joints {
                let motion = motions[node as usize];
                let here = self.motion.joints[poses.len()] + motion.moved;
                poses.push(JointPose {
                    position: pose.rotation * here + pose.position,
                    rotation: (pose.rotation * motion.rotation).normalize(),
                    scale: if motion.alive { 1.0 } else { GONE },
                });
            }
        }
        if self.has_wall {
            let position = Vec3::X * at;
            poses.push(JointPose { position, rotation: Quat::IDENTITY, scale: 1.0 });
        }
        self.motion.times.push(STEP * self.motion.frames.len() as f32);
        self.motion.frames.push(poses);
        Ok(())
    }

    pub(crate) fn write(&self, path: &Path) -> Result<(), Box<dyn Error>> {
        Ok(write_glb_moving(&self.mesh, &self.motion, path, &GlbOptions::default())?)
    }
}

/// The main nodes, and for each node of the tree which of them carries it.
fn joints(model: &PlasticTree) -> (Vec<u32>, Vec<u16>) {
    let parents = model.tree().skeleton().parents();
    let (mut joints, mut of_node) = (Vec::new(), vec![0_u16; parents.len()]);
    for (node, &main) in model.is_main().iter().enumerate() {
        if main {
            of_node[node] = joints.len() as u16;
            joints.push(node as u32);
        } else {
            of_node[node] = of_node[parents[node] as usize];
        }
    }
    (joints, of_node)
}

/// The node each vertex belongs to: leaves by their place, bark by the nearest surface of a node.
fn nodes(tree: &Tree, surface: &Surface) -> Vec<u32> {
    let skeleton = tree.skeleton();
    let nearest = |points: &[Vec3], at: Vec3, radius: &dyn Fn(usize) -> f32| {
        let far = |i: usize| points[i].distance(at) - radius(i);
        (0..points.len()).min_by(|&a, &b| far(a).total_cmp(&far(b))).unwrap_or(0)
    };
    match surface.vertices_per_leaf() {
        Some(n) if n > 0 => {
            let (leaves, places) = (tree.foliage().nodes(), tree.foliage().positions());
            let node = |anchor: &Vec3| leaves[nearest(places, *anchor, &|_| 0.0)];
            surface.anchors.iter().flat_map(|anchor| vec![node(anchor); n]).collect()
        }
        _ => {
            let radius = |node: usize| skeleton.radii()[node];
            let positions = surface.positions.iter();
            positions.map(|&at| nearest(skeleton.positions(), at, &radius) as u32).collect()
        }
    }
}
