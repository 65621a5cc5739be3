// Snippets of shaders/ made whole: includes resolved, each file once, ready for a compiler or for a
// reader.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gg::glsl {

// Where a line of flattened text came from, for compiler messages.
struct Origin {
  std::filesystem::path file; // relative to the root
  int line = 0;               // from 1
};

struct Flattened {
  std::string text;
  std::vector<Origin> lines; // one per line of text
  std::vector<std::filesystem::path>
      files; // in the order in which they were taken in, relative to the root
};

// The text of `files` (relative to `root`, which is shaders/), with every `#include "x.glsl"` (also
// relative to the root) replaced by that file the first time that it is met and by nothing
// afterwards. Include guards are kept: they do no harm, and let two flattened snippets be pasted
// into one program. Throws Error(input), naming file and line, for a file that does not exist, an
// include outside the root, a circle of includes, or an #include that is not of this form.
Flattened flatten(const std::filesystem::path& root, std::span<const std::filesystem::path> files);
Flattened flatten(const std::filesystem::path& root, const std::filesystem::path& file);

// Every .glsl file under root/folder, relative to root and sorted; empty if there is no such
// folder.
std::vector<std::filesystem::path> list_snippets(const std::filesystem::path& root,
                                                 const std::filesystem::path& folder);

// True for files that must fetch from textures (named ..._fetch.glsl): GLSL and ESSL only, no C++.
bool is_fetch(const std::filesystem::path& file);

// What goes before a flattened snippet in GLSL ES 3.00: highp for whatever has no default precision
// there. mediump is not enough (shaders/README.md, "Half precision"). The prelude has the version too.
std::string essl_precisions();
std::string essl_prelude();

// The include guards (macro names) that a text defines, in order.
std::vector<std::string> include_guards(const std::string& text);

} // namespace gg::glsl
