// table_axis.glsl: texture coordinates of tables whose nodes are texel centres.
// Frame    none.
// alpha    none.
// Returns  tableCoordinate, blockCoordinate: in [0, 1], for x in [0, 1] (clamped) from the first node to the last.
// Source   none.
// Limits   linear filtering between texel centres.
#ifndef GG_ENVIRONMENT_TABLE_AXIS_GLSL
#define GG_ENVIRONMENT_TABLE_AXIS_GLSL

// Nodes at i / (size - 1) of block number `block` of `blocks` equal ones along one axis: half a texel in from the block's
// edges, so that no lookup mixes two blocks.
float blockCoordinate(float x, int size, int block, int blocks) {
  float texel = float(block * size) + clamp(x, 0.0, 1.0) * float(size - 1) + 0.5;
  return texel / float(size * blocks);
}

float tableCoordinate(float x, int size) { return blockCoordinate(x, size, 0, 1); }

#endif
