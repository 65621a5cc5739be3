// What writers get wrong without a doubt about what they mean, put right before the file is checked.
#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <string>

namespace gg::scene::gltf {

// What is wrong with a camera, by index: an error only where that camera is looked through.
using CameraFaults = std::map<int, std::string>;

// Changes `json`, with one note each: members that are null (as if they were not there), a version written as 2 or "2",
// attenuationDistance 0 (old exporters' word for none), byteStride 0 (packed). A material that nothing uses becomes a
// plain one if it is not valid, and so does a camera: what is wrong with it is returned. Does not touch extras. Never
// throws: what it does not understand is left to check().
CameraFaults mend(nlohmann::json& json, const std::string& file);

} // namespace gg::scene::gltf
