/* What every function shares: statuses, error texts, versions, sized structs, texts, handles. */
#include "check.h"
#include <pthread.h>

static void statuses_have_names(void) {
    CHECK(!strcmp(tree_status_name(TREE_OK), "TREE_OK"));
    CHECK(!strcmp(tree_status_name(TREE_ERROR_PANIC), "TREE_ERROR_PANIC"));
    const char *unknown = tree_status_name(TREE_ERROR_PANIC + 1);
    CHECK(unknown && *unknown && !strcmp(unknown, tree_status_name(-1)));
    for (tree_status status = TREE_OK; status <= TREE_ERROR_PANIC; status++) {
        CHECK(!strncmp(tree_status_name(status), "TREE_", 5));
        for (tree_status other = TREE_OK; other < status; other++)
            CHECK(strcmp(tree_status_name(status), tree_status_name(other)) != 0);
    }
}

static void *another_thread(void *unused) {
    (void)unused;
    CHECK(tree_error_status() == TREE_OK && !*tree_error_text());
    FAILS(TREE_ERROR_NULL, "cancel", tree_cancel_set(NULL));
    return NULL;
}

static void every_thread_has_its_error(void) {
    FAILS(TREE_ERROR_NULL, "skeleton", tree_skeleton_view(NULL, NULL));
    const char *text = tree_error_text();
    pthread_t thread;
    CHECK(pthread_create(&thread, NULL, another_thread, NULL) == 0);
    pthread_join(thread, NULL);
    CHECK(tree_error_status() == TREE_ERROR_NULL && strstr(tree_error_text(), "skeleton"));

    /* What goes well keeps the last error. */
    OK(tree_skeleton_free(NULL));
    CHECK(tree_error_status() == TREE_ERROR_NULL && tree_error_text() == text);
    tree_error_clear();
    CHECK(tree_error_status() == TREE_OK && !*tree_error_text());
}

static void versions(void) {
    int major = -1, minor = -1, patch = -1;
    CHECK(sscanf(tree_version(), "%d.%d.%d", &major, &minor, &patch) == 3);
    CHECK(major >= 0 && minor >= 0 && patch >= 0);
    CHECK(tree_abi_version() == TREE_ABI_VERSION);
}

/* A program built with a newer header: its structs are longer. */
typedef struct newer_control {
    tree_control known;
    uint64_t more[3];
} newer_control;

static void structs_grow(void) {
    newer_control control;
    memset(&control, 0xee, sizeof control);
    OK(tree_control_init(&control.known, sizeof control));
    CHECK(control.known.struct_size == sizeof control && control.more[2] == 0);
    CHECK(control.known.progress == NULL && control.known.cancel == NULL);

    /* Zero means what this library does; anything else means what it cannot know. */
    tree_skeleton *skeleton = NULL;
    static const float positions[] = {0, 0, 0};
    static const float radii[] = {0.1f};
    static const uint32_t parents[] = {TREE_NO_PARENT};
    tree_skeleton_columns columns = {sizeof columns, 1, positions, radii, parents};
    OK(tree_skeleton_from_columns(&columns, &control.known, &skeleton));
    control.more[1] = 1;
    tree_skeleton *none = skeleton;
    FAILS(TREE_ERROR_STRUCT_SIZE, "not known here",
          tree_skeleton_from_columns(&columns, &control.known, &none));
    CHECK(none == NULL);

    /* Views of a newer program get zeros where this library has nothing to say. */
    struct {
        tree_skeleton_columns known;
        size_t more;
    } view = {{.struct_size = sizeof view}, 7};
    OK(tree_skeleton_view(skeleton, &view.known));
    CHECK(view.known.struct_size == sizeof view && view.known.n_nodes == 1 && view.more == 0);

    /* A struct that was not set, and one shorter than any version. */
    view.known.struct_size = 0;
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof(tree_skeleton_columns)",
          tree_skeleton_view(skeleton, &view.known));
    view.known.struct_size = sizeof view.known - 1;
    FAILS(TREE_ERROR_STRUCT_SIZE, "columns", tree_skeleton_view(skeleton, &view.known));
    tree_limits limits;
    FAILS(TREE_ERROR_STRUCT_SIZE, "tree_limits", tree_limits_init(&limits, 8));
    FAILS(TREE_ERROR_NULL, "tree_limits", tree_limits_init(NULL, sizeof limits));
    OK(tree_skeleton_free(skeleton));
}

static tree_status with_name(const char *name, size_t len, tree_tree **tree) {
    tree_skeleton *fork = a_fork();
    tree_species species = {sizeof species, {name, len}, {NULL, 0}, NULL, 0};
    tree_status status = tree_tree_new(fork, NULL, &species, NULL, tree);
    OK(tree_skeleton_free(fork));
    return status;
}

