// One mesh with one material.
GG_BLOCK(1) GgDraw {
  mat4 ggWorldFromMesh;
  vec4 ggColor;      // base colour, 1: unlit
  vec4 ggSurface;    // roughness, metallic, back roughness (below 0: as the front), curvature of a body in 1/m (below 0: from the normals)
  vec4 ggGlass;      // transmission, ior, thickness in the mesh's units, its number among the bodies of glass, from 1
  vec4 ggAbsorption; // 1/m
};
