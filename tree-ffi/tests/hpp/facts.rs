//! What `tree.h` says in words only.

use crate::common::header::Header;

/// Places for one number or one struct without a size.
pub(crate) const SINGLES: &[&str] = &[
    "angle",
    "area",
    "arrangement",
    "azimuth",
    "by_all",
    "by_bumps",
    "contrast",
    "coverage",
    "cut",
    "difference",
    "distance",
    "domain",
    "gap",
    "growth",
    "id",
    "iou",
    "kind",
    "lambda",
    "length",
    "level",
    "measure",
    "metres",
    "n_indices",
    "n_levels",
    "n_runs",
    "n_triangles",
    "phase",
    "pose",
    "posterior",
    "precision",
    "quality",
    "radius",
    "reach",
    "recall",
    "row",
    "scale",
    "score",
    "seconds",
    "seed",
    "share",
    "shown",
    "sway",
    "n_threads",
    "value",
    "volume",
    "window",
];

/// Yes or no, as an argument.
pub(crate) const FLAGS: &[&str] = &["hemi", "left", "plain", "with_crown", "with_stalks"];

/// Objects and arrays that may be left out.
pub(crate) fn is_optional(function: &str, argument: &str) -> bool {
    matches!(argument, "look" | "hints" | "mtl" | "branches")
        || matches!(
            (function, argument),
            ("tree_packed_unpack", "mesh")
                | ("tree_grid_new", "values")
                | ("tree_elements_of_mesh", "surfaces")
                | ("tree_order_coverage", "tiers")
                | ("tree_sketch_branches_propagate", "crown" | "obstacles")
                | ("tree_sketch_grow_crown", "crown")
                | ("tree_sketch_infer", "pins")
                | ("tree_sketch_session_set_templates", "templates")
                | ("tree_sketch_session_set_obstacles", "obstacles")
                | ("tree_from_sketch", "templates" | "obstacles")
                | ("tree_branch_infer", "outline")
                | ("tree_crown_close", "spots")
                | ("tree_templates_select", "crown")
                | ("tree_attractor_livewire" | "tree_matte_turned", "photo")
        )
}

/// Structs that have no default.
pub(crate) fn is_required(argument: &str) -> bool {
    matches!(argument, "camera" | "columns" | "frame" | "leaf" | "meta" | "pixels" | "samples")
}

/// Arrays that have one count with those after them.
pub(crate) fn shares_count(argument: &str) -> bool {
    matches!(argument, "depths" | "edges" | "rays")
}

/// Numbers in one item of an array that is taken.
pub(crate) fn width(function: &str, argument: &str) -> usize {
    match (function, argument) {
        ("tree_convert_tangents", "from") => 4,
        ("tree_convert_uvs", "from") | (_, "edges" | "profile") => 2,
        (_, "eraser" | "seeds" | "spots" | "stroke") => 2,
        (_, "branch" | "line" | "parent") | ("tree_revolved_of", "axis") => 2,
        (_, "rays") => 4,
        ("tree_traces_flow", "starts") => 3,
        (_, "ways") => 6,
        (_, "from" | "points" | "positions" | "indices") => 3,
        _ => 1,
    }
}

/// Numbers in an array of one length that is taken without a count.
pub(crate) fn fixed(function: &str, argument: &str) -> usize {
    match argument {
        "columns" => 12,
        "view" | "projection" if function == "tree_scene_eye_check" => 16,
        "affine" => 6,
        "center_rank" => 4,
        "branch" if function == "tree_multi_mesh_position" => 4,
        "weights" => 6,
        "pixel" | "place" => 2,
        "at" | "at_pixel" | "base_pixel" | "by_pixels" | "stretch" => 2,
        "low" | "high" if function == "tree_outline_mask" => 2,
        "base" | "tip" if function == "tree_leaf_outline_of" => 2,
        "end" | "tangent" if function == "tree_branch_infer" => 2,
        _ => 3,
    }
}

