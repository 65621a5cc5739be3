#include "report/text.h"

#include <fmt/format.h>

namespace gg::report {

std::string escaped(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (const char ch : text)
    switch (ch) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    case '\'':
      result += "&#39;";
      break;
    default:
      result += ch;
    }
  return result;
}

std::string ms_text(double ms) {
  return ms < 100.0 ? fmt::format("{:.3g} ms", ms) : fmt::format("{:.0f} ms", ms);
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string result = "\"";
  for (const char ch : text) {
    if (ch == '"') result += '"';
    result += ch;
  }
  return result + '"';
}

} // namespace gg::report
