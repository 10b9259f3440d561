#include "check.h"

tree_mesh *a_leafy_mesh(void);

static tree_view small(void) {
    tree_view view;
    OK(tree_view_init(&view, sizeof view));
    view.width = 24;
    view.height = 32;
    view.samples = 1;
    return view;
}

static tree_style quick(void) {
    tree_style style;
    OK(tree_style_studio(&style, sizeof style));
    style.sun_map_px = style.sky_map_px = 16;
    style.sky_directions = 2;
    return style;
}

static void views(const tree_mesh *mesh) {
    tree_view view = small();
    CHECK(view.camera == TREE_CAMERA_FRAMED && view.lens == TREE_LENS_PERSPECTIVE);
    CHECK(view.fov == 0.6f && view.yaw == 0.6f && view.margin == 0.06f && view.up[1] == 1);
    tree_view placed = {.struct_size = sizeof placed};
    OK(tree_view_place(&view, mesh, &placed));
    CHECK(placed.camera == TREE_CAMERA_PLACED && placed.width == 24 && placed.fov == 0.6f);
    CHECK(placed.eye[2] > 1);
    /* The same picture from the same place. */
    tree_mask *one = NULL, *two = NULL;
    tree_mask_columns a = {.struct_size = sizeof a}, b = a;
    OK(tree_render_mask(mesh, &view, NULL, &one));
    OK(tree_render_mask(mesh, &placed, NULL, &two));
    OK(tree_mask_view(one, &a));
    OK(tree_mask_view(two, &b));
    CHECK(a.n_pixels == 24 * 32 && memcmp(a.coverage, b.coverage, a.n_pixels) == 0);
    OK(tree_mask_free(one));
    OK(tree_mask_free(two));

    view.lens = TREE_LENS_ORTHOGRAPHIC;
    OK(tree_view_place(&view, mesh, &view));
    CHECK(view.camera == TREE_CAMERA_PLACED && view.lens_height > 2 && view.lens_height < 4);
    view.lens_height = 0;
    FAILS(TREE_ERROR_PARAMETER, "camera.height", tree_view_place(&view, mesh, &placed));
    view.lens = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_LENS_", tree_view_place(&view, mesh, &placed));
    view = small();
    view.camera = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_CAMERA_", tree_view_place(&view, mesh, &placed));
    view.camera = TREE_CAMERA_PLACED;
    FAILS(TREE_ERROR_PARAMETER, "camera.target", tree_view_place(&view, mesh, &placed));
}

static void masks(const tree_mesh *mesh) {
    tree_view view = small();
    tree_mask *mask = NULL;
    OK(tree_render_mask(mesh, &view, NULL, &mask));
    tree_mask_columns columns = {.struct_size = sizeof columns};
    OK(tree_mask_view(mask, &columns));
    CHECK(columns.width == 24 && columns.height == 32 && columns.area > 10 && columns.area < 400);
    uint8_t bits[24 * 32];
    OK(tree_mask_bits(mask, bits, sizeof bits));
    double n = 0;
    for (size_t i = 0; i < sizeof bits; i++) {
        n += bits[i];
        CHECK(bits[i] == (columns.coverage[i] >= 128));
    }
    CHECK(n == columns.area);
    FAILS(TREE_ERROR_BUFFER, "room", tree_mask_bits(mask, bits, 24 * 32 - 1));

    tree_picture *picture = NULL, *silhouette = NULL;
    OK(tree_mask_picture(mask, &picture));
    OK(tree_render_silhouette(mesh, &view, NULL, &silhouette));
    tree_pixels a = {.struct_size = sizeof a}, b = a;
    OK(tree_picture_view(picture, &a));
    OK(tree_picture_view(silhouette, &b));
    CHECK(a.n_bytes == 4 * 24 * 32 && memcmp(a.pixels, b.pixels, a.n_bytes) == 0);
    CHECK(a.pixels[0] == 255 && a.pixels[3] == 255);
    OK(tree_picture_free(silhouette));
    OK(tree_picture_free(picture));
    OK(tree_mask_free(mask));
}

