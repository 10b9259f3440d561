#include "check.h"

void test_foliage(void) {}
