/* Made by tests/hostile.rs of include/tree.h: calls everything as nobody should. */
#define _POSIX_C_SOURCE 200809L
#include "tree.h"
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-value"
#endif

#define NO_STATUS (-1)
#define PASSED_FOR_WELL (-2)
#define MOST_ARGUMENTS 16

typedef struct attack {
    const char *name;
    int (*call)(const unsigned *moods);
    unsigned n_arguments;
    unsigned n_moods[MOST_ARGUMENTS];
    /* Which struct an argument is, counted from 1; 0 for all else. */
    unsigned structs[MOST_ARGUMENTS];
    int control;
    int strict;
} attack;

static int n_failures;
static size_t n_calls;
static const char *now = "nothing";
static unsigned moods_now[MOST_ARGUMENTS];

static void complain(const char *what) {
    static const char *last;
    static int n_of_this;
    n_of_this = last == now ? n_of_this + 1 : 0;
    last = now;
    if (n_of_this > 2) return;
    printf("%s(", now);
    for (int i = 0; i < 8; i++) printf("%u ", moods_now[i]);
    printf("): %s: %s\n", what, tree_error_text());
    if (++n_failures > 40) exit(1);
}

static void must(tree_status status) {
    if (status != TREE_OK) complain("preparing failed");
}

#define UNTOUCHED ((void *)0x11)

/* Where a handle goes, with something else in it. */
static void *new_place(unsigned m) {
    static void *places[8];
    static unsigned next;
    void **found = &places[next++ % 8];
    *found = UNTOUCHED;
    return m ? found : NULL;
}

/* After a failure there is NULL where the object would be. */
static void handed_out(int status, int all_given, const void *found, int freed) {
    if (status != TREE_OK && all_given && found != NULL) complain("the handle is not NULL after an error");
    if (status == TREE_OK && freed != TREE_OK) complain("what was handed out cannot be freed");
}

/* Room for structs: enough for those of one call. */
static void *room(size_t size) {
    static union { char bytes[4096]; double align; void *pointer; } rooms[64];
    static unsigned next;
    char *found = rooms[next++ % 64].bytes;
    if (size > 4096) complain("a struct is larger than the test's room");
    memset(found, 0, 4096);
    return found;
}

static float hostile_float(unsigned m) {
    static const float values[] = {0, 0.5f, NAN, INFINITY, -1, 1e30f, 1e-30f};
    return values[m];
}

static uint64_t hostile_integer(unsigned m, size_t size) {
    uint64_t most = size == 8 ? UINT64_MAX : ((uint64_t)1 << (8 * size)) - 1;
    switch (m) {
    case 0: return 0;
    case 1: return 1;
    case 2: return 2;
    case 3: return most;
    case 4: return most / 2;
    default: return most / 8 + 2;
    }
}

static const char *hostile_text(unsigned m) {
    static const char *const values[] = {NULL, "a name\0of 16 b", "\xff\xfe no UTF-8 this",
                                         "\0 an empty one", "/no/such/folder/x"};
    return values[m];
}

static tree_str hostile_str(unsigned m) {
    switch (m) {
    case 0: return (tree_str){NULL, 0};
    case 1: return (tree_str){"name", 4};
    case 2: return (tree_str){"\xff\xfe", 2};
    case 3: return (tree_str){NULL, 5};
    default: return (tree_str){"", TREE_NUL_TERMINATED};
    }
}

/* Numbers to read, and room for results. */
static void *hostile_memory(unsigned m) {
    static _Alignas(64) unsigned char memory[4][1 << 22];
    static unsigned next;
    static const float halves[256] = {0.5f, 0.25f, 1, 0.5f};
    if (m == 0) return NULL;
    unsigned char *found = memory[next++ % 4];
    memset(found, m == 2 ? 0xff : 0, 4096);
    if (m == 3) memcpy(found, halves, sizeof halves);
    /* The last one lies badly. */
    return m == 4 ? found + 1 : found;
}

static void **several(void *alive, unsigned m) {
    void **found = room(4 * sizeof *found);
    for (int i = 0; i < 4; i++)
        found[i] = m == 1 ? alive : m == 2 ? NULL : m == 3 ? (void *)0x10 : (void *)((char *)alive + 1);
    return m ? found : NULL;
}

