// The writers: what they are given comes out whole, whatever characters are in it.
#include "report/page.h"

#include "report/exports.h"
#include "report/plot.h"
#include "report/tables.h"
#include "report/text.h"
#include "report/webp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <sstream>

namespace gg::report {
namespace {

Cell cell(const std::string& method, const std::string& backend, double ms, double error) {
  Cell c{.method = method,
         .lookups = {1, 2, 3, 4},
         .device = {backend, "surface", "device, with a comma", "driver"},
         .bytes = 1 << 20,
         .triangles = 12,
         .timing = {.picture = {ms, 0.9 * ms, 1.1 * ms, 0.8 * ms, 2.0 * ms, 10},
                    .passes = {{"opaque", {0.7 * ms, 0.6 * ms, 0.8 * ms, 0.5 * ms, ms, 10}}}},
         .verdict = {.by_class = {{"metal", 40, error, 0.7 * error, 0.01, 0.1, 0.001}},
                     .by_roughness = {{"to .1", 40, error, 0.7 * error, 0.01, 0.1, 0.001}}},
         .picture = "data:image/webp;base64,QUJD",
         .flip = "data:image/webp;base64,QUJE",
         .command = "groundglass capture 'a <scene>.glb'"};
  c.verdict.objects.relmse = error;
  c.verdict.objects.relmse_trimmed = 0.7 * error;
  c.verdict.objects.psnr = 30.0;
  c.verdict.frame = c.verdict.objects;
  return c;
}

Report report() {
  Section s{.name = "a <b> \"c\"",
            .path = "a <b>.glb",
            .environment = "sky.hdr",
            .width = 64,
            .height = 48,
            .truth = "data:image/webp;base64,QUJF",
            .cells = {cell("standard", "opengl", 2.0, 0.5), cell("lobes2", "opengl", 4.0, 0.01),
                      cell("standard", "vulkan", 3.0, 0.5)}};
  const auto all = points_of(s.cells, Measure::all), best = points_of(s.cells, Measure::trimmed);
  s.front = pareto_front(all);
  s.front_trimmed = pareto_front(best);
  s.choice = choose(all, best, {.max_error = 0.1});
  return {.version = "0",
          .command = "groundglass report",
          .limit = {.max_error = 0.1},
          .sections = {s}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

} // namespace

TEST(page, escapes_what_would_be_markup) {
  EXPECT_EQ(escaped("<a href='x'>&\"</a>"), "&lt;a href=&#39;x&#39;&gt;&amp;&quot;&lt;/a&gt;");
  const std::string html = page(report());
  EXPECT_EQ(html.find("a <b>"), std::string::npos);
  EXPECT_NE(html.find("a &lt;b&gt; &quot;c&quot;"), std::string::npos);
}

TEST(page, refers_to_nothing_outside_itself) {
  const std::string html = page(report());
  for (const char* part : {"http:", "https:", "src=\"/", "@import", "url("})
    EXPECT_EQ(html.find(part), std::string::npos) << part;
  EXPECT_EQ(count(html, "<img"), count(html, "src=\"data:image/webp;base64,"));
  EXPECT_EQ(count(html, "<script"), 1u);
}

TEST(page, shows_every_method_and_names_the_choice) {
  const std::string html = page(report());
  for (const char* part :
       {"standard on opengl", "lobes2 on opengl", "standard on vulkan",
        "To use: lobes2 on opengl: 4 ms", "the fastest with a relMSE of at most 0.1",
        "<td>both</td>", "metal", "to .1", "opaque"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(page, shows_how_times_of_passes_spread) {
  EXPECT_EQ(count(page(report()), "2.80 <span class=\"quiet\">2.40 – 3.20</span>"), 1u);
}

TEST(page, says_where_outliers_dominate_the_error_and_where_noise_does) {
  const auto has = [](const Report& r, const char* text) {
    return page(r).find(text) != std::string::npos;
  };
  Report r = report();
  EXPECT_FALSE(has(r, "One pixel in a hundred"));
  EXPECT_FALSE(has(r, "own noise for"));
  image::Errors& lobes2 = r.sections[0].cells[1].verdict.objects;
  lobes2.relmse = 866.0;
  lobes2.relmse_trimmed = 0.123;
  lobes2.noise = image::Noise{.relmse = 500.0, .pixels_within = 0.37};
  for (const char* text :
       {"One pixel in a hundred carries more than half of the relMSE for: "
        "lobes2 on opengl. ",
        "own noise for: lobes2 on opengl. ", "<td>866</td><td>0.123</td>", "<td>37 %</td>"})
    EXPECT_TRUE(has(r, text)) << text;
}

TEST(page, lists_passes_in_the_order_of_the_frame_whichever_method_has_them) {
  Report r = report();
  r.sections[0].cells[0].timing.passes = {{"opaque", {}}, {"refractive", {}}};
  r.sections[0].cells[1].timing.passes = {{"opaque", {}}, {"interior", {}}, {"refractive", {}}};
  const std::string html = page(r);
  const auto at = [&](const char* pass) { return html.find(std::string("<td>") + pass + "</td>"); };
  EXPECT_LT(at("opaque"), at("interior"));
  EXPECT_LT(at("interior"), at("refractive"));
}

TEST(page, leads_with_a_verdict_and_gives_the_command_of_each_row) {
  Report r = report();
  r.limit = {};
  r.sections[0].choice.reset();
  const std::string html = page(r);
  const auto verdict =
      html.find("The most accurate is lobes2 on opengl: relMSE 0.007 (1 %-trimmed) in "
                "4 ms; standard, with as many samples, has 50 times the error in 0.5 "
                "times the time.");
  EXPECT_LT(verdict, html.find("triangles")) << html.substr(0, 4000);
  EXPECT_EQ(count(html, "<code>groundglass capture &#39;a &lt;scene&gt;.glb&#39;</code>"), 3u);
}

TEST(page, offers_any_two_of_the_truth_the_pictures_and_their_flip_maps) {
  const std::string html = page(report());
  for (const char* option : {">truth</option>", ">standard</option>", ">FLIP of lobes2</option>"})
    EXPECT_GE(count(html, option), 2u) << option;
  EXPECT_EQ(count(html, "<select"), 2u);
}

TEST(plot, joins_the_points_of_one_method_by_their_samples) {
  Report r = report();
  Section& s = r.sections.front();
  s.cells[0].samples = 16;
  s.cells[1] = s.cells[0];
  s.cells[1].samples = 1;
  s.cells[1].timing.picture.median = 0.5;
  EXPECT_EQ(count(plot(s, {}, Measure::all), "class=\"curve\""), 1u);
  EXPECT_EQ(cell_name(s, s.cells[1]), "standard, 1 sample on opengl");
}

TEST(page, of_a_report_of_nothing_is_a_page) {
  EXPECT_NE(page({}).find("</html>"), std::string::npos);
}

TEST(plot, of_the_trimmed_percent_has_their_errors_and_their_front) {
  Report r = report();
  Section& s = r.sections.front();
  s.cells[1].verdict.objects.relmse = 866.0; // one pixel: by all, the slower method is the worse
  s.front = pareto_front(points_of(s.cells, Measure::all));
  EXPECT_EQ(s.front, (std::vector<std::size_t>{0}));
  EXPECT_EQ(s.front_trimmed, (std::vector<std::size_t>{0, 1}));
  const std::string all = plot(s, {}, Measure::all), best = plot(s, {}, Measure::trimmed);
  EXPECT_EQ(count(all, "relMSE 866"), 1u);
  EXPECT_EQ(count(best, "relMSE 866"), 0u);
  EXPECT_EQ(count(best, "relMSE 0.007"), 1u);
  EXPECT_EQ(count(best, "1 %-trimmed"), 1u);
  EXPECT_EQ(count(page(r), "<td>trimmed</td>"), 1u);
  EXPECT_EQ(count(plots(r), "class=\"front\""), 2u);
}

TEST(plot, has_a_point_and_an_error_bar_per_cell_and_the_front) {
  const Report r = report();
  const std::string svg = plot(r.sections.front(), r.limit, Measure::all);
  EXPECT_EQ(count(svg, "<title>"), 3u);
  EXPECT_EQ(count(svg, "class=\"front\""), 1u);
  EXPECT_EQ(count(svg, "--max-error"), 1u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(plot, of_equal_pictures_and_of_one_point_has_finite_axes) {
  Report r = report();
  r.sections.front().cells = {cell("standard", "opengl", 0.0, 0.0)};
  r.sections.front().front = {0};
  const std::string svg = plot(r.sections.front(), r.limit, Measure::all);
  EXPECT_EQ(svg.find("nan"), std::string::npos) << svg;
  EXPECT_EQ(svg.find("inf"), std::string::npos) << svg;
}

TEST(plot, ticks_are_round_few_and_inside) {
  EXPECT_EQ(log_ticks(0.8, 25.0), (std::vector<double>{1, 2, 5, 10, 20}));
  for (const auto& [low, high] : {std::pair{1e-9, 1e3}, {1e-3, 1.0}, {0.5, 2.0}}) {
    const std::vector<double> ticks = log_ticks(low, high);
    EXPECT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 8u);
    for (const double t : ticks)
      EXPECT_TRUE(t >= low && t <= high) << t;
  }
}

TEST(page, says_how_many_lookups_of_each_kind_a_method_makes) {
  EXPECT_EQ(count(page(report()), "<td>1 + 2 + 3 + 4</td>"), 3u);
  Report metal = report();
  for (Cell& cell : metal.sections[0].cells)
    cell.lookups = {.reflected = 5};
  EXPECT_EQ(count(page(metal), "<td>5</td>"), 3u);
}

// Where the methods' points fall together, as those of many lobes do, their labels do not.
TEST(plot, labels_find_room_for_themselves) {
  Report crowded = report();
  auto& cells = crowded.sections[0].cells;
  cells.clear();
  for (const char* name : {"standard", "lobes1", "lobes2", "lobes3", "lobes4", "fis16", "fis32"})
    cells.push_back(cell(name, "opengl", 4.0 + 0.001 * static_cast<double>(cells.size()), 0.01));
  crowded.sections[0].front = {0};
  const std::string svg = plot(crowded.sections[0], crowded.limit, Measure::all);
  struct Label {
    double x, y;
  };
  std::vector<Label> labels;
  const std::regex text(
      R"re(<text x="([0-9.]+)" y="([0-9.]+)" fill="[^"]+" font-weight="bold">)re");
  for (std::sregex_iterator i(svg.begin(), svg.end(), text), end; i != end; ++i)
    labels.push_back({std::stod((*i)[1]), std::stod((*i)[2])});
  ASSERT_EQ(labels.size(), cells.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_TRUE(std::abs(labels[i].y - labels[k].y) > 12.0
                  || std::abs(labels[i].x - labels[k].x) > 36.0) // of type of 12 px, six letters
          << cells[i].method << " over " << cells[k].method;
}

TEST(exports, csv_has_as_many_fields_in_every_line_as_names) {
  EXPECT_EQ(csv_field("a,\"b\""), "\"a,\"\"b\"\"\"");
  EXPECT_EQ(csv_field("plain"), "plain");
  std::istringstream lines(to_csv(report()));
  std::string names, line;
  std::getline(lines, names);
  std::size_t read = 0;
  for (; std::getline(lines, line); ++read) {
    bool quoted = false;
    std::size_t commas = 0;
    for (const char ch : line) {
      if (ch == '"') quoted = !quoted;
      commas += ch == ',' && !quoted;
    }
    EXPECT_EQ(commas, count(names, ",")) << line;
  }
  EXPECT_EQ(read, 3u);
}

TEST(exports, json_has_every_number_and_verdicts_survive_it_exactly) {
  const auto json = to_json(report());
  const auto& first = json.at("scenes").at(0).at("cells").at(0);
  EXPECT_EQ(first.at("picture_ms").at("median"), 2.0);
  EXPECT_EQ(first.at("passes").at(0).at("pass"), "opaque");
  EXPECT_EQ(json.at("scenes").at(0).at("choice").at("cell"), 1);
  EXPECT_EQ(first.at("passes").at(0).at("ms").at("high_quartile"), 1.6);
  EXPECT_EQ(first.at("errors").at("objects").at("relmse_trimmed"), 0.35);
  Verdict v = report().sections.front().cells.front().verdict;
  v.objects.noise = image::Noise{.relmse = 0.1, .relmse_trimmed = 0.05};
  EXPECT_EQ(to_json(verdict_from(to_json(v))), to_json(v));
  Verdict equal = v; // an infinite PSNR has no number in JSON
  equal.objects.psnr = INFINITY;
  EXPECT_TRUE(std::isinf(verdict_from(to_json(equal)).objects.psnr));
}

TEST(pictures, are_encoded_without_loss_and_as_base64) {
  EXPECT_EQ(data_uri({std::byte{'A'}}), "data:image/webp;base64,QQ==");
  EXPECT_EQ(data_uri({std::byte{'A'}, std::byte{'B'}, std::byte{'C'}, std::byte{'D'}}),
            "data:image/webp;base64,QUJDRA==");
  image::Image picture(5, 3, 3);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = static_cast<float>(i * 5) / 255.0f;
  const auto bytes = webp_of(picture);
  const image::Image8 back = image::decode(bytes.data(), bytes.size(), "picture");
  for (std::size_t pixel = 0; pixel < 15; ++pixel)
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_EQ(back.rgba[4 * pixel + c], (3 * pixel + c) * 5);
}

} // namespace gg::report
