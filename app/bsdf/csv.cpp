#include "bsdf/csv.h"

#include "core/error.h"

#include <cerrno>
#include <cstring>

namespace gg::bsdf {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace

CsvReader::CsvReader(const std::filesystem::path& path) : path_(path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw Error(ExitCode::input, path, "is a directory", "Name a CSV file.");
  file_.open(path == "-" ? "/dev/stdin" : path, std::ios::binary);
  if (!file_)
    throw Error(ExitCode::input, path, std::string("cannot be read: ") + std::strerror(errno),
                "Check the path and its permissions.");
}

bool CsvReader::next_line() {
  if (!std::getline(file_, text_)) return false;
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  if (line_++ == 0 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  return true;
}

bool CsvReader::next(std::vector<std::string>& fields) {
  do {
    if (!next_line()) return false;
  } while (trimmed(text_).empty());
  record_line_ = line_;

  fields.clear();
  std::size_t at = 0;
  for (;;) {
    const std::size_t start = text_.find_first_not_of(" \t", at);
    if (start == text_.npos || text_[start] != '"') {
      const std::size_t comma = text_.find(',', at);
      fields.emplace_back(trimmed(std::string_view(text_).substr(at, comma - at)));
      if (comma == text_.npos) return true;
      at = comma + 1;
      continue;
    }
    std::string field;
    for (at = start + 1;;) {
      const std::size_t quote = text_.find('"', at);
      field.append(text_, at, quote - at);
      if (quote == text_.npos) { // the field goes on in the next line
        field += '\n';
        at = 0;
        if (next_line()) continue;
        open_quote_ = true;
        return false;
      }
      at = quote + 1;
      if (at >= text_.size() || text_[at] != '"') break;
      field += '"';
      ++at;
    }
    fields.push_back(std::move(field));
    at = text_.find(',', at);
    if (at == text_.npos) return true;
    ++at;
  }
}

void CsvReader::expect_end() const {
  if (open_quote_)
    throw Error(ExitCode::input, path_.string() + ":" + std::to_string(record_line_),
                "a quoted field is not closed", "Close it with a double quote.");
  if (!file_.eof())
    throw Error(ExitCode::input, path_, "could not be read to its end", "Check the disk.");
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos && trimmed(text) == text) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

} // namespace gg::bsdf
