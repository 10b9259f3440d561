//! What engines want besides triangles: wind, packed vertices, capsules, other axes.
