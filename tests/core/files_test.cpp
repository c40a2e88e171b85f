// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files.hpp"

#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp {
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

TEST(Files, TheInputIsNeverTheOutput) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.csv", "x");
  EXPECT_FALSE(check_different(path, folder.path("./a.csv")));
  EXPECT_TRUE(check_different(path, folder.path("b.csv")));
}

}  // namespace
}  // namespace isograsp
