//! From traces to a tree: smoothing, radii, twigs and leaves.
