#define _POSIX_C_SOURCE 200809L
#include "check.h"
#include <math.h>
#include <pthread.h>
#include <time.h>

static const float origin[3] = {0, 0, 0};
static const float up[3] = {0, 1, 0};

/* Whether a point lies inside. */
static int has(const tree_volume *volume, float x, float y, float z) {
    float point[3] = {x, y, z};
    uint8_t inside = 9;
    OK(tree_volume_contains(volume, point, 1, NULL, &inside));
    return inside;
}

static uint32_t kind(const tree_volume *volume) {
    tree_solid solid = {.struct_size = sizeof solid};
    OK(tree_volume_view(volume, &solid));
    return solid.kind;
}

static void plain_solids(void) {
    static const float radii[] = {1, 2, 3}, two_up[] = {0, 2, 0}, one[] = {1, 1, 1};
    static const float profile[] = {0, 0, 1, 1, 0, 2};
    static const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const uint32_t faces[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    tree_volume *solids[11];
    OK(tree_volume_sphere(origin, 1, &solids[0]));
    OK(tree_volume_ellipsoid(origin, radii, &solids[1]));
    OK(tree_volume_cylinder(origin, two_up, 1, &solids[2]));
    OK(tree_volume_frustum(origin, two_up, 1, 0.5f, &solids[3]));
    OK(tree_volume_cone(origin, two_up, 1, &solids[4]));
    OK(tree_volume_capsule(origin, two_up, 1, &solids[5]));
    OK(tree_volume_box(origin, one, &solids[6]));
    OK(tree_volume_half_space(origin, up, &solids[7]));
    OK(tree_volume_sector(origin, up, 0.5f, 1, &solids[8]));
    OK(tree_volume_revolution(origin, up, profile, 3, NULL, &solids[9]));
    OK(tree_volume_closed_mesh(corners, 4, faces, 4, NULL, &solids[10]));
    static const uint32_t kinds[] = {TREE_SOLID_SPHERE,     TREE_SOLID_ELLIPSOID, TREE_SOLID_CYLINDER,
                                     TREE_SOLID_FRUSTUM,    TREE_SOLID_FRUSTUM,   TREE_SOLID_CAPSULE,
                                     TREE_SOLID_BOX,        TREE_SOLID_HALF_SPACE, TREE_SOLID_SECTOR,
                                     TREE_SOLID_REVOLUTION, TREE_SOLID_MESH};
    static const float pi = 3.14159265f;
    const float measures[] = {4 * pi / 3, 8 * pi, 2 * pi, 7 * pi / 6, 2 * pi / 3, 10 * pi / 3, 1,
                              NAN, 2 * pi / 3 * (1 - cosf(0.5f)), 2 * pi / 3, 1.0f / 6};
    for (int i = 0; i < 11; i++) {
        CHECK(kind(solids[i]) == kinds[i]);
        float measure, estimate;
        uint32_t exact, bounded;
        OK(tree_volume_measure(solids[i], &measure));
        CHECK(isnan(measures[i]) ? isnan(measure) : fabsf(measure / measures[i] - 1) < 1e-4f);
        OK(tree_volume_estimate_measure(solids[i], 8000, NULL, &estimate));
        CHECK(isnan(measures[i]) ? isinf(estimate) : fabsf(estimate / measures[i] - 1) < 0.1f);
        OK(tree_volume_distance_is_exact(solids[i], &exact));
        OK(tree_volume_is_bounded(solids[i], &bounded));
        CHECK(exact == 1 && bounded == (i != 7));
        CHECK(has(solids[i], 0.1f, 0.3f, 0.1f) == (i != 7));
        CHECK(!has(solids[i], 0, 9, 0));
    }
    tree_solid mesh = {.struct_size = sizeof mesh};
    OK(tree_volume_view(solids[10], &mesh));
    CHECK(mesh.n_points == 4 && mesh.n_triangles == 4 && mesh.points[3] == 1 && mesh.indices[1] == 2);
    tree_solid sector = {.struct_size = sizeof sector};
    OK(tree_volume_view(solids[8], &sector));
    CHECK(sector.angle == 0.5f && sector.radius == 1 && sector.b[1] == 1 && sector.n_parts == 0);
    for (int i = 0; i < 11; i++) {
        OK(tree_volume_free(solids[i]));
    }

    tree_volume *none = NULL;
    FAILS(TREE_ERROR_PARAMETER, "radius", tree_volume_sphere(origin, -1, &none));
    FAILS(TREE_ERROR_PARAMETER, "radius", tree_volume_sphere(origin, NAN, &none));
    CHECK(none == NULL);
    FAILS(TREE_ERROR_NULL, "center", tree_volume_sphere(NULL, 1, &none));
    FAILS(TREE_ERROR_NULL, "volume", tree_volume_sphere(origin, 1, NULL));
    FAILS(TREE_ERROR_PARAMETER, "edge",
          tree_volume_closed_mesh(corners, 4, faces, 3, NULL, &none));
    FAILS(TREE_ERROR_LIMIT, "triangles",
          tree_volume_closed_mesh(corners, 4, faces, SIZE_MAX, NULL, &none));
}

static void combinations(void) {
    static const float x1[] = {1, 0, 0}, x5[] = {5, 0, 0};
    tree_volume *balls[3], *all, *lens, *bite, *moved, *part;
    OK(tree_volume_sphere(origin, 1, &balls[0]));
    OK(tree_volume_sphere(x1, 1, &balls[1]));
    OK(tree_volume_sphere(x5, 1, &balls[2]));
    const tree_volume *const given[] = {balls[0], balls[1], balls[2]};
    OK(tree_volume_union(given, 3, &all));
    CHECK(kind(all) == TREE_SOLID_UNION && has(all, -0.5f, 0, 0) && has(all, 5, 0, 0));
    OK(tree_volume_intersection(given, 2, &lens));
    CHECK(kind(lens) == TREE_SOLID_INTERSECTION && has(lens, 0.5f, 0, 0) && !has(lens, -0.5f, 0, 0));
    OK(tree_volume_difference(balls[0], balls[1], &bite));
    CHECK(kind(bite) == TREE_SOLID_DIFFERENCE && !has(bite, 0.5f, 0, 0) && has(bite, -0.5f, 0, 0));
    /* Twice as high, and then one metre along X. */
    static const float columns[] = {1, 0, 0, 0, 2, 0, 0, 0, 1, 1, 0, 0};
    OK(tree_volume_transformed(balls[0], columns, &moved));
    CHECK(has(moved, 1, 1.9f, 0) && !has(moved, 0, 1, 0));
    tree_solid solid = {.struct_size = sizeof solid};
    OK(tree_volume_view(moved, &solid));
    CHECK(solid.kind == TREE_SOLID_TRANSFORMED && solid.columns[4] == 2 && solid.columns[9] == 1);

    OK(tree_volume_view(all, &solid));
    CHECK(solid.n_parts == 3);
    OK(tree_volume_part(all, 2, &part));
    OK(tree_volume_free(all));
    CHECK(has(part, 5, 0, 0));
    FAILS(TREE_ERROR_PARAMETER, "parts", tree_volume_part(part, 0, &all));
    FAILS(TREE_ERROR_INVALID, "empty", tree_volume_union(given, 0, &all));
    FAILS(TREE_ERROR_LIMIT, "at most", tree_volume_union(given, SIZE_MAX, &all));
    FAILS(TREE_ERROR_NULL, "volumes", tree_volume_intersection(NULL, 2, &all));
    float flat[12] = {0};
    FAILS(TREE_ERROR_PARAMETER, "transform", tree_volume_transformed(part, flat, &all));
    OK(tree_volume_free(part));
    for (int i = 0; i < 3; i++) {
        OK(tree_volume_free(balls[i]));
    }
    FAILS(TREE_ERROR_HANDLE, "volumes[0]", tree_volume_union(given, 1, &all));
    OK(tree_volume_free(lens));
    OK(tree_volume_free(bite));
    OK(tree_volume_free(moved));
}

static void questions(void) {
    tree_volume *ball;
    OK(tree_volume_sphere(origin, 2, &ball));
    const float points[] = {0, 0, 0, 3, 0, 0, NAN, 0, 0};
    float distances[3];
    uint8_t inside[3];
    OK(tree_volume_contains(ball, points, 3, NULL, inside));
    CHECK(inside[0] == 1 && inside[1] == 0 && inside[2] == 0);
    OK(tree_volume_distance(ball, points, 3, NULL, distances));
    CHECK(distances[0] == -2 && distances[1] == 1 && isnan(distances[2]));
    OK(tree_volume_contains(ball, NULL, 0, NULL, NULL));
    FAILS(TREE_ERROR_LIMIT, "nodes", tree_volume_contains(ball, points, SIZE_MAX, NULL, inside));
    FAILS(TREE_ERROR_NULL, "inside", tree_volume_contains(ball, points, 3, NULL, NULL));

    /* So many that several threads share them. */
    enum { MANY = 10000 };
    float *many = malloc(3 * MANY * sizeof(float)), *far = malloc(MANY * sizeof(float));
    for (int i = 0; i < 3 * MANY; i++) {
        many[i] = i % 3 ? 0 : (float)(i / 3);
    }
    OK(tree_volume_distance(ball, many, MANY, NULL, far));
    CHECK(far[0] == -2 && far[MANY - 1] == MANY - 3);
    free(many);
    free(far);

    float box[6];
    OK(tree_volume_bounds(ball, &box));
    CHECK(box[0] == -2 && box[5] == 2);
    float drawn[3 * 50], again[3 * 50];
    uint8_t all[50];
    OK(tree_volume_sample(ball, 50, 64, 7, NULL, drawn));
    OK(tree_volume_sample(ball, 50, 64, 7, NULL, again));
    CHECK(memcmp(drawn, again, sizeof drawn) == 0);
    OK(tree_volume_contains(ball, drawn, 50, NULL, all));
    for (int i = 0; i < 50; i++) {
        CHECK(all[i]);
    }
    FAILS(TREE_ERROR_NO_RESULT, "attempts", tree_volume_sample(ball, 1, 0, 7, NULL, drawn));

    tree_cancel *cancel;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel",
          tree_volume_distance(ball, points, 3, &control, distances));
    OK(tree_cancel_free(cancel));
    OK(tree_volume_free(ball));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_volume_bounds(ball, &box));
}

