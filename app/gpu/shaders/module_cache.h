// Specialised modules kept on disk between runs, so that a stage is compiled once per text and constants.
#pragma once

#include "gpu/device.h"
#include "gpu/shaders/module.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gg::gpu::shaders {

// The same for the keys, as keep_modules().
void keep_keys();

// Of a stage's text with every file that it may include: as it was when it was first asked for, or remembered since; and as it is
// now. Throws Error(input) if a file cannot be read.
std::string text_hash(const std::filesystem::path& file);
std::string text_hash_on_disk(const std::filesystem::path& file);
void remember_text_hashes(const std::map<std::filesystem::path, std::string>& hashes);

// What a specialised module depends on: the stage's text with every file that it may include, the constants, the API, and the
// versions of the compilers. Nothing if a file cannot be read, or if there is no cache directory.
std::optional<std::string> module_key(std::string_view stage_file,
                                      std::span<const Constant> constants, Backend backend);

// Nothing if it is not there; what is damaged or of another version counts as not there.
std::optional<Module> load_module(const std::string& key, std::string_view stage_file);
// Where that is not possible the next run compiles again, nothing more.
void store_module(const std::string& key, const Module& module) noexcept;

} // namespace gg::gpu::shaders
