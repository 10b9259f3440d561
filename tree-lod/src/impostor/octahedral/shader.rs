//! What a shader does with an octahedral impostor, in three languages; [`Octahedral::view`] is the
//! reference.
//!
//! [`Octahedral::view`]: super::Octahedral::view

/// The functions in WGSL.
pub const WGSL: &str = include_str!("../shaders/octahedral.wgsl");
/// The functions in GLSL, from version 1.30 (desktop) or 3.00 (ES) on.
pub const GLSL: &str = include_str!("../shaders/octahedral.glsl");
/// The functions in HLSL, any shader model.
pub const HLSL: &str = include_str!("../shaders/octahedral.hlsl");
