#include "render/harness.h"

namespace gg::test {

INSTANTIATE_TEST_SUITE_P(
    on, Render,
    ::testing::Values(Backend{"opengl", gpu::Backend::opengl, gpu::Surface::egl},
                      Backend{"osmesa", gpu::Backend::opengl, gpu::Surface::osmesa},
                      Backend{"vulkan", gpu::Backend::vulkan, gpu::Surface::automatic}),
    [](const ::testing::TestParamInfo<Backend>& backend) {
      return std::string(backend.param.name);
    });

} // namespace gg::test
