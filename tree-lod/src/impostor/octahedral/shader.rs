//! What a shader does with an octahedral impostor, in three languages.
/// The functions in WGSL.
pub const WGSL: &str = "";
/// The functions in GLSL.
pub const GLSL: &str = "";
/// The functions in HLSL.
pub const HLSL: &str = "";
