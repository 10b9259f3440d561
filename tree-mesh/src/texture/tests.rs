//! What holds for every built-in texture.
