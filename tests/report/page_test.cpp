// SPDX-License-Identifier: BSD-3-Clause
#include "report/page.hpp"

#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/case_words.hpp"
#include "report/html.hpp"
#include "report/tables.hpp"
#include "tests/report/small_run.hpp"

namespace packbed::report {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string nasty =
    R"x(<img src=x onerror="alert(1)"> </script><script>alert('2')</script> & <!--)x";

std::string page_of(const test::SmallRun& run) {
  const UnitSystem units;
  return page({read_run(run.path(), units)}, units);
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

/// What stands between `begin` and the next `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const auto at = text.find(begin) + begin.size();
  return text.substr(at, text.find(end, at) - at);
}

TEST(Html, EscapesWhatCouldBeATagOrAnAttribute) {
  EXPECT_EQ(escaped("<b a=\"1\" c='2'> & é"), "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt; &amp; é");
  EXPECT_EQ(escaped("a\xFF"), "a\xEF\xBF\xBD");
}

TEST(Html, JsonOfAScriptHasNoTagAndReadsTheSame) {
  const Json json{{"label", nasty}};

  const auto script = script_json(json);

  EXPECT_THAT(script, AllOf(Not(HasSubstr("<")), Not(HasSubstr(">")), Not(HasSubstr("&"))));
  EXPECT_EQ(Json::parse(script), json);
}

TEST(Page, NeedsNothingButItself) {
  const test::SmallRun run;
  auto html = page_of(run);

  EXPECT_THAT(html, HasSubstr("content=\"default-src 'none';"));
  // uPlot names its home in a comment; nothing else may look like an address.
  html = std::regex_replace(html, std::regex("/\\*! https://github.com/leeoniya/uPlot"), "");
  for (const auto* request : {"http://", "https://", "src=", "url(", "@import", "<link", "fetch(",
                              "XMLHttpRequest", "WebSocket"}) {
    EXPECT_THAT(html, Not(HasSubstr(request)));
  }
}

TEST(Page, LetsNoTextOfTheUserBecomeAnythingElse) {
  const test::SmallRun run(nasty, nasty);
  run.write("summary.json", Json{{"title", nasty},
                                 {"version", nasty},
                                 {"case", nasty},
                                 {"warnings", {nasty}},
                                 {"simulated_time_s", 1.0},
                                 {"timings", {{{"stage", 1}, {"name", nasty}, {"wall_s", 1.0}}}}}
                                .dump());

  const auto html = page_of(run);

  EXPECT_EQ(count(html, "<script"), 2U);
  EXPECT_EQ(count(html, "</script"), 2U);
  EXPECT_THAT(html, Not(HasSubstr("<img")));
  EXPECT_THAT(html, Not(HasSubstr("<!--")));
  EXPECT_THAT(html, HasSubstr("&lt;img"));
}

TEST(Page, LetsNoTitleOutOfTheDataOfAComparison) {
  const test::SmallRun a(nasty);
  const test::SmallRun b("b");
  const UnitSystem units;

  const auto html = page({read_run(a.path(), units), read_run(b.path(), units)}, units);

  EXPECT_EQ(count(html, "</script"), 2U);
  const auto data = Json::parse(between(html, "id=\"data\">", "</script>"));
  EXPECT_EQ(data[0]["curves"][0]["label"], nasty + ", up");
}

TEST(Page, HasWarningsFirst) {
  const auto html = page_of(test::SmallRun());

  EXPECT_LT(html.find("mind the gap"), html.find("Key figures</h2>"));
}

TEST(Page, HasAPlaceForEachPlotOfItsData) {
  const auto html = page_of(test::SmallRun());

  const auto data = Json::parse(between(html, "id=\"data\">", "</script>"));
  EXPECT_GE(data.size(), 10U);
  EXPECT_EQ(count(html, "<figure>"), data.size());
  for (std::size_t i = 0; i < data.size(); ++i) {
    EXPECT_THAT(html, HasSubstr("data-plot=\"" + std::to_string(i) + "\""));
  }
}

TEST(Page, ShowsTheTimesOfStagesWhereTheyAreKnown) {
  const test::SmallRun run;
  EXPECT_THAT(page_of(run), Not(HasSubstr("Where the time went")));

  auto summary = Json::parse(read_text_file(run.path() / "summary.json"));
  summary["timings"] = Json::array({{{"stage", 2},
                                     {"name", "flow_ramp"},
                                     {"beads_s", 1.5},
                                     {"liquid_s", 2.0},
                                     {"wall_s", 4.0}}});
  run.write("summary.json", summary.dump());

  EXPECT_THAT(page_of(run), AllOf(HasSubstr("2, flow_ramp"), HasSubstr("width:37.50%")));
}

TEST(Page, OfACaseThatWasNotSimulatedSaysSo) {
  const test::SmallRun run;
  run.write("summary.json", R"({"title": "prepared"})");

  EXPECT_THAT(page_of(run), AllOf(HasSubstr("not simulated"), Not(HasSubstr("<figure>"))));
}

TEST(Page, TellsRunsOfOneTitleApartByTheirFolders) {
  const test::SmallRun a;
  const test::SmallRun b;
  const UnitSystem units;

  const auto html = page({read_run(a.path(), units), read_run(b.path(), units)}, units);

  EXPECT_THAT(html, AllOf(HasSubstr(a.path().filename().string() + ", up"),
                          HasSubstr(b.path().filename().string() + ", up")));
  EXPECT_THAT(html, HasSubstr("The cases have the same values."));
}

TEST(CaseWords, SpeakInLabUnits) {
  const test::SmallRun files;
  const UnitSystem units;
  const auto run = read_run(files.path(), units);

  const auto lines = case_lines(run, units);
  const auto steps = protocol_sentences(run, units);

  EXPECT_EQ(lines.at(0).text,
            "slice of a round column, inner diameter 4 mm, depth 0.9 mm (periodic), height 12 mm");
  EXPECT_EQ(lines.at(3).text, "water at 20 °C: 998.2 kg/m3, 1 mPa s");
  EXPECT_EQ(steps.at(0).text, "Settle to a bed of 8 mm");
  EXPECT_EQ(steps.at(1).text, "Repeat 1 times:");
  EXPECT_EQ(steps.at(1).parts.at(0).text, "Flow from 0 cm/h to 720 cm/h in 2 steps, each held 1 s");
  EXPECT_EQ(steps.at(1).parts.at(1).text, "Hold for 1 s at 360 cm/h");
}

TEST(CaseWords, TellHowABedIsPacked) {
  const test::SmallRun small;
  const UnitSystem units;
  auto run = read_run(small.path(), units);
  run.values["protocol"] = Json::parse(R"([
    {"step": "compress", "speed": "20 mm/min", "pressure": "1 bar", "flow": "100 cm/h", "friction": 0.5},
    {"step": "relax", "speed": "20 mm/min", "withdraw": true, "flow": "0 cm/h"},
    {"step": "flow_pack", "flow": "2210 cm/h", "steps": 10, "hold": "until steady", "hold_limit": "5 s",
     "compression": "20 %", "plunger_speed": "30 mm/min"},
    {"step": "cycle", "count": 10, "high": "0.75 RHL", "low": "0.05 RHL", "high_duration": "2 s",
     "low_duration": "until steady", "hold_limit": "5 s"},
    {"step": "store", "hold_limit": "5 s"}])");