/* Ends work that has become long. */
static int n_told;
static int32_t patience(void *user, const char *stage, float fraction) {
    (void)user;
    return !stage || !(fraction >= 0 && fraction <= 1) || ++n_told > 200;
}

static tree_limits small_limits;

static void calm(tree_control *control) {
    if (!small_limits.struct_size) {
        must(tree_limits_init(&small_limits, sizeof small_limits));
        small_limits.nodes = small_limits.leaves = 2000;
        small_limits.graph_nodes = small_limits.graph_arcs = small_limits.modules = 20000;
        small_limits.triangles = small_limits.voxels = small_limits.pixels = 40000;
        small_limits.pairs = 20000;
    }
    must(tree_control_init(control, sizeof *control));
    control->progress = patience;
    control->limits = &small_limits;
}

static const float fork_positions[] = {0, 0, 0, 0, 1, 0, 0.5f, 2.5f, 0, -0.5f, 2, 0};
static const float fork_radii[] = {0.1f, 0.08f, 0.01f, 0.01f};
static const uint32_t fork_parents[] = {TREE_NO_PARENT, 0, 1, 1};
static const tree_skeleton_columns fork_columns = {sizeof fork_columns, 4, fork_positions,
                                                   fork_radii, fork_parents};
static const tree_pool_options one_thread = {sizeof one_thread, 1, 0, 0, NULL, NULL};

static const float origin[3];
static const uint8_t pixel[4];
static const char svg[] = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 10 10\">"
                          "<path d=\"M5 10 L9 5 L5 0\"/></svg>";
static const uint32_t fork_edges[] = {0, 1, 1, 2, 1, 3};
static const char swc[] = "1 1 0 0 0 1 -1\n2 1 0 1 0 1 1\n";
static const uint32_t leaf_nodes[] = {2, 3};
static const float leaf_positions[] = {0.5f, 2.5f, 0, -0.5f, 2, 0};
static const float leaf_rotations[] = {0, 0, 0, 1, 0.6f, 0, 0.8f, 0};
static const float leaf_sizes[] = {0.1f, 0.12f};
static const uint16_t leaf_kinds[2];
static const tree_foliage two_leaves = {sizeof two_leaves, 2, leaf_nodes, leaf_positions,
                                        leaf_rotations, leaf_sizes, leaf_kinds};

/* A crown on a trunk, in few pixels. */
static uint8_t small_rgba[4 * 8 * 12];
static uint8_t small_levels[8 * 12];
static float small_alpha[8 * 12];
static void small_tree(void) {
    for (int y = 0; y < 12; y++) {
        for (int x = 0; x < 8; x++) {
            int i = 8 * y + x, crown = y > 0 && y < 7 && x > 0 && x < 7, trunk = y < 11 && x / 2 == 1;
            int in = crown || (trunk && y >= 7), edge = crown && (y == 1 || x == 1 || x == 6);
            small_alpha[i] = edge ? 0.5f : in ? 1.0f : 0.0f;
            small_levels[i] = edge ? TREE_LEVEL_UNKNOWN : in ? TREE_LEVEL_FOREGROUND : TREE_LEVEL_BACKGROUND;
            small_rgba[4 * i] = in ? 40 : 200;
            small_rgba[4 * i + 1] = in ? 90 : 220;
            small_rgba[4 * i + 2] = in ? 30 : 255;
            small_rgba[4 * i + 3] = 255;
        }
    }
}
static const float fork_spots[] = {3, 11, 3, 6, 2, 2, 5, 2};
static const tree_attractor_columns fork_pixels = {sizeof fork_pixels, 4, fork_spots, fork_parents};
static const tree_align_warning a_warning[1];
static const tree_align_params *a_look_from_afar(void) {
    static tree_align_params params;
    must(tree_align_params_init(&params, sizeof params));
    return &params;
}

