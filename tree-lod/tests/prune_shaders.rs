//! The shader snippets are valid, and the same in every language.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests

use naga::valid::{Capabilities, ValidationFlags, Validator};
use tree_lod::prune::{GLSL, HLSL, WGSL};

fn validate(module: &naga::Module) {
    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(module).unwrap();
    let names: Vec<_> = module.functions.iter().filter_map(|(_, f)| f.name.clone()).collect();
    for name in ["tree_prune_position", "tree_prune_color"] {
        assert!(names.iter().any(|found| found == name), "{name} is not in {names:?}");
    }
}

#[test]
fn wgsl_is_valid_in_both_stages() {
    let module = naga::front::wgsl::parse_str(&format!(
        "{WGSL}
        struct Seen {{ @builtin(position) position: vec4<f32> }}
        @vertex fn vertex(
            @location(0) position: vec3<f32>, @location(5) center: vec4<f32>, @location(6) lod: vec4<f32>,
        ) -> Seen {{
            return Seen(vec4<f32>(tree_prune_position(position, center, lod.x, lod.y, lod.z), 1.0));
        }}
        @fragment fn fragment() -> @location(0) vec4<f32> {{
            return vec4<f32>(tree_prune_color(vec3<f32>(0.1), vec3<f32>(0.2), 0.5), 1.0);
        }}"
    ));
    validate(&module.unwrap_or_else(|error| panic!("{}", error.emit_to_string(WGSL))));
}

#[test]
fn glsl_is_valid_in_both_stages() {
    let vertex = format!(
        "#version 450\n{GLSL}
        layout(location = 0) in vec3 position;
        layout(location = 5) in vec4 center;
        layout(location = 6) in vec4 lod;
        void main() {{
            gl_Position = vec4(tree_prune_position(position, center, lod.x, lod.y, lod.z), 1.0);
        }}"
    );
    let fragment = format!(
        "#version 450\n{GLSL}
        layout(location = 0) out vec4 color;
        void main() {{
            color = vec4(tree_prune_color(vec3(0.1), vec3(0.2), 0.5), 1.0);
        }}"
    );
    for (stage, source) in
        [(naga::ShaderStage::Vertex, vertex), (naga::ShaderStage::Fragment, fragment)]
    {
        let mut frontend = naga::front::glsl::Frontend::default();
        let module = frontend.parse(&naga::front::glsl::Options::from(stage), &source);
        validate(&module.unwrap_or_else(|errors| panic!("{}", errors.emit_to_string(&source))));
    }
}

/// The code of a snippet in the words of HLSL, a line a statement.
fn code(source: &str, words: &[(&str, &str)]) -> Vec<String> {
    let lines = source.lines().map(|line| line.split("//").next().unwrap_or("").trim());
    lines
        .filter(|line| !line.is_empty())
        .map(|line| words.iter().fold(line.to_owned(), |line, (from, to)| line.replace(from, to)))
        .collect()
}

#[test]
fn every_statement_is_the_same_in_all_languages() {
    let hlsl = code(HLSL, &[]);
    assert_eq!(code(GLSL, &[("vec3", "float3"), ("vec4", "float4")]), hlsl);
    // Functions are declared in another way.
    let bodies = |lines: Vec<String>| {
        let body = lines.into_iter().filter(|line| !line.contains("tree_prune_"));
        body.collect::<Vec<_>>()
    };
    let wgsl = bodies(code(WGSL, &[("var size: f32", "float size")]));
    assert_eq!(wgsl, bodies(hlsl));
    assert_eq!(wgsl.len(), 8);
}
