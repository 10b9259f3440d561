//! What readers leave out or change.

use crate::border::{Failure, call, out_value, tree_status, tree_str};
use ::tree_mesh::io::Note;

/// Something a reader left out or changed: one of the `TREE_NOTE_` constants.
pub type tree_note = u32;

/// Primitives, elements or lines that are points or lines, left out.
pub const TREE_NOTE_POINTS_OR_LINES: u32 = 0;
/// Primitives without positions, left out.
pub const TREE_NOTE_NO_POSITIONS: u32 = 1;
/// Corners left over behind the last whole triangle, or faces with fewer than three.
pub const TREE_NOTE_PARTIAL_FACES: u32 = 2;
/// Surfaces (OBJ: corners) whose normals were computed because there were none.
pub const TREE_NOTE_NORMALS_COMPUTED: u32 = 3;
/// Single normals of no length, computed from the triangles around.
pub const TREE_NOTE_NORMALS_REPAIRED: u32 = 4;
/// Surfaces (OBJ: corners) without texture coordinates, which became 0.
pub const TREE_NOTE_UVS_MISSING: u32 = 5;
/// Vertex colours, which a surface has no column for. PLY: their mean became the material's.
pub const TREE_NOTE_VERTEX_COLORS: u32 = 6;
/// Skins and morph targets; the mesh is as it rests.
pub const TREE_NOTE_DEFORMATIONS: u32 = 7;
/// Nodes a scene lists as roots although they are not.
pub const TREE_NOTE_LISTED_TWICE: u32 = 8;
/// Materials that blend by alpha, cut at one half instead.
pub const TREE_NOTE_BLEND_AS_MASK: u32 = 9;
/// Normal, roughness, occlusion and emission maps, left out.
pub const TREE_NOTE_OTHER_TEXTURES: u32 = 10;
/// Colours and factors outside their range, brought back into it.
pub const TREE_NOTE_CLAMPED: u32 = 11;
/// Textures and materials in other files, which were not asked for.
pub const TREE_NOTE_EXTERNAL_REFUSED: u32 = 12;
/// Textures and materials in files that are not there.
pub const TREE_NOTE_EXTERNAL_MISSING: u32 = 13;
/// Textures that could not be decoded.
pub const TREE_NOTE_TEXTURE_UNREADABLE: u32 = 14;
/// Textures without a picture in a known format.
pub const TREE_NOTE_TEXTURE_UNSUPPORTED: u32 = 15;
/// Materials that faces name and no file defines.
pub const TREE_NOTE_MATERIAL_UNKNOWN: u32 = 16;
/// Statements or elements that are not understood, passed over.
pub const TREE_NOTE_UNKNOWN: u32 = 17;

/// Number of notes in this version; new ones may be added.
pub const TREE_N_NOTES: usize = 18;

// The constants are places in this list.
const _: () = assert!(Note::ALL.len() == TREE_N_NOTES);
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_POINTS_OR_LINES as usize], Note::PointsOrLines));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_NO_POSITIONS as usize], Note::NoPositions));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_PARTIAL_FACES as usize], Note::PartialFaces));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_NORMALS_COMPUTED as usize], Note::NormalsComputed));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_NORMALS_REPAIRED as usize], Note::NormalsRepaired));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_UVS_MISSING as usize], Note::UvsMissing));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_VERTEX_COLORS as usize], Note::VertexColors));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_DEFORMATIONS as usize], Note::Deformations));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_LISTED_TWICE as usize], Note::ListedTwice));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_BLEND_AS_MASK as usize], Note::BlendAsMask));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_OTHER_TEXTURES as usize], Note::OtherTextures));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_CLAMPED as usize], Note::Clamped));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_EXTERNAL_REFUSED as usize], Note::ExternalRefused));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_EXTERNAL_MISSING as usize], Note::ExternalMissing));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_TEXTURE_UNREADABLE as usize], Note::TextureUnreadable));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_TEXTURE_UNSUPPORTED as usize], Note::TextureUnsupported));
const _: () =
    assert!(matches!(Note::ALL[TREE_NOTE_MATERIAL_UNKNOWN as usize], Note::MaterialUnknown));
const _: () = assert!(matches!(Note::ALL[TREE_NOTE_UNKNOWN as usize], Note::Unknown));

/// What a note says, for people; the text is there for ever.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tree_note_text(note: tree_note, text: *mut tree_str) -> tree_status {
    call(|| {
        let Some(found) = Note::ALL.get(note as usize) else {
            return Err(Failure::not_one_of("note", note, "TREE_NOTE_"));
        };
        unsafe { out_value(text, tree_str::of(found.text()), "text") }
    })
}
