// kit_score SIZE PICTURE MASK.rgba REFERENCE.exr OUT.png: error of a picture (.exr, .hdr, or .rgba that a browser has read back:
// float RGBA, the lowest row first) over the pixels whose mask is 1, of all and of each object, as JSON; the picture itself for
// people.
#include "glsl/f32.h"
#include "image/compare.h"
#include "image/image.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace {

gg::image::Image picture_of(const std::string& path, int size) {
  if (!path.ends_with(".rgba")) return gg::image::read(path);
  gg::image::Image image(size, size, 3);
  std::vector<float> texels(4 * static_cast<std::size_t>(size) * size);
  std::ifstream file(path, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(texels.data()),
                 static_cast<std::streamsize>(texels.size() * sizeof(float)))) {
    std::fprintf(stderr, "%s: holds less than %d x %d texels\n", path.c_str(), size, size);
    std::exit(1);
  }
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (int c = 0; c < 3; ++c)
        image.at(x, y, c) = texels[4 * (static_cast<std::size_t>(size - 1 - y) * size + x) + c];
  return image;
}

struct Sum {
  double error = 0.0, bias = 0.0, reference = 0.0, count = 0.0;
  std::vector<double> errors;
  void add(double x, double r) {
    errors.push_back((x - r) * (x - r) / (r * r + 0.01));
    error += errors.back();
    bias += x - r;
    reference += r;
    ++count;
  }
  // 1 %-trimmed: a lamp's glint in one pixel is as much as all the rest.
  double trimmed() const {
    std::vector<double> sorted = errors;
    std::ranges::sort(sorted);
    const auto kept = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sorted.size()));
    return std::accumulate(sorted.begin(), sorted.begin() + kept, 0.0)
           / static_cast<double>(std::max<std::ptrdiff_t>(kept, 1));
  }
  void print(const std::string& name) const {
    const double n = std::max(count, 1.0);
    std::printf("\"%s\": {\"pixels\": %.0f, \"relMSE\": %.6g, \"trimmed\": %.6g, \"bias\": %.6g, "
                "\"mean\": %.6g}",
                name.c_str(), count / 3.0, error / n, trimmed(), bias / n, reference / n);
  }
};

// For people: as a display shows it.
gg::image::Image encoded(gg::image::Image image) {
  for (float& v : image.values)
    v = gg::glsl::f32::srgbFromLinear(v);
  return image;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 6) return 2;
  const int size = std::atoi(argv[1]);
  const gg::image::Image picture = picture_of(argv[2], size), mask = picture_of(argv[3], size);
  const gg::image::Picture reference = gg::image::load_picture(argv[4]);
  Sum all;
  std::map<int, Sum> objects;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      if (mask.at(x, y) < 0.999F) continue;
      const std::size_t at = static_cast<std::size_t>(y) * size + x;
      const int id = at < reference.id.size() ? static_cast<int>(reference.id[at]) : 0;
      for (int c = 0; c < 3; ++c) {
        all.add(picture.at(x, y, c), reference.colour.at(x, y, c));
        objects[id].add(picture.at(x, y, c), reference.colour.at(x, y, c));
      }
    }
  gg::image::write(argv[5], encoded(picture));
  std::printf("{");
  all.print("all");
  for (const auto& [id, sum] : objects) {
    std::printf(",\n ");
    const auto name = reference.object_names.find(id);
    sum.print(name == reference.object_names.end() ? std::to_string(id) : name->second);
  }
  std::printf("}\n");
}
