#include "check.h"
#include <math.h>

enum { POST = 1000 };

/* A post of two metres and ten centimetres across, z up, far from the origin; with `shift` another beside it. */
static void post(double *points, double shift) {
    for (int i = 0; i < POST; i++) {
        points[3 * i] = 430000 + shift + 0.05 * cos(0.7 * i);
        points[3 * i + 1] = 0.05 * sin(0.7 * i);
        points[3 * i + 2] = 0.002 * i;
    }
}

static void whole(void) {
    static double points[3 * (2 * POST + 2)];
    post(points, 0);
    points[3 * POST] = NAN;
    memcpy(points + 3 * POST + 3, points, 3 * sizeof *points);
    tree_scan_params params;
    OK(tree_scan_params_init(&params, sizeof params));
    CHECK(params.up == TREE_UP_Z && params.unit == 1 && params.neighbours == 8 && params.ground == 1);
    OK(tree_scan_params_check(&params));
    tree_scan_report report = {.struct_size = sizeof report};
    tree_scanned *scanned;
    OK(tree_skeletonize_scan(points, POST + 2, &params, NULL, &report, &scanned));
    CHECK(report.n_points == POST + 2 && report.n_not_finite == 1 && report.n_doubles == 1);
    CHECK(report.n_bases >= 1 && report.n_bridges == 0 && report.n_fitted > 0 && report.spacing > 0);
    size_t n_trees;
    OK(tree_scanned_count(scanned, &n_trees));
    CHECK(n_trees == 1);
    tree_scanned_columns columns = {.struct_size = sizeof columns};
    OK(tree_scanned_view(scanned, 0, &columns));
    CHECK(fabs(columns.base[0] - 430000) < 0.02 && fabs(columns.base[2]) < 0.05);
    CHECK(columns.n_nodes == report.n_nodes && columns.in_foliage[0] == 0);
    tree_skeleton *skeleton;
    OK(tree_scanned_skeleton(scanned, 0, &skeleton));
    float length;
    size_t n_points;
    FAILS(TREE_ERROR_PARAMETER, "0 bridges", tree_scanned_bridge(scanned, 0, &length, &n_points));
    FAILS(TREE_ERROR_PARAMETER, "1 trees", tree_scanned_view(scanned, 1, &columns));
    tree_skeleton *none;
    FAILS(TREE_ERROR_PARAMETER, "1 trees", tree_scanned_skeleton(scanned, 1, &none));
    CHECK(none == NULL);
    OK(tree_scanned_free(scanned));
    /* It outlives the scan. */
    float box[6];
    tree_skeleton_columns nodes = {.struct_size = sizeof nodes};
    OK(tree_skeleton_bounds(skeleton, &box));
    CHECK(fabsf(box[4] - box[1] - 2) < 0.1f);
    OK(tree_skeleton_view(skeleton, &nodes));
    CHECK(fabsf(nodes.radii[0] - 0.05f) < 0.005f);
    OK(tree_skeleton_free(skeleton));

    /* A post from whose middle a piece is missing. */
    size_t n = 0;
    static double torn[3 * POST];
    for (int i = 0; i < POST; i++)
        if (i < 480 || i >= 560) memcpy(torn + 3 * n++, points + 3 * i, 3 * sizeof *torn);
    OK(tree_skeletonize_scan(torn, n, NULL, NULL, &report, &scanned));
    CHECK(report.n_bridges > 0 && report.n_left_out == 0);
    OK(tree_scanned_bridge(scanned, 0, &length, &n_points));
    CHECK(length > 0.1f && length < 0.25f && n_points > 300 && n_points < 500);
    OK(tree_scanned_free(scanned));

    /* Two posts are one tree, or two. */
    post(points, 0);
    post(points + 3 * POST, 3);
    params.several = 1;
    params.bridge = 0;
    OK(tree_skeletonize_scan(points, 2 * POST, &params, NULL, &report, &scanned));
    OK(tree_scanned_count(scanned, &n_trees));
    CHECK(n_trees == 2 && report.n_bases == 2);
    OK(tree_scanned_free(scanned));

    FAILS(TREE_ERROR_INVALID, "16", tree_skeletonize_scan(points, 15, NULL, NULL, NULL, &scanned));
    CHECK(scanned == NULL);
    FAILS(TREE_ERROR_NULL, "points", tree_skeletonize_scan(NULL, 15, NULL, NULL, NULL, &scanned));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_skeletonize_scan(points, SIZE_MAX, NULL, NULL, NULL, &scanned));
    params.up = 2;
    FAILS(TREE_ERROR_ENUM, "params.up", tree_scan_params_check(&params));
    params.up = TREE_UP_Y;
    params.step = 0;
    FAILS(TREE_ERROR_PARAMETER, "scan.step", tree_scan_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "scan.step",
          tree_skeletonize_scan(points, POST, &params, NULL, NULL, &scanned));
    tree_cancel *cancel;
    tree_control control;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_skeletonize_scan(points, POST, NULL, &control, NULL, &scanned));
    OK(tree_cancel_free(cancel));
}