static void *set_in_a_moment(void *cancel) {
    const struct timespec moment = {0, 20 * 1000 * 1000};
    nanosleep(&moment, NULL);
    OK(tree_cancel_set(cancel));
    return NULL;
}

/* Long questions are cancelled while they run. */
static void cancelled_soon(void) {
    tree_volume *ball, *nothing, *costly;
    OK(tree_volume_sphere(origin, 1, &ball));
    OK(tree_volume_difference(ball, ball, &nothing));
    OK(tree_volume_difference(ball, ball, &costly));
    for (int i = 0; i < 17; i++) {
        tree_volume *next;
        OK(tree_volume_difference(costly, costly, &next));
        OK(tree_volume_free(costly));
        costly = next;
    }
    float *points = calloc(3 * 4096, sizeof *points), *distances = calloc(4096, sizeof *distances);
    for (int what = 0; what < 2; what++) {
        tree_cancel *cancel;
        OK(tree_cancel_new(&cancel));
        tree_control control;
        OK(tree_control_init(&control, sizeof control));
        control.cancel = cancel;
        pthread_t thread;
        CHECK(pthread_create(&thread, NULL, set_in_a_moment, cancel) == 0);
        if (what == 0) {
            /* Points of the bounds, none of which lies inside. */
            FAILS(TREE_ERROR_CANCELLED, "cancel",
                  tree_volume_sample(nothing, 1, UINT32_MAX, 7, &control, points));
        } else {
            FAILS(TREE_ERROR_CANCELLED, "cancel",
                  tree_volume_distance(costly, points, 4096, &control, distances));
        }
        pthread_join(thread, NULL);
        OK(tree_cancel_free(cancel));
    }
    free(points);
    free(distances);
    /* More attempts than are drawn between two looks at the control. */
    FAILS(TREE_ERROR_NO_RESULT, "10000 attempts",
          tree_volume_sample(nothing, 1, 10000, 7, NULL, (float[3]){0}));
    OK(tree_volume_free(costly));
    OK(tree_volume_free(nothing));
    OK(tree_volume_free(ball));
}

void test_volume(void) {
    cancelled_soon();
    plain_solids();
    combinations();
    questions();
}
