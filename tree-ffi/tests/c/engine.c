#include "check.h"

void test_engine(void) {}
