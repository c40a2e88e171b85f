// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files.hpp"

#include <csignal>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/csv.hpp"
#include "tests/support/files_below.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::files_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

TEST(FileWriter, AnUncommittedFileLeavesNothingBehind) {
  const TemporaryFolder folder;
  {
    auto writer = FileWriter::create(folder.path("half.csv"));
    ASSERT_TRUE(writer);
    writer->write("t_s\n");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FileWriter, AnOlderFileStaysUntilTheNewOneIsComplete) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv", "old");
  {
    auto writer = FileWriter::create(path);
    ASSERT_TRUE(writer);
    writer->write("new");
    EXPECT_EQ(read_text(path).value(), "old");
    ASSERT_TRUE(writer->commit());
  }
  EXPECT_EQ(read_text(path).value(), "new");
}

TEST(FileWriter, ALinkStaysALink) {
  const TemporaryFolder folder;
  const auto target = folder.write("target.csv", "old");
  fs::create_symlink(target, folder.path("link.csv"));
  ASSERT_TRUE(write_text(folder.path("link.csv"), "new"));
  EXPECT_TRUE(fs::is_symlink(folder.path("link.csv")));
  EXPECT_EQ(read_text(target).value(), "new");
}

TEST(FileWriter, APipeIsWrittenToAndNotReplaced) {
  const TemporaryFolder folder;
  const auto pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string received;
  std::thread reader([&] {
    std::ifstream in(pipe);
    std::getline(in, received);
  });
  EXPECT_TRUE(write_text(pipe, "a line\n"));
  reader.join();
  EXPECT_EQ(received, "a line");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

/// The permission bits of a file.
int mode_of(const std::string& path) {
  return static_cast<int>(fs::status(path).permissions());
}

std::string leftover_of(const TemporaryFolder& folder) {
  return folder.path(".a.csv.part");
}

TEST(FileWriter, ANewFileIsForItsOwnerOnlyAndAnOldOneKeepsItsPermissions) {
  const TemporaryFolder folder;
  const mode_t before = umask(0);
  ASSERT_TRUE(write_text(folder.path("a.csv"), "new"));
  EXPECT_EQ(mode_of(folder.path("a.csv")), 0600);
  fs::permissions(folder.path("a.csv"), fs::perms{0640});
  ASSERT_TRUE(write_text(folder.path("a.csv"), "newer"));
  EXPECT_EQ(mode_of(folder.path("a.csv")), 0640);
  umask(before);
}

TEST(FileWriter, ALinkThatWaitsUnderTheTemporaryNameLeadsNowhere) {
  const TemporaryFolder folder;
  const auto victim = folder.write("victim", "precious");
  fs::create_symlink(victim, leftover_of(folder));
  // The name that older versions used.
  fs::create_symlink(victim, folder.path("a.csv.part-" + std::to_string(getpid())));
  ASSERT_TRUE(write_text(folder.path("a.csv"), "new"));
  EXPECT_EQ(test::read_file(victim), "precious");
  EXPECT_EQ(test::read_file(folder.path("a.csv")), "new");
  EXPECT_FALSE(fs::is_symlink(folder.path("a.csv")));
}

TEST(FileWriter, WhatAKilledWriterLeftIsGoneAfterTheNext) {
  const TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    auto writer = FileWriter::create(folder.path("a.csv"));
    if (writer) writer->write(std::string(1 << 20, 'x'));
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_FALSE(fs::is_empty(folder.path())) << "the kill came too late";
  ASSERT_TRUE(write_text(folder.path("a.csv"), "whole"));
  const std::vector<std::string> there{test::files_below(folder.path())};
  EXPECT_EQ(there, std::vector<std::string>{"a.csv"});
  EXPECT_EQ(test::read_file(folder.path("a.csv")), "whole");
}

TEST(FileWriter, TwoWritersOfOneFileDoNotMixTheirWords) {
  const TemporaryFolder folder;
  auto first = FileWriter::create(folder.path("a.csv"));
  ASSERT_TRUE(first);
  const auto second = FileWriter::create(folder.path("a.csv"));
  ASSERT_FALSE(second);
  EXPECT_NE(second.error().message().find("is being written by another program"),
            std::string::npos);
  first->write("first");
  ASSERT_TRUE(first->commit());
  EXPECT_EQ(test::read_file(folder.path("a.csv")), "first");
  EXPECT_TRUE(write_text(folder.path("a.csv"), "second"));
}

TEST(FileWriter, AFullDiskIsAnErrorAndTheOldFileStays) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv", "old");
  const pid_t child = fork();
  if (child == 0) {
    const rlimit few{1 << 17, 1 << 17};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &few);
    _exit(write_text(path, std::string(1 << 18, 'x')) ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(test::read_file(path), "old");
  EXPECT_EQ(test::files_below(folder.path()), std::vector<std::string>{"a.csv"});
}

/// Every reader of this folder, given something that never answers: had it waited, so would this.
TEST(InputFile, APipeADeviceAndAFolderAreRefusedAtOnce) {
  const TemporaryFolder folder;
  const auto pipe = folder.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/zero"), std::string("/dev/tty")})
    for (const Error& error :
         {read_text(path).error(), CsvReader::open(path).error(), read_signals(path).error()}) {
      EXPECT_EQ(error.file, path);
      EXPECT_NE(english(error.what).find(path == "/dev/tty" ? "" : "is not a file"),
                std::string::npos)
          << error.message();
    }
  EXPECT_EQ(english(read_text(folder.path()).error().what), "is a folder");
  EXPECT_EQ(english(CsvReader::open(folder.path()).error().what), "is a folder");
  EXPECT_TRUE(CsvReader::open(folder.write("a.csv", "t_s\n")));
}

TEST(Files, TheInputIsNeverTheOutput) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv", "x");
  EXPECT_FALSE(check_different(path, folder.path("./a.csv")));
  EXPECT_TRUE(check_different(path, folder.path("b.csv")));
}

}  // namespace
}  // namespace isograsp::files_test
