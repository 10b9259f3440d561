//! What comes in: borrowed triangles, part by part.

use crate::error::{ModelError, Result};
use tree_core::Part;

/// Checks columns and indices of a part; `number` names it in errors.
pub(super) fn check(part: &Part<'_>, number: usize) -> Result<()> {
    let bad = |problem: String| Err(ModelError::BadPart { part: number, problem });
    if let Some(row) = part.positions.iter().position(|p| !p.is_finite()) {
        return Err(ModelError::NotFinite { field: format!("parts[{number}].positions[{row}]") });
    }
    if let Some(row) = part.uvs.iter().position(|uv| !uv.is_finite()) {
        return Err(ModelError::NotFinite { field: format!("parts[{number}].uvs[{row}]") });
    }
    if !part.uvs.is_empty() && part.uvs.len() != part.positions.len() {
        let (uvs, vertices) = (part.uvs.len(), part.positions.len());
        return bad(format!("{uvs} uvs for {vertices} vertices; one for each, or none"));
    }
    if !part.indices.len().is_multiple_of(3) {
        return bad(format!("{} indices, which is no multiple of 3", part.indices.len()));
    }
    match part.indices.iter().find(|&&i| i as usize >= part.positions.len()) {
        Some(i) => bad(format!("index {i}, but there are {} vertices", part.positions.len())),
        None => Ok(()),
    }
}
