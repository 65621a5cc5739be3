#define GG_BEFORE ggBackFaces
#define GG_BEFORE_AT 11
#include "back_faces.frag"
