//! Pictures: of differences, and several beside each other.

use super::cases::OUT;
use super::view::Seen;
use std::error::Error;
use std::path::Path;
use tree_lod::preview::Picture;
use tree_model::particle::Photo;

/// Of both, of the outline only, of the tree only, of the trunk below the crown, and of neither.
const INKS: [[u8; 3]; 5] =
    [[120, 165, 95], [60, 105, 215], [215, 60, 50], [200, 200, 200], [255, 255, 255]];

/// Outline and tree in one: green where they agree, blue where the outline is bare, red where the tree is beyond it, grey
/// where the trunk is left out.
pub(super) fn difference(seen: &Seen) -> Picture {
    let n = seen.n;
    let mut pixels = Vec::with_capacity(4 * n * n);
    for y in (0..n).rev() {
        for at in y * n..(y + 1) * n {
            let ink = match (seen.trunk[at], seen.outline[at], seen.tree[at]) {
                (true, ..) => INKS[3],
                (_, true, true) => INKS[0],
                (_, true, false) => INKS[1],
                (_, false, true) => INKS[2],
                (_, false, false) => INKS[4],
            };
            pixels.extend([ink[0], ink[1], ink[2], 255]);
        }
    }
    Picture { width: n as u32, height: n as u32, pixels }
}

/// Pictures of one height beside each other.
pub(super) fn beside(parts: &[Picture]) -> Picture {
    let height = parts.iter().map(|part| part.height).min().unwrap_or(0);
    let mut pixels = Vec::new();
    for y in 0..height as usize {
        for part in parts {
            let row = 4 * part.width as usize;
            pixels.extend_from_slice(&part.pixels[y * row..(y + 1) * row]);
        }
    }
    Picture { width: parts.iter().map(|part| part.width).sum(), height, pixels }
}

/// Writes a picture of this name.
pub(super) fn save(picture: &Picture, name: &str) -> Result<(), Box<dyn Error>> {
    let pixels = picture.pixels.as_chunks().0.to_vec();
    let photo = Photo::new(picture.width, picture.height, pixels)?;
    Ok(photo.save_png(Path::new(OUT).join(format!("{name}.png")))?)
}
