#include "bsdf/query_file.h"

#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gg::bsdf {
namespace {

constexpr std::array<std::string_view, 16> column_names = {
    "id", "lobe", "dist", "alpha", "eta", "cn", "ck", "ix",
    "iy", "iz",   "ox",   "oy",    "oz",  "nx", "ny", "nz"};
enum Column { id, lobe, dist, alpha, eta, cn, ck, ix, ox = ix + 3, nx = ox + 3 };

// How many bad rows are described; the rest are only counted.
constexpr std::size_t described_rows = 20;

// Directions whose squared length is within this of 1 are taken as they are, so that a float32 unit
// vector keeps its bits: each of three components is off by half an ulp (2^-25) at most, the sum of
// their squares by 2^-22 with room.
constexpr double unit_tolerance = 0x1p-21;

// What float32 can square, and square again, on the way to an answer: beyond these a product
// overflows or vanishes half-way although the answer would not. Glass and metals are far inside
// (alpha 1e-4 is a mirror, indices end at 10).
struct Range {
  float low, high; // 0 is allowed besides
};
constexpr Range widths{1e-8f, 1e4f};      // slope width
constexpr Range exponents{1e-30f, 1e16f}; // Phong's: 1e16 is a width of 1.4e-8
constexpr Range indices{1e-4f, 1e4f};     // eta
constexpr Range parts{0.0f, 1e4f};        // cn, ck

// Why a row is not a query.
struct BadRow {
  std::string reason;
};

std::string quoted(const std::string& text) {
  return "'" + (text.size() > 40 ? text.substr(0, 40) + "..." : text) + "'";
}

float number(const std::string& text, std::string_view name) {
  float value = 0.0f;
  const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* last = text.data() + text.size();
  const auto [end, status] = std::from_chars(first, last, value);
  if (text.empty()) throw BadRow{std::string(name) + " is empty"};
  if (status == std::errc::result_out_of_range && end == last) {
    // Too small for float32 is 0; too large is no number that anything can be done with.
    double wide = 0.0;
    if (std::from_chars(first, last, wide).ec == std::errc() && std::abs(wide) < 1.0)
      return static_cast<float>(wide);
    throw BadRow{std::string(name) + " is too large for float32: " + quoted(text)};
  }
  if (status != std::errc() || end != last)
    throw BadRow{std::string(name) + " is not a number: " + quoted(text)};
  if (!std::isfinite(value)) throw BadRow{std::string(name) + " is not finite: " + quoted(text)};
  return value;
}

float in_range(const std::string& text, std::string_view name, Range range) {
  const float value = number(text, name);
  if (value < 0.0f) throw BadRow{std::string(name) + " is negative: " + quoted(text)};
  if (value != 0.0f && (value < range.low || value > range.high))
    throw BadRow{fmt::format("{} is outside 0 and {:g} to {:g}: {}", name, range.low, range.high,
                             quoted(text))};
  return value;
}

std::array<float, 3> direction(const std::array<float, 3>& v, std::string_view name) {
  const double x = v[0], y = v[1], z = v[2];
  const double length2 = x * x + y * y + z * z;
  if (length2 == 0.0) throw BadRow{"direction " + std::string(name) + " has no length"};
  if (std::abs(length2 - 1.0) <= unit_tolerance) return v;
  const double scale = 1.0 / std::sqrt(length2);
  return {static_cast<float>(x * scale), static_cast<float>(y * scale),
          static_cast<float>(z * scale)};
}

} // namespace

QueryReader::QueryReader(const std::filesystem::path& path) : path_(path), csv_(path) {
  find_columns();
}

void QueryReader::find_columns() {
  const std::string remedy =
      "The first line has to name the columns id, lobe, dist, alpha, eta, cn, "
      "ck, ix, iy, iz, ox, oy, oz, nx, ny, nz.";
  std::vector<std::string> header;
  if (!csv_.next(header)) {
    csv_.expect_end();
    throw Error(ExitCode::input, path_, "is empty", remedy);
  }
  std::string missing;
  for (std::size_t c = 0; c < column_names.size(); ++c) {
    const auto found = std::find(header.begin(), header.end(), column_names[c]);
    columns_[c] = static_cast<std::size_t>(found - header.begin());
    if (found == header.end())
      missing += (missing.empty() ? "" : ", ") + std::string(column_names[c]);
  }
  if (!missing.empty())
    throw Error(ExitCode::input, path_.string() + ":" + std::to_string(csv_.line()),
                "has no column " + missing, remedy);
}

