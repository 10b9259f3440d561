#include "crown.h"
#include <math.h>

static tree_octahedral *all_round(const tree_mesh *mesh) {
    tree_octahedral_params params;
    tree_octahedral_report report = {.struct_size = sizeof report}, again = report;
    tree_octahedral *octahedral = NULL;
    OK(tree_octahedral_params_init(&params, sizeof params));
    CHECK(params.grid == 12 && params.hemi == 1 && params.side == 2048 && params.half_detail == 0);
    OK(tree_octahedral_params_check(&params));
    params.grid = 1;
    FAILS(TREE_ERROR_PARAMETER, "octahedral.grid", tree_octahedral_params_check(&params));
    FAILS(TREE_ERROR_PARAMETER, "octahedral.grid",
          tree_octahedral_bake(mesh, &params, NULL, NULL, &octahedral));
    CHECK(octahedral == NULL);
    params.grid = 3;
    params.side = 64;
    params.samples = 1;
    params.half_detail = 1;
    OK(tree_octahedral_bake(mesh, &params, NULL, &report, &octahedral));
    CHECK(report.n_views == 9 && report.n_triangles == 2 * LEAVES && report.covered > 100);
    CHECK(report.bytes == 4 * (64 * 64 + 32 * 32));
    OK(tree_octahedral_measure(octahedral, &again));
    CHECK(memcmp(&again, &report, sizeof report) == 0);
    return octahedral;
}

/* Numbers, pictures, and the same impostor put together again. */
static void parts_of(const tree_octahedral *octahedral) {
    tree_octahedral_meta meta = {.struct_size = sizeof meta};
    OK(tree_octahedral_describe(octahedral, &meta));
    CHECK(meta.grid == 3 && meta.hemi == 1 && meta.side == 64 && meta.tile == 21 && meta.detail_side == 32);
    CHECK(meta.radius > 3 && meta.wide > 2 && meta.high > 0.3f && meta.texel > 0.1f);
    OK(tree_octahedral_meta_check(&meta));
    float half[2] = {0, 0}, reach = 0;
    OK(tree_octahedral_meta_extent(&meta, 0, &half, &reach));
    CHECK(half[0] == meta.wide && half[1] == meta.high && reach == meta.wide);
    tree_bytes *json = NULL;
    const uint8_t *data = NULL;
    size_t len = 0;
    OK(tree_octahedral_to_json(octahedral, &json));
    OK(tree_bytes_view(json, &data, &len));
    CHECK(len > 100 && memcmp(data, "{ \"kind\": \"octahedral\"", 22) == 0);
    OK(tree_bytes_free(json));

    tree_pixels color = {.struct_size = sizeof color}, detail = {.struct_size = sizeof detail};
    OK(tree_octahedral_pixels(octahedral, TREE_IMPOSTOR_COLOR, &color));
    OK(tree_octahedral_pixels(octahedral, TREE_IMPOSTOR_DETAIL, &detail));
    CHECK(color.width == 64 && detail.width == 32);
    FAILS(TREE_ERROR_ENUM, "TREE_IMPOSTOR_", tree_octahedral_pixels(octahedral, 2, &color));
    tree_picture *pictures[2] = {NULL, NULL}, *seen = NULL, *same = NULL;
    OK(tree_octahedral_picture(octahedral, TREE_IMPOSTOR_COLOR, NULL, &pictures[0]));
    OK(tree_octahedral_picture(octahedral, TREE_IMPOSTOR_DETAIL, NULL, &pictures[1]));
    tree_octahedral *again = NULL, *none = NULL;
    OK(tree_octahedral_from_pictures(&meta, pictures[0], pictures[1], NULL, &again));
    FAILS(TREE_ERROR_INVALID, "another size",
          tree_octahedral_from_pictures(&meta, pictures[1], pictures[0], NULL, &none));
    tree_view view = from_the_side(TREE_CAMERA_PLACED);
    OK(tree_octahedral_view(octahedral, &view, NULL, &seen));
    OK(tree_octahedral_view(again, &view, NULL, &same));
    tree_pixels a = {.struct_size = sizeof a}, b = {.struct_size = sizeof b};
    OK(tree_picture_view(seen, &a));
    OK(tree_picture_view(same, &b));
    CHECK(memcmp(a.pixels, b.pixels, a.n_bytes) == 0);
    CHECK(n_covered(seen) > 20 && n_covered(seen) < 32 * 32);
    tree_mask *mask = NULL;
    tree_mask_columns columns = {.struct_size = sizeof columns};
    OK(tree_octahedral_mask(octahedral, &view, NULL, &mask));
    OK(tree_mask_view(mask, &columns));
    int alike = 1;
    for (size_t i = 0; i < columns.n_pixels; i++) alike &= columns.coverage[i] == a.pixels[4 * i + 3];
    CHECK(columns.n_pixels == 32 * 32 && alike);
    OK(tree_mask_free(mask));
    view = from_the_side(TREE_CAMERA_FRAMED);
    FAILS(TREE_ERROR_INVALID, "placed", tree_octahedral_mask(octahedral, &view, NULL, &mask));
    meta.detail_side = 7;
    FAILS(TREE_ERROR_INVALID, "detail_side", tree_octahedral_meta_check(&meta));
    FAILS(TREE_ERROR_INVALID, "detail_side",
          tree_octahedral_from_pictures(&meta, pictures[0], pictures[1], NULL, &none));
    CHECK(none == NULL && mask == NULL);
    OK(tree_picture_free(pictures[0]));
    OK(tree_picture_free(pictures[1]));
    OK(tree_picture_free(seen));
    OK(tree_picture_free(same));
    OK(tree_octahedral_free(again));
}