static void pictures(const tree_mesh *mesh) {
    tree_view view = small();
    tree_style style, studio = quick();
    OK(tree_style_init(&style, sizeof style));
    CHECK(style.has_ground == 1 && style.ground == 0 && style.backdrop == TREE_BACKDROP_SKY);
    CHECK(studio.backdrop == TREE_BACKDROP_STUDIO && studio.sun == 1.4f);
    tree_picture *picture = NULL, *bare = NULL, *copy = NULL;
    OK(tree_render(mesh, &view, &studio, NULL, &picture));
    studio.has_ground = 0;
    OK(tree_render(mesh, &view, &studio, NULL, &bare));
    tree_pixels a = {.struct_size = sizeof a}, b = a;
    OK(tree_picture_view(picture, &a));
    OK(tree_picture_view(bare, &b));
    CHECK(a.width == 24 && a.height == 32 && memcmp(a.pixels, b.pixels, a.n_bytes) != 0);

    OK(tree_picture_from_pixels(24, 32, a.pixels, a.n_bytes, NULL, &copy));
    tree_bytes *png = NULL, *again = NULL;
    OK(tree_picture_to_png(picture, &png));
    OK(tree_picture_to_png(copy, &again));
    const uint8_t *data = NULL, *same = NULL;
    size_t len = 0, same_len = 0;
    OK(tree_bytes_view(png, &data, &len));
    OK(tree_bytes_view(again, &same, &same_len));
    CHECK(len > 100 && len == same_len && memcmp(data, same, len) == 0);
    CHECK(memcmp(data, "\x89PNG", 4) == 0);

    const char *folder = getenv("TREE_TEST_DIR");
    char path[4096];
    snprintf(path, sizeof path, "%s/tree_test_preview.png", folder ? folder : ".");
    OK(tree_picture_write_png(picture, path, TREE_NUL_TERMINATED));
    FILE *file = fopen(path, "rb");
    CHECK(file != NULL);
    if (file) {
        CHECK(fseek(file, 0, SEEK_END) == 0 && ftell(file) == (long)len);
        fclose(file);
    }
    CHECK(remove(path) == 0);
    FAILS(TREE_ERROR_IO, "nowhere", tree_picture_write_png(picture, "/nowhere/a.png", TREE_NUL_TERMINATED));
    OK(tree_picture_free(copy));
    FAILS(TREE_ERROR_INVALID, "12", tree_picture_from_pixels(2, 2, a.pixels, 12, NULL, &copy));
    CHECK(copy == NULL);
    OK(tree_bytes_free(png));
    OK(tree_picture_free(picture));
    OK(tree_picture_free(bare));
    OK(tree_bytes_free(again));
}

static int32_t stop(void *user, const char *stage, float fraction) {
    (void)fraction;
    *(int *)user += strcmp(stage, "light") == 0;
    return *(int *)user > 0;
}

static void refusals(const tree_mesh *mesh) {
    tree_view view = small();
    tree_style style = quick();
    tree_picture *picture = NULL;
    view.width = 0;
    FAILS(TREE_ERROR_PARAMETER, "view.width", tree_render(mesh, &view, &style, NULL, &picture));
    view = small();
    view.pitch = 0.0f / 0.0f;
    FAILS(TREE_ERROR_PARAMETER, "camera.pitch", tree_render(mesh, &view, &style, NULL, &picture));
    view = small();
    style.backdrop = 2;
    FAILS(TREE_ERROR_ENUM, "TREE_BACKDROP_", tree_render(mesh, &view, &style, NULL, &picture));
    style = quick();
    style.exposure = 0;
    FAILS(TREE_ERROR_PARAMETER, "style.exposure", tree_render(mesh, &view, &style, NULL, &picture));
    style = quick();
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.pixels = 100;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_render(mesh, &view, &style, &control, &picture));
    tree_mask *mask = NULL;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_render_mask(mesh, &view, &control, &mask));
    int lights = 0;
    control.limits = NULL;
    control.progress = stop;
    control.user = &lights;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_render(mesh, &view, &style, &control, &picture));
    CHECK(picture == NULL && mask == NULL && lights > 0);
}

void test_preview(void) {
    tree_mesh *mesh = a_leafy_mesh();
    views(mesh);
    masks(mesh);
    pictures(mesh);
    refusals(mesh);
    OK(tree_mesh_free(mesh));
}
