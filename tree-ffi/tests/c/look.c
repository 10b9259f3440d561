#include "check.h"

void test_look(void) {}
