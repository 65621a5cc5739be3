// From a pixel to a ray: the inverse of the raster's matrices (app/uniforms/camera.h).
#pragma once

#include "scene/scene.h"

namespace gg::truth {

// Unit direction; distances in metres along it. Only what lies between near and far is drawn.
struct Ray {
  glm::dvec3 origin{0.0}, direction{0.0, 0.0, -1.0};
  double near = 0.0, far = INFINITY;
};

class Camera {
public:
  // A picture of width x height pixels; the vertical field of view is kept.
  Camera(const scene::Camera& camera, int width, int height);

  // The ray through the point (x, y) of the picture: x to the right from 0 to width, y down from 0
  // to height; the centre of pixel (i, j) is (i + 1/2, j + 1/2).
  Ray through(double x, double y) const;

  bool orthographic() const { return orthographic_; }
  glm::dvec3 eye() const { return eye_; }

private:
  glm::dvec3 right_, up_, back_, eye_;
  glm::dvec2 half_extent_; // of the picture: at distance 1 (perspective), or in metres
  double width_, height_, near_, far_;
  bool orthographic_;
};

} // namespace gg::truth
