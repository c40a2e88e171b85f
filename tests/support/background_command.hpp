// SPDX-License-Identifier: GPL-3.0-or-later
// A command that runs beside the test, as a user would start it in another terminal.
#pragma once

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {

/// Ends by itself: whoever made it waits for that.
class BackgroundCommand {
 public:
  /// `line`: for the shell; quote what needs it.
  explicit BackgroundCommand(const std::string& line) {
    const std::string command = "{ " + line + " >" + folder_.path("out") + " 2>" +
                                folder_.path("err") + " </dev/null; echo $? >" +
                                folder_.path("part") + "; mv " + folder_.path("part") + " " +
                                folder_.path("status") + "; } &";
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  [[nodiscard]] bool has_ended() const { return std::filesystem::exists(folder_.path("status")); }
  /// Exit status; -1 while it runs.
  [[nodiscard]] int status() const {
    int status = -1;
    std::ifstream(folder_.path("status")) >> status;
    return status;
  }
  [[nodiscard]] std::string out() const { return read_file(folder_.path("out")); }
  [[nodiscard]] std::string err() const { return read_file(folder_.path("err")); }
  /// Until it is so, or the command has ended: then false.
  [[nodiscard]] bool wait_until(const std::function<bool()>& so) const {
    while (!so()) {
      if (has_ended()) return so();
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }
  void wait_for_end() const {
    (void)wait_until([] { return false; });
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace isograsp::test
