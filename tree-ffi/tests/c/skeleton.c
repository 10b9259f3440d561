#include "check.h"
#include <math.h>
#include <time.h>

static int near(double a, double b) { return fabs(a - b) < 1e-5; }

static void test_columns(void) {
    tree_skeleton *fork = a_fork();
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(fork, &view));
    CHECK(view.n_nodes == 4);
    CHECK(view.parents[0] == TREE_NO_PARENT && view.parents[3] == 1);
    CHECK(view.positions[3 * 3 + 1] == 2.0f);

    float box[6];
    OK(tree_skeleton_bounds(fork, &box));
    CHECK(box[1] == 0.0f && box[4] == 2.5f);

    /* The same nodes from the tips down. */
    float positions[12], radii[4];
    uint32_t parents[4], rows[4];
    for (int i = 0; i < 4; i++) {
        memcpy(positions + 3 * i, view.positions + 3 * (3 - i), 3 * sizeof(float));
        radii[i] = view.radii[3 - i];
        parents[i] = view.parents[3 - i] == TREE_NO_PARENT ? TREE_NO_PARENT : 3 - view.parents[3 - i];
    }
    tree_skeleton_columns columns = {sizeof columns, 4, positions, radii, parents};
    tree_skeleton *turned = NULL;
    OK(tree_skeleton_from_unordered(&columns, NULL, rows, &turned));
    CHECK(rows[0] == 3 && rows[1] == 2);
    OK(tree_skeleton_free(turned));

    FAILS(TREE_ERROR_INVALID, "root", tree_skeleton_from_columns(&columns, NULL, &turned));
    CHECK(turned == NULL);
    columns.n_nodes = (size_t)1 << 60;
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_skeleton_from_columns(&columns, NULL, &turned));
    columns.struct_size = 3;
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof", tree_skeleton_from_columns(&columns, NULL, &turned));

    OK(tree_skeleton_free(fork));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_skeleton_free(fork));
    OK(tree_skeleton_free(NULL));
}

static void test_replaced_columns(void) {
    tree_skeleton *fork = a_fork(), *changed = NULL;
    tree_skeleton_columns view = {.struct_size = sizeof view};
    float radii[] = {0.4f, 0.3f, 0.2f, 0.1f};
    OK(tree_skeleton_with_radii(fork, radii, 4, &changed));
    OK(tree_skeleton_view(changed, &view));
    CHECK(view.radii[2] == 0.2f && view.parents[2] == 1);
    OK(tree_skeleton_free(changed));
    OK(tree_skeleton_view(fork, &view));
    CHECK(view.radii[2] == 0.01f);

    FAILS(TREE_ERROR_INVALID, "radii", tree_skeleton_with_radii(fork, radii, 3, &changed));
    CHECK(changed == NULL);
    FAILS(TREE_ERROR_NULL, "radii", tree_skeleton_with_radii(fork, NULL, 4, &changed));
    radii[3] = -1.0f;
    CHECK(tree_skeleton_with_radii(fork, radii, 4, &changed) != TREE_OK && changed == NULL);

    float positions[12] = {0, 0, 0, 0, 2, 0, 1, 3, 0, -1, 3, 0};
    OK(tree_skeleton_with_positions(fork, positions, 4, &changed));
    OK(tree_skeleton_view(changed, &view));
    CHECK(view.positions[4] == 2.0f && view.radii[1] == 0.08f);
    OK(tree_skeleton_free(changed));
    positions[5] = NAN;
    FAILS(TREE_ERROR_PARAMETER, "positions",
          tree_skeleton_with_positions(fork, positions, 4, &changed));
    OK(tree_skeleton_free(fork));
}

