#include "check.h"

void test_threads(void) {}