  std::vector<std::string> texts;
  for (const auto& s : protocol_sentences(run, units)) texts.push_back(s.text);

  EXPECT_THAT(
      texts,
      testing::ElementsAre(
          "Plunger down at 20 mm/min to a pressure of 1 bar, friction 0.5, in a flow of 100 cm/h",
          "Plunger up at 20 mm/min, then out of the way",
          "Pack in a flow of 2210 cm/h, reached in 10 steps, each held until steady, 5 s at most, "
          "to a "
          "compression of 20 %; then the plunger is set down at 30 mm/min",
          "Cycle 10 times: 0.75 RHL for 2 s, 0.05 RHL until steady, 5 s at most",
          "Store without a flow until steady, 5 s at most"));
}

TEST(CaseWords, TellWhatDiffers) {
  const UnitSystem units;
  const test::SmallRun a("a", "soft");
  const test::SmallRun b("b", "stiff");

  const auto found = differences({read_run(a.path(), units), read_run(b.path(), units)});

  ASSERT_EQ(found.size(), 1U) << "titles do not count";
  EXPECT_EQ(found[0].key, "resin.name");
  EXPECT_THAT(found[0].values, ElementsAre("soft", "stiff"));
}

TEST(CaseWords, TellOtherProtocolsInWords) {
  const UnitSystem units;
  const test::SmallRun a("a", "soft");
  const test::SmallRun b("b", "soft");
  std::vector runs = {read_run(a.path(), units), read_run(b.path(), units)};
  runs[1].values["protocol"].push_back({{"step", "store"}, {"hold_limit", "5 s"}});

  EXPECT_FALSE(have_same_steps(runs));
  EXPECT_TRUE(differences(runs).empty());
  const auto table = difference_table(runs, units);
  EXPECT_THAT(table, HasSubstr("<li>Store without a flow"));
  EXPECT_EQ(table.find("protocol["), std::string::npos);
}

}  // namespace
}  // namespace packbed::report
