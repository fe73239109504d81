// SPDX-License-Identifier: BSD-3-Clause
#include "core/file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/message_of.hpp"
#include "tests/support/temporary_folder.hpp"

namespace packbed {
namespace {

using testing::HasSubstr;

TEST(Files, ComeBackAsTheyWereWritten) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "größe.txt";

  write_text_file(path, "one\r\ntwo");

  EXPECT_EQ(read_text_file(path), "one\r\ntwo");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "größe.txt.part"));
}

TEST(Files, LoseTheirByteOrderMark) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_text_file(folder.file("a", "\xEF\xBB\xBFtext")), "text");
}

TEST(Files, SayWhyTheyCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::message_of([&] { read_text_file(folder.path() / "none"); }),
              HasSubstr("No such file"));
  EXPECT_THAT(test::message_of([&] { read_text_file(folder.path()); }), HasSubstr("a folder"));
}

TEST(Files, SayWhyTheyCannotBeWritten) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(test::message_of([&] { write_text_file(folder.path() / "none" / "a", "x"); }),
              HasSubstr("cannot be written (No such file"));
}

}  // namespace
}  // namespace packbed
