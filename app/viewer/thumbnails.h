// Small pictures of the environments that come with the program, for a panel.
#pragma once

#include <array>
#include <future>
#include <string>
#include <vector>

namespace gg::viewer {

struct Thumbnail {
  std::string path;
  std::array<float, 4>
      place{}; // in Dear ImGui's atlas of letters: u and v of its top left, and of its bottom right
};

class Thumbnails {
public:
  Thumbnails(); // begins to read them, on a thread of its own
  // Puts them into the atlas of letters, whose fonts have been added, before the first frame: the one texture that every backend
  // of Dear ImGui shows. Waits for what is being read; leaves out what cannot be.
  std::vector<Thumbnail> in_atlas(float scale);

private:
  struct Read {
    std::string path;
    std::vector<unsigned char> rgba;
  };
  static std::vector<Read> read();
  std::future<std::vector<Read>> reading_;
};

// Of one, in Dear ImGui's coordinates at scale 1.
inline constexpr int thumbnail_width = 72, thumbnail_height = 36;

} // namespace gg::viewer
