#include "check.h"
#include <math.h>

static const char bush[] = "#define r 0.5\n"
                           "steps: 2\n"
                           "angle: 30\n"
                           "seed: 7\n"
                           "axiom: A(1)\n"
                           "A(l) : l > 0.1 -> F(l)[+A(l*r)]A(l*r)\n";

static tree_grammar *a_grammar(const char *text) {
    tree_grammar *grammar = NULL;
    OK(tree_grammar_from_text(text, TREE_NUL_TERMINATED, NULL, NULL, &grammar));
    return grammar;
}

static tree_word *a_word(const char *text) {
    tree_word *word = NULL;
    OK(tree_word_from_text(text, TREE_NUL_TERMINATED, NULL, NULL, &word));
    return word;
}

/* Whether the word is this text. */
static int reads(const tree_word *word, const char *text) {
    tree_bytes *bytes;
    const uint8_t *data;
    size_t len;
    OK(tree_word_to_text(word, &bytes));
    OK(tree_bytes_view(bytes, &data, &len));
    int same = len == strlen(text) && memcmp(data, text, len) == 0;
    if (!same) printf("%.*s\n", (int)len, (const char *)data);
    OK(tree_bytes_free(bytes));
    return same;
}

static int is(tree_str found, const char *text) {
    return found.len == strlen(text) && memcmp(found.data, text, found.len) == 0;
}

static tree_skeleton_columns nodes_of(const tree_tree *tree, tree_skeleton **skeleton) {
    tree_skeleton_columns columns = {.struct_size = sizeof columns};
    OK(tree_tree_skeleton(tree, skeleton));
    OK(tree_skeleton_view(*skeleton, &columns));
    return columns;
}

static void grammars(void) {
    tree_grammar *grammar = a_grammar(bush), *other;
    tree_grammar_info info = {.struct_size = sizeof info};
    OK(tree_grammar_view(grammar, &info));
    CHECK(is(info.text, bush) && info.angle == 30 && info.steps == 2 && info.seed == 7);
    CHECK(info.n_productions == 1 && info.n_constants == 3 && info.reserved == 0);

    tree_str name;
    double value;
    OK(tree_grammar_constant(grammar, 1, &name, &value));
    CHECK(is(name, "r") && value == 0.5);
    FAILS(TREE_ERROR_PARAMETER, "3 constants", tree_grammar_constant(grammar, 3, &name, &value));

    uint16_t kind;
    size_t n_params;
    OK(tree_grammar_find_kind(grammar, "F", 1, 1, &kind));
    CHECK(kind < info.n_kinds);
    OK(tree_grammar_kind(grammar, kind, &name, &n_params));
    CHECK(is(name, "F") && n_params == 1);
    OK(tree_grammar_kind(grammar, TREE_KIND_PUSH, &name, &n_params));
    CHECK(is(name, "[") && n_params == 0);
    OK(tree_grammar_kind(grammar, TREE_KIND_POP, &name, &n_params));
    CHECK(is(name, "]") && n_params == 0);
    FAILS(TREE_ERROR_UNKNOWN_NAME, "'F' with 2", tree_grammar_find_kind(grammar, "F", 1, 2, &kind));
    FAILS(TREE_ERROR_PARAMETER, "kinds", tree_grammar_kind(grammar, 999, &name, &n_params));

    /* Another constant, in a copy. */
    OK(tree_grammar_with_constant(grammar, "r", 1, 0.25, NULL, &other));
    OK(tree_grammar_constant(other, 1, &name, &value));
    CHECK(value == 0.25);
    OK(tree_grammar_constant(grammar, 1, &name, &value));
    CHECK(value == 0.5);
    tree_grammar_report report = {.struct_size = sizeof report};
    tree_grammar *none;
    FAILS(TREE_ERROR_INVALID, "no constant 'q'",
          tree_grammar_with_constant(grammar, "q", 1, 1, &report, &none));
    CHECK(none == NULL && report.place == TREE_GRAMMAR_PLACE_TEXT && report.line == 1);
    FAILS(TREE_ERROR_PARAMETER, "r", tree_grammar_with_constant(grammar, "r", 1, NAN, &report, &none));
    CHECK(report.place == TREE_GRAMMAR_PLACE_NONE && report.line == 0);

    /* A file says the same. */
    const char *path = "lsystem_c_test.l";
    FILE *file = fopen(path, "wb");
    CHECK(file && fwrite(bush, 1, sizeof bush - 1, file) == sizeof bush - 1 && fclose(file) == 0);
    tree_grammar *read;
    OK(tree_grammar_read(path, TREE_NUL_TERMINATED, NULL, &report, &read));
    OK(tree_grammar_view(read, &info));
    CHECK(is(info.text, bush));
    remove(path);
    FAILS(TREE_ERROR_IO, path, tree_grammar_read(path, strlen(path), NULL, &report, &none));
    CHECK(none == NULL);

    /* A mistake has a place. */
    FAILS(TREE_ERROR_INVALID, "line 2, column ",
          tree_grammar_from_text("axiom: A\nA -> B)", TREE_NUL_TERMINATED, NULL, &report, &none));
    CHECK(none == NULL && report.place == TREE_GRAMMAR_PLACE_TEXT);
    CHECK(report.line == 2 && report.column > 1 && report.column < 9 && report.module == 0);
    FAILS(TREE_ERROR_INVALID, "axiom", tree_grammar_from_text("A -> B", 6, NULL, NULL, &none));
    FAILS(TREE_ERROR_TEXT, "UTF-8", tree_grammar_from_text("\xff", 1, NULL, &report, &none));
    CHECK(report.place == TREE_GRAMMAR_PLACE_NONE);
    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    limits.input_bytes = 10;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "input_bytes",
          tree_grammar_from_text(bush, sizeof bush - 1, &control, NULL, &none));
    OK(tree_grammar_free(read));
    OK(tree_grammar_free(other));
    OK(tree_grammar_free(grammar));
    OK(tree_grammar_free(NULL));
}

