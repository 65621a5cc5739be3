// tinygltf with everything switched off that touches files or pixels: the bytes are ours to check
// (container.h, images.h), tinygltf reads the structure. The same switches must hold wherever the
// header is seen, so nothing includes it directly.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_USE_CPP14

#include <tiny_gltf.h>
