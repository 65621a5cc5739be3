#include "snippet/rewrite.h"

#include "glsl/flatten.h"
#include "snippet/scan.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace gg::snippet {
namespace {

std::string first_word(std::istringstream& words) {
  std::string word;
  words >> word;
  return word;
}

// NAME of every `#define NAME`.
std::set<std::string> macros(const std::string& text) {
  std::set<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    if (first_word(words) == "#define") names.insert(first_word(words));
  }
  return names;
}

std::string renamed_words(const std::string& line, const std::set<std::string>& names,
                          const std::string& prefix) {
  std::string out;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size()
           && (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '_'))
      ++end;
    if (end == at) {
      out += line[at++];
      continue;
    }
    const std::string word = line.substr(at, end - at);
    out += names.contains(word) ? prefix + word : word;
    at = end;
  }
  return out;
}

// Preprocessor lines have no tokens of their own in scan.h.
std::string renamed_directives(const std::string& text, const std::set<std::string>& names,
                               const std::string& prefix) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(" \t");
    const bool directive = first != std::string::npos && line[first] == '#';
    out += (directive ? renamed_words(line, names, prefix) : line) + '\n';
  }
  return out;
}

// Where tokens are names of a struct's fields, which no declaration outside can mean.
bool names_field(const std::string& text, const std::vector<Token>& all, std::size_t i,
                 const std::vector<Item>& declared) {
  if (i > 0 && text[all[i - 1].begin] == '.') return true;
  if (all[i].depth != 1 || i + 1 == all.size()) return false;
  const bool in_struct = std::ranges::any_of(declared, [&](const Item& item) {
    return item.kind == Item::Kind::structure && item.begin < all[i].begin && all[i].end < item.end;
  });
  if (!in_struct) return false;
  const char next = text[all[i + 1].begin];
  const bool wgsl_type = text[all[i - 1].begin] == ':';
  return next == ':' || (!wgsl_type && (next == ';' || next == ',' || next == '['));
}

} // namespace

std::string with_prefix(const std::string& text, const std::string& prefix) {
  if (prefix.empty()) return text;
  const std::vector<Item> declared = items(text);
  std::set<std::string> names = macros(text);
  for (const Item& item : declared)
    if (!item.name.empty()) names.insert(item.name);
  const std::vector<Token> all = tokens(text);
  std::string out;
  std::size_t copied = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string word = text.substr(all[i].begin, all[i].end - all[i].begin);
    if (!names.contains(word) || names_field(text, all, i, declared)) continue;
    out.append(text, copied, all[i].begin - copied);
    out += prefix;
    copied = all[i].begin;
  }
  out.append(text, copied);
  return renamed_directives(out, names, prefix);
}

std::string without_comments(const std::string& text) {
  std::string code;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.compare(at, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", at);
      at = end == std::string::npos ? text.size() : end + 2;
    } else {
      code += text[at++];
    }
  }
  std::string out;
  std::istringstream lines(code);
  for (std::string line; std::getline(lines, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) out += line + '\n';
  }
  return out;
}

std::string without_guards(const std::string& text) {
  const std::vector<std::string> guards = glsl::include_guards(text);
  std::vector<bool> guarded; // of each #if that is open: whether it is a guard
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    const std::string directive = first_word(words), name = first_word(words);
    const bool guard = std::ranges::find(guards, name) != guards.end();
    bool drop = guard && (directive == "#ifndef" || directive == "#define");
    if (directive.starts_with("#if")) guarded.push_back(drop);
    if (directive == "#endif" && !guarded.empty()) {
      drop = guarded.back();
      guarded.pop_back();
    }
    if (!drop) out += line + '\n';
  }
  return out;
}

} // namespace gg::snippet
