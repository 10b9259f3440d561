#include "check.h"

void test_instance(void) {}
