//! MTL: what the materials of an OBJ look like.
//!
//! `Kd` and `d` (or `Tr`) become the base colour and its alpha, `map_Kd` the texture, `map_d` its
//! alpha with a mask at one half, `Pr` (or `Ns`) the roughness. All else is passed over. MTL knows no
//! two-sidedness; what is masked is taken for leaves and drawn from both sides.

use crate::error::{MeshError, Result};
use crate::io::import::{Beside, ImportReport, Note};
use crate::mesh::{Alpha, Material, Texture};
use std::collections::BTreeMap;
use std::sync::Arc;
use tree_core::Control;

/// Alpha at which masks are cut; MTL does not say.
const CUTOFF: f32 = 0.5;
/// Options of texture statements and how many words follow each at most. `-o`, `-s` and `-t` take one
/// to three numbers.
const MAP_OPTIONS: [(&str, usize); 13] = [
    ("-blendu", 1),
    ("-blendv", 1),
    ("-boost", 1),
    ("-bm", 1),
    ("-cc", 1),
    ("-clamp", 1),
    ("-imfchan", 1),
    ("-mm", 2),
    ("-o", 3),
    ("-s", 3),
    ("-t", 3),
    ("-texres", 1),
    ("-type", 1),
];

/// A material as it stands in the file.
#[derive(Clone, Debug)]
struct Entry {
    name: String,
    color: [f32; 3],
    alpha: f32,
    roughness: f32,
    texture: Option<String>,
    mask: Option<String>,
}

/// Reads materials and their textures. Later ones of the same name replace earlier ones.
pub(super) fn read(
    bytes: &[u8],
    known: &mut BTreeMap<String, Material>,
    textures: &mut Textures,
    beside: &mut Beside<'_>,
    report: &mut ImportReport,
    control: &Control,
) -> Result<()> {
    let text = String::from_utf8_lossy(bytes);
    let mut entry: Option<Entry> = None;
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        let (keyword, rest) =
            line.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((line, ""));
        let rest = rest.trim();
        if keyword == "newmtl" {
            if let Some(done) = entry.take() {
                let material = done.finish(textures, beside, report, control)?;
                known.insert(material.name.clone(), material);
            }
            entry = Some(Entry::new(rest));
            continue;
        }
        let Some(entry) = &mut entry else { continue };
        statement(entry, keyword, rest, number + 1)?;
    }
    if let Some(done) = entry {
        let material = done.finish(textures, beside, report, control)?;
        known.insert(material.name.clone(), material);
    }
    Ok(())
}

fn statement(entry: &mut Entry, keyword: &str, rest: &str, line: usize) -> Result<()> {
    let numbers = || {
        let mut numbers = [0.0_f32; 3];
        let mut n = 0;
        for (to, word) in numbers.iter_mut().zip(rest.split_ascii_whitespace()) {
            *to = word.parse().ok().filter(|value: &f32| value.is_finite()).ok_or_else(|| {
                let problem = format!("{keyword} needs numbers");
                MeshError::Malformed { format: "MTL", place: format!("line {line}"), problem }
            })?;
            n += 1;
        }
        if n == 0 {
            let problem = format!("{keyword} needs a number");
            return Err(MeshError::Malformed {
                format: "MTL",
                place: format!("line {line}"),
                problem,
            });
        }
        Ok((numbers, n))
    };
    match keyword {
        // Spectra and CIE colours, which nobody writes.
        "Kd" if rest.starts_with("spectral") || rest.starts_with("xyz") => {}
        "Kd" => {
            let (color, n) = numbers()?;
            entry.color = if n == 3 { color } else { [color[0]; 3] };
        }
        "d" => {
            let rest_of_halo = rest.strip_prefix("-halo").unwrap_or(rest);
            entry.alpha = rest_of_halo.trim().parse().unwrap_or(1.0);
        }
        "Tr" => entry.alpha = 1.0 - numbers()?.0[0],
        "Pr" => entry.roughness = numbers()?.0[0],
        // The width of Blinn's highlight of exponent Ns.
        "Ns" => entry.roughness = libm::sqrtf(2.0 / (numbers()?.0[0].max(0.0) + 2.0)),
        "map_Kd" => entry.texture = file_name(rest),
        "map_d" => entry.mask = file_name(rest),
        _ => {}
    }
    Ok(())
}