static void directions(void) {
    static const float slanted[] = {0.6f, 0.48f, 0.64f}, outside[] = {2, 0}, nowhere[3];
    float place[2] = {-1, -1}, back[3] = {0, 0, 0}, right[3], up[3], toward[3];
    for (uint32_t hemi = 0; hemi < 2; hemi++) {
        OK(tree_octahedral_encode(slanted, hemi, &place));
        CHECK(place[0] > 0 && place[0] < 1 && place[1] > 0 && place[1] < 1);
        OK(tree_octahedral_decode(place, hemi, &back));
        for (int i = 0; i < 3; i++) CHECK(fabsf(back[i] - slanted[i]) < 1e-5f);
        tree_octahedral_frame frames[3];
        OK(tree_octahedral_frames(slanted, 3, hemi, frames, 3));
        CHECK(fabsf(frames[0].weight + frames[1].weight + frames[2].weight - 1) < 1e-5f);
        for (int i = 0; i < 3; i++) CHECK(frames[i].column < 3 && frames[i].row < 3);
        FAILS(TREE_ERROR_BUFFER, "frames", tree_octahedral_frames(slanted, 3, hemi, frames, 2));
        FAILS(TREE_ERROR_PARAMETER, "grid is 65", tree_octahedral_frames(slanted, 65, hemi, frames, 3));
    }
    OK(tree_octahedral_axes(1, 1, 3, 1, &right, &up, &toward));
    CHECK(right[0] == 1 && fabsf(toward[1] - 1) < 1e-6f && fabsf(up[2] + 1) < 1e-6f);
    FAILS(TREE_ERROR_PARAMETER, "(3, 0)", tree_octahedral_axes(3, 0, 3, 1, &right, &up, &toward));
    FAILS(TREE_ERROR_PARAMETER, "direction", tree_octahedral_encode(nowhere, 1, &place));
    FAILS(TREE_ERROR_PARAMETER, "place", tree_octahedral_decode(outside, 1, &back));
}

void test_octahedral(void) {
    tree_mesh *mesh = leaves_at_tips();
    tree_octahedral *octahedral = all_round(mesh);
    OK(tree_mesh_free(mesh));
    parts_of(octahedral);
    OK(tree_octahedral_free(octahedral));
    directions();
}
