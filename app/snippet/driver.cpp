#include "snippet/driver.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <vector>

namespace gg::snippet {
namespace {

constexpr const char* opening = "#version 450\nlayout(location = 0) out vec4 gg_pixel;\n";

bool is_sampler(const std::string& type) {
  return type.find("sampler") != std::string::npos;
}

std::string sampler_name(const std::string& type) {
  return "gg_" + type;
}

std::string samplers(const std::vector<Item>& declared) {
  std::set<std::string> types;
  for (const Item& item : declared)
    for (const Parameter& parameter : item.parameters)
      if (is_sampler(parameter.type)) types.insert(parameter.type);
  std::string text;
  int binding = 2;
  for (const std::string& type : types)
    text += "layout(set = 0, binding = " + std::to_string(binding++) + ") uniform " + type + " "
            + sampler_name(type) + ";\n";
  return text;
}

// Whether the tokens from `i`, a name, on are the target of an assignment: name, name.field or name[k] before =, +=, ++ and the
// like.
bool is_assigned(const std::string& text, const std::vector<Token>& all, std::size_t i) {
  const auto at = [&](std::size_t k) { return k < all.size() ? text[all[k].begin] : '\0'; };
  if (i > 1 && ((at(i - 1) == '+' && at(i - 2) == '+') || (at(i - 1) == '-' && at(i - 2) == '-')))
    return true;
  std::size_t k = i + 1;
  while (at(k) == '.' || at(k) == '[') {
    if (at(k) == '.') {
      k += 2;
      continue;
    }
    const int depth = all[k].depth;
    do
      ++k;
    while (k < all.size() && all[k].depth > depth);
    ++k;
  }
  if (at(k) == '=') return at(k + 1) != '=';
  const bool combines = std::string_view("+-*/").find(at(k)) != std::string_view::npos;
  return combines && all[k].end == (k + 1 < all.size() ? all[k + 1].begin : 0)
         && (at(k + 1) == '=' || (at(k) != '*' && at(k) != '/' && at(k + 1) == at(k)));
}

bool changes(const std::string& text, const std::vector<Token>& all, const Item& function,
             const std::string& name) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].begin > function.header_end && all[i].end < function.end
        && text.compare(all[i].begin, all[i].end - all[i].begin, name) == 0
        && is_assigned(text, all, i))
      return true;
  return false;
}

std::string by_value(const std::string& text, const std::vector<Item>& declared) {
  const std::vector<Token> all = tokens(text);
  std::string out;
  std::size_t copied = 0;
  for (const Item& item : declared)
    for (const Parameter& parameter : item.parameters) {
      const bool callable = item.kind == Item::Kind::function || item.kind == Item::Kind::prototype;
      if (!callable || is_sampler(parameter.type) || changes(text, all, item, parameter.name))
        continue;
      out.append(text, copied, parameter.begin - copied);
      out += "const ";
      copied = parameter.begin;
    }
  return out + text.substr(copied);
}

// A body for every function that is only declared.
std::string stubs(const std::string& text, const std::vector<Item>& declared) {
  std::string out;
  for (const Item& item : declared)
    if (item.kind == Item::Kind::prototype)
      out += text.substr(item.begin, item.header_end - item.begin) + " { " + item.type
             + " gg_nothing; return gg_nothing; }\n";
  return out;
}

} // namespace

std::string calling_all(const std::string& glsl) {
  const std::vector<Item> declared = items(glsl);
  std::string text = opening + samplers(declared);
  const std::string body = by_value(glsl, declared);
  text += body + stubs(body, items(body)) + "void main() {\n";
  for (const Item& item : declared) {
    if (item.kind != Item::Kind::function && item.kind != Item::Kind::prototype) continue;
    text += "  {";
    std::string arguments;
    for (std::size_t i = 0; i < item.parameters.size(); ++i) {
      const std::string& type = item.parameters[i].type;
      const std::string name = is_sampler(type) ? sampler_name(type) : "gg_a" + std::to_string(i);
      if (!is_sampler(type)) text.append(" ").append(type).append(" ").append(name).append(";");
      arguments.append(i == 0 ? "" : ", ").append(name);
    }
    text += " " + item.name + "(" + arguments + "); }\n";
  }
  return text + "  gg_pixel = vec4(0.0);\n}\n";
}

std::string calling_one(const std::string& glsl, const Item& function) {
  std::string fields, arguments;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const std::string& type = function.parameters[i].type;
    const std::string field = "a" + std::to_string(i);
    if (!is_sampler(type)) fields += " " + type + " " + field + ";";
    arguments += (i == 0 ? "" : ", ") + (is_sampler(type) ? sampler_name(type) : "gg_in." + field);
  }
  const std::vector<Item> declared = items(glsl);
  return opening + samplers(declared) + glsl + stubs(glsl, declared)
         + "layout(set = 0, binding = 0) readonly buffer GgIn {"
         + (fields.empty() ? " float unused;" : fields)
         + " } gg_in;\nlayout(set = 0, binding = 1) buffer GgOut { " + function.type
         + " r; } gg_out;\nvoid main() { gg_out.r = " + function.name + "(" + arguments
         + "); gg_pixel = vec4(0.0); }\n";
}

} // namespace gg::snippet
