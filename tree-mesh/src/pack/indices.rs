//! Indices of 16 or 32 bits, by the number of vertices.

/// Most vertices that 16-bit indices name: 0xFFFF restarts strips in most engines and stays free.
const SHORT_MAX: usize = 0xFFFF;

/// Triangle indices, as narrow as the number of vertices allows. Nothing ever wraps.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Indices {
    /// For at most 65,535 vertices, so that no index is 0xFFFF.
    U16(Vec<u16>),
    /// For more.
    U32(Vec<u32>),
}

impl Indices {
    /// Chooses the width. Should an index reach beyond `n_vertices`, the width is 32 bits.
    ///
    /// # Complexity
    /// One pass.
    #[must_use]
    pub fn new(indices: &[u32], n_vertices: usize) -> Self {
        let narrow = |&index: &u32| u16::try_from(index).ok().filter(|&index| index != u16::MAX);
        if n_vertices <= SHORT_MAX
            && let Some(short) = indices.iter().map(narrow).collect()
        {
            return Self::U16(short);
        }
        Self::U32(indices.to_vec())
    }

    /// Number of indices.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::U16(indices) => indices.len(),
            Self::U32(indices) => indices.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The indices as bytes, as an engine uploads them (in the machine's order of bytes).
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        match self {
            Self::U16(indices) => bytemuck::cast_slice(indices),
            Self::U32(indices) => bytemuck::cast_slice(indices),
        }
    }

    /// The indices with 32 bits each.
    #[must_use]
    pub fn to_u32(&self) -> Vec<u32> {
        match self {
            Self::U16(indices) => indices.iter().map(|&index| u32::from(index)).collect(),
            Self::U32(indices) => indices.clone(),
        }
    }
}
