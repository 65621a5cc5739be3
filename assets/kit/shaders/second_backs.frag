#define GG_BEFORE ggSecondFronts
#define GG_BEFORE_AT 12
#include "back_faces.frag"
