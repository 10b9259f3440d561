#include "check.h"

void test_volume(void) {}
