// Alpha-blended surfaces among glass.
#include "render/harness.h"
#include "render/shapes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace gg::test::blended_test {
namespace {

constexpr int size = 64;

// A card to the upper left, behind a ball or inside it.
scene::Scene card_and_ball(scene::AlphaMode mode, float alpha, float z) {
  scene::Material card = unlit({0.1f, 0.75f, 0.2f});
  card.alpha_mode = mode;
  card.base_color.a = alpha;
  card.double_sided = true;
  scene::Scene scene = ball(glass(0.0f));
  add(scene, square(card),
      glm::scale(glm::translate(glm::mat4(1.0f), {-0.25f, 0.3f, z}), glm::vec3(0.25f)));
  add(scene, square(unlit(glm::vec3(0.8f))),
      glm::scale(glm::translate(glm::mat4(1.0f), {0.0f, 0.0f, -6.0f}), glm::vec3(8.0f)));
  return scene;
}

// What is nearly opaque is seen through the ball where an opaque thing is: at the other end, upside down.
TEST_P(Render, blended_things_are_seen_through_glass_where_they_are) {
  for (const float z : {-1.6f, 0.0f}) {
    const frame::FrameDesc desc{.width = size,
                                .height = size,
                                .samples = 1,
                                .camera = camera_at({0, 0, 3.6f}),
                                .method = frame::Method::lobes2};
    const auto picture = [&](scene::AlphaMode mode, float alpha) {
      return draw(card_and_ball(mode, alpha, z), {.environment = {}, .desc = desc});
    };
    const image::Image wanted = picture(scene::AlphaMode::opaque, 1.0f),
                       none = picture(scene::AlphaMode::blend, 0.0f),
                       got = picture(scene::AlphaMode::blend, 0.98f);
    double error = 0.0, signal = 0.0;
    for (std::size_t i = 0; i < wanted.values.size(); ++i) {
      error += std::pow(static_cast<double>(got.values[i] - wanted.values[i]), 2);
      signal += std::pow(static_cast<double>(none.values[i] - wanted.values[i]), 2);
    }
    EXPECT_GT(signal, 1.0) << z; // the card is in the picture
    EXPECT_LT(error, 0.02 * signal) << z;
  }
}

} // namespace
} // namespace gg::test::blended_test
