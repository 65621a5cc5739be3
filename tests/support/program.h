// Runs the built program as a user would.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gg::test {

struct Finished {
  int code = 0; // 128 + signal if it was killed
  std::string out, err;
};

// Runs `groundglass arguments...` without a shell and waits. stdin is empty.
Finished run_program(const std::vector<std::string>& arguments,
                     const std::vector<std::string>& environment = {});

std::filesystem::path asset(const std::string& path); // below assets/

} // namespace gg::test