static void words(void) {
    tree_grammar *grammar = a_grammar(bush);
    tree_word *axiom, *word, *again, *none;
    OK(tree_grammar_axiom(grammar, &axiom));
    CHECK(reads(axiom, "A(1)"));

    OK(tree_grammar_word(grammar, "F(2)[+A(0.5)]", TREE_NUL_TERMINATED, NULL, NULL, &word));
    tree_word_columns columns = {.struct_size = sizeof columns};
    OK(tree_word_view(word, &columns));
    CHECK(columns.n_modules == 5 && columns.n_params == 2 && columns.kinds[1] == TREE_KIND_PUSH);
    CHECK(columns.kinds[4] == TREE_KIND_POP && columns.params[0] == 2 && columns.params[1] == 0.5);
    tree_str name;
    size_t n_params;
    OK(tree_word_kind(word, columns.kinds[0], &name, &n_params));
    CHECK(is(name, "F") && n_params == 1);
    uint16_t kind;
    OK(tree_word_find_kind(word, "A", 1, 1, &kind));
    CHECK(kind == columns.kinds[3]);
    FAILS(TREE_ERROR_UNKNOWN_NAME, "'Q'", tree_word_find_kind(word, "Q", 1, 0, &kind));
    FAILS(TREE_ERROR_PARAMETER, "kind", tree_word_kind(word, 999, &name, &n_params));
    OK(tree_word_check(word));

    /* The columns make the word again. */
    tree_grammar_report report = {.struct_size = sizeof report};
    OK(tree_grammar_word_from_columns(grammar, &columns, NULL, &report, &again));
    CHECK(reads(again, "F(2)[+A(0.5)]"));
    tree_word_columns wrong = columns;
    wrong.n_params = 1;
    FAILS(TREE_ERROR_INVALID, "takes 1 parameters, not 0",
          tree_grammar_word_from_columns(grammar, &wrong, NULL, &report, &none));
    CHECK(none == NULL && report.place == TREE_GRAMMAR_PLACE_MODULE && report.module == 3);
    wrong.n_params = 2;
    wrong.n_modules = 3;
    FAILS(TREE_ERROR_INVALID, "left over",
          tree_grammar_word_from_columns(grammar, &wrong, NULL, &report, &none));
    static const uint16_t unknown[] = {999};
    wrong = (tree_word_columns){.struct_size = sizeof wrong, .n_modules = 1, .kinds = unknown};
    FAILS(TREE_ERROR_INVALID, "999",
          tree_grammar_word_from_columns(grammar, &wrong, NULL, &report, &none));

    FAILS(TREE_ERROR_INVALID, "'F' with 0", tree_grammar_word(grammar, "FQ", 2, NULL, &report, &none));
    FAILS(TREE_ERROR_INVALID, "module",
          tree_grammar_word(grammar, "F(1)Q", 5, NULL, &report, &none));
    CHECK(report.place == TREE_GRAMMAR_PLACE_MODULE && report.module == 1 && report.line == 0);
    FAILS(TREE_ERROR_INVALID, "never closed", tree_word_from_text("FF(1", 4, NULL, &report, &none));
    CHECK(none == NULL && report.module == 1);

    tree_word *open = a_word("F[+F");
    FAILS(TREE_ERROR_INVALID, "module 1", tree_word_check(open));
    tree_word_history past = {.struct_size = sizeof past};
    OK(tree_word_past(open, &past));
    CHECK(past.n_growth == 0 && past.growth == NULL && past.nodes == NULL && past.leaves == NULL);
    tree_word *empty = a_word("");
    OK(tree_word_view(empty, &columns));
    CHECK(columns.n_modules == 0 && columns.kinds == NULL && columns.params == NULL);
    CHECK(columns.n_kinds == 2);
    OK(tree_word_free(empty));
    OK(tree_word_free(open));
    OK(tree_word_free(again));
    OK(tree_word_free(word));
    OK(tree_word_free(axiom));
    OK(tree_grammar_free(grammar));
}

