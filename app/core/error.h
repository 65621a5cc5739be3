// What a person is told when something cannot be done, and how the program exits then.
#pragma once

#include <stdexcept>
#include <string>

namespace gg {

// The exit codes of every command (listed in app/README.md, "Exit codes").
enum class ExitCode {
  success = 0,
  internal = 1,    // a fault of ours: please report it
  usage = 2,       // an option, a camera, a material or a method that does not exist
  input = 3,       // a file that is missing, truncated, malformed or out of range
  unsupported = 4, // understood, but not something this build can do
  output = 5,      // a result that cannot be written
  device = 6,      // no driver, no suitable device, or the device failed
  different = 7,   // the work was done and its answer is "no" (compare, checks)
  interrupted = 130
};

// An error for people: `where` names the file and the place in it, `what` says what is wrong,
// `remedy` what to do. what() reads "where: what. remedy" with the parts that are not empty.
class Error : public std::runtime_error {
public:
  Error(ExitCode code, const std::string& where, const std::string& what,
        const std::string& remedy = {});
  ExitCode code() const { return code_; }

private:
  ExitCode code_;
};

// One line on stderr, prefixed "groundglass: note: ", for what is not modelled or was mended in
// passing. Each distinct text is printed once per process.
void note(const std::string& text);

} // namespace gg
