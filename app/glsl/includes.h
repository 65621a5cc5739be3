// Follows the #include lines of a text, file by file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gg::glsl {

class IncludeWalk {
public:
  virtual ~IncludeWalk() = default;

  // The lines of `file` in order; in place of the line that first asks for another file, that file's. Each file once. Throws
  // Error(input) where a file cannot be read.
  void walk(const std::filesystem::path& file);

protected:
  struct Place {
    std::filesystem::path file;
    int line = 0; // from 1
  };
  // The file that `#include "name"` asks for at that place (name empty: it names none), as walk() takes it; empty: the line is text
  // like any other.
  virtual std::filesystem::path find(const std::string& name, const Place& from) = 0;
  virtual void text(std::string_view line, const Place& at) = 0; // without its end
  virtual std::filesystem::path path_of(const std::filesystem::path& file) { return file; }

  bool is_open(const std::filesystem::path& file) const;                     // is being walked
  const std::vector<std::filesystem::path>& files() const { return files_; } // in order

private:
  std::vector<std::filesystem::path> files_, open_;
};

} // namespace gg::glsl