static void test_axes(void) {
    tree_skeleton *fork = a_fork();
    tree_axes *axes = NULL;
    OK(tree_skeleton_axes(fork, TREE_CONTINUATION_LONGEST, &axes));
    OK(tree_skeleton_free(fork));
    tree_axis_columns view = {.struct_size = sizeof view};
    OK(tree_axes_view(axes, &view));
    CHECK(view.n_axes == 2 && view.n_nodes == 4);
    CHECK(view.orders[0] == 0 && view.orders[1] == 1);
    CHECK(view.starts[0] == 0 && view.starts[1] == 3 && view.starts[2] == 4);
    CHECK(view.nodes[2] == 2 && view.nodes[3] == 3);
    CHECK(view.axis_of[1] == 0 && view.axis_of[3] == 1);
    OK(tree_axes_free(axes));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_axes_view(axes, &view));

    fork = a_fork();
    OK(tree_skeleton_axes(fork, TREE_CONTINUATION_STRAIGHTEST, &axes));
    OK(tree_axes_view(axes, &view));
    CHECK(view.axis_of[2] == 0);
    OK(tree_axes_free(axes));
    FAILS(TREE_ERROR_ENUM, "TREE_CONTINUATION_", tree_skeleton_axes(fork, 3, &axes));
    CHECK(axes == NULL);
    OK(tree_skeleton_free(fork));
}

/* The root, a trunk of one segment, and two branches of one segment each. */
static void test_branching(void) {
    tree_skeleton *fork = a_fork();
    tree_branching_report report = {.struct_size = sizeof report};
    OK(tree_skeleton_branching(fork, &report));
    CHECK(report.n_orders == 2 && report.n_runs == 3);
    CHECK(near(report.bifurcation_ratio, 2) && report.length_ratio > 0 && report.pipe_exponent == 0);

    uint32_t orders[4], run_of[4];
    OK(tree_skeleton_strahler_orders(fork, orders, 4));
    CHECK(orders[0] == 2 && orders[1] == 2 && orders[2] == 1 && orders[3] == 1);
    tree_strahler_order rows[4];
    size_t n = 0;
    OK(tree_skeleton_strahler_counts(fork, rows, 4, &n));
    CHECK(n == 2 && rows[0].n_branches == 2 && rows[1].n_branches == 1 && near(rows[1].mean_length, 1));

    tree_unbranched_run runs[4];
    OK(tree_skeleton_runs(fork, runs, 4, &n));
    OK(tree_skeleton_run_of(fork, run_of, 4));
    CHECK(n == 3 && runs[0].parent == TREE_NO_PARENT && runs[0].end == 1 && runs[0].is_tip == 0);
    CHECK(runs[1].is_tip == 1 && runs[1].n_segments == 1 && near(runs[1].radius, 0.01));
    CHECK(run_of[0] == 0 && run_of[1] == 0 && run_of[2] == 1 && run_of[3] == 2);

    double exponents[4];
    OK(tree_skeleton_pipe_exponents(fork, exponents, 4, &n));
    CHECK(n == 0);
    tree_lateral_angle laterals[4];
    OK(tree_skeleton_lateral_angles(fork, TREE_CONTINUATION_LONGEST, 0, laterals, 4, &n));
    CHECK(n == 1 && laterals[0].node == 3 && near(laterals[0].angle, atan(0.5)));

    FAILS(TREE_ERROR_BUFFER, "rows", tree_skeleton_strahler_counts(fork, rows, 1, &n));
    FAILS(TREE_ERROR_BUFFER, "runs", tree_skeleton_runs(fork, runs, 2, &n));
    FAILS(TREE_ERROR_NULL, "n_runs", tree_skeleton_runs(fork, runs, 4, NULL));
    FAILS(TREE_ERROR_PARAMETER, "reach", tree_skeleton_lateral_angles(fork, 0, -1, laterals, 4, &n));
    FAILS(TREE_ERROR_ENUM, "TREE_CONTINUATION_", tree_skeleton_lateral_angles(fork, 3, 0, laterals, 4, &n));
    OK(tree_skeleton_free(fork));

    /* Two branches of two segments, each with half the cross-section of the trunk: Leonardo's exponent. */
    float positions[] = {0, 0, 0, 0, 1, 0, 1, 2, 0, 1, 3, 0, -1, 2, 0, -1, 3, 0};
    float thin = 0.2f * (float)sqrt(0.5), radii[] = {0.2f, 0.2f, thin, thin, thin, thin};
    uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 2, 1, 4};
    tree_skeleton_columns columns = {sizeof columns, 6, positions, radii, parents};
    OK(tree_skeleton_from_columns(&columns, NULL, &fork));
    OK(tree_skeleton_branching(fork, &report));
    OK(tree_skeleton_pipe_exponents(fork, exponents, 4, &n));
    CHECK(n == 1 && fabs(exponents[0] - 2) < 1e-3 && exponents[0] == report.pipe_exponent);
    OK(tree_skeleton_free(fork));
}