/* The same tree as a view and as a photograph of a session; the objects are made below. */
static tree_matte *live_tree_matte(void);
static tree_particle_view *one_view(void) {
    static tree_particle_view view;
    static tree_particle_camera camera;
    must(tree_particle_camera_init(&camera, sizeof camera));
    camera.size[0] = 8;
    camera.size[1] = 12;
    camera.base[0] = 3;
    camera.base[1] = 11;
    camera.scale = 0.5f;
    must(tree_particle_view_init(&view, sizeof view));
    view.matte = live_tree_matte();
    view.camera = &camera;
    return &view;
}
static tree_photo_shot *one_shot(void) {
    static tree_photo_shot shot;
    must(tree_photo_shot_init(&shot, sizeof shot));
    shot.matte = live_tree_matte();
    return &shot;
}
static const float a_start[] = {0.5f, 4, 0};
static const tree_density_params *few_voxels(void) {
    static tree_density_params params;
    must(tree_density_params_init(&params, sizeof params));
    params.resolution = 6;
    return &params;
}
static const tree_field_params *few_rows(void) {
    static tree_field_params params;
    must(tree_field_params_init(&params, sizeof params));
    params.rows = 6;
    return &params;
}
static const tree_photo_params *few_particles(void) {
    static tree_photo_params params;
    static tree_flow_params flow;
    must(tree_photo_params_init(&params, sizeof params));
    must(tree_flow_params_init(&flow, sizeof flow));
    flow.particles = 10;
    params.branches = 4;
    params.height = 5;
    params.flow = &flow;
    params.density = few_voxels();
    params.field = few_rows();
    return &params;
}

static const tree_sketch_params *few_branches(void) {
    static tree_sketch_params params;
    static tree_sketch_propagate_params propagate;
    static tree_sketch_finish_params finish;
    must(tree_sketch_params_init(&params, sizeof params));
    must(tree_sketch_propagate_params_init(&propagate, sizeof propagate));
    must(tree_sketch_finish_params_init(&finish, sizeof finish));
    propagate.generations = 1;
    finish.fullness = 0.05f;
    params.propagate = &propagate;
    params.finish = &finish;
    return &params;
}

/* Strokes of a sketch. */
static const float fork_trunk[] = {50, 100, 50, 60, 50, 10}, fork_branch[] = {50, 60, 80, 30};
static const tree_sketch_stroke strokes_of_a_fork[] = {
    {.struct_size = sizeof(tree_sketch_stroke), .n_points = 3, .points = fork_trunk},
    {.struct_size = sizeof(tree_sketch_stroke), .n_points = 2, .points = fork_branch}};
static const char json[] = "[[[5, 9], [5, 5], [5, 1]], [[5, 5], [8, 2]]]\n";
static const float triangle_points[] = {-2, 1, 2, 1, 0, 4, -2, 1};
static const uint64_t triangle_starts[] = {0, 4};
static const tree_drawn_stroke drawn_outlines[] = {
    {.struct_size = sizeof(tree_drawn_stroke), .n_points = 2, .points = fork_spots},
    {.struct_size = sizeof(tree_drawn_stroke), .n_points = 4, .points = fork_spots,
     .kind = TREE_DRAWN_KIND_OUTLINE}};
static const tree_domain two_domains[] = {{{0, 1}, {0, 6}}, {{0.5f, 0.5f}, {-1, 1}}};
static const tree_arrangement decussate = {.kind = TREE_ARRANGEMENT_DECUSSATE};
static const tree_strokes_columns a_triangle = {sizeof a_triangle, 1, triangle_starts, 4,
                                                triangle_points};

static const tree_silhouette_params *few_boughs(void) {
    static tree_silhouette_params params;
    static tree_silhouette_grow_params grow;
    must(tree_silhouette_params_init(&params, sizeof params));
    must(tree_silhouette_grow_params_init(&grow, sizeof grow));
    grow.depth = 1;
    params.grow = &grow;
    return &params;
}

static const tree_stand_params *few_trees(void) {
    static tree_stand_params params;
    must(tree_stand_params_init(&params, sizeof params));
    params.silhouette = few_boughs();
    return &params;
}

/* A scene of one tree of one triangle. */
static const tree_lod_row the_full_row = {1, 1, 1, 1, 1};
static const tree_scene_instance one_instance = {0, {0, 0, -20}, {0, 0, 0, 1}, 1};
static const tree_scene_model *one_scene_model(void) {
    static tree_scene_model model;
    static const float all = 1;
    static const tree_scene_draw triangle = {0, 3, 0};
    must(tree_scene_model_init(&model, sizeof model));
    model.lambdas = &all;
    model.draws = &triangle;
    model.n_levels = model.n_parts = 1;
    return &model;
}

