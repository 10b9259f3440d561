//! TEMPORARY
use std::collections::BTreeMap;
use std::sync::OnceLock;
pub(crate) fn knob(name: &'static str, default: f32) -> f32 {
    static K: OnceLock<BTreeMap<String, f32>> = OnceLock::new();
    K.get_or_init(|| std::env::vars().filter(|(k, _)| k.starts_with("K_")).filter_map(|(k, v)| Some((k[2..].to_string(), v.parse().ok()?))).collect()).get(name).copied().unwrap_or(default)
}
