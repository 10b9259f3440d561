#include "check.h"
#include <math.h>

enum { W = 60, H = 80, N = W * H };

static int near(float a, float b) { return fabsf(a - b) < 1e-3f; }

/* Whether (x, y) is in a round crown on a trunk that ends above the picture's bottom. */
static int in_tree(int x, int y) {
    float dx = (float)x + 0.5f - 30, dy = (float)y + 0.5f - 28;
    return dx * dx + dy * dy < 22 * 22 || (x >= 28 && x < 32 && y >= 28 && y < 74);
}

static uint8_t rgba[4 * N];

/* Green leaves and brown wood against sky; the sky is transparent when `cut` says so. */
static tree_photo *a_photo(const uint8_t sky[3], int cut) {
    for (int i = 0; i < N; i++) {
        int x = i % W, y = i / W;
        uint8_t wood[3] = {90, 60, 40}, leaf[3] = {50, (uint8_t)(100 + 5 * ((x + y) % 3)), 40};
        memcpy(rgba + 4 * i, !in_tree(x, y) ? sky : x >= 28 && x < 32 && y >= 40 ? wood : leaf, 3);
        rgba[4 * i + 3] = cut && !in_tree(x, y) ? 0 : 255;
    }
    tree_photo *photo;
    OK(tree_photo_from_pixels(W, H, rgba, sizeof rgba, NULL, &photo));
    return photo;
}

static const uint8_t SKY[3] = {190, 215, 245}, BLUE[3] = {20, 40, 230};

static tree_matte *a_matte(void) {
    float alpha[N];
    for (int i = 0; i < N; i++) alpha[i] = in_tree(i % W, i / W) ? 1.0f : 0.0f;
    tree_matte *matte;
    OK(tree_matte_from_alpha(W, H, alpha, N, NULL, &matte));
    return matte;
}

/* How much two mattes differ, as a share of all pixels. */
static float difference(const tree_matte *a, const tree_matte *b) {
    tree_matte_columns one = {.struct_size = sizeof one}, other = {.struct_size = sizeof other};
    OK(tree_matte_view(a, &one));
    OK(tree_matte_view(b, &other));
    CHECK(one.n_pixels == other.n_pixels);
    float sum = 0;
    for (size_t i = 0; i < one.n_pixels && i < other.n_pixels; i++)
        sum += fabsf(one.alpha[i] - other.alpha[i]);
    return sum / (float)one.n_pixels;
}

static const uint8_t *pixel(const tree_photo *photo, uint32_t x, uint32_t y) {
    tree_pixels pixels = {.struct_size = sizeof pixels};
    OK(tree_photo_view(photo, &pixels));
    return pixels.pixels + 4 * (y * pixels.width + x);
}