static void derivation(void) {
    static const char second[] = "F(1)[+F(0.5)[+A(0.25)]A(0.25)]F(0.5)[+A(0.25)]A(0.25)";
    tree_grammar *grammar = a_grammar(bush);
    tree_word *word, *steps[3], *none;
    OK(tree_grammar_derive(grammar, TREE_STEPS_OF_TEXT, 1, NULL, &word));
    CHECK(reads(word, second));
    tree_word_history past = {.struct_size = sizeof past};
    OK(tree_word_past(word, &past));
    CHECK(past.n_growth == 3 && past.growth[0] == 1 && past.growth[1] == 6 && past.growth[2] == 16);
    CHECK(past.n_nodes == 0 && past.n_leaves == 0);
    OK(tree_word_free(word));

    OK(tree_grammar_axiom(grammar, &steps[0]));
    for (uint32_t i = 0; i < 2; i++) {
        OK(tree_grammar_step(grammar, steps[i], i, 2, 1, NULL, &steps[i + 1]));
    }
    CHECK(reads(steps[2], second));
    OK(tree_grammar_derive(grammar, 0, 1, NULL, &word));
    CHECK(reads(word, "A(1)"));
    OK(tree_word_free(word));
    FAILS(TREE_ERROR_PARAMETER, "TREE_STEPS_OF_TEXT",
          tree_grammar_derive(grammar, 1000001, 1, NULL, &none));
    CHECK(none == NULL);

    /* A word of another alphabet means something else. */
    tree_word *foreign = a_word("AF(1)");
    FAILS(TREE_ERROR_INVALID, "alphabet", tree_grammar_step(grammar, foreign, 0, 1, 1, NULL, &none));
    FAILS(TREE_ERROR_INVALID, "alphabet",
          tree_grammar_interpretation(grammar, foreign, 1, NULL, &none));
    OK(tree_word_free(foreign));
    /* A grammar with another constant has the same alphabet. */
    tree_grammar *other;
    OK(tree_grammar_with_constant(grammar, "r", TREE_NUL_TERMINATED, 0.25, NULL, &other));
    OK(tree_grammar_step(other, steps[0], 0, 1, 1, NULL, &word));
    CHECK(reads(word, "F(1)[+A(0.25)]A(0.25)"));
    OK(tree_word_free(word));
    OK(tree_grammar_interpretation(other, steps[0], 1, NULL, &word));
    CHECK(reads(word, "A(1)"));
    OK(tree_word_free(word));
    OK(tree_grammar_free(other));
    for (int i = 0; i < 3; i++) OK(tree_word_free(steps[i]));

    tree_limits limits;
    OK(tree_limits_init(&limits, sizeof limits));
    CHECK(limits.modules == 100000000);
    limits.modules = 10;
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.limits = &limits;
    FAILS(TREE_ERROR_LIMIT, "modules", tree_grammar_derive(grammar, 2, 1, &control, &none));
    tree_cancel *cancel;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    control.limits = NULL;
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_grammar_derive(grammar, 2, 1, &control, &none));
    OK(tree_cancel_free(cancel));
    OK(tree_grammar_free(grammar));

    grammar = a_grammar("axiom: A(1)\nA(x) -> A(1/(x-1))");
    FAILS(TREE_ERROR_INVALID, "module 0", tree_grammar_derive(grammar, 1, 1, NULL, &none));
    OK(tree_grammar_free(grammar));

    /* What the turtle is to see. */
    grammar = a_grammar("axiom: AB\nA -> AA\ninterpretation\nA -> F[+F]");
    OK(tree_grammar_derive(grammar, 1, 1, NULL, &word));
    CHECK(reads(word, "AAB"));
    tree_word *seen;
    OK(tree_grammar_interpretation(grammar, word, 1, NULL, &seen));
    CHECK(reads(seen, "F[+F]F[+F]B"));
    /* Words outlive their grammar. */
    OK(tree_grammar_free(grammar));
    CHECK(reads(word, "AAB"));
    OK(tree_word_free(seen));
    OK(tree_word_free(word));
}

