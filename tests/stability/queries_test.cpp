// What `groundglass eval` reads and writes: any CSV that names the columns, bad rows by their line.
#include "bsdf/evaluate.h"
#include "bsdf/query_file.h"
#include "core/error.h"
#include "support/scratch.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace gg;

const std::string header = "id,lobe,dist,alpha,eta,cn,ck,ix,iy,iz,ox,oy,oz,nx,ny,nz\n";
const std::string row = "R,ggx,0.3,1.5,0,0,0,0,1,0,0,1,0,0,1\n";

struct Read {
  std::vector<std::string> ids;
  std::vector<bsdf::Query> queries;
};

Read read(const std::string& text) {
  Read all;
  bsdf::QueryReader reader(test::scratch_file("queries.csv", text));
  reader.next(1000, all.ids, all.queries);
  reader.expect_no_bad_rows();
  return all;
}

std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::input);
    return error.what();
  }
  ADD_FAILURE() << "accepted:\n" << text;
  return {};
}

bsdf::Values<double> answer(const bsdf::Query& query) {
  std::vector<bsdf::Values<double>> values(1);
  bsdf::evaluate_cpu({&query, 1}, values);
  return values[0];
}

TEST(queries, columns_are_found_by_name_and_others_are_ignored) {
  const Read all = read("class,nz,ny,nx,oz,oy,ox,iz,iy,ix,ck,cn,eta,alpha,dist,lobe,id\n"
                        "easy,1,0,0,-1,0,0,1,0,0,4,3,1.5,0.25,beckmann,T,a\n");
  ASSERT_EQ(all.queries.size(), 1u);
  const bsdf::Query& q = all.queries[0];
  EXPECT_EQ(all.ids[0], "a");
  EXPECT_EQ(q.lobe, bsdf::Lobe::transmission);
  EXPECT_EQ(q.distribution, bsdf::Distribution::beckmann);
  EXPECT_EQ(q.alpha, 0.25f);
  EXPECT_EQ(q.o[2], -1.0f);
}

TEST(queries, quotes_windows_lines_blanks_and_a_byte_order_mark_are_read) {
  const Read all =
      read("\xEF\xBB\xBF\"id\", lobe ,dist,alpha,eta,cn,ck,ix,iy,iz,ox,oy,oz,nx,ny,nz\r\n"
           "\"a \"\"b\"\", c\", R ,\"ggx\",3e-1,+1.5,,,0,0,1,0,0,1,0,0,1\r\n\r\n"
           "\"two\nlines\","
           + row);
  ASSERT_EQ(all.ids.size(), 2u);
  EXPECT_EQ(all.ids[0], "a \"b\", c");
  EXPECT_EQ(all.ids[1], "two\nlines");
  EXPECT_EQ(all.queries[0].alpha, 0.3f);
  std::string text;
  bsdf::append_rows<float>(text, all.ids, std::vector<bsdf::Values<float>>(2));
  EXPECT_EQ(text, "\"a \"\"b\"\", c\",0,0,0,0,0,0,0,0,0,0\n\"two\nlines\",0,0,0,0,0,0,0,0,0,0\n");
}

TEST(queries, bad_rows_are_all_counted_and_the_first_ones_named_by_line) {
  std::string text = header + "1," + row + "2,X,ggx,0.3,1.5,0,0,0,0,1,0,0,1,0,0,1\n" + "3," + row;
  for (int i = 0; i < 30; ++i)
    text += "4,R,ggx,nan,1.5,0,0,0,0,1,0,0,1,0,0,1\n";
  const std::string said = complaint(text);
  EXPECT_NE(said.find("31 of 33 rows"), std::string::npos) << said;
  EXPECT_NE(said.find("line 3: lobe is neither R nor T: 'X'"), std::string::npos) << said;
  EXPECT_NE(said.find("line 5: alpha is not finite: 'nan'"), std::string::npos) << said;
  EXPECT_NE(said.find("and 11 more"), std::string::npos) << said;
}

TEST(queries, every_kind_of_bad_value_is_said) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"R,ggy,0.3,1.5,0,0,0,0,1,0,0,1,0,0,1", "dist is not ggx, beckmann or phong"},
      {"R,ggx,-1,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is negative"},
      {"R,ggx,,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is empty"},
      {"R,ggx,0.3x,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is not a number"},
      {"R,ggx,1e99,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is too large"},
      {"R,ggx,1e-9,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is outside 0 and 1e-08 to 10000"},
      {"R,phong,1e17,1.5,0,0,0,0,1,0,0,1,0,0,1", "alpha is outside"},
      {"R,ggx,0.3,2e4,0,0,0,0,1,0,0,1,0,0,1", "eta is outside"},
      {"R,ggx,0.3,0,2e4,0,0,0,1,0,0,1,0,0,1", "cn is outside"},
      {"R,ggx,0.3,inf,0,0,0,0,1,0,0,1,0,0,1", "eta is not finite"},
      {"R,ggx,0.3,0,0,0,0,0,1,0,0,1,0,0,1", "eta is 0 (a conductor) and so are cn and ck"},
      {"R,ggx,0.3,1.5,0,0,0,0,0,0,0,1,0,0,1", "direction i has no length"},
      {"R,ggx,0.3,1.5,0,0,0,0,1", "has 10 fields and no ox"},
  };
  for (const auto& [text, words] : rows)
    EXPECT_NE(complaint(header + "1," + text + "\n").find(words), std::string::npos) << text;
}

