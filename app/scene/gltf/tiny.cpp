// The one translation unit that compiles tinygltf.
#include <fstream> // which its writer needs, and no longer includes without the file access

#define TINYGLTF_IMPLEMENTATION
#include "scene/gltf/tiny.h"
