//! Textures, materials, and what a species looks like.
