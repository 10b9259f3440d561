//! Pictures, masks and silhouettes of meshes.