static void test_measures(void) {
    tree_skeleton *fork = a_fork();
    float lengths[4], low[4], high[4];
    uint32_t sizes[4], tips[4];
    OK(tree_skeleton_segment_lengths(fork, lengths, 4));
    OK(tree_skeleton_distances_to_root(fork, low, 4));
    OK(tree_skeleton_distances_to_tip(fork, high, 4));
    OK(tree_skeleton_subtree_sizes(fork, sizes, 4));
    OK(tree_skeleton_tip_counts(fork, tips, 4));
    double longest = sqrt(0.5 * 0.5 + 1.5 * 1.5);
    CHECK(lengths[0] == 0 && lengths[1] == 1 && near(lengths[2], longest));
    CHECK(low[0] == 0 && near(low[2], 1 + longest));
    CHECK(near(high[0], 1 + longest) && high[2] == 0 && high[3] == 0);
    CHECK(sizes[0] == 4 && sizes[1] == 3 && sizes[3] == 1);
    CHECK(tips[0] == 2 && tips[2] == 1);

    uint32_t starts[5], nodes[3];
    OK(tree_skeleton_children(fork, starts, 5, nodes, 3));
    CHECK(starts[0] == 0 && starts[1] == 1 && starts[2] == 3 && starts[4] == 3);
    CHECK(nodes[0] == 1 && nodes[1] == 2 && nodes[2] == 3);

    FAILS(TREE_ERROR_BUFFER, "lengths", tree_skeleton_segment_lengths(fork, lengths, 3));
    FAILS(TREE_ERROR_NULL, "counts", tree_skeleton_tip_counts(fork, NULL, 4));
    FAILS(TREE_ERROR_BUFFER, "starts", tree_skeleton_children(fork, starts, 4, nodes, 3));
    FAILS(TREE_ERROR_BUFFER, "nodes", tree_skeleton_children(fork, starts, 5, nodes, 2));
    OK(tree_skeleton_free(fork));

    /* A lone node has no children, and needs no room for them. */
    float position[3] = {0, 0, 0}, radius = 0.1f;
    uint32_t parent = TREE_NO_PARENT;
    tree_skeleton_columns columns = {sizeof columns, 1, position, &radius, &parent};
    OK(tree_skeleton_from_columns(&columns, NULL, &fork));
    OK(tree_skeleton_children(fork, starts, 2, NULL, 0));
    CHECK(starts[0] == 0 && starts[1] == 0);
    OK(tree_skeleton_free(fork));
}

