// SPDX-License-Identifier: BSD-3-Clause
// Runs that are killed, stopped and resumed, as a user sees them.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "core/random.hpp"
#include "io/checkpoint.hpp"
#include "io/checkpoint_seal.hpp"
#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

namespace fs = std::filesystem;
using test::run_packbed;
using test::run_shell;
using testing::HasSubstr;

const std::string small_bed = R"(
title = "A small bed"
[column]
shape = "slice"
inner_diameter = "1.2 mm"
slice_depth = "0.5 mm"
height = "8 mm"
[resin]
name = "CM Sepharose 6FF"
youngs_modulus = "0.3 MPa"
coarse_grain = 3
[liquid]
[beads]
count = 50
[[protocol]]
step = "settle"
[[protocol]]
step = "tap"
amplitude = "20 um"
frequency = "200 Hz"
count = 1
[[protocol]]
step = "run"
duration = "20 ms"
[output]
checkpoint_interval = "20 ms"
frame_interval = "20 ms"
beads_csv = true
)";

/// 60 grains that settle.
const std::string small_column = R"(
[column]
shape = "slice"
inner_diameter = "1.2 mm"
slice_depth = "0.5 mm"
height = "4 mm"
[resin]
name = "CM Sepharose 6FF"
youngs_modulus = "0.3 MPa"
coarse_grain = 3
[liquid]
[beads]
count = 60
[[protocol]]
step = "settle"
)";

/// They in a flow that goes up in three plateaus and is then held.
const std::string bed_in_a_flow = small_column + R"(
[[protocol]]
step = "flow_ramp"
to = "600 cm/h"
steps = 3
hold = "60 ms"
[[protocol]]
step = "hold"
duration = "60 ms"
[output]
checkpoint_interval = "20 ms"
frame_interval = "40 ms"
)";

/// The same grains, packed by a flow and the plunger, loaded, and released.
const std::string packed_bed = small_column + R"(
[[protocol]]
step = "flow_pack"
flow = "600 cm/h"
steps = 2
hold = "40 ms"
compression = "3 %"
plunger_speed = "5 mm/s"
[[protocol]]
step = "compress"
speed = "5 mm/s"
further_compression = "4 %"
[[protocol]]
step = "cycle"
count = 2
high_duration = "40 ms"
low_duration = "40 ms"
[[protocol]]
step = "relax"
speed = "5 mm/s"
withdraw = true
[output]
interval = "5 ms"
checkpoint_interval = "20 ms"
)";

/// Every file of a run but those that tell of wall time.
std::map<std::string, std::string> results(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto name = fs::relative(entry.path(), folder).string();
    if (name == "report.html") continue;  // made of the other files; it tells the wall time
    if (!entry.is_regular_file() || name == "run.log" || name == "checkpoints/timings.json")
      continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    files[name] = {std::istreambuf_iterator<char>(stream), {}};
  }
  auto summary = nlohmann::ordered_json::parse(files.at("summary.json"));
  summary.erase("wall_time_s");
  summary.erase("timings");
  files["summary.json"] = summary.dump();
  return files;
}

void expect_same(const fs::path& a, const fs::path& b, const std::set<std::string>& but = {}) {
  const auto one = results(a);
  const auto other = results(b);
  for (const auto& [name, content] : one) {
    if (std::ranges::any_of(but, [&](const auto& begin) { return name.starts_with(begin); })) {
      continue;
    }
    ASSERT_TRUE(other.contains(name)) << name;
    EXPECT_TRUE(other.at(name) == content) << name;
  }
  if (!but.empty()) return;
  for (const auto& [name, content] : other) EXPECT_TRUE(one.contains(name)) << name;
}

class Resume : public testing::Test {
 protected:
  explicit Resume(std::string text = small_bed) : text_(std::move(text)) {}

  void SetUp() override {
    case_ = folder_.file("bed.toml", text_);
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(run("whole").code, 0);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }

