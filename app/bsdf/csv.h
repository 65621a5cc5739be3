// Comma-separated text, record by record: RFC 4180 quotes, LF or CRLF, an optional byte order mark.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace gg::bsdf {

class CsvReader {
public:
  // Throws Error(input) if the file cannot be opened.
  explicit CsvReader(const std::filesystem::path& path);

  // The next record that is not an empty line; false at the end. Blanks around an unquoted field
  // are not part of it.
  bool next(std::vector<std::string>& fields);
  // The line on which the last record began, from 1.
  long line() const { return record_line_; }
  // Throws Error(input) if reading stopped before the end, or a quote is still open there.
  void expect_end() const;

private:
  bool next_line();

  std::filesystem::path path_;
  std::ifstream file_;
  std::string text_;
  long line_ = 0, record_line_ = 0;
  bool open_quote_ = false;
};

// The field as it must be written to be read back: in quotes if it needs them.
std::string csv_field(std::string_view text);

} // namespace gg::bsdf
