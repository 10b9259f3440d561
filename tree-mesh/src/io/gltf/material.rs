//! Materials, textures and pictures of a file that is written.

use super::GlbOptions;
use super::quantize::UvRange;
use crate::error::Result;
use crate::mesh::{Alpha, Material, Texture};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::sync::Arc;

/// Linear between texels and between mipmap levels.
const LINEAR: u32 = 9729;
const LINEAR_MIPMAP_LINEAR: u32 = 9987;
const REPEAT: u32 = 10_497;

/// Materials in use, in the order of first use.
#[derive(Default)]
pub(super) struct Materials<'a> {
    entries: Vec<Entry<'a>>,
}

struct Entry<'a> {
    /// Which mesh it comes from: two of one mesh are kept apart even when they are equal.
    mesh: usize,
    material: &'a Material,
    /// How quantised texture coordinates are stretched; `None` when they are not.
    range: Option<UvRange>,
}

impl<'a> Materials<'a> {
    /// The number in the file of a material of mesh `mesh`.
    pub(super) fn place(
        &mut self,
        mesh: usize,
        material: &'a Material,
        range: Option<UvRange>,
    ) -> usize {
        let same = |entry: &Entry<'_>| {
            entry.range == range
                && (std::ptr::eq(entry.material, material)
                    || (entry.mesh != mesh && entry.material == material))
        };
        self.entries.iter().position(same).unwrap_or_else(|| {
            self.entries.push(Entry { mesh, material, range });
            self.entries.len() - 1
        })
    }

    /// The textures in use, each once.
    pub(super) fn textures(&self) -> Vec<&'a Arc<Texture>> {
        let mut textures: Vec<&Arc<Texture>> = Vec::new();
        for texture in self.entries.iter().filter_map(|entry| entry.material.texture.as_ref()) {
            if !textures.iter().any(|known| Arc::ptr_eq(known, texture)) {
                textures.push(texture);
            }
        }
        textures
    }

    /// The materials as they stand in the file, and the extensions they use.
    pub(super) fn json(&self, options: &GlbOptions) -> (Vec<Value>, Vec<&'static str>) {
        let textures = self.textures();
        let mut extensions = Vec::new();
        let materials = self
            .entries
            .iter()
            .map(|entry| {
                let texture = entry.material.texture.as_ref().and_then(|wanted| {
                    textures.iter().position(|known| Arc::ptr_eq(known, wanted))
                });
                let info = texture.map(|index| texture_info(index, entry.range));
                if info.is_some() && entry.range.is_some() {
                    extensions.push("KHR_texture_transform");
                }
                let translucent = options.translucency && entry.material.translucency > 0.0;
                if translucent {
                    extensions.push("KHR_materials_diffuse_transmission");
                }
                material(entry.material, info.as_ref(), translucent)
            })
            .collect();
        (materials, extensions)
    }
}

/// PNG files of the textures, in their order.
pub(super) fn pictures(textures: &[&Arc<Texture>]) -> Result<Vec<Vec<u8>>> {
    textures.par_iter().map(|texture| texture.to_png()).collect()
}

/// The one sampler all textures share.
pub(super) fn sampler() -> Value {
    json!({
        "magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR, "wrapS": REPEAT, "wrapT": REPEAT,
    })
}

fn texture_info(index: usize, range: Option<UvRange>) -> Value {
    let mut info = json!({ "index": index });
    if let Some(range) = range {
        info["extensions"] = json!({ "KHR_texture_transform": {
            "offset": range.offset.to_array(), "scale": range.scale.to_array(),
        }});
    }
    info
}

fn material(material: &Material, texture: Option<&Value>, translucent: bool) -> Value {
    let mut pbr = json!({
        "baseColorFactor": material.base_color,
        "metallicFactor": 0.0,
        "roughnessFactor": material.roughness,
    });
    if let Some(texture) = texture {
        pbr["baseColorTexture"] = texture.clone();
    }
    let mut json = json!({ "name": material.name, "pbrMetallicRoughness": pbr });
    if let Alpha::Mask(cutoff) = material.alpha {
        json["alphaMode"] = "MASK".into();
        json["alphaCutoff"] = cutoff.into();
    }
    if material.double_sided {
        json["doubleSided"] = true.into();
    }
    if translucent {
        // The light that comes through has the colour of the leaf, not of the lamp.
        let [r, g, b, _] = material.base_color;
        let mut transmission = json!({
            "diffuseTransmissionFactor": material.translucency,
            "diffuseTransmissionColorFactor": [r, g, b],
        });
        if let Some(texture) = texture {
            transmission["diffuseTransmissionColorTexture"] = texture.clone();
        }
        json["extensions"] = json!({ "KHR_materials_diffuse_transmission": transmission });
    }
    json
}