static void turtles(void) {
    tree_turtle_params turtle;
    OK(tree_turtle_params_init(&turtle, sizeof turtle));
    CHECK(turtle.step == 1 && turtle.width == 0.1 && turtle.angle == 22.5 && turtle.unit == 1);
    CHECK(fabs(turtle.width_ratio - sqrt(0.5)) < 1e-15 && turtle.leaf_size == 1);
    CHECK(turtle.tropism[1] == -1 && turtle.height == 0 && turtle.trunk_radius == 0);
    CHECK(turtle.taper == TREE_TAPER_SMOOTH && turtle.thickness == TREE_THICKNESS_AUTO);
    CHECK(turtle.polygon_leaves == 1 && !turtle.radii && !turtle.species && turtle.elasticity == 0);
    OK(tree_turtle_params_check(NULL));
    OK(tree_turtle_params_check(&turtle));
    turtle.thickness = TREE_THICKNESS_RULE;
    OK(tree_turtle_params_check(&turtle));
    turtle.taper = 9;
    FAILS(TREE_ERROR_ENUM, "taper", tree_turtle_params_check(&turtle));
    turtle.taper = TREE_TAPER_ENDS;
    turtle.thickness = 9;
    FAILS(TREE_ERROR_ENUM, "thickness", tree_turtle_params_check(&turtle));
    turtle.thickness = TREE_THICKNESS_WORD;
    turtle.width_ratio = 2;
    FAILS(TREE_ERROR_PARAMETER, "width_ratio", tree_turtle_params_check(&turtle));

    tree_grammar *grammar = a_grammar("angle: 30\nheight = 3\ntropism_y = 1\naxiom: F\n");
    OK(tree_grammar_turtle(grammar, &turtle, sizeof turtle));
    CHECK(turtle.angle == 30 && turtle.height == 3 && turtle.tropism[1] == 1 && turtle.step == 1);
    OK(tree_grammar_free(grammar));
    grammar = a_grammar("elasticity = 1e9\naxiom: F\n");
    FAILS(TREE_ERROR_PARAMETER, "elasticity", tree_grammar_turtle(grammar, &turtle, sizeof turtle));
    OK(tree_grammar_free(grammar));

    OK(tree_chain_turtle(&turtle, sizeof turtle));
    CHECK(turtle.taper == TREE_TAPER_ENDS && turtle.thickness == TREE_THICKNESS_WORD);
    CHECK(turtle.width == 0);
}