  [[nodiscard]] fs::path in(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] std::string call(const std::string& name, const std::string& options) const {
    return fmt::format("ASAN_OPTIONS=detect_leaks=0 {} run {} -o {} {}", PACKBED_PROGRAM,
                       case_.string(), in(name).string(), options);
  }
  [[nodiscard]] test::Outcome run(const std::string& name,
                                  const std::string& options = "-n 1") const {
    return run_shell(call(name, options), PACKBED_SOURCE_DIR);
  }
  /// The same, killed after some seconds.
  [[nodiscard]] test::Outcome killed(const std::string& name,
                                     double seconds,
                                     const std::string& options) const {
    const auto line = call(name, options);
    const auto program = line.find(PACKBED_PROGRAM);
    return run_shell(fmt::format("{}timeout -s KILL {:.3f} {}", line.substr(0, program), seconds,
                                 line.substr(program)),
                     PACKBED_SOURCE_DIR);
  }
  /// The same, sent a signal as soon as there is a checkpoint.
  [[nodiscard]] test::Outcome stopped(const std::string& name,
                                      const std::string& signal,
                                      const std::string& options) const {
    const auto checkpoints = (in(name) / "checkpoints").string();
    return run_shell(
        fmt::format(
            "{} & run=$!; until ls {}/*.h5 >/dev/null 2>&1 || ! kill -0 $run; do sleep 0.02; "
            "done; kill -{} $run; wait $run",
            call(name, options), checkpoints, signal),
        PACKBED_SOURCE_DIR);
  }
  [[nodiscard]] bool has_checkpoint(const std::string& name) const {
    std::error_code none;
    return std::ranges::any_of(fs::directory_iterator(in(name) / "checkpoints", none),
                               [](const auto& entry) { return entry.path().extension() == ".h5"; });
  }

  std::string text_;
  test::TemporaryFolder folder_;
  fs::path case_;
  double seconds_ = 0.0;
};

TEST_F(Resume, AfterBeingKilledAtRandomInstantsGivesTheSameFiles) {
  std::string how = "--overwrite -n 1";
  for (std::uint64_t kill = 0; kill < 4 && !fs::exists(in("killed") / "report.html"); ++kill) {
    const double share = 0.1 + 0.5 * uniform(41, Stream::bead_position, kill);
    (void)killed("killed", share * seconds_, how);
    if (has_checkpoint("killed")) how = "--resume -n 1";
  }
  if (!fs::exists(in("killed") / "report.html")) {
    const auto last = run("killed", how);
    ASSERT_EQ(last.code, 0) << last.err;
  }
  expect_same(in("whole"), in("killed"));
}

// Killed after the last checkpoint, before those before it were taken away.
TEST_F(Resume, AtItsVeryEndTakesEarlierCheckpointsAway) {
  ASSERT_EQ(stopped("end", "TERM", "-n 1").code, 4);
  fs::copy(in("end") / "checkpoints", in("earlier"));
  ASSERT_EQ(run("end", "--resume -n 1").code, 0);
  const auto copied = fs::copy_options::skip_existing;
  fs::copy(in("earlier"), in("end") / "checkpoints", copied);
  fs::remove(in("end") / "summary.json");
  ASSERT_EQ(run("end", "--resume -n 1").code, 0);
  expect_same(in("whole"), in("end"));
}

class ResumeInAFlow : public Resume {
 protected:
  ResumeInAFlow() : Resume(bed_in_a_flow) {}
};

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

nlohmann::json frames_in(const fs::path& list) {
  return nlohmann::json::parse(text_of(list)).at("files");
}

TEST_F(ResumeInAFlow, AfterBeingKilledGivesTheSameFiles) {
  std::string how = "--overwrite -n 1";
  int resumed = 0;
  for (int kill = 0; kill < 5 && !fs::exists(in("killed") / "report.html"); ++kill) {
    (void)killed("killed", (kill == 0 ? 0.8 : 0.3) * seconds_, how);
    if (!has_checkpoint("killed")) continue;
    how = "--resume -n 1";
    ++resumed;
  }
  if (!fs::exists(in("killed") / "report.html")) {
    const auto last = run("killed", how);
    ASSERT_EQ(last.code, 0) << last.err;
  }
  EXPECT_GT(resumed, 0);
  expect_same(in("whole"), in("killed"));
}

class ResumeWhilePacked : public Resume {
 protected:
  ResumeWhilePacked() : Resume(packed_bed) {}
};

TEST_F(ResumeWhilePacked, AfterBeingKilledGivesTheSameFiles) {
  std::string how = "--overwrite -n 1";
  int resumed = 0;
  for (int kill = 0; kill < 6 && !fs::exists(in("killed") / "report.html"); ++kill) {
    (void)killed("killed", (kill == 0 ? 0.6 : 0.25) * seconds_, how);
    if (!has_checkpoint("killed")) continue;
    how = "--resume -n 1";
    ++resumed;
  }
  if (!fs::exists(in("killed") / "report.html")) {
    const auto last = run("killed", how);
    ASSERT_EQ(last.code, 0) << last.err;
  }
  EXPECT_GT(resumed, 0);
  expect_same(in("whole"), in("killed"));
}

