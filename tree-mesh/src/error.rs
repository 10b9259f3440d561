//! What can go wrong in this crate.

use tree_core::{Cancelled, CoreError, LimitError, ParameterError};

/// Shorthand for results of this crate.
pub(crate) type Result<T, E = MeshError> = std::result::Result<T, E>;

/// Every error of tree-mesh. Each says what was wrong, where, and what would be right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MeshError {
    /// Columns of a surface differ in length.
    #[error("{}: {field} has {found} rows, {expected} are needed", named(surface))]
    Length {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// The column at fault.
        field: &'static str,
        /// Its number of rows.
        found: usize,
        /// The number of positions.
        expected: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("{}: {field}[{index}] is not finite", named(surface))]
    NotFinite {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// The column at fault.
        field: &'static str,
        /// Row in that column.
        index: usize,
    },
    /// An index names something that is not there.
    #[error("{}: {what} {found} does not exist, there are only {count}", named(surface))]
    Dangling {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// `vertex`, `welded vertex`, `branch` or `material`.
        what: &'static str,
        /// The index found.
        found: u32,
        /// How many there are.
        count: usize,
    },
    /// A surface of this number was asked for, and the mesh has none.
    #[error("there is no surface {found}, only {count}")]
    NoSurface {
        /// The number asked for.
        found: usize,
        /// How many surfaces there are.
        count: usize,
    },
    /// A branch comes before the one that carries it.
    #[error(
        "branch {branch} is carried by {parent}: parents must come first, and only 0 carries itself"
    )]
    BranchOrder {
        /// Row in the table of branches.
        branch: usize,
        /// The parent found.
        parent: u32,
    },
    /// A number of a branch is NaN or infinite.
    #[error("branch {branch}: a number is not finite")]
    BranchNotFinite {
        /// Row in the table of branches.
        branch: usize,
    },
    /// The number of indices is not a multiple of three.
    #[error("{}: {found} indices are not whole triangles", named(surface))]
    PartialTriangle {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// Number of indices.
        found: usize,
    },
    /// A vertex is welded to a later one.
    #[error("{}: welds[{index}] is {found}, must be {index} itself or less", named(surface))]
    Weld {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// Row in its welds.
        index: usize,
        /// The vertex it is welded to.
        found: u32,
    },
    /// Leaves cannot be subdivided: their vertices lie in groups of equal size.
    #[error("the surface consists of {found} leaves, only bark can be subdivided")]
    Leaves {
        /// Number of leaves.
        found: usize,
    },
    /// A material's look lies outside its range, or is not finite.
    #[error("material {material}: {field} is {found}, allowed is {min} to {max:?}")]
    Material {
        /// Number of the material.
        material: usize,
        /// The field at fault; `alpha` is the cutoff of [`Alpha::Mask`](crate::Alpha::Mask).
        field: &'static str,
        /// The value found.
        found: f32,
        /// Smallest allowed value.
        min: f32,
        /// Largest allowed value.
        max: f32,
    },
    /// A texture's pixels do not fill its width and height.
    #[error("texture {name}: {found} bytes, {expected} are needed for {width} × {height} RGBA")]
    Texture {
        /// Name of the texture.
        name: String,
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Bytes it holds.
        found: usize,
        /// Bytes it needs.
        expected: usize,
    },
    /// A parameter lies outside its range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// There is no built-in bark or leaf of this name, and none was supplied.
    #[error("no {what} named '{name}'; built in are {known}, or supply your own texture")]
    Unknown {
        /// `bark` or `leaf kind`.
        what: &'static str,
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A coordinate, radius or leaf is so large that 32-bit numbers have no precision left.
    #[error("{what}[{index}] is {found} m, at most {max} m can be meshed")]
    TooLarge {
        /// The column at fault.
        what: &'static str,
        /// Row in that column.
        index: usize,
        /// The largest magnitude in that row.
        found: f32,
        /// Largest allowed magnitude.
        max: f32,
    },
    /// The look does not have one material per leaf kind.
    #[error("the look has {found} leaf materials, the species has {expected} leaf kinds")]
    LeafMaterials {
        /// Leaf materials of the look.
        found: usize,
        /// Leaf kinds of the species.
        expected: usize,
    },
    /// A leaf of your own cannot be drawn.
    #[error("leaf mesh: {problem} (row {index})")]
    LeafMesh {
        /// What is wrong.
        problem: &'static str,
        /// Row at fault, or a number of rows.
        index: usize,
    },
    /// A surface would have more vertices than 32-bit indices can name.
    #[error("{} would have {found} vertices, 32-bit indices reach {max}", named(surface))]
    TooManyVertices {
        /// Number of the surface; `None` where only one is looked at.
        surface: Option<usize>,
        /// Its number of vertices.
        found: u64,
        /// Largest allowed number.
        max: u64,
    },
    /// There is nothing to write: no surface has a triangle.
    #[error("the mesh has no triangles, so there is nothing to write")]
    NoTriangles,
    /// A normal does not have unit length, which file formats and engines rely on.
    #[error("surface {surface}: normals[{index}] has length {found}, 1 is needed")]
    NotUnit {
        /// Number of the surface.
        surface: usize,
        /// Row in its normals.
        index: usize,
        /// The length found.
        found: f32,
    },
    /// An image could not be decoded or encoded.
    #[cfg(feature = "image")]
    #[error("image {name}: {source}")]
    Image {
        /// File or texture.
        name: String,
        /// What the image library said.
        #[source]
        source: image::ImageError,
    },
    /// The glTF document could not be written.
    #[cfg(feature = "gltf")]
    #[error("glTF: {0}")]
    Gltf(String),
    /// A motion that does not fit its mesh.
    #[cfg(feature = "gltf")]
    #[error("motion: {0}")]
    Motion(String),
    /// A file that is read is not what its format asks for.
    #[error("{format}, {place}: {problem}")]
    Malformed {
        /// `glTF`, `OBJ`, `MTL` or `PLY`.
        format: &'static str,
        /// Where in the file: `line 12`, `accessor 3`.
        place: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A file that is read names another file, which was not asked for or lies out of bounds.
    #[error("{format} names the file '{uri}': {problem}")]
    External {
        /// `glTF`, `OBJ` or `MTL`.
        format: &'static str,
        /// The name as it stands in the file, cut to 200 characters.
        uri: String,
        /// Why it is not opened.
        problem: &'static str,
    },
    /// A file needs something this library cannot do.
    #[error("{format}: {what} is not supported")]
    Unsupported {
        /// `glTF`, `PLY` or `file`.
        format: &'static str,
        /// What it needs.
        what: String,
    },
    /// A caller's extra vertex attribute cannot be written.
    #[error("attribute {name}: {problem}")]
    Attribute {
        /// Its name.
        name: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// Instances of a mesh cannot be written.
    #[error("instances {name}: {problem}")]
    Instances {
        /// Their name.
        name: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// Something from the layer below.
    #[error(transparent)]
    Core(#[from] CoreError),
    /// More was asked for than the limits allow.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// The caller cancelled the work.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// What an error calls a surface.
fn named(surface: &Option<usize>) -> String {
    surface.map_or_else(|| "the surface".into(), |number| format!("surface {number}"))
}
