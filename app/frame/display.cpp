#include "frame/display.h"
#include "core/error.h"