TEST_F(ResumeWhilePacked, TellsWhatThePlungerDid) {
  const auto log = text_of(in("whole") / "run.log");
  for (const auto* words :
       {"stage 3: flow_pack, plunger at", "(compression 0.0300)", "stage 5: compress, plunger at",
        "(compression 0.0700)", "stage 6: cycle high, 450 cm/h", "stage 9: cycle low, 30 cm/h",
        "stage 10: relax, plunger at 4.0000 mm"}) {
    EXPECT_THAT(log, HasSubstr(words));
  }
  const auto header = text_of(in("whole") / "series.csv");
  EXPECT_THAT(header, HasSubstr("plunger_position_m,plunger_compression,plunger_force_N"));
}

TEST_F(ResumeInAFlow, TakesAwayWhatIsLaterThanTheCheckpoint) {
  ASSERT_EQ(stopped("early", "TERM", "-n 1").code, 4);  // while it settles
  ASSERT_FALSE(fs::exists(in("early") / "plateaus.csv"));
  for (const auto* later :
       {"plateaus.csv", "frames/liquid_000077.hdf", "frames/liquid.hdf.series"}) {
    fs::copy_file(in("whole") / "plateaus.csv", in("early") / later);
  }
  std::ofstream(in("early") / "frames" / "liquid.hdf.series")
      << R"({"files": [{"name": "liquid_000077.hdf", "time": 1}]})";
  ASSERT_EQ(run("early", "--resume -n 1").code, 0);
  expect_same(in("whole"), in("early"));
}

TEST_F(ResumeInAFlow, WritesPlateausProfilesAndFramesOfTheLiquid) {
  const auto rows = text_of(in("whole") / "plateaus.csv");
  EXPECT_EQ(std::ranges::count(rows, '\n'), 5);  // header, three plateaus, a hold
  for (const auto* name : {"plateau_z_000001.csv", "plateau_x_000004.csv"}) {
    EXPECT_TRUE(fs::exists(in("whole") / "profiles" / name)) << name;
  }
  // A frame of the liquid has the number and the time of that of the beads.
  const auto beads = frames_in(in("whole") / "frames" / "beads.hdf.series");
  const auto liquid = frames_in(in("whole") / "frames" / "liquid.hdf.series");
  ASSERT_GT(liquid.size(), 3U);
  ASSERT_GT(beads.size(), liquid.size());
  for (std::size_t k = 0; k < liquid.size(); ++k) {
    const auto& bead = beads[beads.size() - liquid.size() + k];
    EXPECT_EQ("beads" + liquid[k]["name"].get<std::string>().substr(6), bead["name"]);
    EXPECT_EQ(liquid[k]["time"], bead["time"]);
    EXPECT_TRUE(fs::exists(in("whole") / "frames" / liquid[k]["name"].get<std::string>()));
  }
}

TEST_F(ResumeInAFlow, TellsWhereTheTimeWent) {
  const auto summary = nlohmann::json::parse(text_of(in("whole") / "summary.json"));
  const auto& timings = summary.at("timings");
  ASSERT_EQ(timings.size(), 3U);
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& t = timings[k];
    EXPECT_EQ(t["stage"], k + 1);
    EXPECT_EQ(t["liquid_s"].get<double>() > 0.0, k > 0);
    EXPECT_EQ(t["coupling_s"].get<double>() > 0.0, k > 0);
    EXPECT_GT(t["beads_s"], 0.0);
    EXPECT_GT(t["outputs_s"], 0.0);
    double parts = 0.0;
    for (const auto* part : {"beads_s", "coupling_s", "liquid_s", "outputs_s"}) {
      parts += t[part].get<double>();
    }
    EXPECT_LE(parts, t["wall_s"].get<double>() * (1.0 + 1e-9));
    sum += t["wall_s"].get<double>();
  }
  EXPECT_EQ(timings[0]["name"], "settle");
  EXPECT_LE(sum, summary["wall_time_s"].get<double>());
  EXPECT_THAT(text_of(in("whole") / "run.log"), HasSubstr("stage 2 took "));

  // What was spent before an interruption counts: more than the part after it took.
  ASSERT_EQ(stopped("two", "TERM", "-n 1").code, 4);
  const auto before = nlohmann::json::parse(text_of(in("two") / "checkpoints" / "timings.json"));
  ASSERT_EQ(run("two", "--resume -n 1").code, 0);
  const auto after = nlohmann::json::parse(text_of(in("two") / "summary.json")).at("timings");
  EXPECT_GT(after[0]["wall_s"], before[0]["wall_s"]);
  EXPECT_GT(before[0]["wall_s"], 0.0);
}

