// Queries read from a CSV file and values written to one: the two files of `groundglass eval`.
#pragma once

#include "bsdf/csv.h"
#include "bsdf/query.h"
#include "core/files.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace gg::bsdf {

// Reads rows in batches, so that memory does not grow with the file. Columns are found by name:
// id, lobe (R or T), dist (ggx, beckmann, phong), alpha, eta, cn, ck, ix, iy, iz, ox, oy, oz, nx,
// ny, nz; others are ignored. Numbers are rounded to float32 once; a direction that is not of unit
// length is normalised. alpha is 0 or 1e-8 to 1e4 (Phong's exponent: 1e-30 to 1e16), eta 0 or 1e-4
// to 1e4, cn and ck 0 to 1e4: beyond that float32 cannot square its way to an answer.
class QueryReader {
public:
  // Throws Error(input) if the file cannot be read or lacks a column, naming all that it lacks.
  explicit QueryReader(const std::filesystem::path& path);

  // Up to `limit` rows; false when there are none left. A row that is not a query is counted and
  // described, and takes no place in the batch.
  bool next(std::size_t limit, std::vector<std::string>& ids, std::vector<Query>& queries);
  // Throws Error(input) with a line for each of the first bad rows and the number of the rest, if
  // there was any.
  void expect_no_bad_rows() const;

private:
  void find_columns();

  std::filesystem::path path_;
  CsvReader csv_;
  std::array<std::size_t, 16> columns_{}; // where each of the columns above is, in that order
  std::vector<std::string> fields_;
  std::vector<std::string> complaints_;
  long bad_rows_ = 0, rows_ = 0;
};

// Appends `id` and the ten values of each row, with as many digits as `Real` needs to be read back
// exactly: 9 for float (%.9g), 17 for double (%.17g).
template <class Real>
void append_rows(std::string& text, std::span<const std::string> ids,
                 std::span<const Values<Real>> values);
std::string value_header();

} // namespace gg::bsdf
