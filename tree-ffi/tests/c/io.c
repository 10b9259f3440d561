#include "check.h"

void test_io(void) {}
