// What a person is told where Vulkan cannot be used, and that the validation layer listens.
#include "core/error.h"
#include "gpu/fixture.h"
#include "gpu/vulkan/adapter.h"
#include "gpu/vulkan/commands.h"
#include "gpu/vulkan/context.h"
#include "gpu/vulkan/result.h"

#include <cstdlib>
#include <optional>

namespace gg::gpu::vulkan {
namespace {

// An environment variable with another value, for as long as it lives.
class Environment {
public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value, 1);
  }
  ~Environment() {
    if (before_)
      ::setenv(name_, before_->c_str(), 1);
    else
      ::unsetenv(name_);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

template <typename Function>
std::string error_of_calling(Function function) {
  try {
    function();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::device);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

void expect_says(const std::string& message, std::initializer_list<const char*> parts) {
  for (const char* part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << message << "\" lacks " << part;
}

TEST(vulkan_errors, without_a_loader_says_what_to_install) {
  expect_says(error_of_calling([] { Instance instance(false, "libvulkan-that-is-not.so.1"); }),
              {"libvulkan-that-is-not.so.1", "libvulkan1", "--backend opengl"});
}

TEST(vulkan_errors, without_a_driver_says_what_to_install) {
  const Environment old_name("VK_ICD_FILENAMES", "/nonexistent/icd.json");
  const Environment new_name("VK_DRIVER_FILES", "/nonexistent/icd.json");
  expect_says(error_of_calling([] { Context context({.backend = Backend::vulkan}); }),
              {"driver", "mesa-vulkan-drivers", "VK_ICD_FILENAMES"});
  EXPECT_TRUE(list_devices().empty() || list_devices().front().backend != "vulkan");
}

Adapter adapter(const char* name, std::uint32_t version, bool features) {
  Adapter made;
  made.info.name = name;
  made.abilities.properties.apiVersion = version;
  made.abilities.queues = {
      {.queueFlags = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT, .queueCount = 1}};
  made.abilities.features12.timelineSemaphore = features;
  made.abilities.features13.dynamicRendering = features;
  made.abilities.features13.synchronization2 = features;
  made.missing = missing(made.abilities);
  return made;
}

TEST(vulkan_errors, an_unsuitable_device_is_named_with_what_it_lacks) {
  const auto old = adapter("Old GPU", VK_API_VERSION_1_1, false);
  expect_says(error_of_calling([&] { choose({old}, -1); }),
              {"Old GPU", "Vulkan 1.3", "it has 1.1", "dynamic rendering", "--backend opengl"});
  EXPECT_TRUE(adapter("New GPU", VK_API_VERSION_1_3, true).missing.empty());
  expect_says(error_of_calling([] { choose({}, -1); }), {"no device", "mesa-vulkan-drivers"});
}

TEST(vulkan_errors, a_device_that_is_not_there_is_answered_with_those_that_are) {
  const auto usable = adapter("New GPU", VK_API_VERSION_1_3, true);
  expect_says(error_of_calling([&] { choose({usable}, 7); }), {"New GPU"});
  EXPECT_EQ(choose({usable}, 0).info.name, "New GPU");
  EXPECT_EQ(choose({usable}, -1).info.name, "New GPU");
}

TEST(vulkan_errors, a_queue_that_only_copies_or_computes_will_not_do) {
  const VkQueueFamilyProperties copies{.queueFlags = VK_QUEUE_TRANSFER_BIT, .queueCount = 1};
  const VkQueueFamilyProperties computes{.queueFlags = VK_QUEUE_COMPUTE_BIT, .queueCount = 1};
  const VkQueueFamilyProperties both{.queueFlags = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT,
                                     .queueCount = 4};
  EXPECT_FALSE(queue_family({copies, computes}));
  EXPECT_EQ(queue_family({copies, computes, both}), 2u);
}

TEST(vulkan_errors, a_lost_device_and_full_memory_say_what_to_do) {
  expect_says(error_of(VK_ERROR_DEVICE_LOST, "submitting").what(),
              {"lost", "while submitting", "driver", "--device"});
  expect_says(error_of(VK_ERROR_OUT_OF_DEVICE_MEMORY, "creating the texture 'colour'").what(),
              {"out of memory", "'colour'", "--size"});
}

// The tests below need a device, like all tests of this folder that run on Vulkan.
class VulkanDebug : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(context.instance().is_validated())
        << "the validation layer is not installed (vulkan-validationlayers)";
  }
  Context context{{.backend = Backend::vulkan, .debug = true}};
};

TEST_F(VulkanDebug, memory_that_there_is_not_is_refused_by_name) {
  const std::uint64_t terabyte = std::uint64_t{1} << 40;
  const auto message = error_of_calling([&] {
    const auto device = create_device({.backend = Backend::vulkan, .debug = true});
    device->create(BufferDesc{.label = "huge", .bytes = terabyte, .use = Use::vertices});
  });
  expect_says(message, {"out of memory", "huge", std::to_string(terabyte).c_str()});
}

TEST_F(VulkanDebug, misuse_of_the_api_becomes_an_error) {
  const VkBufferCreateInfo empty{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                 .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
  VkBuffer buffer = VK_NULL_HANDLE;
  context.vk().CreateBuffer(context.device(), &empty, nullptr, &buffer);
  if (buffer) context.vk().DestroyBuffer(context.device(), buffer, nullptr);
  expect_says(error_of_calling([&] { context.instance().check_messages(); }),
              {"VUID-VkBufferCreateInfo-size"});
  context.instance().check_messages(); // told once
}

TEST_F(VulkanDebug, a_missing_barrier_becomes_an_error) {
  Commands commands(context);
  HostBuffer buffer(context, 64, MemoryKind::upload, "target");
  const VkCommandBuffer open = commands.open();
  context.vk().CmdFillBuffer(open, buffer.handle, 0, 64, 0);
  context.vk().CmdFillBuffer(open, buffer.handle, 0, 64, 1);
  commands.finish();
  expect_says(error_of_calling([&] { context.instance().check_messages(); }), {"SYNC-HAZARD"});
}

} // namespace
} // namespace gg::gpu::vulkan
