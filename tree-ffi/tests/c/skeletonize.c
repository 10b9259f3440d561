#include "check.h"

void test_skeletonize(void) {}