static void texts(void) {
    tree_tree *tree = NULL;
    tree_species species = {.struct_size = sizeof species};
    OK(with_name("Eiche", TREE_NUL_TERMINATED, &tree));
    OK(tree_tree_species(tree, &species));
    CHECK(species.name.len == 5 && !memcmp(species.name.data, "Eiche", 5));
    OK(tree_tree_free(tree));

    OK(with_name("oak tree", 3, &tree));
    OK(tree_tree_species(tree, &species));
    CHECK(species.name.len == 3 && !memcmp(species.name.data, "oak", 3));
    OK(tree_tree_free(tree));

    OK(with_name(NULL, 0, &tree));
    OK(tree_tree_free(tree));
    FAILS(TREE_ERROR_NULL, "species.name", with_name(NULL, 4, &tree));
    FAILS(TREE_ERROR_TEXT, "species.name is not UTF-8 from byte 3", with_name("oak\xff", 4, &tree));
    CHECK(tree == NULL);
    FAILS(TREE_ERROR_LIMIT, "", with_name("oak", SIZE_MAX - 1, &tree));

    tree_path_params params;
    OK(tree_path_preset("oak", TREE_NUL_TERMINATED, &params, sizeof params));
    FAILS(TREE_ERROR_UNKNOWN_NAME, "oak", tree_path_preset("oa", 2, &params, sizeof params));
    FAILS(TREE_ERROR_TEXT, "UTF-8",
          tree_path_preset("\xc3\x28", TREE_NUL_TERMINATED, &params, sizeof params));

    /* No file has a NUL byte in its name, or none at all. */
    tree_swc *swc = NULL;
    FAILS(TREE_ERROR_TEXT, "NUL", tree_swc_read("a\0b", 3, NULL, NULL, &swc));
    FAILS(TREE_ERROR_TEXT, "empty", tree_swc_read("", 0, NULL, NULL, &swc));
    FAILS(TREE_ERROR_IO, "no/such", tree_swc_read("no/such/file.swc", TREE_NUL_TERMINATED, NULL,
                                                       NULL, &swc));
}

static void handles(void) {
    size_t before = tree_live_objects();
    tree_skeleton *fork = a_fork();
    CHECK(tree_live_objects() == before + 1);
    tree_cancel *cancel = NULL;
    OK(tree_cancel_new(&cancel));

    /* Another kind, an address within one, and one that is nothing. */
    FAILS(TREE_ERROR_HANDLE, "it is a tree_cancel",
          tree_skeleton_free((tree_skeleton *)(void *)cancel));
    FAILS(TREE_ERROR_HANDLE, "it is a tree_skeleton", tree_cancel_set((tree_cancel *)(void *)fork));
    float box[6];
    FAILS(TREE_ERROR_HANDLE, "tree_skeleton",
          tree_skeleton_bounds((tree_skeleton *)(void *)((char *)fork + 8), &box));
    FAILS(TREE_ERROR_HANDLE, "tree_skeleton", tree_skeleton_bounds((void *)box, &box));

    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.pool = (const tree_pool *)(const void *)cancel;
    tree_mesh *mesh = NULL;
    tree_tree *twig = an_oak_twig();
    tree_look *look = NULL;
    OK(tree_look_plain(NULL, &look));
    FAILS(TREE_ERROR_HANDLE, "control.pool", tree_mesh_build(twig, look, NULL, &control, NULL, &mesh));
    CHECK(mesh == NULL);
    OK(tree_look_free(look));
    OK(tree_tree_free(twig));

    OK(tree_skeleton_free(fork));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_skeleton_free(fork));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_skeleton_bounds(fork, &box));
    OK(tree_cancel_free(cancel));
    FAILS(TREE_ERROR_HANDLE, "freed", tree_cancel_set(cancel));
    CHECK(tree_live_objects() == before);
}

/* A skeleton of a tree lives on without the tree's handle. */
static void parts_outlive_the_whole(void) {
    tree_tree *twig = an_oak_twig();
    tree_skeleton *skeleton = NULL;
    OK(tree_tree_skeleton(twig, &skeleton));
    OK(tree_tree_free(twig));
    tree_skeleton_columns view = {.struct_size = sizeof view};
    OK(tree_skeleton_view(skeleton, &view));
    CHECK(view.n_nodes == 4 && view.positions[4] == 1.0f);
    OK(tree_skeleton_free(skeleton));
}

void test_border(void) {
    statuses_have_names();
    every_thread_has_its_error();
    versions();
    structs_grow();
    texts();
    handles();
    parts_outlive_the_whole();
    tree_error_clear();
}