static void drawing(void) {
    /* A fork with a leaf-like polygon, a gap and a symbol that says nothing. */
    tree_word *word = a_word("F(1)[+(90)F(0.5)]F(1)Qf(1)F(1)[{+(60)f(1)-(120)f(1)}]");
    tree_turtle_report report = {.struct_size = sizeof report};
    tree_turtle_trace *trace;
    tree_tree *tree, *none;
    OK(tree_word_interpret(word, NULL, NULL, &report, &trace, &tree));
    tree_skeleton *skeleton;
    tree_skeleton_columns columns = nodes_of(tree, &skeleton);
    CHECK(columns.n_nodes == 6 && columns.parents[2] == 1 && columns.parents[3] == 1);
    CHECK(fabsf(columns.positions[6] + 0.5f) < 1e-6f && columns.positions[4] == 1);
    CHECK(report.depth == 1 && report.gaps == 1 && report.n_skipped == 1 && report.widths == 0);
    CHECK(report.scale == 1 && report.n_steps == 0 && report.n_produced == 0 && report.cut == 0);
    CHECK(report.merged == 0 && report.n_modules > 10 && report.reserved == 0);
    OK(tree_skeleton_free(skeleton));

    tree_turtle_polygons polygons = {.struct_size = sizeof polygons};
    OK(tree_turtle_trace_view(trace, &polygons));
    CHECK(polygons.n_polygons + report.thin_polygons == 1);
    CHECK(polygons.starts[0] == 0 && polygons.starts[polygons.n_polygons] == polygons.n_vertices);
    tree_str name;
    size_t n_times;
    OK(tree_turtle_trace_skipped(trace, 0, &name, &n_times));
    CHECK(is(name, "Q") && n_times == 1);
    FAILS(TREE_ERROR_PARAMETER, "1 symbols", tree_turtle_trace_skipped(trace, 1, &name, &n_times));
    tree_lines *warnings;
    const tree_str *texts;
    size_t n_texts;
    OK(tree_turtle_trace_warnings(trace, &warnings));
    OK(tree_lines_view(warnings, &texts, &n_texts));
    CHECK(n_texts == 1 + report.thin_polygons && texts[0].len > 10);
    OK(tree_lines_free(warnings));
    OK(tree_turtle_trace_free(trace));
    OK(tree_tree_free(tree));
    OK(tree_word_free(word));

    /* A polygon of three corners is a leaf. */
    word = a_word("F'(3){.[+(30)f(1).]-(30)f(1)}");
    OK(tree_word_interpret(word, NULL, NULL, &report, &trace, &tree));
    OK(tree_turtle_trace_view(trace, &polygons));
    CHECK(polygons.n_polygons == 1 && polygons.n_vertices >= 3 && polygons.starts[1] >= 3);
    CHECK(polygons.colors[0] == 3 && polygons.nodes[0] == 1 && polygons.vertices[1] == 1);
    CHECK(report.polygon_leaves == 1);
    tree_foliage foliage = {.struct_size = sizeof foliage};
    OK(tree_tree_foliage(tree, &foliage));
    CHECK(foliage.n_leaves == 1);
    OK(tree_turtle_trace_free(trace));
    OK(tree_tree_free(tree));
    OK(tree_word_free(word));

    word = a_word("F[+F");
    FAILS(TREE_ERROR_INVALID, "module 1", tree_word_interpret(word, NULL, NULL, NULL, NULL, &none));
    CHECK(none == NULL);
    OK(tree_word_free(word));
    word = a_word("F~(1,7)");
    FAILS(TREE_ERROR_INVALID, "module 1", tree_word_interpret(word, NULL, NULL, NULL, NULL, &none));
    FAILS(TREE_ERROR_NULL, "tree", tree_word_interpret(word, NULL, NULL, NULL, &trace, NULL));
    CHECK(trace == NULL);
    OK(tree_word_free(word));

    /* Lines. */
    word = a_word("F[+(90)F]f(1)G(2)");
    float lines[18] = {9};
    size_t n_lines = 9;
    FAILS(TREE_ERROR_BUFFER, "lines", tree_word_lines(word, NULL, NULL, lines, 17, &n_lines));
    CHECK(n_lines == 3 && lines[0] == 9);
    OK(tree_word_lines(word, NULL, NULL, lines, 18, &n_lines));
    CHECK(n_lines == 3 && lines[0] == 0 && lines[1] == 0 && lines[4] == 1);
    CHECK(lines[7] == 1 && fabsf(lines[9] + 1) < 1e-6f && lines[13] == 2 && lines[16] == 4);
    tree_turtle_params turtle;
    OK(tree_turtle_params_init(&turtle, sizeof turtle));
    turtle.unit = 10;
    OK(tree_word_lines(word, &turtle, NULL, lines, 18, &n_lines));
    CHECK(lines[16] == 40);
    OK(tree_word_free(word));
    word = a_word("+f");
    OK(tree_word_lines(word, NULL, NULL, NULL, 0, &n_lines));
    CHECK(n_lines == 0);
    OK(tree_word_free(word));
}

