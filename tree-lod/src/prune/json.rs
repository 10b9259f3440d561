//! Levels as text, for engines that load a model from a file.

use super::level::Level;
use super::model::PrunedModel;
use std::fmt::{Display, Write};

impl PrunedModel {
    /// The levels as JSON, to be stored beside the mesh:
    ///
    /// ```json
    /// {
    ///   "triangles": 1200, "elements": 600, "least_lambda": 0.0016,
    ///   "parts": [{ "surface": 1, "primitive": 1, "mean": [0.1, 0.2, 0.05] }],
    ///   "table": [{ "lambda": 0.1, "scale": 4.0, "precision": 0.8, "recall": 0.8, "quality": 0.7 }],
    ///   "levels": [{ "lambda": 0.1, "scale": 4.0, "growth": 2.0, "contrast": 0.8, "fade": 0.01,
    ///                "triangles": 120, "windows": [{ "part": 0, "first_index": 0, "index_count": 360 }] }]
    /// }
    /// ```
    ///
    /// `primitive` is the place of the surface in a glTF mesh, which leaves empty surfaces out; `null` for an
    /// empty one. Numbers are written so that they are read as the same bits.
    #[must_use]
    pub fn to_json(&self, levels: &[Level]) -> String {
        let parts = list(self.parts.iter().map(|part| {
            let surface = part.surface as usize;
            let [r, g, b] = part.mean.to_array();
            let primitive = self.primitive(surface).map_or("null".into(), |p| p.to_string());
            format!(
                r#"{{ "surface": {surface}, "primitive": {primitive}, "mean": [{r}, {g}, {b}] }}"#
            )
        }));
        let table = list(self.table.rows().iter().map(|row| {
            object(&[
                ("lambda", &row.lambda),
                ("scale", &row.scale),
                ("precision", &row.precision),
                ("recall", &row.recall),
                ("quality", &row.quality),
            ])
        }));
        let levels = list(levels.iter().map(level));
        let least = self.schedule.least_lambda();
        let (n, elements) = (self.schedule.n_triangles(), self.schedule.n_elements());
        format!(
            "{{\n  \"triangles\": {n}, \"elements\": {elements}, \"least_lambda\": {least},\n  \
             \"parts\": {parts},\n  \"table\": {table},\n  \"levels\": {levels}\n}}\n"
        )
    }

    /// The place of a surface among those with triangles.
    fn primitive(&self, surface: usize) -> Option<usize> {
        let drawn = |number: &usize| !self.mesh.surfaces[*number].indices.is_empty();
        drawn(&surface).then(|| (0..surface).filter(drawn).count())
    }
}

fn level(level: &Level) -> String {
    let windows = level.windows.iter().enumerate().map(|(part, window)| {
        object(&[
            ("part", &part),
            ("first_index", &window.first_index),
            ("index_count", &window.index_count),
        ])
    });
    let windows = format!("[{}]", windows.collect::<Vec<_>>().join(", "));
    object(&[
        ("lambda", &level.lambda),
        ("scale", &level.scale),
        ("growth", &level.growth),
        ("contrast", &level.contrast),
        ("fade", &level.fade),
        ("triangles", &level.n_triangles),
        ("windows", &windows),
    ])
}

fn object(fields: &[(&str, &dyn Display)]) -> String {
    let mut text = String::from("{ ");
    for (i, (name, value)) in fields.iter().enumerate() {
        let comma = if i > 0 { ", " } else { "" };
        // Writing to a string does not fail.
        let _ = write!(text, "{comma}\"{name}\": {value}");
    }
    text + " }"
}

fn list(rows: impl Iterator<Item = String>) -> String {
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() { "[]".into() } else { format!("[\n    {}\n  ]", rows.join(",\n    ")) }
}
