//! A mesh that moves: a skin whose joints go from key frame to key frame.

use super::write::{Column, FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT, VERTICES, Writer, push};
use super::write::{check, push_floats};
use super::{GlbOptions, container};
use crate::error::{MeshError, Result};
use crate::mesh::{Mesh, Surface};
use glam::{Quat, Vec3};
use serde_json::{Value, json};
use std::path::Path;
use tree_core::{CoreError, file};

/// Most joints that 16 bits can name.
const JOINTS_MAX: usize = 65_536;

/// How a mesh moves: each vertex with one joint, each joint from frame to frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    /// Where each joint is in the mesh as it stands, in metres; 1 to 65,536.
    pub joints: Vec<Vec3>,
    /// For each surface of the mesh the joint of each vertex.
    pub surfaces: Vec<Vec<u16>>,
    /// Seconds, from 0 on, ascending.
    pub times: Vec<f32>,
    /// For each time where each joint is then.
    pub frames: Vec<Vec<JointPose>>,
}

/// Where a joint is: what stood at p is at `position + rotation * (scale * (p - joint))`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPose {
    /// In metres.
    pub position: Vec3,
    /// Of length 1.
    pub rotation: Quat,
    /// 0 or more.
    pub scale: f32,
}

impl Motion {
    /// Checks that it fits the mesh.
    ///
    /// # Errors
    /// [`MeshError::Motion`] saying what does not fit, and where.
    pub fn check(&self, mesh: &Mesh) -> Result<()> {
        let fail = |problem: String| Err(MeshError::Motion(problem));
        let n_joints = self.joints.len();
        if !(1..=JOINTS_MAX).contains(&n_joints) {
            return fail(format!("{n_joints} joints, 1 to {JOINTS_MAX} can be written"));
        }
        if let Some(joint) = self.joints.iter().position(|at| !at.is_finite()) {
            return fail(format!("joint {joint} is not finite"));
        }
        let (found, expected) = (self.surfaces.len(), mesh.surfaces.len());
        if found != expected {
            return fail(format!("joints for {found} surfaces, the mesh has {expected}"));
        }
        for (number, (joints, surface)) in self.surfaces.iter().zip(&mesh.surfaces).enumerate() {
            let (found, expected) = (joints.len(), surface.positions.len());
            if found != expected {
                return fail(format!("surface {number}: {found} joints, {expected} vertices"));
            }
            if let Some(joint) = joints.iter().find(|&&joint| usize::from(joint) >= n_joints) {
                return fail(format!("surface {number}: joint {joint}, there are {n_joints}"));
            }
        }
        let (found, expected) = (self.frames.len(), self.times.len());
        if found != expected || found == 0 {
            return fail(format!("{found} frames at {expected} times, as many of each are needed"));
        }
        let mut last = -f32::MIN_POSITIVE;
        for (frame, (&time, poses)) in self.times.iter().zip(&self.frames).enumerate() {
            if !time.is_finite() || time <= last {
                return fail(format!("time {frame} is {time}, times ascend from 0"));
            }
            last = time;
            if poses.len() != n_joints {
                return fail(format!("frame {frame}: {} poses, {n_joints} joints", poses.len()));
            }
            if let Some(joint) = poses.iter().position(|pose| !pose.is_sound()) {
                return fail(format!(
                    "frame {frame}, joint {joint}: not finite, not a rotation, or a scale below 0"
                ));
            }
        }
        Ok(())
    }
}

impl JointPose {
    fn is_sound(&self) -> bool {
        self.position.is_finite()
            && self.rotation.is_finite()
            && (self.rotation.length_squared() - 1.0).abs() < 1e-3
            && self.scale.is_finite()
            && self.scale >= 0.0
    }
}

/// Writes a mesh that moves to a GLB file, whole or not at all.
///
/// # Errors
/// As [`to_glb_moving`], and [`MeshError::Core`] when the file cannot be written.
pub fn write_glb_moving(
    mesh: &Mesh,
    motion: &Motion,
    path: impl AsRef<Path>,
    options: &GlbOptions,
) -> Result<()> {
    let (path, bytes) = (path.as_ref(), to_glb_moving(mesh, motion, options)?);
    file::write_atomic(path, |out| {
        out.write_all(&bytes).map_err(|error| CoreError::io(path, error).into())
    })
}

