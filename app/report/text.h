// Texts for pages and tables.
#pragma once

#include <string>
#include <string_view>

namespace gg::report {

// For HTML and SVG, in text and in quoted attributes.
std::string escaped(std::string_view text);

// A time in milliseconds with its unit: three digits, whole numbers from 100 on.
std::string ms_text(double ms);

// A field of a comma-separated file: quoted if it must be (RFC 4180).
std::string csv_field(std::string_view text);

} // namespace gg::report
