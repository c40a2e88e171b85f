// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of `isograsp`: subcommands, their options, and what each of them does. Commands
// are declared through these handles. Only command_line.cpp includes the parsing library: its
// headers take longer to compile than any command.
//
// A handle is a pointer: copy it freely while the CommandLine lives. Variables that options fill
// are held by reference and must live until parse() has returned; the action keeps them (by a
// shared_ptr) until it has run. A mistake in a declaration, such as a name given twice, throws.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "hand/finger.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace isograsp::app {

/// What a subcommand does, or why it could not.
using Action = std::function<Result<void>()>;

/// One option or flag. Each call adds a condition for what is typed, or a word to its line in the
/// help.
class Option {
 public:
  Option required();
  /// A number from `least` to `most`, both of them included.
  Option range(int least, int most);
  Option range(double least, double most);
  /// A number above zero.
  Option positive();
  /// One of these words.
  Option one_of(std::initializer_list<const char*> words);
  /// `objection` says what is wrong with the text, or nothing; the help does not mention it.
  Option check(std::function<std::string(const std::string& text)> objection);
  /// May be given only together with the other one.
  Option needs(Option other);
  /// May not be given together with the other one.
  Option excludes(Option other);
  /// The word that stands for its value in the help, in place of TEXT, INT or FLOAT.
  Option type(const char* word);
  /// The help tells the value that the variable has now.
  Option shows_default();

 private:
  friend class OptionGroup;
  explicit Option(CLI::Option* option) : option_(option) {}
  CLI::Option* option_;
};

/// Options and flags that belong together.
class OptionGroup {
 public:
  /// `--name VALUE` or `--name=VALUE`; a name without dashes is a positional argument. What is
  /// typed goes into the variable; without it the variable stays as it is.
  Option option(const std::string& name, std::string& value, const std::string& help);
  /// One or more words, and the option may be given more than once.
  Option option(const std::string& name, std::vector<std::string>& values, const std::string& help);
  Option option(const std::string& name, int& value, const std::string& help);
  Option option(const std::string& name, std::uint64_t& value, const std::string& help);
  Option option(const std::string& name, double& value, const std::string& help);
  Option option(const std::string& name, std::optional<double>& value, const std::string& help);
  /// right or left.
  Option option(const std::string& name, std::optional<Hand>& hand, const std::string& help);
  /// `--name` alone: true.
  Option flag(const std::string& name, bool& value, const std::string& help);

 private:
  friend class Subcommand;
  explicit OptionGroup(CLI::App* group) : group_(group) {}
  CLI::App* group_;
};

/// A word that says what is to be done, with its options; it may have subcommands of its own.
class Subcommand : public OptionGroup {
 public:
  Subcommand subcommand(const std::string& name, const std::string& help);
  /// It does nothing by itself: exactly one of its subcommands must follow.
  void requires_subcommand();
  /// Options of which exactly one must be given; the help shows them under the name of the group.
  OptionGroup exactly_one(const std::string& group);
  /// The last lines of its help.
  void footer(const std::string& text);
  /// What CommandLine::parse() answers if the words name this subcommand.
  void runs(Action action);

 private:
  friend class CommandLine;
  Subcommand(CLI::App* command, Action* chosen) : OptionGroup(command), chosen_(chosen) {}
  Action* chosen_;
};

/// All subcommands of the program.
class CommandLine {
 public:
  /// `version` is the line that --version prints, `footer` the last of the help.
  CommandLine(const std::string& description, const std::string& version,
              const std::string& footer);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Subcommand subcommand(const std::string& name, const std::string& help);
  /// Fills the variables and answers what is to be done, an empty action if no subcommand is named.
  /// --help and --version are printed here and leave nothing to do. Errors are those of the user.
  [[nodiscard]] Result<Action> parse(int argc, const char* const* argv);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace isograsp::app
