//! Materials of a document that is read.

use super::accessor::Columns;
use super::document::{self, TextureTransform};
use super::image::Images;
use crate::error::Result;
use crate::io::import::{Beside, ImportReport, Note};
use crate::mesh::{Alpha, Material};
use glam::Vec2;
use tree_core::Control;

/// Alpha at which materials are cut that blend, and masks that do not say.
const CUTOFF: f32 = 0.5;

/// How a material wants its texture coordinates.
#[derive(Clone, Copy)]
pub(super) struct UvUse {
    /// Which set it uses.
    pub(super) set: u32,
    transform: Option<TextureTransform>,
}

impl UvUse {
    pub(super) const PLAIN: Self = Self { set: 0, transform: None };

    fn of(material: &document::Material) -> Self {
        let Some(info) = &material.pbr_metallic_roughness.base_color_texture else {
            return Self::PLAIN;
        };
        let transform = info.extensions.as_ref().and_then(|all| all.transform);
        let set = transform.and_then(|transform| transform.tex_coord).unwrap_or(info.tex_coord);
        Self { set, transform }
    }

    /// Moves texture coordinates to where the material shows them.
    ///
    /// A positive rotation turns them counter-clockwise as seen on the picture, as the extension's
    /// text, its test model and all viewers have it; the formula in its text turns the other way.
    pub(super) fn apply(&self, uvs: &mut [Vec2]) {
        let Some(transform) = self.transform else { return };
        let offset = Vec2::from(transform.offset.unwrap_or_default());
        let scale = Vec2::from(transform.scale.unwrap_or([1.0; 2]));
        let angle = transform.rotation.unwrap_or(0.0);
        let (sin, cos) = (libm::sinf(angle), libm::cosf(angle));
        for uv in uvs {
            let scaled = *uv * scale;
            let turned = if angle == 0.0 {
                scaled
            } else {
                Vec2::new(cos * scaled.x + sin * scaled.y, cos * scaled.y - sin * scaled.x)
            };
            *uv = turned + offset;
        }
    }
}

/// The materials of the document; textures are loaded when a surface shows them.
pub(super) struct Looks<'a> {
    columns: Columns<'a>,
    pub(super) materials: Vec<Material>,
    shown: Vec<bool>,
    images: Images,
    /// Number of the material of primitives that name none.
    default: Option<u32>,
}

impl<'a> Looks<'a> {
    pub(super) fn new(columns: Columns<'a>, report: &mut ImportReport) -> Self {
        let document = columns.document;
        let materials: Vec<Material> = document
            .materials
            .iter()
            .enumerate()
            .map(|(number, material)| convert(number, material, report))
            .collect();
        Self {
            columns,
            shown: vec![false; materials.len()],
            materials,
            images: Images::new(document.images.len()),
            default: None,
        }
    }

    /// The number in the mesh of a primitive's material, and how it uses texture coordinates.
    pub(super) fn show(
        &mut self,
        number: Option<usize>,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<(u32, UvUse)> {
        let source = number.and_then(|number| self.columns.document.materials.get(number));
        let (Some(number), Some(source)) = (number, source) else {
            if number.is_some() {
                report.note(Note::MaterialUnknown);
            }
            let materials = &mut self.materials;
            let default = self.default.get_or_insert_with(|| {
                materials.push(Material { name: "default".into(), ..Default::default() });
                materials.len() as u32 - 1
            });
            return Ok((*default, UvUse::PLAIN));
        };
        let info = &source.pbr_metallic_roughness.base_color_texture;
        if let (Some(info), Some(shown @ false)) = (info, self.shown.get_mut(number)) {
            *shown = true;
            let texture = self.images.texture(self.columns, info.index, beside, report, control)?;
            if let Some(material) = self.materials.get_mut(number) {
                material.texture = texture;
            }
        }
        Ok((number as u32, UvUse::of(source)))
    }
}

fn convert(number: usize, source: &document::Material, report: &mut ImportReport) -> Material {
    let pbr = &source.pbr_metallic_roughness;
    let mut clamped = 0;
    let mut unit = |value: f32| {
        if (0.0..=1.0).contains(&value) {
            return value;
        }
        clamped += 1;
        if value > 0.0 { 1.0 } else { 0.0 }
    };
    let cutoff = unit(source.alpha_cutoff.unwrap_or(CUTOFF));
    let alpha = match source.alpha_mode.as_deref() {
        Some("MASK") => Alpha::Mask(cutoff),
        Some("BLEND") => {
            report.note(Note::BlendAsMask);
            Alpha::Mask(CUTOFF)
        }
        _ => Alpha::Opaque,
    };
    let maps = [
        &source.normal_texture,
        &source.occlusion_texture,
        &source.emissive_texture,
        &pbr.metallic_roughness_texture,
    ];
    report.note_times(Note::OtherTextures, maps.iter().filter(|map| map.is_some()).count() as u64);
    let extensions = source.extensions.as_ref();
    let transmission = extensions.and_then(|all| all.transmission.as_ref());
    let material = Material {
        name: source.name.clone().unwrap_or_else(|| format!("material {number}")),
        base_color: pbr.base_color_factor.unwrap_or([1.0; 4]).map(&mut unit),
        texture: None,
        roughness: unit(pbr.roughness_factor.unwrap_or(1.0)),
        alpha,
        double_sided: source.double_sided,
        translucency: unit(
            transmission.and_then(|all| all.diffuse_transmission_factor).unwrap_or(0.0),
        ),
    };
    report.note_times(Note::Clamped, clamped);
    material
}