static void photographs(void) {
    tree_photo *photo = a_photo(SKY, 0), *read, *cut = a_photo(SKY, 1), *bad;
    tree_pixels pixels = {.struct_size = sizeof pixels};
    OK(tree_photo_view(cut, &pixels));
    CHECK(pixels.width == W && pixels.height == H && pixels.n_bytes == sizeof rgba);
    CHECK(memcmp(pixels.pixels, rgba, sizeof rgba) == 0);
    uint32_t whether = 9;
    OK(tree_photo_has_alpha(photo, &whether));
    CHECK(whether == 0);
    OK(tree_photo_has_alpha(cut, &whether));
    CHECK(whether == 1);

    tree_bytes *png;
    const uint8_t *data;
    size_t len;
    OK(tree_photo_to_png(cut, &png));
    OK(tree_bytes_view(png, &data, &len));
    OK(tree_photo_from_bytes(data, len, NULL, &read));
    CHECK(memcmp(pixel(read, 0, 0), rgba, sizeof rgba) == 0);
    OK(tree_photo_free(read));
    FAILS(TREE_ERROR_FORMAT, "PNG or JPEG", tree_photo_from_bytes(data + 1, len - 1, NULL, &bad));
    OK(tree_bytes_free(png));
    OK(tree_photo_write_png(cut, "photo.png", TREE_NUL_TERMINATED));
    OK(tree_photo_read("photo.png", 9, NULL, &read));
    CHECK(memcmp(pixel(read, 0, 0), rgba, sizeof rgba) == 0);
    OK(tree_photo_free(read));

    tree_limits limits;
    tree_control few;
    OK(tree_limits_init(&limits, sizeof limits));
    OK(tree_control_init(&few, sizeof few));
    few.limits = &limits;
    limits.pixels = N - 1;
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_photo_read("photo.png", 9, &few, &bad));
    FAILS(TREE_ERROR_LIMIT, "pixels", tree_photo_from_pixels(W, H, rgba, sizeof rgba, &few, &bad));
    CHECK(bad == NULL);
    CHECK(remove("photo.png") == 0);
    FAILS(TREE_ERROR_IO, "photo.png", tree_photo_read("photo.png", 9, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "pixels", tree_photo_from_pixels(W, 9, rgba, sizeof rgba, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "four", tree_photo_from_pixels(W, H, rgba, 7, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "at least one", tree_photo_from_pixels(0, 0, NULL, 0, NULL, &bad));

    tree_photo *mirrored;
    OK(tree_photo_mirrored(cut, &mirrored));
    CHECK(pixel(mirrored, 31, 70)[3] == 255 && pixel(mirrored, 0, 0)[3] == 0);
    CHECK(memcmp(pixel(mirrored, 20, 30), pixel(cut, W - 21, 30), 4) == 0);
    OK(tree_photo_free(mirrored));
    OK(tree_photo_free(photo));
    OK(tree_photo_free(cut));
    FAILS(TREE_ERROR_HANDLE, "photo", tree_photo_has_alpha(cut, &whether));
}

static void mattes(void) {
    tree_matte *matte = a_matte(), *other, *bad;
    tree_photo *cut = a_photo(SKY, 1), *whole = a_photo(SKY, 0), *grey;
    tree_matte_columns columns = {.struct_size = sizeof columns};
    OK(tree_matte_view(matte, &columns));
    CHECK(columns.width == W && columns.height == H && columns.n_pixels == N);
    CHECK(columns.area > 1500 && columns.area < 1700);
    OK(tree_matte_of_photo(cut, &other));
    CHECK(difference(matte, other) == 0);
    OK(tree_matte_free(other));
    FAILS(TREE_ERROR_NO_RESULT, "alpha", tree_matte_of_photo(whole, &bad));
    const float spots[] = {30.5f, 28.5f, 28, 60.5f, 1, 1, NAN, 0}, none = NAN;
    float values[4];
    OK(tree_matte_sample(matte, spots, 4, NULL, values, 4));
    CHECK(values[0] == 1 && near(values[1], 0.5f) && values[2] == 0 && values[3] == 0);
    FAILS(TREE_ERROR_BUFFER, "values", tree_matte_sample(matte, spots, 4, NULL, values, 3));
    OK(tree_matte_sample(matte, NULL, 0, NULL, NULL, 0));
    FAILS(TREE_ERROR_PARAMETER, "alpha[0]", tree_matte_from_alpha(1, 1, &none, 1, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "pixels", tree_matte_from_alpha(2, 1, spots, 1, NULL, &bad));

    tree_bytes *png;
    const uint8_t *data;
    size_t len;
    OK(tree_matte_to_png(matte, &png));
    OK(tree_bytes_view(png, &data, &len));
    OK(tree_photo_from_bytes(data, len, NULL, &grey));
    CHECK(pixel(grey, 30, 28)[0] == 255 && pixel(grey, 0, 0)[1] == 0);
    OK(tree_photo_free(grey));
    OK(tree_bytes_free(png));
    OK(tree_matte_write_png(matte, "matte.png", TREE_NUL_TERMINATED));
    OK(tree_photo_read("matte.png", TREE_NUL_TERMINATED, NULL, &grey));
    OK(tree_photo_free(grey));
    CHECK(remove("matte.png") == 0);

    OK(tree_matte_mirrored(matte, &other));
    OK(tree_matte_view(other, &columns));
    CHECK(columns.alpha[28 * W + 29] == 1 && columns.alpha[0] == 0);
    OK(tree_matte_free(other));
    tree_particle_camera camera, turned = {.struct_size = sizeof turned};
    OK(tree_particle_camera_init(&camera, sizeof camera));
    camera.size[0] = W;
    camera.size[1] = H;
    camera.base[0] = 20;
    tree_photo *turned_photo;
    OK(tree_matte_turned(matte, cut, &camera, &turned, &turned_photo, &other));
    CHECK(near(turned.yaw, 1.5708f) && turned.base[0] == 40 && turned_photo != NULL);
    OK(tree_photo_free(turned_photo));
    OK(tree_matte_free(other));
    OK(tree_matte_turned(matte, NULL, &camera, &turned, &turned_photo, &other));
    CHECK(turned_photo == NULL);
    OK(tree_matte_free(other));
    OK(tree_matte_turned(matte, cut, &camera, &turned, NULL, &other));
    OK(tree_matte_free(other));
    OK(tree_matte_free(matte));
    OK(tree_photo_free(cut));
    OK(tree_photo_free(whole));
}

static void trimaps(void) {
    uint8_t levels[N];
    for (int i = 0; i < N; i++) {
        int in = in_tree(i % W, i / W), x = i % W, y = i / W;
        int edge = in != in_tree(x - 1, y) || in != in_tree(x + 1, y) || in != in_tree(x, y - 1);
        levels[i] = edge ? TREE_LEVEL_UNKNOWN : in ? TREE_LEVEL_FOREGROUND : TREE_LEVEL_BACKGROUND;
    }
    tree_trimap *trimap, *strokes, *drawn, *bad;
    OK(tree_trimap_from_levels(W, H, levels, N, NULL, &trimap));
    tree_trimap_columns columns = {.struct_size = sizeof columns};
    OK(tree_trimap_view(trimap, &columns));
    CHECK(columns.width == W && columns.height == H && columns.n_pixels == N);
    CHECK(memcmp(columns.levels, levels, N) == 0);
    CHECK(columns.n_background + columns.n_unknown + columns.n_foreground == N);
    CHECK(columns.n_unknown > 100 && columns.n_unknown < 400);
    levels[5] = 7;
    FAILS(TREE_ERROR_ENUM, "levels[5]", tree_trimap_from_levels(W, H, levels, N, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "pixels", tree_trimap_from_levels(W, H, levels, 5, NULL, &bad));

    tree_photo *photo = a_photo(SKY, 0), *painted;
    OK(tree_photo_blank(2, 1, 0xffffffff, NULL, &painted));
    OK(tree_trimap_of_photo(painted, &drawn));
    OK(tree_trimap_view(drawn, &columns));
    CHECK(columns.n_foreground == 2);
    OK(tree_trimap_free(drawn));
    OK(tree_photo_free(painted));

    const float trunk[] = {30, 30, 30, 72}, ground[] = {4, 70};
    tree_trimap_stroke two[2];
    OK(tree_trimap_stroke_init(&two[0], sizeof two[0]));
    OK(tree_trimap_stroke_init(&two[1], sizeof two[1]));
    two[0].points = trunk;
    two[0].n_points = 2;
    two[0].width = 2;
    two[0].foreground = 1;
    two[1].points = ground;
    two[1].n_points = 1;
    two[1].width = 6;
    OK(tree_trimap_from_strokes(W, H, two, 2, NULL, &strokes));
    OK(tree_trimap_view(strokes, &columns));
    CHECK(columns.n_foreground > 80 && columns.n_foreground < 100);
    CHECK(columns.n_background > 20 && columns.n_background < 36);
    CHECK(columns.levels[60 * W + 30] == TREE_LEVEL_FOREGROUND);
    two[1].width = 0;
    FAILS(TREE_ERROR_PARAMETER, "strokes[1].width",
          tree_trimap_from_strokes(W, H, two, 2, NULL, &bad));
    FAILS(TREE_ERROR_LIMIT, "pixels",
          tree_trimap_from_strokes(1u << 31, 1u << 31, two, 1, NULL, &bad));

    const uint8_t leaf[] = {50, 105, 40, 90, 60, 40};
    tree_color_samples samples;
    OK(tree_color_samples_init(&samples, sizeof samples));
    CHECK(samples.tolerance == 24);
    FAILS(TREE_ERROR_INVALID, "sample", tree_trimap_from_colors(photo, &samples, NULL, &bad));
    samples.foreground = leaf;
    samples.n_foreground = 2;
    samples.background = SKY;
    samples.n_background = 1;
    OK(tree_trimap_from_colors(photo, &samples, NULL, &drawn));
    OK(tree_trimap_view(drawn, &columns));
    CHECK(columns.n_unknown == 0 && columns.n_foreground > 1500 && columns.n_foreground < 1700);

    tree_natural_params params;
    OK(tree_natural_params_init(&params, sizeof params));
    CHECK(params.max_side == 768 && params.mark_clear == 1);
    tree_natural_report report = {.struct_size = sizeof report};
    tree_lines *warnings;
    tree_matte *matte, *exact = a_matte(), *none;
    OK(tree_matte_natural(photo, trimap, &params, NULL, &report, &warnings, &matte));
    CHECK(report.size[0] == W && report.size[1] == H && report.n_unknown > 100);
    CHECK(difference(matte, exact) < 0.02f);
    const tree_str *texts;
    size_t n_texts = 9;
    OK(tree_lines_view(warnings, &texts, &n_texts));
    CHECK(n_texts == 0 && texts == NULL);
    OK(tree_lines_free(warnings));
    OK(tree_matte_free(matte));
    /* Few known pixels: it says so, in words. */
    OK(tree_trimap_free(trimap));
    two[1].width = 2;
    two[0].n_points = 1;
    OK(tree_trimap_from_strokes(W, H, two, 2, NULL, &trimap));
    OK(tree_matte_natural(photo, trimap, NULL, NULL, NULL, &warnings, &matte));
    OK(tree_lines_view(warnings, &texts, &n_texts));
    CHECK(n_texts >= 1 && texts[0].len > 10);
    OK(tree_lines_free(warnings));
    OK(tree_matte_free(matte));
    params.max_side = 1;
    FAILS(TREE_ERROR_PARAMETER, "max_side",
          tree_matte_natural(photo, trimap, &params, NULL, NULL, NULL, &none));
    OK(tree_trimap_free(trimap));
    OK(tree_trimap_from_strokes(W, H, NULL, 0, NULL, &trimap));
    FAILS(TREE_ERROR_NO_RESULT, "no tree",
          tree_matte_natural(photo, trimap, NULL, NULL, NULL, &warnings, &none));
    CHECK(warnings == NULL && none == NULL);
    OK(tree_trimap_free(trimap));
    OK(tree_trimap_free(strokes));
    OK(tree_trimap_free(drawn));
    OK(tree_matte_free(exact));
    OK(tree_photo_free(photo));
}

static void screens(void) {
    tree_photo *screen = a_photo(BLUE, 0), *photo = a_photo(SKY, 0), *plate, *small, *nothing;
    tree_matte *exact = a_matte(), *matte, *bad;
    OK(tree_matte_screen(screen, NULL, NULL, &matte));
    CHECK(difference(matte, exact) < 0.01f);
    OK(tree_matte_free(matte));
    tree_screen_params params;
    OK(tree_screen_params_init(&params, sizeof params));
    CHECK(params.color == TREE_SCREEN_BLUE && params.gain == 2 && params.balance == 1);
    params.color = TREE_SCREEN_GREEN;
    OK(tree_matte_screen(screen, &params, NULL, &matte));
    CHECK(difference(matte, exact) > 0.5f);
    OK(tree_matte_free(matte));
    params.color = 2;
    FAILS(TREE_ERROR_ENUM, "color", tree_matte_screen(screen, &params, NULL, &bad));

    tree_difference_params soft;
    OK(tree_difference_params_init(&soft, sizeof soft));
    CHECK(near(soft.threshold, 0.15f) && near(soft.softness, 0.15f));
    OK(tree_photo_blank(W, H, 0xbed7f5ff, NULL, &plate));
    OK(tree_matte_difference(photo, plate, &soft, NULL, &matte));
    CHECK(difference(matte, exact) < 0.01f);
    OK(tree_matte_free(matte));
    OK(tree_photo_blank(W, 1, 0, NULL, &small));
    FAILS(TREE_ERROR_NO_RESULT, "the same", tree_matte_difference(photo, small, NULL, NULL, &bad));
    FAILS(TREE_ERROR_INVALID, "at least one", tree_photo_blank(W, 0, 0, NULL, &nothing));
    OK(tree_photo_free(plate));
    FAILS(TREE_ERROR_HANDLE, "plate", tree_matte_difference(photo, plate, NULL, NULL, &bad));

    tree_automatic_params automatic;
    tree_natural_params natural;
    OK(tree_automatic_params_init(&automatic, sizeof automatic));
    OK(tree_natural_params_init(&natural, sizeof natural));
    automatic.natural = &natural;
    tree_automatic_report report = {.struct_size = sizeof report};
    tree_trimap *trimap;
    tree_lines *warnings;
    OK(tree_matte_automatic(photo, &automatic, NULL, &report, &trimap, &warnings, &matte));
    CHECK(report.has_alpha == 0 && report.confidence > 0 && report.width == W);
    CHECK(difference(matte, exact) < 0.1f && trimap != NULL);
    OK(tree_matte_free(matte));
    OK(tree_trimap_free(trimap));
    OK(tree_lines_free(warnings));
    tree_photo *cut = a_photo(SKY, 1);
    OK(tree_matte_automatic(cut, NULL, NULL, &report, &trimap, NULL, &matte));
    CHECK(report.has_alpha == 1 && report.confidence == 1 && trimap == NULL);
    CHECK(difference(matte, exact) == 0);
    OK(tree_matte_free(matte));
    natural.epsilon = NAN;
    FAILS(TREE_ERROR_PARAMETER, "epsilon",
          tree_matte_automatic(photo, &automatic, NULL, NULL, NULL, NULL, &bad));
    OK(tree_photo_free(small));
    OK(tree_photo_blank(W, H, 0x202020ff, NULL, &small));
    FAILS(TREE_ERROR_NO_RESULT, "no tree",
          tree_matte_automatic(small, NULL, NULL, NULL, &trimap, &warnings, &bad));
    CHECK(bad == NULL && trimap == NULL && warnings == NULL);
    OK(tree_photo_free(small));
    OK(tree_photo_free(cut));
    OK(tree_photo_free(screen));
    OK(tree_photo_free(photo));
    OK(tree_matte_free(exact));
}

static void cameras(void) {
    tree_particle_camera camera;
    OK(tree_particle_camera_init(&camera, sizeof camera));
    OK(tree_particle_camera_check(&camera));
    camera.size[0] = 200;
    camera.size[1] = 300;
    camera.base[0] = 90;
    camera.base[1] = 280;
    camera.scale = 0.05f;
    float right[3], up[3], forward[3];
    OK(tree_particle_camera_frame(&camera, &right, &up, &forward));
    CHECK(near(right[0], 1) && near(up[1], 1) && near(forward[2], -1));
    for (int perspective = 0; perspective < 2; perspective++) {
        camera.fov = perspective ? 0.9f : 0;
        const float points[] = {0, 0, 0, 1, 5, -2, 0, 0, 1e6f};
        float spots[6], rays[12], sizes[3];
        OK(tree_particle_camera_project(&camera, points, 3, NULL, spots, 6));
        CHECK(near(spots[0], 90) && near(spots[1], 280));
        CHECK(perspective ? isnan(spots[4]) != 0 : near(spots[4], 90));
        OK(tree_particle_camera_pixel_sizes(&camera, points, 2, NULL, sizes, 2));
        CHECK(near(sizes[0], 0.05f) && (perspective ? sizes[1] > sizes[0] : near(sizes[1], 0.05f)));
        OK(tree_particle_camera_rays(&camera, spots, 2, NULL, rays, 12));
        /* The second ray goes through the second point. */
        float off[3], along = 0;
        for (int i = 0; i < 3; i++) along += (points[3 + i] - rays[6 + i]) * rays[9 + i];
        for (int i = 0; i < 3; i++) off[i] = points[3 + i] - rays[6 + i] - along * rays[9 + i];
        CHECK(fabsf(off[0]) + fabsf(off[1]) + fabsf(off[2]) < 1e-3f);
        FAILS(TREE_ERROR_BUFFER, "rays",
              tree_particle_camera_rays(&camera, spots, 2, NULL, rays, 11));
        tree_particle_stand stand = {.struct_size = sizeof stand};
        OK(tree_particle_camera_stand(&camera, &stand));
        CHECK(near(stand.height, 15) && stand.fov == camera.fov && stand.eye[2] > 10);
        tree_view view = {.struct_size = sizeof view};
        OK(tree_particle_camera_view(&camera, &view));
        CHECK(view.width == 200 && view.height == 300 && view.camera == TREE_CAMERA_PLACED);
        CHECK(view.lens == (perspective ? TREE_LENS_PERSPECTIVE : TREE_LENS_ORTHOGRAPHIC));
        CHECK(memcmp(view.eye, stand.eye, sizeof view.eye) == 0);
    }
    camera.scale = 0;
    FAILS(TREE_ERROR_PARAMETER, "camera.scale", tree_particle_camera_check(&camera));
    FAILS(TREE_ERROR_PARAMETER, "camera.scale",
          tree_particle_camera_frame(&camera, &right, &up, &forward));
}

static void alignment(void) {
    tree_matte *matte = a_matte();
    tree_align_params params[2];
    OK(tree_align_params_init(&params[0], sizeof params[0]));
    OK(tree_align_params_init(&params[1], sizeof params[1]));
    CHECK(params[0].height == 10);
    params[0].height = 6.8f;
    tree_particle_camera camera = {.struct_size = sizeof camera};
    tree_align_report report = {.struct_size = sizeof report};
    OK(tree_align(matte, &params[0], NULL, &camera, &report));
    CHECK(fabsf(camera.base[0] - 30) < 1 && fabsf(camera.base[1] - 74) < 1.5f);
    CHECK(fabsf(camera.scale - 0.1f) < 0.005f && camera.size[0] == W && camera.size[1] == H);
    CHECK(report.base[0] == camera.base[0] && fabsf(report.top[1] - 6) < 1.5f);
    CHECK(fabsf(report.crown_base - 50) < 4 && fabsf(report.trunk_width - 4) < 1);
    CHECK(fabsf(report.crown_low[0] - 8) < 2 && fabsf(report.crown_high[0] - 52) < 2);
    CHECK(report.n_warnings == 0);
    OK(tree_align(matte, NULL, NULL, &camera, NULL));
    params[0].height = -1;
    FAILS(TREE_ERROR_PARAMETER, "height", tree_align(matte, &params[0], NULL, &camera, NULL));
    FAILS(TREE_ERROR_NULL, "camera", tree_align(matte, NULL, NULL, NULL, NULL));

    /* A crown without a trunk, half out of the picture. */
    float alpha[N], none[N] = {0};
    for (int i = 0; i < N; i++) alpha[i] = i / W < 40 && i % W < 25 ? 1.0f : 0.0f;
    tree_matte *cropped, *empty;
    OK(tree_matte_from_alpha(W, H, alpha, N, NULL, &cropped));
    OK(tree_matte_from_alpha(W, H, none, N, NULL, &empty));
    OK(tree_align(cropped, NULL, NULL, &camera, &report));
    CHECK(report.n_warnings >= 1);
    int is_cropped = 0;
    for (uint32_t i = 0; i < report.n_warnings; i++)
        is_cropped |= report.warnings[i].problem == TREE_ALIGN_CROWN_CROPPED;
    CHECK(is_cropped);
    FAILS(TREE_ERROR_NO_RESULT, "covered", tree_align(empty, NULL, NULL, &camera, NULL));

    tree_aligned *aligned;
    const tree_matte *const both[] = {matte, cropped}, *const with_empty[] = {matte, empty};
    OK(tree_align_all(both, params, 2, 6.8f, NULL, &aligned));
    size_t n_views, n_warnings, n_texts;
    OK(tree_aligned_count(aligned, &n_views));
    CHECK(n_views == 2);
    OK(tree_aligned_camera(aligned, 0, &camera, &report));
    CHECK(fabsf(camera.scale - 0.1f) < 0.005f && report.n_warnings == 0);
    OK(tree_aligned_camera(aligned, 1, &camera, NULL));
    CHECK(fabsf(camera.scale - 0.17f) < 0.01f);
    FAILS(TREE_ERROR_PARAMETER, "index", tree_aligned_camera(aligned, 2, &camera, NULL));
    const tree_align_warning *warnings;
    OK(tree_aligned_warnings(aligned, &warnings, &n_warnings));
    CHECK(n_warnings >= 1 && warnings[0].problem == TREE_ALIGN_CROWN_BASE);
    tree_lines *lines;
    const tree_str *texts;
    OK(tree_align_warnings_text(warnings, n_warnings, &lines));
    OK(tree_lines_view(lines, &texts, &n_texts));
    CHECK(n_texts == n_warnings && memcmp(texts[0].data, "in views[", 9) == 0);
    OK(tree_lines_free(lines));
    OK(tree_aligned_free(aligned));
    tree_align_warning unknown = {.problem = 99};
    FAILS(TREE_ERROR_ENUM, "warnings[0]", tree_align_warnings_text(&unknown, 1, &lines));
    FAILS(TREE_ERROR_NO_RESULT, "views[1]",
          tree_align_all(with_empty, params, 2, 6.8f, NULL, &aligned));
    FAILS(TREE_ERROR_PARAMETER, "mattes", tree_align_all(NULL, NULL, 0, 6.8f, NULL, &aligned));
    CHECK(aligned == NULL);
    OK(tree_matte_free(matte));
    OK(tree_matte_free(cropped));
    OK(tree_matte_free(empty));
}

static tree_attractor *a_fork_of_pixels(void) {
    static const float positions[] = {5, 9, 5, 5, 2, 1, 8, 1};
    static const uint32_t parents[] = {TREE_NO_PARENT, 0, 1, 1};
    tree_attractor_columns columns = {sizeof columns, 4, positions, parents};
    tree_attractor *attractor;
    OK(tree_attractor_from_columns(&columns, NULL, &attractor));
    return attractor;
}

static float length_of(const tree_attractor *attractor) {
    float length = NAN;
    OK(tree_attractor_length(attractor, &length));
    return length;
}

static void attractors(void) {
    tree_attractor *fork = a_fork_of_pixels(), *changed, *bad;
    tree_attractor_columns columns = {.struct_size = sizeof columns};
    OK(tree_attractor_view(fork, &columns));
    CHECK(columns.n_nodes == 4 && columns.positions[6] == 8 && columns.parents[3] == 1);
    static const uint32_t wrong[] = {1, TREE_NO_PARENT, 0, 0};
    tree_attractor_columns backwards = {sizeof backwards, 4, columns.positions, wrong};
    FAILS(TREE_ERROR_INVALID, "before", tree_attractor_from_columns(&backwards, NULL, &bad));
    CHECK(bad == NULL && length_of(fork) == 14);
    tree_rows *tips;
    const uint32_t *rows;
    size_t n;
    OK(tree_attractor_tips(fork, &tips));
    OK(tree_rows_view(tips, &rows, &n));
    CHECK(n == 2 && rows[0] == 2 && rows[1] == 3);
    OK(tree_rows_free(tips));
    const float at[] = {7, 7}, by[] = {1, 0}, nowhere[] = {NAN, 0};
    tree_attractor_nearest_point nearest = {.struct_size = sizeof nearest};
    OK(tree_attractor_nearest(fork, at, &nearest));
    CHECK(nearest.found && nearest.node == 1 && nearest.share == 0.5f && nearest.distance == 2);
    CHECK(nearest.point[0] == 5 && nearest.point[1] == 7);
    OK(tree_attractor_nearest(fork, nowhere, &nearest));
    CHECK(!nearest.found);

    const float stroke[] = {6, 6, 9, 6};
    float gap = 0;
    tree_stroke_params params;
    tree_stroke_report strokes = {.struct_size = sizeof strokes};
    OK(tree_stroke_params_init(&params, sizeof params));
    CHECK(near(params.spacing, 0.02f));
    OK(tree_attractor_add_stroke(fork, stroke, 2, &params, NULL, &strokes, &gap, &changed));
    CHECK(near(gap, 1) && strokes.n_bridged == 1 && near(length_of(changed), 18));
    OK(tree_attractor_free(changed));
    OK(tree_attractor_add_stroke(fork, NULL, 0, NULL, NULL, NULL, &gap, &changed));
    CHECK(isnan(gap) && length_of(changed) == 14);
    OK(tree_attractor_free(changed));
    params.snap = 2;
    FAILS(TREE_ERROR_PARAMETER, "strokes.snap",
          tree_attractor_add_stroke(fork, stroke, 2, &params, NULL, NULL, NULL, &bad));

    tree_erase_report erased = {.struct_size = sizeof erased};
    const float across[] = {4, 7, 6, 7};
    OK(tree_attractor_erase(fork, across, 2, 0.1f, TREE_CUT_OFF_DROP, &erased, &changed));
    CHECK(erased.n_erased == 1 && erased.n_dropped == 2 && length_of(changed) == 0);
    OK(tree_attractor_nearest(changed, at, &nearest));
    CHECK(!nearest.found);
    OK(tree_attractor_free(changed));
    OK(tree_attractor_erase(fork, across, 2, 0.1f, TREE_CUT_OFF_RECONNECT, &erased, &changed));
    CHECK(erased.n_reconnected == 1 && length_of(changed) > 13);
    OK(tree_attractor_free(changed));
    FAILS(TREE_ERROR_ENUM, "cut_off", tree_attractor_erase(fork, across, 2, 1, 5, NULL, &bad));
    OK(tree_attractor_move_near(fork, columns.positions + 6, by, 1, &changed));
    OK(tree_attractor_view(changed, &columns));
    CHECK(columns.positions[6] == 9 && columns.positions[4] == 2);
    OK(tree_attractor_free(changed));
    FAILS(TREE_ERROR_PARAMETER, "at", tree_attractor_move_near(fork, nowhere, by, 1, &bad));
    OK(tree_attractor_mirrored(fork, 10, &changed));
    OK(tree_attractor_view(changed, &columns));
    CHECK(columns.positions[4] == 8 && columns.positions[5] == 1);
    OK(tree_attractor_free(changed));
    FAILS(TREE_ERROR_PARAMETER, "width", tree_attractor_mirrored(fork, INFINITY, &bad));
    static const float wide[] = {-3e38f, 0, 1, 1};
    static const uint32_t up[] = {TREE_NO_PARENT, 0};
    tree_attractor_columns far_off = {.struct_size = sizeof far_off, 2, wide, up};
    tree_attractor *afar;
    OK(tree_attractor_from_columns(&far_off, NULL, &afar));
    FAILS(TREE_ERROR_PARAMETER, "width", tree_attractor_mirrored(afar, 3e38f, &bad));
    OK(tree_attractor_free(afar));

    tree_photo *paper, *drawn;
    OK(tree_photo_blank(10, 10, 0x000000ff, NULL, &paper));
    OK(tree_attractor_draw(fork, paper, 2, 0xff8000ff, &drawn));
    CHECK(pixel(drawn, 5, 7)[0] == 255 && pixel(drawn, 5, 7)[1] == 128);
    CHECK(pixel(drawn, 0, 9)[0] == 0 && pixel(paper, 5, 7)[0] == 0);
    OK(tree_photo_free(paper));
    OK(tree_photo_free(drawn));
    OK(tree_attractor_free(fork));
}

static void drawings(void) {
    static const char svg[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 30 40'>"
        "<path d='M 15 37 L 15 14'/><polyline points='15,20 8,12 6,10'/></svg>";
    tree_strokes *strokes;
    OK(tree_strokes_from_svg(svg, TREE_NUL_TERMINATED, W, H, NULL, &strokes));
    tree_strokes_columns columns = {.struct_size = sizeof columns};
    OK(tree_strokes_view(strokes, &columns));
    CHECK(columns.n_strokes == 2 && columns.n_points == 5 && columns.starts[1] == 2);
    CHECK(columns.points[0] == 30 && columns.points[1] == 74 && columns.points[9] == 20);
    const float base[] = {30, 74};
    float gaps[2];
    tree_stroke_report report = {.struct_size = sizeof report};
    tree_attractor *attractor, *bad;
    OK(tree_attractor_from_strokes(&columns, base, NULL, NULL, &report, gaps, 2, &attractor));
    CHECK(gaps[0] == 0 && near(gaps[1], 0) && report.n_empty == 0 && report.n_bridged == 0);
    CHECK(fabsf(length_of(attractor) - 46 - 21.26f - 5.66f) < 0.1f);
    OK(tree_attractor_free(attractor));
    OK(tree_attractor_from_strokes(&columns, base, NULL, NULL, NULL, NULL, 0, &attractor));
    OK(tree_attractor_free(attractor));
    FAILS(TREE_ERROR_BUFFER, "gaps",
          tree_attractor_from_strokes(&columns, base, NULL, NULL, NULL, gaps, 1, &bad));
    const uint64_t falling[] = {0, 7, 5}, short_[] = {0, 2, 4};
    columns.starts = falling;
    FAILS(TREE_ERROR_INVALID, "starts[1]",
          tree_attractor_from_strokes(&columns, base, NULL, NULL, NULL, NULL, 0, &bad));
    columns.starts = short_;
    FAILS(TREE_ERROR_INVALID, "n_points",
          tree_attractor_from_strokes(&columns, base, NULL, NULL, NULL, NULL, 0, &bad));
    columns.n_strokes = SIZE_MAX;
    FAILS(TREE_ERROR_LIMIT, "nodes",
          tree_attractor_from_strokes(&columns, base, NULL, NULL, NULL, NULL, 0, &bad));
    OK(tree_strokes_free(strokes));
    FAILS(TREE_ERROR_FORMAT, "SVG", tree_strokes_from_svg("<svg", 4, W, H, NULL, &strokes));
    FAILS(TREE_ERROR_PARAMETER, "picture_size", tree_strokes_from_svg(svg, 9, 0, H, NULL, &strokes));
    FAILS(TREE_ERROR_TEXT, "UTF-8", tree_strokes_from_svg("\xff", 1, W, H, NULL, &strokes));

    /* Without strokes the graph is the base alone. */
    tree_strokes_columns nothing = {.struct_size = sizeof nothing};
    OK(tree_attractor_from_strokes(&nothing, base, NULL, NULL, NULL, NULL, 0, &attractor));
    CHECK(length_of(attractor) == 0);
    OK(tree_attractor_free(attractor));
}

static void paths(void) {
    tree_matte *matte = a_matte(), *empty;
    tree_photo *photo = a_photo(SKY, 0), *small;
    const float base[] = {30, 74}, none = 0;
    OK(tree_matte_from_alpha(1, 1, &none, 1, NULL, &empty));
    tree_seed_params spread;
    OK(tree_seed_params_init(&spread, sizeof spread));
    CHECK(near(spread.from_trunk, 0.08f) && spread.reserved == 0);
    float seeds[24], again[24];
    size_t n = 0;
    OK(tree_matte_seeds(matte, base, 10, &spread, 7, NULL, seeds, 24, &n));
    CHECK(n == 10);
    OK(tree_matte_seeds(matte, base, 10, NULL, 7, NULL, again, 24, &n));
    CHECK(memcmp(seeds, again, 2 * n * sizeof *seeds) == 0);
    for (size_t i = 0; i < n; i++) {
        float dx = seeds[2 * i] - 30, dy = seeds[2 * i + 1] - 28;
        CHECK(fabsf(sqrtf(dx * dx + dy * dy) - 22) < 3);
    }
    FAILS(TREE_ERROR_BUFFER, "seeds",
          tree_matte_seeds(matte, base, 10, NULL, 7, NULL, seeds, 5, &n));
    FAILS(TREE_ERROR_PARAMETER, "seeds.n",
          tree_matte_seeds(matte, base, 1 << 30, NULL, 7, NULL, seeds, 24, &n));
    FAILS(TREE_ERROR_NO_RESULT, "no silhouette",
          tree_matte_seeds(empty, base, 10, NULL, 7, NULL, seeds, 24, &n));

    tree_livewire_params params;
    OK(tree_livewire_params_init(&params, sizeof params));
    CHECK(params.rows == 256 && params.smoothing == 12 && params.reserved == 0);
    params.stub = 0;
    seeds[20] = NAN;
    seeds[21] = 0;
    seeds[22] = -9;
    seeds[23] = 28;
    tree_livewire_report report = {.struct_size = sizeof report};
    tree_attractor *attractor, *bad;
    OK(tree_attractor_livewire(matte, photo, base, seeds, 12, &params, NULL, &report, &attractor));
    CHECK(report.n_bad_seeds == 1 && report.n_moved_seeds == 1 && report.n_tips >= 5);
    CHECK(report.outside < 0.3f && fabsf(report.trunk_width - 4) < 2);
    tree_attractor_columns columns = {.struct_size = sizeof columns};
    OK(tree_attractor_view(attractor, &columns));
    CHECK(columns.positions[0] == 30 && columns.positions[1] == 74 && length_of(attractor) > 60);
    OK(tree_attractor_free(attractor));
    OK(tree_attractor_livewire(matte, NULL, base, NULL, 0, NULL, NULL, NULL, &attractor));
    CHECK(length_of(attractor) == 0);
    OK(tree_attractor_free(attractor));
    params.join = 1;
    FAILS(TREE_ERROR_PARAMETER, "livewire.join",
          tree_attractor_livewire(matte, NULL, base, seeds, 9, &params, NULL, NULL, &bad));
    OK(tree_photo_blank(2, 2, 0, NULL, &small));
    FAILS(TREE_ERROR_NO_RESULT, "matte",
          tree_attractor_livewire(matte, small, base, seeds, 9, NULL, NULL, NULL, &bad));
    FAILS(TREE_ERROR_NO_RESULT, "no tree",
          tree_attractor_livewire(empty, NULL, base, seeds, 9, NULL, NULL, NULL, &bad));
    tree_cancel *cancel;
    tree_control control;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_attractor_livewire(matte, photo, base, seeds, 9, NULL, &control, NULL, &bad));
    CHECK(bad == NULL);
    OK(tree_cancel_free(cancel));
    OK(tree_photo_free(small));
    OK(tree_photo_free(photo));
    OK(tree_matte_free(matte));
    OK(tree_matte_free(empty));
}

static void marks(void) {
    tree_matte *matte = a_matte();
    tree_photo *grey, *drawn, *bad;
    OK(tree_photo_of_matte(matte, &grey));
    CHECK(pixel(grey, 30, 28)[0] == 255 && pixel(grey, 0, 0)[0] == 0 && pixel(grey, 0, 0)[3] == 255);
    tree_mark all[] = {
        {TREE_MARK_FILL, {0, 0}, {10, 5}, 0, 0x0000ffff},
        {TREE_MARK_LINE, {0, 79.5f}, {60, 79.5f}, 1, 0xff0000ff},
        {TREE_MARK_DOT, {55, 75}, {0, 0}, 4, 0x00ff00ff},
        {TREE_MARK_ARROW, {2, 60}, {20, 60}, 2, 0xff00ffff},
    };
    OK(tree_photo_draw(grey, all, 4, NULL, &drawn));
    CHECK(pixel(drawn, 9, 4)[2] == 255 && pixel(drawn, 10, 4)[2] == 0);
    CHECK(pixel(drawn, 40, 79)[0] == 255 && pixel(drawn, 40, 79)[1] == 0);
    CHECK(pixel(drawn, 55, 75)[1] == 255 && pixel(drawn, 55, 71)[1] == 0);
    CHECK(pixel(drawn, 10, 60)[0] == 255 && pixel(drawn, 16, 58)[2] == 255);
    CHECK(pixel(drawn, 4, 57)[2] == 0 && pixel(drawn, 30, 28)[1] == 255);
    OK(tree_photo_free(drawn));
    OK(tree_photo_draw(grey, NULL, 0, NULL, &drawn));
    CHECK(memcmp(pixel(drawn, 0, 0), pixel(grey, 0, 0), 4 * N) == 0);
    OK(tree_photo_free(drawn));
    all[3].kind = 4;
    FAILS(TREE_ERROR_ENUM, "marks[3].kind", tree_photo_draw(grey, all, 4, NULL, &bad));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_photo_draw(grey, all, SIZE_MAX, NULL, &bad));
    CHECK(bad == NULL);
    OK(tree_photo_free(grey));
    OK(tree_matte_free(matte));
}

void test_photo(void) {
    photographs();
    mattes();
    trimaps();
    screens();
    cameras();
    alignment();
    attractors();
    drawings();
    paths();
    marks();
}
