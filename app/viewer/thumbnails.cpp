#include "viewer/thumbnails.h"

#include "core/files.h"
#include "image/image.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace gg::viewer {
namespace {

namespace fs = std::filesystem;

// Kept at twice the size, for displays of scale 2.
constexpr int width = 2 * thumbnail_width, height = 2 * thumbnail_height;

// Means of its pixels; the map's median becomes a middle grey, brighter ones near 1: x / (1 + x).
std::vector<unsigned char> shrunk(const image::Image& map) {
  std::vector<float> grey;
  std::vector<std::array<float, 3>> means;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::array<float, 3> sum{};
      const int top = y * map.height / height,
                bottom = std::max(top + 1, (y + 1) * map.height / height);
      const int left = x * map.width / width,
                right = std::max(left + 1, (x + 1) * map.width / width);
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u)
          for (int c = 0; c < 3; ++c)
            sum[static_cast<std::size_t>(c)] += map.at(u, v, std::min(c, map.channels - 1));
      for (float& value : sum)
        value /= static_cast<float>((bottom - top) * (right - left));
      means.push_back(sum);
      grey.push_back((sum[0] + sum[1] + sum[2]) / 3.0f);
    }
  std::ranges::nth_element(grey, grey.begin() + static_cast<std::ptrdiff_t>(grey.size() / 2));
  // A black map stays black.
  const float median = std::max(grey[grey.size() / 2], 1e-6f);
  std::vector<unsigned char> rgba;
  for (const std::array<float, 3>& mean : means) {
    for (const float value : mean) {
      const float x = 0.35f * std::max(value, 0.0f) / median;
      rgba.push_back(static_cast<unsigned char>(255.0f * std::pow(x / (1.0f + x), 1.0f / 2.2f)));
    }
    rgba.push_back(255);
  }
  return rgba;
}

} // namespace

Thumbnails::Thumbnails() : reading_(std::async(std::launch::async, read)) {}

std::vector<Thumbnails::Read> Thumbnails::read() {
  std::vector<Read> all;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(home_directory() / "assets/environments", none))
    if (entry.path().extension() == ".hdr") all.push_back({entry.path().string(), {}});
  std::ranges::sort(all, {}, &Read::path);
  for (Read& one : all)
    try {
      one.rgba = shrunk(image::read(one.path));
    } catch (const std::exception&) { // opening it will say what is wrong
    }
  return all;
}

std::vector<Thumbnail> Thumbnails::in_atlas(float scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const std::vector<Read> all = reading_.get();
  std::vector<int> rectangles;
  rectangles.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    rectangles.push_back(atlas.AddCustomRectRegular(width, height));
  if (atlas.ConfigData.empty()) { // no letters yet: those of the built-in font
    ImFontConfig config;
    config.SizePixels = std::round(13.0f * scale);
    atlas.AddFontDefault(&config);
  }
  unsigned char* pixels = nullptr;
  int across = 0, down = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &across, &down);
  std::vector<Thumbnail> thumbnails;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Thumbnail made{.path = all[i].path};
    const ImFontAtlasCustomRect* rectangle = atlas.GetCustomRectByIndex(rectangles[i]);
    if (!all[i].rgba.empty() && rectangle->IsPacked()) {
      for (int y = 0; y < height; ++y)
        std::memcpy(pixels + 4 * ((rectangle->Y + y) * across + rectangle->X),
                    all[i].rgba.data() + 4 * y * width, 4 * width);
      ImVec2 low, high;
      atlas.CalcCustomRectUV(rectangle, &low, &high);
      made.place = {low.x, low.y, high.x, high.y};
    }
    thumbnails.push_back(std::move(made));
  }
  return thumbnails;
}

} // namespace gg::viewer