static void presets(void) {
    size_t n = tree_lsystem_preset_count(), published = 0, changed = 0;
    CHECK(n > 20);
    for (size_t i = 0; i < n; i++) {
        tree_lsystem_preset_info info = {.struct_size = sizeof info};
        tree_turtle_params turtle;
        tree_grammar *grammar;
        OK(tree_lsystem_preset_view(i, &info));
        CHECK(info.title.len > 3 && info.text.len > 20);
        published += info.source.len > 0;
        OK(tree_lsystem_preset(info.name.data, info.name.len, &turtle, sizeof turtle, &grammar));
        OK(tree_turtle_params_check(&turtle));
        CHECK(turtle.radii && turtle.species && turtle.species->name.len > 0);
        for (size_t j = 0; j < info.n_constants; j++, changed++) {
            tree_str name, other;
            double value, found = NAN;
            OK(tree_lsystem_preset_constant(i, j, &name, &value));
            tree_grammar_info said = {.struct_size = sizeof said};
            OK(tree_grammar_view(grammar, &said));
            for (size_t k = 0; k < said.n_constants; k++) {
                double here;
                OK(tree_grammar_constant(grammar, k, &other, &here));
                if (other.len == name.len && !memcmp(other.data, name.data, name.len)) found = here;
            }
            CHECK(found == value);
        }
        OK(tree_grammar_free(grammar));
    }
    CHECK(published > 15 && published < n && changed > 5);
    tree_lsystem_preset_info info = {.struct_size = sizeof info};
    tree_str name;
    double value;
    FAILS(TREE_ERROR_PARAMETER, "index", tree_lsystem_preset_view(n, &info));
    FAILS(TREE_ERROR_PARAMETER, "index", tree_lsystem_preset_constant(n, 0, &name, &value));
    FAILS(TREE_ERROR_PARAMETER, "changes 0", tree_lsystem_preset_constant(0, 0, &name, &value));
    tree_turtle_params turtle;
    tree_grammar *grammar;
    FAILS(TREE_ERROR_UNKNOWN_NAME, "birch",
          tree_lsystem_preset("elm", 3, &turtle, sizeof turtle, &grammar));
    FAILS(TREE_ERROR_STRUCT_SIZE, "sizeof", tree_lsystem_preset("oak", 3, &turtle, 3, &grammar));
    CHECK(grammar == NULL);
}