static void test_radii(void) {
    tree_skeleton *fork = a_fork(), *changed = NULL;
    tree_radius_rule rule;
    float radii[4];
    OK(tree_radius_rule_init(&rule, sizeof rule));
    CHECK(rule.kind == TREE_RADII_PIPE && rule.exponent == (float)TREE_PIPE_MURRAY);
    CHECK(rule.trunk_radius == 0 && rule.zeta == 0.3f && rule.strand_diameter == 0.004f);
    OK(tree_radius_rule_check(&rule));

    OK(tree_skeleton_radii(fork, NULL, radii, 4));
    CHECK(radii[2] == 0.002f && radii[0] > radii[1] && radii[1] > radii[2]);
    rule.trunk_radius = 0.2f;
    OK(tree_skeleton_with_rule(fork, &rule, &changed));
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(changed, &view));
    CHECK(view.radii[0] == 0.2f && view.positions[4] == 1.0f);
    OK(tree_skeleton_free(changed));

    rule.kind = TREE_RADII_TIP_DISTANCE;
    OK(tree_skeleton_radii(fork, &rule, radii, 4));
    CHECK(radii[2] == 0.001f && near(radii[1], 0.05 * pow(sqrt(2.5), 0.3)));
    uint32_t levels[4] = {1, 1, 1, 1};
    float halved[4];
    OK(tree_skeleton_radii_at_levels(fork, levels, 4, &rule, halved, 4));
    CHECK(near(halved[1], radii[1] / 2));
    FAILS(TREE_ERROR_INVALID, "levels",
          tree_skeleton_radii_at_levels(fork, levels, 3, NULL, halved, 4));

    rule.kind = TREE_RADII_STRANDS;
    uint64_t strands[4];
    OK(tree_skeleton_strands(fork, NULL, strands, 4));
    CHECK(strands[0] == 2 && strands[1] == 2 && strands[2] == 1 && strands[3] == 1);
    rule.strand_count = TREE_STRANDS_BY_ANGLE;
    rule.strand_base = 100;
    OK(tree_skeleton_strands(fork, &rule, strands, 4));
    CHECK(strands[1] == 100 && strands[2] + strands[3] == 100 && strands[2] > strands[3]);
    OK(tree_skeleton_radii(fork, &rule, radii, 4));
    CHECK(near(radii[0], 0.02));

    rule.strand_base = 1;
    FAILS(TREE_ERROR_PARAMETER, "count.base", tree_skeleton_strands(fork, &rule, strands, 4));
    rule.strand_count = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_STRANDS_", tree_skeleton_radii(fork, &rule, radii, 4));
    rule.kind = 3;
    FAILS(TREE_ERROR_ENUM, "TREE_RADII_", tree_skeleton_with_rule(fork, &rule, &changed));
    CHECK(changed == NULL);
    rule.kind = TREE_RADII_PIPE;
    rule.taper = 2;
    FAILS(TREE_ERROR_PARAMETER, "taper", tree_radius_rule_check(&rule));
    rule.taper = NAN;
    CHECK(tree_radius_rule_check(&rule) != TREE_OK && strstr(tree_error_text(), "taper"));
    FAILS(TREE_ERROR_BUFFER, "radii", tree_skeleton_radii(fork, NULL, radii, 3));
    OK(tree_skeleton_free(fork));
}

static void test_angles(void) {
    float angles[2];
    OK(tree_murray_angles(1.26f, 1, 1, &angles));
    CHECK(near(angles[0], angles[1]) && fabs(angles[0] - 0.654) < 1e-2);
    OK(tree_pipe_angles((float)TREE_PIPE_MANDELBROT, 0.1f, 1, &angles));
    CHECK(angles[0] > angles[1] && angles[1] > 0);
    OK(tree_pipe_angles((float)TREE_PIPE_DA_VINCI, 1, 1, &angles));
    CHECK(near(angles[0], 0));
    OK(tree_strand_angles(3, 1, 1, &angles));
    CHECK(near(angles[0], 0.25) && near(angles[1], 0.75));
    FAILS(TREE_ERROR_PARAMETER, "r0", tree_murray_angles(5, 1, 1, &angles));
    FAILS(TREE_ERROR_PARAMETER, "exponent", tree_pipe_angles(1, 1, 1, &angles));
    FAILS(TREE_ERROR_PARAMETER, "s1", tree_strand_angles(0, 0, 1, &angles));
    FAILS(TREE_ERROR_NULL, "angles", tree_strand_angles(1, 1, 1, NULL));
}

