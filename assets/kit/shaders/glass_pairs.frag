#define GG_TWO_PAIRS
#include "glass.frag"
