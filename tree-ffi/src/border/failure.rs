//! From the family's errors to codes.

use super::status::*;
use std::any::Any;
use tree_lod::LodError;
use tree_mesh::MeshError;
use tree_model::ModelError;
use tree_model::tree_core::{Cancelled, CoreError, LimitError};

/// Shorthand for results of this crate.
pub(crate) type Result<T> = std::result::Result<T, Failure>;

/// A code and a text.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) status: tree_status,
    pub(crate) text: String,
}

impl Failure {
    pub(crate) fn new(status: tree_status, text: impl Into<String>) -> Self {
        Self { status, text: text.into() }
    }

    pub(crate) fn null(name: &str) -> Self {
        Self::new(TREE_ERROR_NULL, format!("{name} is NULL"))
    }

    /// `found` is none of the constants whose common beginning is `constants`.
    pub(crate) fn not_one_of(name: &str, found: u32, constants: &str) -> Self {
        Self::new(TREE_ERROR_ENUM, format!("{name} is {found}, which is no {constants} constant"))
    }

    pub(crate) fn panic(payload: &(dyn Any + Send)) -> Self {
        let what = payload
            .downcast_ref::<&str>()
            .copied()
            .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
            .unwrap_or("no message");
        Self::new(TREE_ERROR_PANIC, format!("a defect in the library: {what}"))
    }
}

impl From<CoreError> for Failure {
    fn from(error: CoreError) -> Self {
        let status = match &error {
            CoreError::Parameter(_)
            | CoreError::OutOfRange { .. }
            | CoreError::NotFinite { .. }
            | CoreError::Volume { .. } => TREE_ERROR_PARAMETER,
            CoreError::Swc { .. } => TREE_ERROR_FORMAT,
            CoreError::Limit(_) => TREE_ERROR_LIMIT,
            CoreError::Cancelled(_) => TREE_ERROR_CANCELLED,
            CoreError::Io { .. } => TREE_ERROR_IO,
            _ => TREE_ERROR_INVALID,
        };
        Self::new(status, error.to_string())
    }
}

impl From<ModelError> for Failure {
    fn from(error: ModelError) -> Self {
        let status = match error {
            ModelError::Core(error) => return error.into(),
            ModelError::Level { index, source } => {
                let inner = Self::from(*source);
                return Self::new(inner.status, format!("levels[{index}]: {}", inner.text));
            }
            ModelError::Parameter(_) | ModelError::NotFinite { .. } | ModelError::Cost { .. } => {
                TREE_ERROR_PARAMETER
            }
            ModelError::BadPart { .. }
            | ModelError::Cloud { .. }
            | ModelError::Grammar { .. }
            | ModelError::Word { .. }
            | ModelError::Sketch { .. }
            | ModelError::Stroke { .. }
            | ModelError::Template { .. }
            | ModelError::Silhouette { .. }
            | ModelError::Scene { .. } => TREE_ERROR_INVALID,
            ModelError::UnknownPreset { .. } => TREE_ERROR_UNKNOWN_NAME,
            ModelError::Svg(_) => TREE_ERROR_FORMAT,
            ModelError::Limit(_) => TREE_ERROR_LIMIT,
            ModelError::Cancelled(_) => TREE_ERROR_CANCELLED,
            _ => TREE_ERROR_NO_RESULT,
        };
        Self::new(status, error.to_string())
    }
}

impl From<MeshError> for Failure {
    fn from(error: MeshError) -> Self {
        let status = match error {
            MeshError::Core(error) => return error.into(),
            MeshError::Parameter(_)
            | MeshError::Material { .. }
            | MeshError::NotFinite { .. }
            | MeshError::BranchNotFinite { .. }
            | MeshError::NotUnit { .. }
            | MeshError::TooLarge { .. } => TREE_ERROR_PARAMETER,
            MeshError::Unknown { .. } => TREE_ERROR_UNKNOWN_NAME,
            MeshError::Malformed { .. }
            | MeshError::External { .. }
            | MeshError::Unsupported { .. }
            | MeshError::Image { .. }
            | MeshError::Gltf(_) => TREE_ERROR_FORMAT,
            MeshError::NoTriangles => TREE_ERROR_NO_RESULT,
            MeshError::TooManyVertices { .. } | MeshError::Limit(_) => TREE_ERROR_LIMIT,
            MeshError::Cancelled(_) => TREE_ERROR_CANCELLED,
            _ => TREE_ERROR_INVALID,
        };
        Self::new(status, error.to_string())
    }
}

impl From<LodError> for Failure {
    fn from(error: LodError) -> Self {
        let status = match error {
            LodError::Mesh(error) => return error.into(),
            LodError::Core(error) => return error.into(),
            LodError::Parameter(_) | LodError::Camera { .. } => TREE_ERROR_PARAMETER,
            // What a frame writes does not fit.
            LodError::Scene { what, .. } if what.starts_with("output") => TREE_ERROR_BUFFER,
            LodError::Table { .. }
            | LodError::Length { .. }
            | LodError::Foliage(_)
            | LodError::Order { .. }
            | LodError::Chain { .. }
            | LodError::Impostor(_)
            | LodError::Scene { .. } => TREE_ERROR_INVALID,
            LodError::Image(_) | LodError::Stream { .. } => TREE_ERROR_FORMAT,
            LodError::Limit(_) => TREE_ERROR_LIMIT,
            LodError::Cancelled(_) => TREE_ERROR_CANCELLED,
            _ => TREE_ERROR_INVALID,
        };
        Self::new(status, error.to_string())
    }
}

impl From<LimitError> for Failure {
    fn from(error: LimitError) -> Self {
        Self::new(TREE_ERROR_LIMIT, error.to_string())
    }
}

impl From<Cancelled> for Failure {
    fn from(error: Cancelled) -> Self {
        Self::new(TREE_ERROR_CANCELLED, error.to_string())
    }
}
