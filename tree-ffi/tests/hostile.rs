//! A hostile caller: a C program, made of `tree.h`, that calls every function with NULL, zeros, numbers
//! that cannot be meant, dead and foreign handles and structs of wrong sizes, each argument in turn and
//! all of them at random. Nothing may crash, panic or pass for well.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a test says what failed by failing"
)]

mod common;

use common::compile::{self, C11};
use common::header::{self, Function, Header};
use std::fmt::Write;

/// Functions that are told nothing wrong by NULL and zeros alone.
const NULL_IS_FINE: &[&str] = &[
    "tree_branching_angles_at",
    "tree_mesh_params_check",
    "tree_path_params_check",
    "tree_convert_positions",
    "tree_convert_directions",
    "tree_convert_tangents",
    "tree_convert_uvs",
    "tree_convert_triangles",
    "tree_order_check",
    "tree_turtle_params_check",
];

/// Numbers that say how long a call works: a large one is a wish, not a defect.
const UNBOUNDED: &[(&str, &str)] = &[("tree_volume_estimate_measure", "n_samples")];

/// Processes that share the functions: valgrind uses one core.
const VALGRIND_PARTS: usize = 2;

/// C that makes a small object of each kind that has no other object behind it, or of those before it.
const MAKERS: &[(&str, &str)] = &[
    ("tree_cancel", "tree_cancel_new(&made)"),
    ("tree_pool", "tree_pool_new(&one_thread, &made)"),
    ("tree_skeleton", "tree_skeleton_from_columns(&fork_columns, NULL, &made)"),
    ("tree_tree", "tree_tree_new(live_tree_skeleton(), &two_leaves, NULL, NULL, &made)"),
    ("tree_volume", "tree_volume_sphere(origin, 1, &made)"),
    ("tree_look", "tree_look_plain(NULL, &made)"),
    ("tree_mesh", "tree_mesh_build(live_tree_tree(), live_tree_look(), NULL, NULL, NULL, &made)"),
    ("tree_picture", "tree_picture_from_pixels(1, 1, pixel, 4, NULL, &made)"),
    ("tree_mask", "tree_render_mask(live_tree_mesh(), tiny_view(), NULL, &made)"),
    ("tree_graph_nodes", "tree_graph_strew(live_tree_volume(), few_nodes(), 1, NULL, &made)"),
    ("tree_leaf_model", "tree_look_leaf_model(live_tree_look(), 0, NULL, NULL, &made)"),
    ("tree_profile", "tree_profile_from_svg(svg, sizeof svg - 1, NULL, NULL, &made)"),
    (
        "tree_rows",
        "tree_skeleton_refine(live_tree_skeleton(), 1, 1, NULL, &made, other_skeleton())",
    ),
    (
        "tree_gltf_leaves",
        "tree_mesh_build_instanced(live_tree_tree(), live_tree_look(), NULL, NULL, other_mesh(), &made)",
    ),
    (
        "tree_twigs",
        "tree_twigs_build(live_tree_tree(), live_tree_look(), NULL, NULL, 1, NULL, NULL, &made)",
    ),
    ("tree_axes", "tree_skeleton_axes(live_tree_skeleton(), 0, &made)"),
    ("tree_capsules", "tree_skeleton_capsules(live_tree_skeleton(), NULL, NULL, NULL, &made)"),
    ("tree_crossings", "tree_mesh_crossings(live_tree_mesh(), 0, NULL, &made)"),
    ("tree_gltf_attributes", "tree_mesh_gltf_wind(live_tree_mesh(), NULL, &made)"),
    (
        "tree_graph",
        "tree_graph_from_edges(fork_positions, 4, fork_edges, fork_radii, 3, NULL, &made)",
    ),
    ("tree_packed", "tree_mesh_pack(live_tree_mesh(), 0, 0, NULL, &made)"),
    ("tree_unpacked", "tree_packed_unpack(live_tree_packed(), live_tree_mesh(), &made)"),
    ("tree_pieces", "tree_pieces_new(NULL, NULL, 0, NULL, &made)"),
    ("tree_separation", "tree_separation_of_mesh(live_tree_mesh(), NULL, 0, NULL, NULL, &made)"),
    (
        "tree_found_leaves",
        "tree_separation_leaves(live_tree_separation(), live_tree_skeleton(), NULL, &made)",
    ),
    ("tree_swc", "tree_swc_from_text(swc, sizeof swc - 1, NULL, NULL, &made)"),
    ("tree_texture", "tree_look_texture(live_tree_look(), 0, &made)"),
    ("tree_wind_branches", "tree_skeleton_wind_branches(live_tree_skeleton(), 0, &made)"),
    (
        "tree_photo",
        "(small_tree(), tree_photo_from_pixels(8, 12, small_rgba, sizeof small_rgba, NULL, &made))",
    ),
    ("tree_matte", "(small_tree(), tree_matte_from_alpha(8, 12, small_alpha, 96, NULL, &made))"),
    (
        "tree_trimap",
        "(small_tree(), tree_trimap_from_levels(8, 12, small_levels, 96, NULL, &made))",
    ),
    ("tree_attractor", "tree_attractor_from_columns(&fork_pixels, NULL, &made)"),
    ("tree_strokes", "tree_strokes_from_svg(svg, sizeof svg - 1, 8, 12, NULL, &made)"),
    ("tree_lines", "tree_align_warnings_text(a_warning, 1, &made)"),
    (
        "tree_aligned",
        "tree_align_all((const tree_matte *const[]){live_tree_matte()}, a_look_from_afar(), 1, 5, NULL, \
         &made)",
    ),
    ("tree_grid", "tree_grid_from_views(one_view(), 1, few_voxels(), NULL, NULL, NULL, 0, &made)"),
    ("tree_carved", "tree_carved_new(one_view(), 1, few_voxels(), NULL, &made)"),
    (
        "tree_equations",
        "tree_equations_new(live_tree_carved(), one_view(), 1, few_voxels(), NULL, &made)",
    ),
    (
        "tree_direction_field",
        "tree_direction_field_new(live_tree_attractor(), 8, 12, 3, 11, few_rows(), NULL, &made)",
    ),
    ("tree_way", "tree_way_new(live_tree_grid(), NULL, NULL, &made)"),
    (
        "tree_traces",
        "tree_traces_flow(live_tree_way(), NULL, 0, a_start, 1, 5, NULL, NULL, NULL, &made)",
    ),
    (
        "tree_photo_session",
        "tree_photo_session_new(one_shot(), 1, few_particles(), 1, NULL, &made)",
    ),
    ("tree_drawing", "tree_drawing_new(strokes_of_a_fork, 2, NULL, &made)"),
    ("tree_drawings", "tree_drawings_from_ndjson(json, sizeof json - 1, NULL, &made)"),
    ("tree_plan", "tree_drawing_clean(live_tree_drawing(), NULL, NULL, &made)"),
    ("tree_crown", "tree_crown_from_polygons(&a_triangle, 1, NULL, &made)"),
    ("tree_midlines", "tree_midlines_of(&a_triangle, NULL, NULL, &made)"),
    ("tree_templates", "tree_templates_builtin(&made)"),
    (
        "tree_inferred",
        "tree_sketch_infer(live_tree_plan(), NULL, NULL, 0, NULL, NULL, 1, NULL, &made)",
    ),
    ("tree_factor_graph", "tree_factor_graph_new(live_tree_plan(), NULL, NULL, 1, NULL, &made)"),
    ("tree_sketch_branches", "tree_inferred_branches(live_tree_inferred(), &made)"),
    (
        "tree_sketch_session",
        "tree_sketch_session_new(live_tree_drawing(), few_branches(), 1, &made)",
    ),
    ("tree_outline", "tree_outline_close(fork_spots, 4, NULL, 0, NULL, NULL, &made)"),
    ("tree_leaf_outline", "tree_leaf_outline_guess(live_tree_outline(), &made)"),
    (
        "tree_outline_drawing",
        "tree_outline_drawing_new(drawn_outlines, 2, NULL, 0, 0, NULL, &made)",
    ),
    ("tree_bumps", "tree_outline_bumps(live_tree_outline(), NULL, NULL, &made)"),
    ("tree_arranged", "tree_arranged_new(two_domains, 2, &decussate, NULL, 1, NULL, NULL, &made)"),
    (
        "tree_revolved",
        "tree_revolved_of(fork_spots, 2, (const tree_outline *const[]){live_tree_outline()}, origin, 1, \
         NULL, &made)",
    ),
    (
        "tree_silhouette_session",
        "(tree_silhouette_session_new(few_boughs(), 1, &made), \
         tree_silhouette_session_draw_crown(made, triangle_points, 3, NULL, NULL))",
    ),
    (
        "tree_silhouette_change",
        "tree_silhouette_session_draw_crown(live_tree_silhouette_session(), triangle_points, 3, NULL, &made)",
    ),
    (
        "tree_outline_plan",
        // Other calls may have taken the crown back.
        "(tree_silhouette_session_draw_crown(live_tree_silhouette_session(), triangle_points, 3, NULL, NULL), \
         tree_silhouette_session_plan(live_tree_silhouette_session(), &made))",
    ),
    (
        "tree_stand",
        "tree_stand_of_drawing(live_tree_outline_drawing(), few_trees(), 1, NULL, &made)",
    ),
    ("tree_elements", "tree_elements_of_mesh(live_tree_mesh(), NULL, 0, 0, NULL, &made)"),
    ("tree_bits", "tree_bits_of_mesh(live_tree_mesh(), tiny_view(), NULL, &made)"),
    ("tree_lod_table", "tree_lod_table_from_rows(&the_full_row, 1, &made)"),
    ("tree_metaballs", "tree_metaballs_new(fork_positions, 4, 1, NULL, &made)"),
    ("tree_hull", "tree_hull_of_metaballs(live_tree_metaballs(), NULL, NULL, &made)"),
    ("tree_scene", "tree_scene_new(one_scene_model(), 1, &one_instance, 1, NULL, &made)"),
    ("tree_scene_state", "tree_scene_state_new(live_tree_scene(), NULL, &made)"),
    ("tree_tiers", "tree_tiers_full(live_tree_mesh(), live_tree_elements(), &made)"),
    ("tree_pruned", "tree_pruned_new(one_subject(), live_tree_lod_table(), NULL, NULL, &made)"),
    ("tree_scene_levels", "tree_pruned_scene_levels(live_tree_pruned(), 2, NULL, &made)"),
    ("tree_adt", "tree_adt_of_skeleton(live_tree_skeleton(), NULL, &made)"),
    ("tree_multi_paths", "tree_multi_paths_new(live_tree_adt(), NULL, 1, NULL, &made)"),
    ("tree_multi_chain", "tree_multi_chain_new(live_tree_multi_paths(), NULL, &made)"),
    ("tree_multires", "tree_multires_new(live_tree_tree(), NULL, 1, NULL, &made)"),
    ("tree_stream_reader", "tree_stream_reader_new(NULL, &made)"),
    (
        "tree_multi_mesh",
        "tree_multi_mesh_new(live_tree_multires(), live_tree_look(), NULL, NULL, &made)",
    ),
    ("tree_grammar", "tree_grammar_from_text(a_bush, sizeof a_bush - 1, NULL, NULL, &made)"),
    ("tree_word", "tree_grammar_axiom(live_tree_grammar(), &made)"),
    (
        "tree_turtle_trace",
        "tree_word_interpret(live_tree_word(), NULL, NULL, NULL, &made, other_tree())",
    ),
    (
        "tree_leaf_boxes",
        "tree_leaf_boxes_along(live_tree_skeleton(), live_tree_mesh(), live_tree_elements(), \
         some_bearers, n_elements(), NULL, NULL, NULL, &made)",
    ),
    (
        "tree_cards",
        "tree_cards_bake(live_tree_mesh(), live_tree_elements(), live_tree_leaf_boxes(), small_cards(), NULL, \
         NULL, &made)",
    ),
    ("tree_card_choice", "tree_card_choice_new(live_tree_cards(), &made)"),
    ("tree_mips", "tree_mips_of_picture(live_tree_picture(), 2, NULL, &made)"),
    ("tree_octahedral", "tree_octahedral_bake(live_tree_mesh(), few_frames(), NULL, NULL, &made)"),
    (
        "tree_hybrid",
        "tree_hybrid_make(live_tree_tree(), live_tree_look(), small_hybrid(), NULL, &made)",
    ),
    ("tree_hybrid_choice", "tree_hybrid_choice_new(live_tree_hybrid(), &made)"),
    ("tree_bytes", "tree_mesh_to_ply(live_tree_mesh(), NULL, NULL, &made)"),
    ("tree_edit_tree", "tree_edit_tree_of_skeleton(live_tree_skeleton(), NULL, &made)"),
    (
        "tree_edit_pairs",
        "tree_skeleton_distance_pairs(live_tree_skeleton(), live_tree_skeleton(), NULL, NULL, NULL, &made)",
    ),
    (
        "tree_cloud",
        "tree_cloud_from_bytes(TREE_CLOUD_FORMAT_TEXT, (const uint8_t *)a_pole(), TREE_NUL_TERMINATED, NULL, \
         &made)",
    ),
    ("tree_scanned", "tree_skeletonize_cloud(live_tree_cloud(), NULL, NULL, NULL, &made)"),
    ("tree_grown", "tree_growth_grow(few_years(), 1, NULL, &made)"),
    ("tree_growth", "tree_growth_new(NULL, &a_seedling, 1, 1, NULL, &made)"),
    ("tree_plastic", "tree_plastic_new(live_tree_tree(), NULL, NULL, NULL, &made)"),
    (
        "tree_plastic_scene",
        "(tree_plastic_scene_new(NULL, NULL, &made), \
         tree_plastic_scene_add_tree(made, live_tree_plastic(), NULL, &some_id))",
    ),
    ("tree_plastic_clusters", "tree_plastic_clusters_of_season(live_tree_plastic(), 0, &made)"),
    (
        "tree_adapted",
        // Other calls may have taken its trees away.
        "(tree_plastic_scene_add_tree(live_tree_plastic_scene(), live_tree_plastic(), a_far_pose, &some_id), \
         tree_plastic_scene_update(live_tree_plastic_scene(), NULL, NULL), \
         tree_plastic_scene_adapted(live_tree_plastic_scene(), some_id, NULL, NULL, &made))",
    ),
];

