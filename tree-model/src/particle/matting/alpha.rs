//! Mattes of pictures that bring one.

use super::super::{Matte, Photo};
use crate::error::{ModelError, Result};

/// The matte of a photograph that has been cut out: its alpha channel as it is.
///
/// # Errors
/// [`ModelError::Picture`] when the photograph is opaque everywhere, or transparent everywhere.
///
/// # Complexity
/// O(pixels).
pub fn alpha_of(photo: &Photo) -> Result<Matte> {
    let refuse = |problem: &str| Err(ModelError::Picture { problem: problem.into() });
    if !photo.has_alpha() {
        return refuse(
            "it is fully opaque; give one with an alpha channel, or separate the tree with a trimap, \
             strokes or the automatic mode",
        );
    }
    if photo.pixels().iter().all(|pixel| pixel[3] == 0) {
        return refuse("it is fully transparent; the tree must be opaque");
    }
    let alpha = photo.pixels().iter().map(|pixel| f32::from(pixel[3]) / 255.0).collect();
    Matte::new(photo.width(), photo.height(), alpha)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alpha_is_taken_as_it_is() {
        let photo = Photo::new(3, 1, vec![[9, 9, 9, 0], [9, 9, 9, 51], [9, 9, 9, 255]]).unwrap();
        assert_eq!(alpha_of(&photo).unwrap().alpha(), [0.0, 0.2, 1.0]);
    }

    #[test]
    fn nothing_and_everything_are_refused() {
        for alpha in [0, 255] {
            let photo = Photo::new(1, 1, vec![[0, 0, 0, alpha]]).unwrap();
            assert!(matches!(alpha_of(&photo), Err(ModelError::Picture { .. })));
        }
    }
}
