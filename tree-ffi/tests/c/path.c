#include "check.h"

void test_path(void) {}