#[test]
fn hostile_calls_are_errors() {
    let program = compile::compile("cc", C11, &[source()], "hostile");
    let said = compile::run(&mut compile::command(&program));
    assert!(said.contains("all is well"), "{said}");
}

#[test]
#[ignore = "slow: .ci/run does it"]
fn hostile_calls_touch_nothing_foreign() {
    if compile::has("valgrind") {
        let program = compile::compile("cc", C11, &[source()], "hostile_valgrind");
        std::thread::scope(|scope| {
            for part in 0..VALGRIND_PARTS {
                let program = &program;
                scope.spawn(move || {
                    let arguments = ["few", &part.to_string(), &VALGRIND_PARTS.to_string()];
                    let said = compile::run(compile::valgrind(program).args(arguments));
                    assert!(said.contains("all is well"), "{said}");
                });
            }
        });
    }
}

/// Every kind of object is thrown at the functions alive, not only dead.
#[test]
fn every_kind_of_object_is_made() {
    let header = header::parse(&header::text());
    let missing: Vec<_> = header.handles.iter().filter(|handle| maker(handle).is_none()).collect();
    assert!(missing.is_empty(), "hostile.rs has no maker for {missing:?}");
}

fn maker(handle: &str) -> Option<&'static str> {
    MAKERS.iter().find(|(name, _)| *name == handle).map(|(_, maker)| *maker)
}

