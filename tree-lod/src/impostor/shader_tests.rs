//! The shader snippets are valid, and the same in every language.

use super::{cards, octahedral};
use naga::valid::{Capabilities, ValidationFlags, Validator};

const HOOKS: &str = "vec4 tree_octa_color(vec2 place) { return vec4(place, 0.0, 1.0); }
    vec4 tree_octa_detail(vec2 place) { return vec4(place, 0.0, 1.0); }\n";
const WGSL_HOOKS: &str =
    "fn tree_octa_color(place: vec2<f32>) -> vec4<f32> { return vec4(place, 0.0, 1.0); }
    fn tree_octa_detail(place: vec2<f32>) -> vec4<f32> { return vec4(place, 0.0, 1.0); }\n";

fn validate(module: &naga::Module) {
    Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(module).unwrap();
    let names: Vec<_> = module.functions.iter().filter_map(|(_, f)| f.name.clone()).collect();
    assert!(
        names.iter().any(|name| name == "tree_octa_view" || name == "tree_card_kept"),
        "{names:?}"
    );
}

#[test]
fn wgsl_is_valid() {
    for (hooks, source) in [("", cards::WGSL), (WGSL_HOOKS, octahedral::WGSL)] {
        let source = format!("{hooks}{source}");
        let module = naga::front::wgsl::parse_str(&source);
        validate(&module.unwrap_or_else(|error| unreachable!("{}", error.emit_to_string(&source))));
    }
}

#[test]
fn glsl_is_valid() {
    for (hooks, source) in [("", cards::GLSL), (HOOKS, octahedral::GLSL)] {
        let source = format!("#version 450\n{hooks}{source}\nvoid main() {{}}");
        let options = naga::front::glsl::Options::from(naga::ShaderStage::Fragment);
        let module = naga::front::glsl::Frontend::default().parse(&options, &source);
        validate(&module.unwrap_or_else(|error| unreachable!("{}", error.emit_to_string(&source))));
    }
}

/// The statements of a snippet, without comments and the heads of functions, in the words of GLSL.
fn statements(source: &str, words: &[(&str, &str)]) -> Vec<String> {
    let lines = source.lines().map(|line| line.split("//").next().unwrap_or("").trim());
    let head =
        |line: &str| line.contains(" tree_") && line.ends_with(") {") || line.starts_with("fn ");
    lines
        .filter(|line| !line.is_empty() && !head(line))
        .map(|line| words.iter().fold(line.to_owned(), |line, (from, to)| line.replace(from, to)))
        .map(|line| match line.strip_prefix("var ").and_then(|rest| rest.split_once(": ")) {
            // `var name: type = value` is `type name = value`.
            Some((name, rest)) => match rest.split_once(' ') {
                Some((kind, value)) => format!("{kind} {name} {value}"),
                None => line,
            },
            None => line,
        })
        .collect()
}

#[test]
fn every_statement_is_the_same_in_all_languages() {
    let hlsl = [("float2", "vec2"), ("float3", "vec3"), ("float4", "vec4")];
    let wgsl = [
        ("vec2<f32>", "vec2"),
        ("vec3<f32>", "vec3"),
        ("vec4<f32>", "vec4"),
        (": f32", ": float"),
        ("var i: i32 = 0", "int i = 0"),
    ];
    for [g, h, w] in [
        [cards::GLSL, cards::HLSL, cards::WGSL],
        [octahedral::GLSL, octahedral::HLSL, octahedral::WGSL],
    ] {
        let wanted = statements(g, &[]);
        assert!(wanted.len() > 40);
        assert_eq!(statements(h, &hlsl), wanted);
        assert_eq!(statements(w, &wgsl), wanted);
    }
}

#[test]
fn the_numbers_of_the_reference_are_those_of_the_shaders() {
    let steps = format!("for (int i = 0; i < {}; i = i + 1)", octahedral::STEPS);
    assert!(octahedral::GLSL.contains(&steps));
    for number in [
        format!("-slab - {} * size.x", octahedral::THICKNESS),
        format!("slab + {} * size.x", octahedral::SLACK),
        format!("seen + {} * hidden", octahedral::HIDDEN),
    ] {
        assert!(octahedral::GLSL.contains(&number), "{number}");
    }
}