/// A mesh that moves as the bytes of a GLB file: a skin and one animation, linear between frames. Joints that stay where they are
/// have no channels. Positions are not quantised, whatever the options say: a skin has no place for the scale.
///
/// # Errors
/// As [`to_glb_levels`](super::to_glb_levels) and [`Motion::check`].
///
/// # Complexity
/// O(vertices + triangles + pixels + joints · frames).
pub fn to_glb_moving(mesh: &Mesh, motion: &Motion, options: &GlbOptions) -> Result<Vec<u8>> {
    check(&[mesh.into()])?;
    motion.check(mesh)?;
    let mut writer = Writer::new(options);
    let number = writer.mesh(mesh, &options.name, None, &[])?;
    writer.bind(number, mesh, motion)?;
    let first = writer.nodes.len();
    for at in &motion.joints {
        push(&mut writer.nodes, json!({ "translation": at.to_array() }));
    }
    let joints: Vec<usize> = (first..writer.nodes.len()).collect();
    let name = format!("{} joints", options.name);
    let root = push(&mut writer.nodes, json!({ "name": name, "children": joints }));
    let inverse = writer.column(Column::plain(joints.len(), FLOAT, "MAT4"), None, |bytes| {
        for at in &motion.joints {
            let matrix = glam::Mat4::from_translation(-*at);
            push_floats(bytes, matrix.to_cols_array());
        }
    })?;
    let skin = json!({ "joints": joints, "skeleton": root, "inverseBindMatrices": inverse });
    let skin = push(&mut writer.skins, skin);
    let body = json!({ "name": options.name, "mesh": number, "skin": skin });
    let body = push(&mut writer.nodes, body);
    writer.animate(first, motion)?;
    let pack = writer.finish(&[body, root], None)?;
    container::join(&pack.json, &pack.binary)
}

impl Writer<'_> {
    /// Ties the vertices of a mesh to their joints.
    fn bind(&mut self, number: usize, mesh: &Mesh, motion: &Motion) -> Result<()> {
        let drawn = |(surface, _): &(&Surface, &Vec<u16>)| surface.n_triangles() > 0;
        let surfaces = mesh.surfaces.iter().zip(&motion.surfaces).filter(drawn);
        for (place, (_, joints)) in surfaces.enumerate() {
            let n = joints.len();
            let rows = Column::plain(n, UNSIGNED_SHORT, "VEC4");
            let named = self.column(rows, Some(VERTICES), |bytes| {
                for joint in joints {
                    bytes.extend_from_slice(&joint.to_le_bytes());
                    bytes.extend_from_slice(&[0; 6]);
                }
            })?;
            let rows = Column::normalized(n, UNSIGNED_BYTE, "VEC4");
            let weights = self.column(rows, Some(VERTICES), |bytes| {
                for _ in joints {
                    bytes.extend_from_slice(&[255, 0, 0, 0]);
                }
            })?;
            let attributes = &mut self.meshes[number]["primitives"][place]["attributes"];
            attributes["JOINTS_0"] = named.into();
            attributes["WEIGHTS_0"] = weights.into();
        }
        Ok(())
    }

    fn animate(&mut self, first: usize, motion: &Motion) -> Result<()> {
        let n = motion.times.len();
        let ends = [motion.times.first(), motion.times.last()].map(|time| json!([time]));
        let [min, max] = ends;
        let times = Column { min_max: Some((min, max)), ..Column::plain(n, FLOAT, "SCALAR") };
        let input =
            self.column(times, None, |bytes| push_floats(bytes, motion.times.iter().copied()))?;
        let (mut samplers, mut channels) = (Vec::new(), Vec::new());
        for joint in 0..motion.joints.len() {
            let poses: Vec<JointPose> = motion.frames.iter().map(|frame| frame[joint]).collect();
            for (path, shape, values) in tracks(motion.joints[joint], &poses) {
                let output = self.column(Column::plain(n, FLOAT, shape), None, |bytes| {
                    push_floats(bytes, values);
                })?;
                let sampler = push(&mut samplers, json!({ "input": input, "output": output }));
                let target = json!({ "node": first + joint, "path": path });
                channels.push(json!({ "sampler": sampler, "target": target }));
            }
        }
        if !channels.is_empty() {
            let animation = json!({
                "name": self.options.name, "samplers": samplers, "channels": channels,
            });
            self.animations.push(Value::clone(&animation));
        }
        Ok(())
    }
}