static void growing(void) {
    tree_turtle_params turtle;
    tree_grammar *grammar;
    OK(tree_lsystem_preset("birch", TREE_NUL_TERMINATED, &turtle, sizeof turtle, &grammar));
    tree_grammar *small;
    tree_grammar_info info = {.struct_size = sizeof info};
    OK(tree_grammar_view(grammar, &info));
    uint32_t few = info.steps > 6 ? 6 : info.steps;
    tree_turtle_report report = {.struct_size = sizeof report};
    tree_word *word;
    tree_turtle_trace *trace;
    tree_tree *tree, *again, *none;
    OK(tree_lsystem_grow(grammar, few, &turtle, 3, NULL, &report, &word, &trace, &tree));
    CHECK(report.n_steps == few && report.n_produced > few && report.n_modules > 0);
    tree_word_history past = {.struct_size = sizeof past};
    tree_word_columns columns = {.struct_size = sizeof columns};
    OK(tree_word_past(word, &past));
    OK(tree_word_view(word, &columns));
    CHECK(past.n_growth == few + 1 && columns.n_modules == past.growth[few]);
    tree_turtle_polygons polygons = {.struct_size = sizeof polygons};
    OK(tree_turtle_trace_view(trace, &polygons));
    CHECK(polygons.n_polygons == 0 && polygons.vertices == NULL && polygons.starts[0] == 0);
    tree_species species = {.struct_size = sizeof species};
    OK(tree_tree_species(tree, &species));
    CHECK(is(species.name, "birch"));

    /* The same by steps. */
    OK(tree_word_interpret(word, &turtle, NULL, NULL, NULL, &again));
    tree_skeleton *a, *b;
    tree_skeleton_columns one = nodes_of(tree, &a), two = nodes_of(again, &b);
    CHECK(one.n_nodes == two.n_nodes && one.n_nodes > 3);
    CHECK(!memcmp(one.positions, two.positions, 3 * one.n_nodes * sizeof(float)));
    CHECK(!memcmp(one.radii, two.radii, one.n_nodes * sizeof(float)));
    OK(tree_skeleton_free(a));
    OK(tree_skeleton_free(b));
    OK(tree_tree_free(again));
    OK(tree_tree_free(tree));
    OK(tree_word_free(word));
    OK(tree_turtle_trace_free(trace));
    FAILS(TREE_ERROR_PARAMETER, "steps",
          tree_lsystem_grow(grammar, 2000000, &turtle, 3, NULL, NULL, NULL, NULL, &none));
    CHECK(none == NULL);
    turtle.unit = NAN;
    FAILS(TREE_ERROR_PARAMETER, "unit",
          tree_lsystem_grow(grammar, 1, &turtle, 3, NULL, NULL, NULL, NULL, &none));
    OK(tree_grammar_free(grammar));

    /* A turtle of the caller's stands for the text's, right or wrong. */
    small = a_grammar("elasticity = 1e9\naxiom: F");
    FAILS(TREE_ERROR_PARAMETER, "elasticity",
          tree_lsystem_grow(small, 0, NULL, 1, NULL, NULL, NULL, NULL, &none));
    OK(tree_turtle_params_init(&turtle, sizeof turtle));
    OK(tree_lsystem_grow(small, 0, &turtle, 1, NULL, NULL, NULL, NULL, &tree));
    OK(tree_tree_free(tree));
    OK(tree_grammar_free(small));

    /* The text may say all there is to say. */
    small = a_grammar("steps: 4\nangle: 30\nheight = 3\naxiom: X\nX -> F[+X][-X]FX\nF -> FF");
    OK(tree_lsystem_grow(small, TREE_STEPS_OF_TEXT, NULL, 1, NULL, NULL, NULL, NULL, &tree));
    one = nodes_of(tree, &a);
    float top = 0;
    for (size_t i = 0; i < one.n_nodes; i++) top = fmaxf(top, one.positions[3 * i + 1]);
    CHECK(fabsf(top - 3) < 1e-4f);
    OK(tree_skeleton_free(a));
    OK(tree_tree_free(tree));
    OK(tree_grammar_free(small));
}

