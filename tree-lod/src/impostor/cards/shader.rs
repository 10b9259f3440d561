//! What a shader does with planes, in three languages; [`weights`](super::weights),
//! [`interval`](super::interval) and [`noise`](super::noise) are the reference.

/// The functions in WGSL.
pub const WGSL: &str = include_str!("../shaders/cards.wgsl");
/// The functions in GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
pub const GLSL: &str = include_str!("../shaders/cards.glsl");
/// The functions in HLSL, any shader model.
pub const HLSL: &str = include_str!("../shaders/cards.hlsl");