TEST(queries, missing_columns_are_all_named) {
  EXPECT_NE(complaint("id,lobe,dist,alpha,cn,ck,ix,iy,iz,ox,oy,oz,nx,ny\n").find("column eta, nz"),
            std::string::npos);
  EXPECT_NE(complaint("").find("is empty"), std::string::npos);
  EXPECT_NE(complaint(header + "\"1," + row).find("not closed"), std::string::npos);
}

TEST(queries, batches_keep_order_and_lose_nothing) {
  std::string text = header;
  for (int i = 0; i < 1000; ++i)
    text += std::to_string(i) + "," + row;
  bsdf::QueryReader reader(test::scratch_file("queries.csv", text));
  std::vector<std::string> ids, all;
  std::vector<bsdf::Query> queries;
  while (reader.next(64, ids, queries))
    all.insert(all.end(), ids.begin(), ids.end());
  ASSERT_EQ(all.size(), 1000u);
  for (int i = 0; i < 1000; ++i)
    EXPECT_EQ(all[static_cast<std::size_t>(i)], std::to_string(i));
}

TEST(queries, directions_of_any_length_are_normalised) {
  const Read all = read(header + "1,R,ggx,0.3,1.5,0,0,0.6,0,0.8,-0.6,0,0.8,0,0,1\n"
                        + "2,R,ggx,0.3,1.5,0,0,3,0,4,-6e20,0,8e20,0,0,1e-30\n");
  const auto a = answer(all.queries[0]), b = answer(all.queries[1]);
  // 0.6 and 0.8 are rounded to float32 before they are normalised, 3 and 4 after.
  for (std::size_t v = 0; v < a.size(); ++v)
    EXPECT_NEAR(b[v], a[v], 1e-6 * a[v]);
}

// Every distribution and lobe with alpha, eta and a metal's index at and beyond what float32 can
// square.
std::vector<bsdf::Query> extreme_queries() {
  std::vector<bsdf::Query> all;
  const std::vector<float> widths = {0.0f, 1e-8f, 1e-6f, 1e-4f, 1.0f, 10.0f, 1e4f};
  const std::vector<float> exponents = {0.0f, 1e-30f, 1.0f, 1e4f, 1e8f, 1e12f, 1e16f};
  const std::vector<float> indices = {1e-4f,      0.25f, 0.5f, 0.99999994f, 1.0f,
                                      1.0000001f, 1.5f,  4.0f, 1e4f};
  const std::vector<std::array<float, 3>> directions = {
      {0.6f, 0.0f, 0.8f},  {-0.6f, 0.0f, 0.8f},  {0.0f, 0.0f, 1.0f},
      {1.0f, 0.0f, 0.0f},  {1.0f, 0.0f, 1e-38f}, {-1.0f, 0.0f, 1e-20f},
      {0.6f, 0.0f, -0.8f}, {-0.6f, 0.0f, -0.8f}, {0.0f, 0.0f, -1.0f}};
  for (const auto distribution :
       {bsdf::Distribution::ggx, bsdf::Distribution::beckmann, bsdf::Distribution::phong})
    for (const auto lobe : {bsdf::Lobe::reflection, bsdf::Lobe::transmission})
      for (const float alpha : distribution == bsdf::Distribution::phong ? exponents : widths)
        for (const auto& i : directions)
          for (const auto& o : directions) {
            bsdf::Query q{i, o, {0.0f, 0.0f, 1.0f}, alpha, 0.0f, 0.0f, 0.0f, lobe, distribution};
            for (const float eta : indices) {
              q.eta = eta;
              all.push_back(q);
            }
            q.eta = 0.0f;
            for (const float n : indices)
              for (const float k : {0.0f, 1e-30f, 5.0f, 1e4f}) {
                q.cn = n;
                q.ck = k;
                all.push_back(q);
              }
          }
  return all;
}

std::string described(const bsdf::Query& q) {
  return fmt::format("dist {} lobe {} alpha {} eta {} n {} k {} i {} {} {} o {} {} {}",
                     static_cast<int>(q.distribution), static_cast<int>(q.lobe), q.alpha, q.eta,
                     q.cn, q.ck, q.i[0], q.i[1], q.i[2], q.o[0], q.o[1], q.o[2]);
}

template <class Real>
void expect_finite(const std::vector<bsdf::Query>& queries,
                   const std::vector<bsdf::Values<Real>>& values) {
  int shown = 0;
  for (std::size_t q = 0; q < queries.size(); ++q)
    for (std::size_t v = 0; v < bsdf::value_names.size(); ++v) {
      const Real x = values[q][v];
      if (std::isfinite(x) && x >= Real(0)) continue;
      ADD_FAILURE() << bsdf::value_names[v] << " = " << x << ": " << described(queries[q]);
      if (++shown == 20) return;
    }
}

TEST(queries, extreme_numbers_give_finite_answers_in_double) {
  const auto queries = extreme_queries();
  std::vector<bsdf::Values<double>> values(queries.size());
  bsdf::evaluate_cpu(queries, values);
  expect_finite(queries, values);
}

TEST(queries, extreme_numbers_give_finite_answers_on_the_device) {
  const auto queries = extreme_queries();
  const auto device = gpu::create_device({.debug = true});
  for (const auto form : {bsdf::Form::stable, bsdf::Form::compensated}) {
    SCOPED_TRACE(form == bsdf::Form::stable ? "stable" : "compensated");
    bsdf::DeviceEvaluator evaluator(*device, form, queries.size());
    std::vector<bsdf::Values<float>> values(queries.size());
    evaluator.evaluate(queries, values);
    expect_finite(queries, values);
  }
}

} // namespace