/* A model to be pruned: its table has the full row alone. */
static tree_mesh *live_tree_mesh(void);
static tree_elements *live_tree_elements(void);
static const tree_lod_subject *one_subject(void) {
    static tree_lod_subject subject;
    static uint32_t order[64];
    tree_elements_columns columns = {.struct_size = sizeof columns};
    must(tree_lod_subject_init(&subject, sizeof subject));
    must(tree_elements_view(live_tree_elements(), &columns));
    must(tree_order_golden(live_tree_elements(), order, 64));
    subject.mesh = live_tree_mesh();
    subject.elements = live_tree_elements();
    subject.order = order;
    subject.n_order = columns.n_elements;
    return &subject;
}

/* A small grammar, with a symbol that says nothing to the turtle. */
static const char a_bush[] = "steps: 3\naxiom: F[+A(1)]Q\nA(l) : l > 0.1 -> F(l)[+A(l/2)]A(l/2)";
/* Leaves that are all carried by the root, and small pictures of them. */
static const uint32_t some_bearers[64];

static size_t n_elements(void) {
    tree_elements_columns columns = {.struct_size = sizeof columns};
    must(tree_elements_view(live_tree_elements(), &columns));
    return columns.n_elements;
}

static const tree_card_params *small_cards(void) {
    static tree_card_params params;
    must(tree_card_params_init(&params, sizeof params));
    params.size = 16;
    params.samples = 1;
    return &params;
}

static const tree_hybrid_params *small_hybrid(void) {
    static tree_hybrid_params params;
    must(tree_hybrid_params_init(&params, sizeof params));
    params.cards = small_cards();
    return &params;
}

static const tree_octahedral_params *few_frames(void) {
    static tree_octahedral_params params;
    must(tree_octahedral_params_init(&params, sizeof params));
    params.grid = 2;
    params.side = 64;
    params.samples = 1;
    return &params;
}

/* A pole as a laser scanner sees it, z up. */
static const char *a_pole(void) {
    static char text[1 << 14];
    size_t length = 0;
    for (int i = 0; i < 400; i++)
        length += (size_t)snprintf(text + length, sizeof text - length, "%.4f %.4f %.4f\n",
                                   0.05 * cos(0.7 * i), 0.05 * sin(0.7 * i), 0.003 * i);
    return text;
}

static const tree_growth_params *few_years(void) {
    static tree_growth_params params;
    must(tree_growth_params_init(&params, sizeof params));
    params.iterations = 2;
    return &params;
}
static const tree_growth_plant a_seedling = {sizeof a_seedling, NULL, {0, 0, 0}, {0, 1, 0}};

/* Where no obstacle of other calls is. */
static const tree_pose a_far_pose[] = {{{1000, 0, 1000}, {0, 0, 0, 1}}};
static uint64_t some_id;

/* Foreign kinds. */
static tree_cancel *a_switch;
static tree_pool *one_thread_pool;

static const tree_view *tiny_view(void) {
    static tree_view view;
    must(tree_view_init(&view, sizeof view));
    view.width = view.height = 8;
    return &view;
}

static const tree_strew_params *few_nodes(void) {
    static tree_strew_params params;
    must(tree_strew_params_init(&params, sizeof params));
    params.n_nodes = 20;
    return &params;
}

/* Where the second thing goes that a call makes; freed at the end. */
static tree_skeleton *second_skeleton;
static tree_mesh *second_mesh;
static tree_tree *second_tree;
static tree_skeleton **other_skeleton(void) {
    must(tree_skeleton_free(second_skeleton));
    return &second_skeleton;
}
static tree_mesh **other_mesh(void) {
    must(tree_mesh_free(second_mesh));
    return &second_mesh;
}

static tree_tree **other_tree(void) {
    must(tree_tree_free(second_tree));
    return &second_tree;
}

/* The address of an object that is gone: nothing is made between this and the call that gets it. */
static void *dead(void) {
    tree_skeleton *skeleton = NULL;
    must(tree_skeleton_from_columns(&fork_columns, NULL, &skeleton));
    must(tree_skeleton_free(skeleton));
    return skeleton;
}