/// What of a joint changes: path, shape and numbers.
fn tracks(rest: Vec3, poses: &[JointPose]) -> Vec<(&'static str, &'static str, Vec<f32>)> {
    let mut tracks = Vec::new();
    if poses.iter().any(|pose| pose.position != rest) {
        let values = poses.iter().flat_map(|pose| pose.position.to_array()).collect();
        tracks.push(("translation", "VEC3", values));
    }
    if poses.iter().any(|pose| pose.rotation != Quat::IDENTITY) {
        let mut last = Quat::IDENTITY;
        let mut values = Vec::with_capacity(4 * poses.len());
        for pose in poses {
            // The near one of two quaternions for the same turn.
            let turn = if pose.rotation.dot(last) < 0.0 { -pose.rotation } else { pose.rotation };
            last = turn.normalize();
            values.extend(last.to_array());
        }
        tracks.push(("rotation", "VEC4", values));
    }
    if poses.iter().any(|pose| pose.scale != 1.0) {
        let values = poses.iter().flat_map(|pose| [pose.scale; 3]).collect();
        tracks.push(("scale", "VEC3", values));
    }
    tracks
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Look, MeshParams, build};
    use ::gltf::animation::util::ReadOutputs;
    use tree_core::{Control, Skeleton, Species, Tree};

    fn moving() -> (Mesh, Motion) {
        let mut builder = Skeleton::builder(Vec3::ZERO, 0.3).unwrap();
        builder.add(0, Vec3::Y * 2.0, 0.2).unwrap();
        let tree = Tree::bare(builder.finish(), Species::default());
        let look = Look::plain(tree.species());
        let mesh = build(&tree, &look, &MeshParams::default(), &Control::default()).unwrap().mesh;
        let high = |at: &Vec3| u16::from(at.y > 1.0);
        let surfaces = mesh
            .surfaces
            .iter()
            .map(|surface| surface.positions.iter().map(high).collect())
            .collect();
        let still = JointPose { position: Vec3::ZERO, rotation: Quat::IDENTITY, scale: 1.0 };
        let up = JointPose { position: Vec3::Y * 2.0, ..still };
        let gone = JointPose {
            position: Vec3::new(0.5, 1.9, 0.0),
            rotation: Quat::from_rotation_z(-0.3),
            scale: 0.5,
        };
        let motion = Motion {
            joints: vec![Vec3::ZERO, Vec3::Y * 2.0],
            surfaces,
            times: vec![0.0, 0.5],
            frames: vec![vec![still, up], vec![still, gone]],
        };
        (mesh, motion)
    }

    #[test]
    fn a_reader_finds_skin_and_frames() {
        let (mesh, motion) = moving();
        let bytes = to_glb_moving(&mesh, &motion, &GlbOptions::default()).unwrap();
        let file = ::gltf::Gltf::from_slice(&bytes).unwrap();
        let blob = file.blob.as_deref().unwrap();
        let skin = file.skins().next().unwrap();
        assert_eq!(skin.joints().count(), 2);
        let inverse: Vec<_> =
            skin.reader(|_| Some(blob)).read_inverse_bind_matrices().unwrap().collect();
        assert_eq!(inverse[1][3], [0.0, -2.0, 0.0, 1.0]);
        let primitive = file.meshes().next().unwrap().primitives().next().unwrap();
        let reader = primitive.reader(|_| Some(blob));
        let joints: Vec<u16> =
            reader.read_joints(0).unwrap().into_u16().map(|joints| joints[0]).collect();
        assert_eq!(joints, motion.surfaces[0]);
        assert!(reader.read_weights(0).unwrap().into_f32().all(|w| w == [1.0, 0.0, 0.0, 0.0]));
        let animation = file.animations().next().unwrap();
        // The joint at the base stays, and has no channels.
        assert_eq!(animation.channels().count(), 3);
        for channel in animation.channels() {
            let reader = channel.reader(|_| Some(blob));
            assert_eq!(reader.read_inputs().unwrap().collect::<Vec<_>>(), motion.times);
            match reader.read_outputs().unwrap() {
                ReadOutputs::Translations(values) => {
                    assert_eq!(values.last(), Some(motion.frames[1][1].position.to_array()));
                }
                ReadOutputs::Rotations(values) => {
                    let last = Quat::from_array(values.into_f32().last().unwrap());
                    assert!(last.dot(motion.frames[1][1].rotation) > 0.999_999);
                }
                ReadOutputs::Scales(values) => assert_eq!(values.last(), Some([0.5; 3])),
                ReadOutputs::MorphTargetWeights(_) => panic!("no shapes were written"),
            }
        }
    }

    #[test]
    fn what_does_not_fit_is_named() {
        let (mesh, motion) = moving();
        let says = |motion: &Motion, what: &str| {
            let error = to_glb_moving(&mesh, motion, &GlbOptions::default()).unwrap_err();
            assert!(error.to_string().contains(what), "{error}");
        };
        let mut other = motion.clone();
        other.times[1] = 0.0;
        says(&other, "time 1");
        let mut other = motion.clone();
        other.frames[1][0].scale = -1.0;
        says(&other, "frame 1, joint 0");
        let mut other = motion.clone();
        other.surfaces[0][0] = 9;
        says(&other, "joint 9");
        let mut other = motion.clone();
        other.surfaces.pop();
        says(&other, "surfaces");
        says(&Motion { joints: Vec::new(), ..motion }, "0 joints");
    }
}