bool QueryReader::next(std::size_t limit, std::vector<std::string>& ids,
                       std::vector<Query>& queries) {
  ids.clear();
  queries.clear();
  const auto field = [&](std::size_t column) -> const std::string& {
    if (columns_[column] >= fields_.size())
      throw BadRow{"has " + std::to_string(fields_.size()) + " fields and no "
                   + std::string(column_names[column])};
    return fields_[columns_[column]];
  };
  const auto vector = [&](std::size_t first, std::string_view name) {
    std::array<float, 3> v{};
    for (std::size_t c = 0; c < 3; ++c)
      v[c] = number(field(first + c), column_names[first + c]);
    return direction(v, name);
  };
  const auto read = [&] {
    Query q;
    if (field(lobe) == "R")
      q.lobe = Lobe::reflection;
    else if (field(lobe) == "T")
      q.lobe = Lobe::transmission;
    else
      throw BadRow{"lobe is neither R nor T: " + quoted(field(lobe))};
    if (field(dist) == "ggx")
      q.distribution = Distribution::ggx;
    else if (field(dist) == "beckmann")
      q.distribution = Distribution::beckmann;
    else if (field(dist) == "phong")
      q.distribution = Distribution::phong;
    else
      throw BadRow{"dist is not ggx, beckmann or phong: " + quoted(field(dist))};
    q.alpha =
        in_range(field(alpha), "alpha", q.distribution == Distribution::phong ? exponents : widths);
    q.eta = in_range(field(eta), "eta", indices);
    if (q.eta == 0.0f) {
      q.cn = in_range(field(cn), "cn", parts);
      q.ck = in_range(field(ck), "ck", parts);
      if (q.cn == 0.0f && q.ck == 0.0f) throw BadRow{"eta is 0 (a conductor) and so are cn and ck"};
    }
    q.i = vector(ix, "i");
    q.o = vector(ox, "o");
    q.n = vector(nx, "n");
    ids.push_back(field(id));
    queries.push_back(q);
  };

  while (queries.size() < limit) {
    if (!csv_.next(fields_)) {
      csv_.expect_end();
      break;
    }
    ++rows_;
    try {
      read();
    } catch (const BadRow& bad) {
      if (++bad_rows_ <= static_cast<long>(described_rows))
        complaints_.push_back("line " + std::to_string(csv_.line()) + ": " + bad.reason);
    }
  }
  return !queries.empty();
}

void QueryReader::expect_no_bad_rows() const {
  if (bad_rows_ == 0) return;
  std::string what =
      std::to_string(bad_rows_) + " of " + std::to_string(rows_) + " rows cannot be used";
  for (const std::string& complaint : complaints_)
    what += "\n  " + complaint;
  if (bad_rows_ > static_cast<long>(complaints_.size()))
    what +=
        "\n  and " + std::to_string(bad_rows_ - static_cast<long>(complaints_.size())) + " more";
  throw Error(ExitCode::input, path_, what + "\nNothing was written", "Mend or remove these rows.");
}

std::string value_header() {
  std::string header = "id";
  for (const std::string_view name : value_names)
    header.append(",").append(name);
  header += '\n';
  return header;
}

template <class Real>
void append_rows(std::string& text, std::span<const std::string> ids,
                 std::span<const Values<Real>> values) {
  // sign, point, exponent of up to four characters and sign: the longest number has fewer than 32
  // characters
  std::array<char, 32> digits{};
  for (std::size_t row = 0; row < ids.size(); ++row) {
    text += csv_field(ids[row]);
    for (const Real value : values[row]) {
      const auto end =
          std::to_chars(digits.data(), digits.data() + digits.size(), value,
                        std::chars_format::general, std::numeric_limits<Real>::max_digits10);
      text += ',';
      text.append(digits.data(), end.ptr);
    }
    text += '\n';
  }
}

template void append_rows<float>(std::string&, std::span<const std::string>,
                                 std::span<const Values<float>>);
template void append_rows<double>(std::string&, std::span<const std::string>,
                                  std::span<const Values<double>>);

} // namespace gg::bsdf
