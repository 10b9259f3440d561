//! stub
use super::super::{Matte, Photo};
use crate::error::Result;
use tree_core::Control;
/// p
#[derive(Clone, Copy, Debug, Default)]
pub struct AutoParams;
/// r
#[derive(Clone, Debug, Default)]
pub struct AutoReport;
/// a
pub fn automatic(_p: &Photo, _a: &AutoParams, _c: &Control) -> Result<(Matte, AutoReport)> {
    todo!()
}
