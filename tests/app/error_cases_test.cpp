// SPDX-License-Identifier: BSD-3-Clause
// cases/errors/: each wrong case says in its first line what the program must answer.
#include <algorithm>
#include <filesystem>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.hpp"

namespace packbed {
namespace {

const std::filesystem::path folder = std::filesystem::path(PACKBED_SOURCE_DIR) / "cases/errors";
constexpr std::string_view mark = "# says: ";

std::vector<std::string> wrong_cases() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

class WrongCase : public testing::TestWithParam<std::string> {};

TEST_P(WrongCase, IsRefusedInOneLineAsItSays) {
  const auto name = GetParam() + ".toml";
  const auto text = read_text_file(folder / name);
  ASSERT_TRUE(text.starts_with(mark)) << "the first line must be \"" << mark << "...\"";
  const auto expected = text.substr(mark.size(), text.find('\n') - mark.size());

  const auto check = test::run_packbed("check " + name, folder);

  EXPECT_EQ(check.err, "packbed: " + expected + "\n");
  EXPECT_EQ(check.out, "");
  EXPECT_EQ(check.code, 1);
}

INSTANTIATE_TEST_SUITE_P(CasesErrors,
                         WrongCase,
                         testing::ValuesIn(wrong_cases()),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace packbed
