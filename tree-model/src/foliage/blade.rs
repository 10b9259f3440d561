//! How one leaf is held: petiole, blade, and the leaflets on it.

use super::LeafParams;
use super::form::Layout;
use super::sites::Site;
use super::vector::across;
use glam::{Mat3, Quat, Vec3};
use std::f32::consts::TAU;
use tree_core::seed::uniform;
use tree_core::{Leaf, Rng};

/// Share of the leaves' jitter that leaflets of one leaf have among themselves.
const LEAFLET_JITTER: f32 = 0.3;

/// A leaf with all its leaflets, as it is held.
#[derive(Clone, Copy, Debug)]
pub(super) struct Whole {
    /// The nearer end of the bearing segment.
    pub(super) host: u32,
    /// The petiole's end, where the blade begins.
    pub(super) base: Vec3,
    pub(super) rotation: Quat,
    /// Length of a full blade.
    pub(super) size: f32,
}

/// What all leaves share.
pub(super) struct Bearer<'a> {
    pub(super) params: &'a LeafParams,
    pub(super) layout: &'a Layout,
    /// Unit vector to the light.
    pub(super) light: Vec3,
}

impl Bearer<'_> {
    /// Appends all leaves of one place, and the same as wholes if they are wanted.
    pub(super) fn bear(
        &self,
        site: &Site,
        leaves: &mut Vec<Leaf>,
        mut wholes: Option<&mut Vec<Whole>>,
    ) {
        let params = self.params;
        let mut rng = site.seed.rng();
        let count = if site.terminal { 1 } else { params.arrangement.per_node() };
        for i in 0..count {
            let whole = if site.terminal {
                let pitch = uniform(&mut rng, 0.0, 0.5 * params.jitter);
                self.hold(site, site.side, pitch, &mut rng)
            } else {
                let jitter = 0.5 * params.jitter * uniform(&mut rng, -1.0, 1.0);
                let angle = site.turn + TAU * i as f32 / count as f32 + jitter;
                let outward = Quat::from_axis_angle(site.along, angle) * site.side;
                let pitch = params.pitch + params.jitter * uniform(&mut rng, -1.0, 1.0);
                self.hold(site, outward, pitch, &mut rng)
            };
            self.spread(site.node, &whole, &mut rng, leaves);
            if let Some(wholes) = &mut wholes {
                wholes.push(whole);
            }
        }
    }

    fn hold(&self, site: &Site, outward: Vec3, pitch: f32, rng: &mut Rng) -> Whole {
        let params = self.params;
        let (sin, cos) = libm::sincosf(pitch);
        let petiole = site.along * cos + outward * sin;
        let midrib = petiole.lerp(Vec3::NEG_Y, params.droop).normalize_or(petiole);
        // Unturned, the upper face looks towards the shoot's tip (adaxial).
        let adaxial = across(site.along, midrib).unwrap_or(midrib.any_orthonormal_vector());
        let lit = across(self.light, midrib).unwrap_or(adaxial);
        let face = adaxial.lerp(lit, params.phototropism);
        let face = across(face, midrib).unwrap_or(adaxial);
        let roll = Quat::from_axis_angle(midrib, params.jitter * uniform(rng, -1.0, 1.0));
        let face = roll * face;
        let rotation = Quat::from_mat3(&Mat3::from_cols(midrib.cross(face), midrib, face));
        let rotation = self.turned_to_light(face) * rotation;
        let vary = 1.0 + params.size_variation * uniform(rng, -1.0, 1.0);
        let size = params.size * vary * size_share(params.size_gradient, site.age);
        let surface = site.point + outward * site.radius;
        let host = if site.share < 0.5 && !site.terminal { site.below } else { site.node };
        Whole {
            host,
            base: surface + petiole * (params.petiole * size),
            rotation: rotation.normalize(),
            size,
        }
    }

    /// The turn of the blade against its petiole that brings its face nearer to the light.
    fn turned_to_light(&self, face: Vec3) -> Quat {
        let params = self.params;
        if params.lamina_turn <= 0.0 {
            return Quat::IDENTITY;
        }
        let axis = face.cross(self.light);
        let angle = libm::atan2f(axis.length(), face.dot(self.light));
        match axis.try_normalize() {
            Some(axis) => {
                let angle = (params.phototropism * angle).min(params.lamina_turn);
                Quat::from_axis_angle(axis, angle)
            }
            None => Quat::IDENTITY,
        }
    }

    fn spread(&self, node: u32, whole: &Whole, rng: &mut Rng, leaves: &mut Vec<Leaf>) {
        let kind = self.params.kind;
        if let [_] = self.layout.leaflets.as_slice() {
            let Whole { base: position, rotation, size, .. } = *whole;
            leaves.push(Leaf { node, position, rotation, size, kind });
            return;
        }
        let jitter = LEAFLET_JITTER * self.params.jitter;
        for leaflet in &self.layout.leaflets {
            let roll = Quat::from_rotation_y(jitter * uniform(rng, -1.0, 1.0));
            let nod = Quat::from_rotation_x(jitter * uniform(rng, -1.0, 1.0));
            leaves.push(Leaf {
                node,
                position: whole.base + whole.rotation * (leaflet.offset * whole.size),
                rotation: (whole.rotation * leaflet.rotation * nod * roll).normalize(),
                size: whole.size * leaflet.size,
                kind,
            });
        }
    }
}

/// Size at an age, the distance to the tip as a share of the bearing zone: 1 at the large end.
pub(super) fn size_share(gradient: f32, age: f32) -> f32 {
    if gradient >= 0.0 { 1.0 - gradient * (1.0 - age) } else { 1.0 + gradient * age }
}
