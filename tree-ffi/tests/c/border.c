#include "check.h"

void test_border(void) {}
