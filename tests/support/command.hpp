// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program as a user would: a command line in a shell, its output and its exit status.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>

#include "tests/support/temporary_folder.hpp"

namespace isograsp::test {

struct CommandResult {
  int status = -1;
  std::string out;
  std::string err;
};

/// A command line for the shell: quote what needs it.
inline CommandResult run(const std::string& line) {
  const TemporaryFolder folder;
  const std::string command =
      line + " >" + folder.path("out") + " 2>" + folder.path("err") + " </dev/null";
  const int status = std::system(command.c_str());
  const auto text = [&folder](const char* name) {
    std::ifstream in(folder.path(name));
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
  };
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text("out"), text("err")};
}

/// `arguments` go to the shell behind the executable. It speaks English, whatever the desktop does.
inline CommandResult isograsp(const std::string& arguments) {
  return run(std::string("LC_ALL=C.UTF-8 \"" ISOGRASP_EXECUTABLE "\" ") + arguments);
}

}  // namespace isograsp::test