static void chains(void) {
    tree_chain_params params;
    OK(tree_chain_params_init(&params, sizeof params));
    CHECK(params.tolerance == 1e-5 && params.continuation == TREE_CONTINUATION_THICKEST);
    tree_turtle_params turtle;
    OK(tree_chain_turtle(&turtle, sizeof turtle));

    /* There and back. */
    tree_skeleton *fork = a_fork(), *drawn;
    tree_word *word, *none;
    OK(tree_skeleton_to_word(fork, NULL, &params, NULL, &word));
    OK(tree_word_check(word));
    tree_word_history past = {.struct_size = sizeof past};
    OK(tree_word_past(word, &past));
    CHECK(past.n_nodes == 4 && past.nodes[0] == 0 && past.n_leaves == 0 && past.n_growth == 0);
    tree_tree *tree;
    OK(tree_word_interpret(word, &turtle, NULL, NULL, NULL, &tree));
    tree_skeleton_columns back = nodes_of(tree, &drawn), there = {.struct_size = sizeof there};
    OK(tree_skeleton_view(fork, &there));
    CHECK(back.n_nodes == 4);
    for (size_t i = 0; i < 4; i++) {
        for (size_t k = 0; k < 3; k++) {
            float apart = back.positions[3 * i + k] - there.positions[3 * past.nodes[i] + k];
            CHECK(fabsf(apart) < 1e-4f);
        }
        CHECK(fabsf(back.radii[i] - there.radii[past.nodes[i]]) < 1e-4f);
    }
    OK(tree_skeleton_free(drawn));
    OK(tree_tree_free(tree));
    OK(tree_word_free(word));

    params.tolerance = 1;
    FAILS(TREE_ERROR_PARAMETER, "tolerance", tree_skeleton_to_word(fork, NULL, &params, NULL, &none));
    CHECK(none == NULL);
    params.tolerance = 0;
    params.continuation = 9;
    FAILS(TREE_ERROR_ENUM, "continuation", tree_skeleton_to_word(fork, NULL, &params, NULL, &none));
    static const uint32_t nowhere[] = {99};
    static const float positions[3], rotations[] = {0, 0, 0, 1}, sizes[] = {0.1f};
    static const uint16_t kinds[1];
    tree_foliage foliage = {sizeof foliage, 1, nowhere, positions, rotations, sizes, kinds};
    FAILS(TREE_ERROR_INVALID, "leaf", tree_skeleton_to_word(fork, &foliage, NULL, NULL, &none));
    OK(tree_skeleton_free(fork));

    /* A whole tree, leaves and all, through text. */
    tree_tree *twig = an_oak_twig();
    OK(tree_tree_to_word(twig, NULL, NULL, &word));
    OK(tree_word_past(word, &past));
    CHECK(past.n_nodes == 4 && past.n_leaves == 3);
    tree_bytes *bytes;
    const uint8_t *text;
    size_t len;
    OK(tree_word_to_text(word, &bytes));
    OK(tree_bytes_view(bytes, &text, &len));
    CHECK(len > 20 && len < 2000);
    tree_word *again;
    OK(tree_word_from_text((const char *)text, len, NULL, NULL, &again));
    OK(tree_word_interpret(again, &turtle, NULL, NULL, NULL, &tree));
    tree_foliage leaves = {.struct_size = sizeof leaves};
    OK(tree_tree_foliage(tree, &leaves));
    CHECK(leaves.n_leaves == 3);
    OK(tree_tree_free(tree));
    OK(tree_word_free(again));
    OK(tree_bytes_free(bytes));
    OK(tree_word_free(word));
    tree_cancel *cancel;
    OK(tree_cancel_new(&cancel));
    OK(tree_cancel_set(cancel));
    tree_control control;
    OK(tree_control_init(&control, sizeof control));
    control.cancel = cancel;
    FAILS(TREE_ERROR_CANCELLED, "cancel", tree_tree_to_word(twig, NULL, &control, &none));
    CHECK(none == NULL);
    OK(tree_cancel_free(cancel));
    OK(tree_tree_free(twig));
}

void test_lsystem(void) {
    size_t before = tree_live_objects();
    grammars();
    words();
    derivation();
    turtles();
    drawing();
    presets();
    growing();
    chains();
    CHECK(tree_live_objects() == before);
}