fn source() -> std::path::PathBuf {
    let header = header::parse(&header::text());
    let source = compile::folder("hostile").join("hostile.c");
    std::fs::write(&source, program(&header)).unwrap();
    source
}

fn program(header: &Header) -> String {
    let mut c = include_str!("hostile_begin.c").to_owned();
    objects(header, &mut c);
    structs(header, &mut c);
    callbacks(header, &mut c);
    for function in &header.functions {
        caller(header, function, &mut c);
    }
    let structs: Vec<_> = header.structs.keys().filter(|name| header.is_sized(name)).collect();
    writeln!(c, "#define MOST_STRUCTS {}", structs.len() + 1).unwrap();
    c.push_str("static const attack attacks[] = {\n");
    for function in &header.functions {
        let kinds: Vec<_> = function
            .arguments
            .iter()
            .map(|one| Kind::of(header, &one.kind).moods(header))
            .collect();
        let list = kinds.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        // Its place among the structs, from 1 on; what is made the default is no lie.
        let made = function.arguments.get(1).is_some_and(|second| second.name == "size");
        let which = |one: &header::Named| match Kind::of(header, &one.kind) {
            Kind::Sized(name) if !made => {
                structs.iter().position(|other| *other == name).map_or(0, |at| at + 1)
            }
            _ => 0,
        };
        let which: Vec<_> = function.arguments.iter().map(|one| which(one).to_string()).collect();
        let which = if which.is_empty() { "0".to_owned() } else { which.join(", ") };
        let name = &function.name;
        let control = function.arguments.iter().position(|one| one.name == "control");
        let status = function.returns == "tree_status";
        let strict = status && !NULL_IS_FINE.contains(&name.as_str()) && !name.ends_with("_free");
        writeln!(
            c,
            "    {{\"{name}\", call_{name}, {}, {{{}}}, {{{which}}}, {}, {}}},",
            kinds.len(),
            if list.is_empty() { "0" } else { &list },
            control.map_or(-1, |at| at as i32),
            i32::from(strict),
        )
        .unwrap();
    }
    c.push_str("};\n");
    c.push_str(include_str!("hostile_end.c"));
    c
}

