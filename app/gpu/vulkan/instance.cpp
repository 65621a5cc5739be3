#include "gpu/vulkan/instance.h"

#include "core/error.h"
#include "gpu/vulkan/result.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace gg::gpu::vulkan {

namespace {

constexpr auto validation_layer = "VK_LAYER_KHRONOS_validation";

bool has_layer(const Library& library, const char* name) {
  std::uint32_t count = 0;
  library.EnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  library.EnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(),
                     [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

bool has_extension(const Library& library, const char* layer, const char* name) {
  std::uint32_t count = 0;
  library.EnumerateInstanceExtensionProperties(layer, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  library.EnumerateInstanceExtensionProperties(layer, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

// The loader unloads drivers and layers with the last instance that uses them, while they still own memory and threads: a leak
// checker then finds memory from code that is gone, and opening the next device loads everything again. So, as EGL's
// displays do (surface/egl.cpp), one instance with these layers and one without stay open until the process ends.
void stay_loaded(const Library& library, VkInstanceCreateInfo info) {
  static std::mutex mutex;
  static std::array<VkInstance, 2> kept{};
  const std::lock_guard lock(mutex);
  VkInstance& instance = kept[info.enabledLayerCount ? 1 : 0];
  info.pNext = nullptr; // a messenger hears of the instance that it was made for
  if (!instance) check(library.CreateInstance(&info, nullptr, &instance), "starting Vulkan");
}

} // namespace

Instance::Instance(bool debug, const std::string& loader, std::span<const char* const> windows)
    : library_(loader) {
  std::uint32_t version = VK_API_VERSION_1_0;
  if (library_.EnumerateInstanceVersion) library_.EnumerateInstanceVersion(&version);
  if (version < VK_API_VERSION_1_1) // which a loader needs to accept applications of later versions
    throw Error(ExitCode::device, "vulkan", "the Vulkan loader is of version 1.0, too old",
                "Update it (Debian, Ubuntu: libvulkan1), or choose --backend opengl");

  std::vector<const char*> layers, extensions(windows.begin(), windows.end());
  labels_ = has_extension(library_, nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  validated_ = debug && has_layer(library_, validation_layer);
  if (debug && !validated_)
    note("the Vulkan validation layer is not installed (Debian, Ubuntu: vulkan-validationlayers); "
         "going on without it");
  if (validated_) layers.push_back(validation_layer);
  if (labels_ || validated_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  labels_ = labels_ || validated_; // the layer brings the extension along

  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .pApplicationName = "groundglass",
                                      .pEngineName = "groundglass",
                                      .apiVersion = VK_API_VERSION_1_3};
  // Here too and not only on the messenger: for what is found while the instance is made.
  VkDebugUtilsMessengerCreateInfoEXT messenger{
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT
                         | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
      .pfnUserCallback = hear,
      .pUserData = this};
  const std::array enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkValidationFeaturesEXT validation{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .pNext = &messenger,
                                           .enabledValidationFeatureCount = enabled.size(),
                                           .pEnabledValidationFeatures = enabled.data()};
  if (validated_
      && has_extension(library_, validation_layer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME))
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);

  const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                  .pNext = validated_ ? &validation : nullptr,
                                  .pApplicationInfo = &application,
                                  .enabledLayerCount = static_cast<std::uint32_t>(layers.size()),
                                  .ppEnabledLayerNames = layers.data(),
                                  .enabledExtensionCount =
                                      static_cast<std::uint32_t>(extensions.size()),
                                  .ppEnabledExtensionNames = extensions.data()};
  stay_loaded(library_, info);
  check(library_.CreateInstance(&info, nullptr, &handle_), "starting Vulkan");
  try {
    functions_ = library_.functions(handle_);
    if (validated_)
      check(functions_.CreateDebugUtilsMessengerEXT(handle_, &messenger, nullptr, &messenger_),
            "listening to the validation layer");
  } catch (...) {
    if (functions_.DestroyInstance) functions_.DestroyInstance(handle_, nullptr);
    throw;
  }
}

Instance::~Instance() {
  // What is said from here on (objects that outlived their device) can only be printed.
  if (messenger_) functions_.DestroyDebugUtilsMessengerEXT(handle_, messenger_, nullptr);
  functions_.DestroyInstance(handle_, nullptr);
  while (const auto message = take_message())
    note("vulkan validation: " + *message);
}

VkBool32 Instance::hear(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                        const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  Instance& self = *static_cast<Instance*>(user);
  const std::lock_guard lock(self.mutex_);
  self.messages_.emplace_back(data->pMessage);
  return VK_FALSE;
}

std::optional<std::string> Instance::take_message() {
  const std::lock_guard lock(mutex_);
  if (messages_.empty()) return std::nullopt;
  std::string first = std::move(messages_.front());
  messages_.erase(messages_.begin());
  return first;
}

void Instance::check_messages() {
  if (!validated_) return;
  const auto first = take_message();
  if (!first) return;
  while (take_message()) // those that follow are mostly its consequences
    ;
  throw Error(ExitCode::device, "vulkan validation", *first,
              "This is a fault of groundglass, please report it");
}

} // namespace gg::gpu::vulkan
