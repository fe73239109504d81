// SPDX-License-Identifier: BSD-3-Clause
#include "resin/resin.hpp"

#include <gtest/gtest.h>

namespace packbed::resin {
namespace {

Resin named(const std::string& name, std::vector<std::string> aliases = {}) {
  Resin resin;
  resin.name = name;
  resin.aliases = std::move(aliases);
  return resin;
}

TEST(Library, FindsByNameAndAliasInAnyCase) {
  Library library;
  library.resins = {named("Alpha", {"A"}), named("Beta")};

  EXPECT_EQ(library.find("alpha")->name, "Alpha");
  EXPECT_EQ(library.find("a")->name, "Alpha");
  EXPECT_EQ(library.find("BETA")->name, "Beta");
  EXPECT_EQ(library.find("gamma"), nullptr);
}

TEST(Library, LetsTheUsersResinsReplaceOurs) {
  Library ours;
  ours.resins = {named("Alpha"), named("Beta")};
  Library own;
  own.resins = {named("Beta", {"B"}), named("Gamma")};

  ours.add(own);

  EXPECT_EQ(ours.resins.size(), 3U);
  EXPECT_EQ(ours.resins.back().name, "Alpha");
  EXPECT_NE(ours.find("B"), nullptr);
  EXPECT_NE(ours.find("Gamma"), nullptr);
}

TEST(Library, FindsTheUsersAliasBeforeOurs) {
  Library ours;
  ours.resins = {named("Alpha", {"A"})};
  Library own;
  own.resins = {named("Omega", {"A"})};

  ours.add(own);

  EXPECT_EQ(ours.find("A")->name, "Omega");
  EXPECT_EQ(ours.find("Alpha")->name, "Alpha");
}

}  // namespace
}  // namespace packbed::resin
