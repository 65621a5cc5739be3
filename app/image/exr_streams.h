// OpenEXR over bytes in memory, so that one place reads and writes files.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gg::image::formats {

class MemoryInput : public Imf::IStream {
public:
  MemoryInput(std::span<const std::byte> bytes, const std::string& name)
      : IStream(name.c_str()), bytes_(bytes) {}
  bool isMemoryMapped() const override { return false; }
  bool read(char* to, int count) override;
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = position; }

private:
  std::span<const std::byte> bytes_;
  std::uint64_t at_ = 0; // may lie past the end, where reading fails
};

class MemoryOutput : public Imf::OStream {
public:
  explicit MemoryOutput(const std::string& name) : OStream(name.c_str()) {}
  void write(const char* from, int count) override;
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }
  std::vector<std::byte> take() { return std::move(bytes_); }

private:
  std::vector<std::byte> bytes_;
  std::uint64_t at_ = 0;
};

} // namespace gg::image::formats