/// The name behind the options of a texture statement; it may hold blanks.
fn file_name(rest: &str) -> Option<String> {
    let mut rest = rest;
    while rest.starts_with('-') {
        let (option, mut after) = rest.split_once(|c: char| c.is_ascii_whitespace())?;
        let (_, n) = MAP_OPTIONS.iter().find(|(name, _)| *name == option)?;
        for i in 0..*n {
            after = after.trim_start();
            let (word, behind) =
                after.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((after, ""));
            // The second and third number may be left out.
            if i > 0 && word.parse::<f32>().is_err() {
                break;
            }
            after = behind;
        }
        rest = after.trim_start();
    }
    let name = rest.trim().trim_matches('"');
    (!name.is_empty()).then(|| name.to_owned())
}

impl Entry {
    fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            color: [1.0; 3],
            alpha: 1.0,
            roughness: Material::default().roughness,
            texture: None,
            mask: None,
        }
    }

    fn finish(
        self,
        textures: &mut Textures,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<Material> {
        let mut clamped = 0;
        let mut unit = |value: f32| {
            if (0.0..=1.0).contains(&value) {
                return value;
            }
            clamped += 1;
            if value > 0.0 { 1.0 } else { 0.0 }
        };
        let [r, g, b] = self.color.map(&mut unit);
        let (alpha, roughness) = (unit(self.alpha), unit(self.roughness));
        report.note_times(Note::Clamped, clamped);
        let mut texture = match &self.texture {
            Some(name) => textures.get(name, beside, report, control)?,
            None => None,
        };
        let mut masked = false;
        match (&self.texture, &self.mask, &texture) {
            (Some(color), Some(mask), Some(_)) if color == mask => masked = true,
            (_, Some(mask), Some(color)) => {
                let mask = textures.get(mask, beside, report, control)?;
                match mask.and_then(|mask| combined(color, &mask)) {
                    Some(both) => {
                        texture = Some(Arc::new(both));
                        masked = true;
                    }
                    None => report.note(Note::OtherTextures),
                }
            }
            (_, Some(_), None) => report.note(Note::OtherTextures),
            (_, None, _) => {}
        }
        Ok(Material {
            name: self.name,
            base_color: [r, g, b, alpha],
            texture,
            roughness,
            alpha: if masked { Alpha::Mask(CUTOFF) } else { Alpha::Opaque },
            double_sided: masked,
            translucency: 0.0,
        })
    }
}

/// The colour of one and as alpha the red of another picture of the same size.
fn combined(color: &Texture, mask: &Texture) -> Option<Texture> {
    if (color.width, color.height) != (mask.width, mask.height) {
        return None;
    }
    let mut both = color.clone();
    for (pixel, mask) in both.pixels.chunks_exact_mut(4).zip(mask.pixels.chunks_exact(4)) {
        pixel[3] = mask[0];
    }
    Some(both)
}

/// Textures by their name in the file, each read once.
#[derive(Default)]
pub(super) struct Textures {
    known: BTreeMap<String, Option<Arc<Texture>>>,
    #[cfg(feature = "image")]
    n_pixels: u64,
}

impl Textures {
    fn get(
        &mut self,
        name: &str,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<Option<Arc<Texture>>> {
        if let Some(known) = self.known.get(name) {
            return Ok(known.clone());
        }
        let texture = if beside.allowed() {
            self.load(name, beside, report, control)?
        } else {
            report.note(Note::ExternalRefused);
            None
        };
        self.known.insert(name.to_owned(), texture.clone());
        Ok(texture)
    }

    #[cfg(feature = "image")]
    fn load(
        &mut self,
        name: &str,
        beside: &mut Beside<'_>,
        report: &mut ImportReport,
        control: &Control,
    ) -> Result<Option<Arc<Texture>>> {
        control.check()?;
        let bytes = match beside.read(name) {
            Ok(bytes) => bytes,
            Err(error) if crate::io::import::is_missing(&error) => {
                report.note(Note::ExternalMissing);
                return Ok(None);
            }
            Err(error) => return Err(error),
        };
        let left = control.limits.pixels.saturating_sub(self.n_pixels);
        let limits = tree_core::Limits { pixels: left, ..control.limits };
        let stem = std::path::Path::new(name).file_stem().unwrap_or_default().to_string_lossy();
        match Texture::decode(&stem, &bytes, &limits) {
            Ok(texture) => {
                self.n_pixels += u64::from(texture.width) * u64::from(texture.height);
                report.n_textures += 1;
                Ok(Some(Arc::new(texture)))
            }
            Err(MeshError::Image { .. }) => {
                report.note(Note::TextureUnreadable);
                Ok(None)
            }
            Err(error) => Err(error),
        }
    }

    #[cfg(not(feature = "image"))]
    #[allow(clippy::unused_self)]
    fn load(
        &mut self,
        _: &str,
        _: &mut Beside<'_>,
        report: &mut ImportReport,
        _: &Control,
    ) -> Result<Option<Arc<Texture>>> {
        report.note(Note::TextureUnsupported);
        Ok(None)
    }
}