/// How many numbers or rows a call writes at most, as an expression of its arguments.
pub(crate) fn room(function: &str, argument: &str) -> Option<&'static str> {
    Some(match (function.trim_start_matches("tree_"), argument) {
        ("skeleton_children", "starts") => "view().n_nodes + 1",
        ("skeleton_from_unordered", _) => "columns ? columns->n_nodes : 0",
        ("mask_bits", _) => "view().n_pixels",
        ("leaf_bearers_of_tree" | "leaf_bearers_nearest", _) => "elements.view().n_elements",
        ("leaf_boxes_planes", _) => "6",
        ("plastic_scene_motions", _) => {
            "[&] { const auto nodes = this->model(id).tree().skeleton(); return nodes.view().n_nodes; }()"
        }
        ("growth_light", _) => "points.size() / 3",
        ("card_choice_boxes", _) => "measure().n_boxes",
        ("card_choice_ranges", _) => "measure().n_ranges",
        ("octahedral_frames", _) => "3",
        ("bits_words", _) => "measure().n_words",
        ("bits_bytes", _) => "measure().n_pixels",
        ("order_coverage", "order") => "elements.view().n_elements",
        ("order_coverage", _) => "3 * elements.view().n_elements",
        (name, "order") if name.starts_with("order_") => "view().n_elements",
        ("metaballs_values", _) => "points.size() / 3",
        ("metaballs_gradients" | "hull_nearest", _) => "points.size()",
        ("hull_sample", _) => "3 * n_samples",
        ("pruned_kept", _) => "measure().n_tiers",
        ("pruned_level", _) => "measure().n_parts",
        ("pruned_levels", "levels") => "n",
        ("pruned_levels", _) => "n * measure().n_parts",
        ("multi_mesh_draws", _) => "measure().n_surfaces",
        ("lod_distance_places", _) => "TREE_LOD_DISTANCE_SAMPLES",
        ("mesh_wind", _) => "this->surface(surface).n_vertices",
        ("mesh_bend", _) => "3 * this->surface(surface).n_vertices",
        ("mesh_points", _) => "this->surface(number).n_vertices",
        ("pieces_link", _) => "count()",
        ("grid_sample" | "grid_nearest", _) => "points.size() / 3",
        ("grid_draw_points", _) => "3 * static_cast<size_t>(n_points)",
        ("grid_from_views" | "carved_solve", _) => "views.size()",
        ("sketch_branches_orders" | "sketch_branches_relations", _) => "view().n_segments",
        ("direction_field_sample", _) => "spots.size()",
        ("way_sample" | "way_directions", _) => "points.size()",
        ("matte_sample", _) => "spots.size() / 2",
        ("particle_camera_project", _) => "points.size() / 3 * 2",
        ("particle_camera_pixel_sizes", _) => "points.size() / 3",
        ("particle_camera_rays", _) => "spots.size() / 2 * 6",
        ("matte_seeds", _) => "2 * static_cast<size_t>(most)",
        ("attractor_from_strokes", _) => "columns ? columns->n_strokes : 0",
        ("graph_search", _) => "view().n_nodes",
        ("word_lines", _) => "6 * view().n_modules",
        ("volume_sample", _) => "3 * n_points",
        ("volume_contains" | "volume_distance", _) => "points.size() / 3",
        ("plan_points_to_drawing" | "plan_points_from_drawing" | "convex_hull", _) => {
            "spots.size()"
        }
        ("crown_contains", _) => "spots.size() / 2",
        ("crown_levels", _) => "points.size() / 3",
        ("crown_exits", _) => "ways.size() / 6",
        ("outline_contains" | "outline_nearest" | "line_nearest", _) => "spots.size() / 2",
        ("outline_exits" | "revolved_exits", _) => "rays.size() / 4",
        ("outline_along", _) => "2 * lengths.size()",
        ("outline_part", _) => "2 * view().n_points + 4",
        ("outline_mask", _) => "static_cast<size_t>(width) * height",
        ("line_at", _) => "2 * places.size()",
        ("branching_angles_at", _) => "places.size()",
        ("branching_angles_set", _) => "2 * this->n_samples + 8",
        ("branch_carry", _) => "branch.size()",
        ("revolved_to_frame", _) => "spots.size()",
        ("revolved_contains", _) => "points.size() / 3",
        ("footprint_of", _) => "TREE_FOOTPRINT_DIRECTIONS",
        ("templates_select", _) => "count()",
        (name, _) if name.starts_with("convert_") => "from.size()",
        (name, _) if name.starts_with("skeleton_") => "view().n_nodes",
        _ => return None,
    })
}

/// The count of what was written, where that can be less than the room.
pub(crate) fn written(function: &str, argument: &str) -> Option<&'static str> {
    match (function, argument) {
        ("tree_matte_seeds", "seeds") => Some("2 * n_seeds"),
        ("tree_sketch_branches_relations", "relations") => Some("n_relations"),
        ("tree_outline_part" | "tree_branch_carry", "points") => Some("2 * n_points"),
        ("tree_branching_angles_set", "samples") => Some("2 * n_samples"),
        ("tree_convex_hull", "corners") => Some("2 * n_corners"),
        ("tree_pruned_levels", "levels") => Some("n_levels"),
        ("tree_pruned_levels", "windows") => Some("n_levels * measure().n_parts"),
        ("tree_word_lines", "lines") => Some("6 * n_lines"),
        ("tree_mesh_points", "first") => Some("n_points"),
        ("tree_skeleton_strahler_counts", "rows") => Some("n_rows"),
        ("tree_skeleton_runs", "runs") => Some("n_runs"),
        ("tree_skeleton_pipe_exponents", "exponents") => Some("n_exponents"),
        ("tree_skeleton_lateral_angles", "laterals") => Some("n_laterals"),
        ("tree_skeleton_children", "nodes") => Some("starts.empty() ? 0 : starts.back()"),
        _ => None,
    }
}

/// Whether it is a callback that asks a number of a place.
pub(crate) fn is_field(header: &Header, kind: &str) -> bool {
    header.callbacks.get(kind).is_some_and(|(returns, arguments)| {
        let kinds: Vec<_> = arguments.iter().map(|one| one.kind.as_str()).collect();
        returns == "float" && kinds == ["void *", "const float *"]
    })
}

/// Whether a result points into what it was asked of.
pub(crate) fn has_pointers(header: &Header, kind: &str) -> bool {
    kind == "tree_str"
        || header.structs.get(kind).is_some_and(|fields| {
            let points = |kind: &str| kind.contains('*') || has_pointers(header, kind);
            fields.iter().any(|field| points(&field.kind))
        })
}
