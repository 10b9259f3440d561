#include "check.h"

void test_mesh(void) {}
