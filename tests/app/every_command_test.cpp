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

/// Words of a kind, tried behind every command: each kind is a test of its own, so that they share
/// the processors.
enum class Behind { nothing, files, databases };
class EveryCommandBehind : public testing::TestWithParam<Behind> {
 protected:
  [[nodiscard]] std::vector<std::string> words() const {
    const std::string absent = folder_.path("absent/file");
    const std::string binary = folder_.write("binary", std::string("\x00\xff\x1b[2J\n\n=1+1", 12));
    switch (GetParam()) {
      case Behind::nothing: return {"", "'' ''", absent};
      case Behind::files: return {absent + " " + absent, binary, binary + " " + binary};
      case Behind::databases: break;
    }
    return {"--db " + absent, "--db " + binary, "--db " + folder_.path("")};
  }
  const test::TemporaryFolder folder_;
};

/// A signal would give -1, and who waits for ever is ended with 124.
TEST_P(EveryCommandBehind, EndsByItselfWithAStatus) {
  const test::Variable home("HOME", folder_.path("HOME"));
  const test::Variable platform("QT_QPA_PLATFORM", "offscreen");
  const auto behind = words();
  for (const std::string& command : test::every(all_commands())) {
    if (command == " gui" || command == " demo") continue;  // they would open windows
    for (const std::string& typed : test::every(behind)) {
      const auto done = test::run("timeout 60 \"" ISOGRASP_EXECUTABLE "\"" + command + " " + typed);
      EXPECT_TRUE(done.status >= 0 && done.status <= 2)
          << command << " " << typed << ": " << done.status << " " << done.err;
    }
  }
}
std::string name_of_words(const testing::TestParamInfo<Behind>& of) {
  if (of.param == Behind::nothing) return "Nothing";
  return of.param == Behind::files ? "Files" : "Databases";
}
INSTANTIATE_TEST_SUITE_P(Words, EveryCommandBehind,
                         testing::Values(Behind::nothing, Behind::files, Behind::databases),
                         name_of_words);

}  // namespace
}  // namespace isograsp::app::every_command_test
