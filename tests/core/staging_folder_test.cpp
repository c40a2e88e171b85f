// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/staging_folder.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::staging_folder_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::string staging_of(const std::string& target) {
  return fs::path(target).parent_path() / ("." + fs::path(target).filename().string() + ".making");
}

TEST(StagingFolder, IsForItsOwnerOnlyAndGoesWithAllThatIsInIt) {
  const TemporaryFolder folder;
  const std::string target = folder.path("clinic.db");
  {
    const auto staging = StagingFolder::beside(target);
    ASSERT_TRUE(staging);
    EXPECT_EQ(staging->path(), staging_of(target));
    EXPECT_EQ(fs::status(staging->path()).permissions(), fs::perms::owner_all);
    std::ofstream(staging->file()) << "half";
    std::ofstream(staging->file() + "-journal") << "half";
  }
  EXPECT_TRUE(fs::is_empty(folder.path("")));
}

TEST(StagingFolder, WhatAKilledProgramLeftIsGoneWithTheNext) {
  const TemporaryFolder folder;
  const std::string target = folder.path("out") + "/";  // as a shell completes the name of a folder
  const pid_t child = fork();
  if (child == 0) {
    const auto staging = StagingFolder::beside(target);
    fs::create_directories(staging->file() + "/deep");
    std::ofstream(staging->file() + "/deep/left.csv") << "of a patient";
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(fs::exists(staging_of(folder.path("out")) + "/out/deep/left.csv"));
  {
    const auto staging = StagingFolder::beside(target);
    ASSERT_TRUE(staging);
    EXPECT_TRUE(fs::is_empty(staging->path()));
  }
  EXPECT_TRUE(fs::is_empty(folder.path("")));
}

TEST(StagingFolder, TwoProgramsDoNotMakeOneFileAtOnce) {
  const TemporaryFolder folder;
  const auto first = StagingFolder::beside(folder.path("a"));
  ASSERT_TRUE(first);
  std::ofstream(first->file()) << "of the first";
  const auto second = StagingFolder::beside(folder.path("a"));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find("is being written by another program"),
            std::string::npos);
  EXPECT_TRUE(fs::exists(first->file()));
  EXPECT_TRUE(StagingFolder::beside(folder.path("b")));
}

TEST(StagingFolder, ALinkInItsPlaceLeadsNowhere) {
  const TemporaryFolder folder;
  const std::string victim = folder.path("victim");
  fs::create_directory(victim);
  std::ofstream(victim + "/precious") << "precious";
  fs::create_symlink(victim, staging_of(folder.path("a")));
  {
    const auto staging = StagingFolder::beside(folder.path("a"));
    ASSERT_TRUE(staging);
    EXPECT_FALSE(fs::is_symlink(staging->path()));
  }
  EXPECT_TRUE(fs::exists(victim + "/precious"));
}

TEST(StagingFolder, AFolderThatIsNotThereIsAnError) {
  const auto staging = StagingFolder::beside("/nowhere/clinic.db");
  ASSERT_FALSE(staging);
  EXPECT_EQ(staging.error().file, "/nowhere/clinic.db");
}

}  // namespace
}  // namespace isograsp::staging_folder_test
