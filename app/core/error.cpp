#include "core/error.h"

#include <cstdio>
#include <mutex>
#include <set>

namespace gg {
namespace {

std::string sentence(const std::string& where, const std::string& what, const std::string& remedy) {
  std::string text = where.empty() ? what : where + ": " + what;
  if (!remedy.empty()) {
    text += text.ends_with('.') ? " " : ". ";
    text += remedy;
  }
  return text;
}

} // namespace

Error::Error(ExitCode code, const std::string& where, const std::string& what,
             const std::string& remedy)
    : std::runtime_error(sentence(where, what, remedy)), code_(code) {}

void note(const std::string& text) {
  static std::mutex mutex;
  static std::set<std::string> said;
  const std::lock_guard lock(mutex);
  if (said.insert(text).second) std::fprintf(stderr, "groundglass: note: %s\n", text.c_str());
}

} // namespace gg