TEST_F(Resume, AfterASignalItTellsHowToGoOn) {
  const auto first = stopped("stopped", "TERM", "-n 1");
  ASSERT_EQ(first.code, 4) << first.err;
  EXPECT_THAT(first.err, HasSubstr("checkpoint"));
  EXPECT_THAT(first.err, HasSubstr("--resume"));
  EXPECT_FALSE(fs::exists(in("stopped") / "summary.json"));
  ASSERT_EQ(run("stopped", "--resume -n 1").code, 0);
  expect_same(in("whole"), in("stopped"));

  const auto again = run("stopped", "--resume -n 1");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.err, HasSubstr("nothing to resume"));
}

TEST_F(Resume, OnTwoRanksAfterAnInterrupt) {
  const auto first = stopped("two", "INT", "-n 2");
  ASSERT_EQ(first.code, 4) << first.err;
  ASSERT_EQ(run("two", "--resume -n 1").code, 0);        // and on another number of ranks
  expect_same(in("whole"), in("two"), {"checkpoints"});  // they count new shares
}

TEST_F(Resume, WithoutCheckpointsTheResultsAreTheSame) {
  auto text = std::string(small_bed);
  text.replace(text.find("\"20 ms\"\nframe"), 7, "\"none\"");
  case_ = folder_.file("bed.toml", text);
  ASSERT_EQ(run("without").code, 0);
  expect_same(in("whole"), in("without"), {"checkpoints", "case.toml", "summary.json"});
}

TEST_F(Resume, RefusesAnotherCaseAndNamesTheKey) {
  ASSERT_EQ(stopped("other", "TERM", "-n 1").code, 4);
  auto text = std::string(small_bed);
  text.replace(text.find("coarse_grain = 3"), 16, "coarse_grain = 3\nfriction = 0.2");
  case_ = folder_.file("bed.toml", text);
  const auto refused = run("other", "--resume -n 1");
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.err, HasSubstr("resin.friction was 0.1, and is 0.2 now"));
}

TEST_F(Resume, RefusesWhatIsDamagedOrMissing) {
  ASSERT_EQ(stopped("damaged", "TERM", "-n 1").code, 4);
  for (const auto& entry : fs::directory_iterator(in("damaged") / "checkpoints")) {
    std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(fs::file_size(entry.path()) / 2));
    file.put('\x55');
    file.put('\xaa');
  }
  const auto altered = run("damaged", "--resume -n 1");
  EXPECT_EQ(altered.code, 3);
  EXPECT_THAT(altered.err, HasSubstr("altered"));
  fs::remove_all(in("damaged") / "checkpoints");
  const auto missing = run("damaged", "--resume -n 1");
  EXPECT_EQ(missing.code, 1);
  EXPECT_THAT(missing.err, HasSubstr("no checkpoint"));
  EXPECT_EQ(run_packbed("run --resume --overwrite x.toml").code, 1);
}

// A build whose stages save other values gives the same version and format: names tell them apart.
TEST_F(Resume, RefusesACheckpointOfAnotherBuild) {
  int number = 0;
  for (const std::string key : {R"("stage_state":{")", R"("outputs":{")", R"("warn)", R"("ca)"}) {
    const auto name = fmt::format("other_build_{}", number++);
    ASSERT_EQ(stopped(name, "TERM", "-n 1").code, 4);
    for (const auto& entry : fs::directory_iterator(in(name) / "checkpoints")) {
      if (entry.path().extension() != ".h5") continue;
      auto bytes = read_text_file(entry.path());
      const auto place = bytes.find(key);
      ASSERT_NE(place, std::string::npos);
      bytes[place + key.size()] = '#';
      std::ofstream(entry.path(), std::ios::binary) << bytes;
      io::seal(entry.path(), io::checkpoint_format);
    }
    // What the first rank alone reads must not leave the other one waiting.
    const auto on_two =
        run_shell("timeout 60 env " + call(name, "--resume -n 2"), PACKBED_SOURCE_DIR);
    EXPECT_EQ(on_two.code, 3) << key;
    EXPECT_THAT(on_two.err, HasSubstr("another build of packbed")) << key;
    const auto refused = run(name, "--resume -n 1");
    EXPECT_EQ(refused.code, 3) << key;
    EXPECT_THAT(refused.err, HasSubstr("another build of packbed")) << key;
    EXPECT_EQ(std::ranges::count(refused.err, '\n'), 1) << key;
  }
}

}  // namespace
}  // namespace packbed