/// What an argument or a field is, as far as lying with it goes.
enum Kind<'a> {
    /// `tree_x *` of an object.
    Handle(&'a str),
    /// `tree_x **`: where a new one goes.
    Place,
    /// `const tree_x *const *`.
    Handles(&'a str),
    /// A struct that begins with its size.
    Sized(&'a str),
    Float,
    Integer,
    Text,
    Str,
    Callback(&'a str),
    User,
    /// Numbers, rows, places for results.
    Memory,
}

impl<'a> Kind<'a> {
    fn of(header: &'a Header, kind: &'a str) -> Self {
        let plain = kind.strip_prefix("const ").unwrap_or(kind);
        let base = plain.split([' ', '*', '(', '[']).next().unwrap_or("");
        let stars = kind.matches('*').count();
        let handle = header.handles.iter().any(|handle| handle == base);
        match (header.number(base), stars) {
            _ if header.callbacks.contains_key(plain) => Self::Callback(base),
            _ if handle && stars == 1 => Self::Handle(base),
            _ if handle && kind.starts_with("const ") && kind.contains("*const") => {
                Self::Handles(base)
            }
            _ if handle => Self::Place,
            _ if header.is_sized(base) && stars == 1 => Self::Sized(base),
            ("float" | "double", 0) => Self::Float,
            ("tree_str", 0) => Self::Str,
            (_, 0) if !header.structs.contains_key(base) => Self::Integer,
            ("char", 1) => Self::Text,
            ("void", 1) => Self::User,
            _ => Self::Memory,
        }
    }

    /// How many values there are: 0 is nothing, 1 is good, the rest is bad.
    fn moods(&self, header: &Header) -> u32 {
        match self {
            Self::Handle(_) => 6,
            Self::Handles(_) => 5,
            Self::Place | Self::Callback(_) => 2,
            Self::Sized(name) => SIZES + FIELD_MOODS * (header.structs[*name].len() as u32 - 1),
            Self::Float => 7,
            Self::Integer => 6,
            Self::Text | Self::Str => 5,
            Self::User => 1,
            Self::Memory => 5,
        }
    }

    /// The value for mood `m`, as C.
    fn value(&self, m: &str, kind: &str) -> String {
        match self {
            Self::Handle(name) => format!("hostile_{name}({m})"),
            Self::Handles(name) => format!("({kind})several(live_{name}(), {m})"),
            Self::Place => format!("({kind})new_place({m})"),
            Self::Sized(name) => format!("hostile_{name}({m})"),
            Self::Float => format!("hostile_float({m})"),
            Self::Integer => format!("({kind})hostile_integer({m}, sizeof({kind}))"),
            Self::Text => format!("({kind})hostile_text({m})"),
            Self::Str => format!("hostile_str({m})"),
            Self::Callback(name) => format!("({m} ? callback_{name} : NULL)"),
            Self::User => "NULL".to_owned(),
            Self::Memory => format!("({kind})hostile_memory({m})"),
        }
    }

    /// Moods that no function may take for good, from the first to the last.
    fn never_good(&self) -> Option<(u32, u32)> {
        match self {
            Self::Handle(_) => Some((2, 5)),
            Self::Sized(_) => Some((2, SIZES - 1)),
            _ => None,
        }
    }
}

/// Moods of a struct before those of its fields: none, good, sizes 0, 3, one too few and 2^20.
const SIZES: u32 = 6;
/// Bad values for each field.
const FIELD_MOODS: u32 = 3;

fn objects(header: &Header, c: &mut String) {
    // The foreign kinds first, then in the makers' order.
    let rank = |handle: &String| MAKERS.iter().position(|(name, _)| name == handle);
    let mut handles: Vec<_> = header.handles.iter().collect();
    handles.sort_by_key(|handle| rank(handle).unwrap_or(usize::MAX));
    for name in &handles {
        let make = maker(name).unwrap_or("0");
        let foreign = if *name == "tree_cancel" { "one_thread_pool" } else { "a_switch" };
        writeln!(
            c,
            "static {name} *alive_{name};\n\
             static {name} *live_{name}(void) {{\n    \
             if (!alive_{name}) {{ {name} *made = NULL; must({make}); alive_{name} = made; }}\n    \
             return alive_{name};\n}}\n\
             static {name} *hostile_{name}(unsigned m) {{\n    \
             switch (m) {{\n    \
             case 0: return NULL;\n    \
             case 1: return live_{name}();\n    \
             case 2: return ({name} *)dead();\n    \
             case 3: return ({name} *){foreign};\n    \
             case 4: return ({name} *)(void *)0x10;\n    \
             default: return ({name} *)(void *)((char *)live_{name}() + 1);\n    \
             }}\n}}"
        )
        .unwrap();
    }
    c.push_str("static void free_all(void) {\n");
    for name in handles.iter().rev().filter(|name| maker(name).is_some()) {
        writeln!(c, "    must({name}_free(alive_{name}));").unwrap();
    }
    c.push_str("}\n");
}

/// Several of one struct in one call, and structs that point at structs: each has room of its own.
fn structs(header: &Header, c: &mut String) {
    for name in header.structs.keys().filter(|name| header.is_sized(name)) {
        writeln!(c, "static {name} *hostile_{name}(unsigned m);").unwrap();
    }
    for name in header.callbacks.keys() {
        let (returns, arguments) = &header.callbacks[name];
        let list: Vec<_> = arguments.iter().map(|one| one.declaration.as_str()).collect();
        writeln!(c, "static {returns} callback_{name}({});", list.join(", ")).unwrap();
    }
    for (name, fields) in header.structs.iter().filter(|(name, _)| header.is_sized(name)) {
        let init = header.functions.iter().any(|function| function.name == format!("{name}_init"));
        let good = if init { format!("must({name}_init(s, sizeof *s));") } else { String::new() };
        let good = if name == "tree_control" { "calm(s);" } else { &good };
        writeln!(
            c,
            "static {name} *hostile_{name}(unsigned m) {{\n    \
             if (m == 0) return NULL;\n    \
             {name} *s = room(sizeof *s);\n    \
             s->struct_size = sizeof *s;\n    {good}\n    \
             switch (m) {{\n    \
             case 1: break;\n    \
             case 2: s->struct_size = 0; break;\n    \
             case 3: s->struct_size = 3; break;\n    \
             case 4: s->struct_size = sizeof *s - 1; break;\n    \
             case 5: s->struct_size = 1 << 20; break;"
        )
        .unwrap();
        for (i, field) in fields.iter().skip(1).enumerate() {
            for bad in 0..FIELD_MOODS {
                let value = spoilt(header, field, bad);
                let case = SIZES + FIELD_MOODS * i as u32 + bad;
                writeln!(c, "    case {case}: {value} break;").unwrap();
            }
        }
        c.push_str("    }\n    return s;\n}\n");
    }
}

fn spoilt(header: &Header, field: &header::Named, bad: u32) -> String {
    let name = &field.name;
    if field.declaration.contains("(*") {
        return format!("s->{name} = NULL;");
    }
    let embedded = header.structs.contains_key(&field.kind) && field.kind != "tree_str";
    if field.declaration.contains('[') || embedded {
        let bytes = ["0xff", "0x00", "0x7f"][bad as usize];
        return format!("memset(&s->{name}, {bytes}, sizeof s->{name});");
    }
    let kind = Kind::of(header, &field.kind);
    let mood = match (&kind, bad) {
        (Kind::Integer, bad) => [0, 3, 5][bad as usize],
        // An array without a count to go with it would be a lie that nothing can see through.
        (Kind::Memory | Kind::User | Kind::Place, _) => 0,
        (Kind::Handles(_), _) => 0,
        (Kind::Callback(_), bad) => bad % 2,
        (_, bad) => bad + 2,
    };
    format!("s->{name} = {};", kind.value(&mood.to_string(), &field.kind))
}

/// Callbacks that answer with what cannot be meant.
fn callbacks(header: &Header, c: &mut String) {
    for (name, (returns, arguments)) in &header.callbacks {
        let list: Vec<_> = arguments.iter().map(|one| one.declaration.as_str()).collect();
        let unused: String = arguments.iter().map(|one| format!(" (void){};", one.name)).collect();
        let answer = match Kind::of(header, returns) {
            Kind::Float => " return (float)NAN;",
            _ if returns == "void" => "",
            Kind::Integer => " return -1;",
            _ => " return NULL;",
        };
        writeln!(c, "static {returns} callback_{name}({}) {{{unused}{answer} }}", list.join(", "))
            .unwrap();
    }
}

fn caller(header: &Header, function: &Function, c: &mut String) {
    let name = &function.name;
    writeln!(c, "static int call_{name}(const unsigned *m) {{\n    (void)m; int bad = 0;").unwrap();
    // `tree_x_init(x, size)` believes its size.
    let believed = function.arguments.get(1).is_some_and(|second| second.name == "size");
    for (i, argument) in function.arguments.iter().enumerate() {
        let kind = Kind::of(header, &argument.kind);
        let mut mood = format!("m[{i}]");
        // A length that goes with a text: as good as any, up to the NUL.
        let after_text = i > 0 && function.arguments[i - 1].kind == "const char *";
        if after_text && argument.kind == "size_t" {
            mood = format!("(m[{i}] == 1 ? 3 : m[{i}])");
        }
        // Work that the caller asks for in full.
        if UNBOUNDED.contains(&(name.as_str(), argument.name.as_str())) {
            mood = format!("m[{i}] % 3");
        }
        let value = if believed && argument.name == "size" {
            let sized = function.arguments[0].kind.trim_end_matches(" *");
            format!("(m[{i}] == 1 ? sizeof({sized}) : m[{i}] == 2 ? SIZE_MAX : m[{i}])")
        } else {
            kind.value(&mood, &argument.kind)
        };
        let declared = argument.called(&format!("a{i}"));
        writeln!(c, "    {declared} = {value};").unwrap();
        // An array of none is not looked at.
        let counted = function.arguments.get(i + 1).is_some_and(|next| next.name.starts_with("n_"));
        if let Some((from, to)) = kind.never_good().filter(|_| !believed && !counted) {
            writeln!(c, "    bad |= m[{i}] >= {from} && m[{i}] <= {to};").unwrap();
        }
    }
    let arguments: Vec<_> = (0..function.arguments.len()).map(|i| format!("a{i}")).collect();
    let call = format!("{name}({})", arguments.join(", "));
    if function.returns != "tree_status" {
        writeln!(c, "    if (bad + 1) {call};\n    return NO_STATUS;\n}}").unwrap();
        return;
    }
    writeln!(c, "    tree_status status = {call};").unwrap();
    let is_place = |one: &header::Named| {
        matches!(Kind::of(header, &one.kind), Kind::Place) && !one.kind.starts_with("const ")
    };
    let places: Vec<_> =
        (0..function.arguments.len()).filter(|&i| is_place(&function.arguments[i])).collect();
    let all_given = places.iter().map(|i| format!("a{i} != NULL")).collect::<Vec<_>>().join(" && ");
    for &i in &places {
        let made = function.arguments[i].kind.split(' ').next().unwrap_or("");
        writeln!(
            c,
            "    if (a{i}) handed_out(status, {all_given}, *a{i}, \
             status || !*a{i} ? 0 : {made}_free(*a{i}));"
        )
        .unwrap();
    }
    let frees =
        name.strip_suffix("_free").filter(|kind| header.handles.iter().any(|one| one == kind));
    if let Some(kind) = frees {
        writeln!(c, "    if (status == TREE_OK && a0 == alive_{kind}) alive_{kind} = NULL;")
            .unwrap();
    }
    c.push_str("    return bad && status == TREE_OK ? PASSED_FOR_WELL : status;\n}\n");
}
