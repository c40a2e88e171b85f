// SPDX-License-Identifier: GPL-3.0-or-later
// Every command that --help names, with whatever may stand behind it: it ends by itself, with a
// status that says what happened.
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::app::every_command_test {
namespace {

using test::isograsp;

/// Subcommands as the help of a command lists them; empty: it has none.
std::vector<std::string> subcommands_of(const std::string& command) {
  std::istringstream help(isograsp(command + " --help").out);
  std::vector<std::string> names;
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (line.starts_with("Subcommands:"))
      listed = true;
    else if (listed && line.starts_with("  ") && line.size() > 2 && line[2] != ' ')
      names.push_back(command + " " + line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

/// All commands, those with subcommands in front of these.
std::vector<std::string> all_commands() {
  std::vector<std::string> all;
  for (const std::string& command : subcommands_of("")) {
    all.push_back(command);
    for (const std::string& below : subcommands_of(command)) all.push_back(below);
  }
  return all;
}

TEST(EveryCommand, TellsItsUseAndRefusesWhatItDoesNotKnowWithStatusTwo) {
  const auto all = all_commands();
  EXPECT_GT(all.size(), 30U);
  for (const std::string& command : test::every(all)) {
    const auto help = isograsp(command + " --help");
    EXPECT_EQ(help.status, 0) << command << help.err;
    EXPECT_FALSE(help.out.empty()) << command;
    const auto unknown = isograsp(command + " --no-such-option");
    EXPECT_EQ(unknown.status, 2) << command << ": " << unknown.err;
    EXPECT_FALSE(unknown.err.empty()) << command;
  }
}

/// A signal would give -1, and who waits for ever is ended with 124.
TEST(EveryCommand, EndsByItselfWithAStatusWhateverStandsBehindIt) {
  const test::TemporaryFolder folder;
  const std::string absent = folder.path("absent/file");
  const std::string binary = folder.write("binary", std::string("\x00\xff\x1b[2J\n\n=1+1", 12));
  const test::Variable home("HOME", folder.path("HOME"));
  const test::Variable platform("QT_QPA_PLATFORM", "offscreen");
  const std::vector<std::string> behind{"",
                                        "'' ''",
                                        absent,
                                        absent + " " + absent,
                                        binary,
                                        binary + " " + binary,
                                        "--db " + absent,
                                        "--db " + binary,
                                        "--db " + folder.path("")};
  for (const std::string& command : test::every(all_commands())) {
    if (command == " gui" || command == " demo") continue;  // they would open windows
    for (const std::string& words : behind) {
      const auto done = test::run("timeout 60 \"" ISOGRASP_EXECUTABLE "\"" + command + " " + words);
      EXPECT_TRUE(done.status >= 0 && done.status <= 2)
          << command << " " << words << ": " << done.status << " " << done.err;
    }
  }
}

}  // namespace
}  // namespace isograsp::app::every_command_test
