#include "check.h"

void test_preview(void) {}
