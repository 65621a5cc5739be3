// What C++ code allocates, here and in the libraries (OpenEXR, Draco), is counted in programs that counted.cpp is part of.
#pragma once

#include <cstddef>

namespace gg::test {

// From its making on. One at a time.
class Memory {
public:
  Memory();
  // The most bytes that were taken at once, beside those taken before.
  std::size_t taken() const;

private:
  std::size_t before_;
};

} // namespace gg::test