static void of_files(void) {
    static double points[3 * POST];
    post(points, 0);
    static char text[64 * POST];
    size_t length = (size_t)snprintf(text, sizeof text, "# a scan\nx,y,z\n");
    for (int i = 0; i < POST; i++)
        length += (size_t)snprintf(text + length, sizeof text - length, "%.17g,%.17g,%.17g\n",
                                   points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    tree_cloud *cloud, *again;
    OK(tree_cloud_from_bytes(TREE_CLOUD_FORMAT_TEXT, (const uint8_t *)text, length, NULL, &cloud));
    tree_cloud_columns columns = {.struct_size = sizeof columns};
    OK(tree_cloud_view(cloud, &columns));
    CHECK(columns.n_points == POST && columns.n_other_lines == 2);
    CHECK(memcmp(columns.positions, points, sizeof points) == 0);
    tree_scanned *scanned;
    OK(tree_skeletonize_cloud(cloud, NULL, NULL, NULL, &scanned));
    OK(tree_scanned_free(scanned));
    OK(tree_cloud_free(cloud));

    FILE *file = fopen("scan.CSV", "wb");
    CHECK(file && fwrite(text, 1, length, file) == length);
    if (file) fclose(file);
    OK(tree_cloud_read("scan.CSV", TREE_NUL_TERMINATED, NULL, &again));
    OK(tree_cloud_view(again, &columns));
    CHECK(columns.n_points == POST);
    OK(tree_cloud_free(again));
    remove("scan.CSV");

    static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                              "property float z\nend_header\n1 2 3\n4 5 6\n";
    const uint8_t *bytes = (const uint8_t *)ply;
    OK(tree_cloud_from_bytes(TREE_CLOUD_FORMAT_PLY, bytes, sizeof ply - 1, NULL, &cloud));
    OK(tree_cloud_view(cloud, &columns));
    CHECK(columns.n_points == 2 && columns.positions[5] == 6);
    OK(tree_cloud_free(cloud));
    FAILS(TREE_ERROR_FORMAT, "", tree_cloud_from_bytes(TREE_CLOUD_FORMAT_PLY, bytes, 20, NULL, &cloud));
    FAILS(TREE_ERROR_FORMAT, "three numbers",
          tree_cloud_from_bytes(TREE_CLOUD_FORMAT_TEXT, (const uint8_t *)"1 2", 3, NULL, &cloud));
    CHECK(cloud == NULL);
    FAILS(TREE_ERROR_ENUM, "format", tree_cloud_from_bytes(0, bytes, 20, NULL, &cloud));
    FAILS(TREE_ERROR_IO, "", tree_cloud_read("/no/such/scan.ply", TREE_NUL_TERMINATED, NULL, &cloud));
    FAILS(TREE_ERROR_FORMAT, "extension", tree_cloud_read("scan.las", TREE_NUL_TERMINATED, NULL, &cloud));
    tree_limits limits;
    tree_control control;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    limits.graph_nodes = 1;
    FAILS(TREE_ERROR_LIMIT, "", tree_cloud_from_bytes(TREE_CLOUD_FORMAT_TEXT, (const uint8_t *)text,
                                                      length, &control, &cloud));
}

void test_scan(void) {
    whole();
    of_files();
}