static void test_swc_text(void) {
    static const char text[] = "# a survey\n7 3 5 6 0 0 -1\n9 3 5 6 2 0.5 7 8\n11 4 5 7 3 0 9\n";
    tree_swc_options options;
    OK(tree_swc_options_init(&options, sizeof options));
    CHECK(options.scale == 1 && options.up == TREE_UP_Z && options.base_at_origin == 1);
    options.unknown_radius = TREE_SWC_RADIUS_INTERPOLATE;
    tree_swc *swc = NULL;
    OK(tree_swc_from_text(text, TREE_NUL_TERMINATED, &options, NULL, &swc));
    tree_swc_contents contents = {.struct_size = sizeof contents};
    OK(tree_swc_view(swc, &contents));
    CHECK(contents.n_nodes == 3 && contents.types[2] == 4 && contents.ids[1] == 9);
    CHECK(contents.n_unknown_radii == 2 && contents.n_filled_radii == 2);
    CHECK(contents.n_rows_with_more_fields == 1 && contents.reordered == 0);
    CHECK(contents.moved_by[0] == -5 && contents.moved_by[2] == 6);
    CHECK(contents.comments.len >= 8 && strstr(contents.comments.data, "a survey"));

    tree_skeleton *skeleton = NULL;
    OK(tree_swc_skeleton(swc, &skeleton));
    OK(tree_swc_free(swc));
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(skeleton, &view));
    CHECK(view.positions[4] == 2 && view.radii[2] == 0.5f);
    OK(tree_skeleton_free(skeleton));

    FAILS(TREE_ERROR_FORMAT, "2", tree_swc_from_text("1 3 0 0 0 1 -1\n2 3", 18, NULL, NULL, &swc));
    CHECK(swc == NULL);
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.nodes = 2;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "nodes",
          tree_swc_from_text(text, sizeof text - 1, NULL, &control, &swc));
    options.up = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_UP_",
          tree_swc_from_text(text, sizeof text - 1, &options, NULL, &swc));
    options.up = TREE_UP_Y;
    options.unknown_radius = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_SWC_RADIUS_",
          tree_swc_from_text(text, sizeof text - 1, &options, NULL, &swc));
    options.unknown_radius = TREE_SWC_RADIUS_KEEP;
    options.reserved = 1;
    FAILS(TREE_ERROR_PARAMETER, "reserved",
          tree_swc_from_text(text, sizeof text - 1, &options, NULL, &swc));
    FAILS(TREE_ERROR_NULL, "text", tree_swc_from_text(NULL, 3, NULL, NULL, &swc));
}

static void test_swc_files(void) {
    tree_skeleton *fork = a_fork(), *again = NULL;
    tree_skeleton_columns one = {.struct_size = sizeof one}, two = one;
    OK(tree_skeleton_view(fork, &one));

    tree_bytes *bytes = NULL;
    OK(tree_skeleton_to_swc(fork, NULL, &bytes));
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_bytes_view(bytes, &data, &len));
    tree_swc *swc = NULL;
    OK(tree_swc_from_text((const char *)data, len, NULL, NULL, &swc));
    OK(tree_swc_skeleton(swc, &again));
    OK(tree_skeleton_view(again, &two));
    CHECK(two.n_nodes == 4 && !memcmp(one.positions, two.positions, 12 * sizeof(float)));
    OK(tree_skeleton_free(again));
    OK(tree_swc_free(swc));
    OK(tree_bytes_free(bytes));

    const char *folder = getenv("TMPDIR");
    char path[512];
    snprintf(path, sizeof path, "%s/tree-%p-%ld.swc", folder ? folder : "/tmp", (void *)fork,
             (long)time(NULL));
    tree_swc_options options;
    OK(tree_swc_options_init(&options, sizeof options));
    options.up = TREE_UP_Y;
    OK(tree_skeleton_write_swc(fork, path, TREE_NUL_TERMINATED, &options));
    OK(tree_swc_read(path, strlen(path), &options, NULL, &swc));
    OK(tree_swc_skeleton(swc, &again));
    OK(tree_skeleton_view(again, &two));
    CHECK(!memcmp(one.radii, two.radii, 4 * sizeof(float)));
    OK(tree_skeleton_free(again));
    OK(tree_swc_free(swc));
    CHECK(remove(path) == 0);

    FAILS(TREE_ERROR_IO, path, tree_swc_read(path, strlen(path), NULL, NULL, &swc));
    FAILS(TREE_ERROR_IO, "nowhere",
          tree_skeleton_write_swc(fork, "/nowhere/at/all.swc", TREE_NUL_TERMINATED, NULL));
    options.scale = 0;
    FAILS(TREE_ERROR_PARAMETER, "scale", tree_skeleton_write_swc(fork, path, strlen(path), &options));
    options.scale = NAN;
    CHECK(tree_skeleton_to_swc(fork, &options, &bytes) != TREE_OK && bytes == NULL);
    OK(tree_skeleton_free(fork));
}

void test_skeleton(void) {
    test_columns();
    test_replaced_columns();
    test_axes();
    test_measures();
    test_branching();
    test_radii();
    test_angles();
    test_swc_text();
    test_swc_files();
}
