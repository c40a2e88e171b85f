// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.hpp"

#include <cmath>
#include <cstdlib>
#include <utility>

#include <CLI/CLI.hpp>

namespace isograsp::app {

namespace {

/// "nan" and "inf" are numbers to the parsing library, and no bound catches the first of them.
std::string not_finite(const std::string& text) {
  return std::isfinite(std::strtod(text.c_str(), nullptr)) ? "" : text + " is no finite number";
}

}  // namespace

Option Option::required() {
  option_->required();
  return *this;
}

Option Option::range(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option Option::range(double least, double most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

Option Option::positive() {
  static const CLI::Validator kAboveZero(
      [](const std::string& text) {
        return std::strtod(text.c_str(), nullptr) > 0.0 ? "" : text + " is not above zero";
      },
      "POSITIVE");
  option_->check(kAboveZero);
  return *this;
}

Option Option::one_of(std::initializer_list<const char*> words) {
  option_->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
  return *this;
}

Option Option::check(std::function<std::string(const std::string& text)> objection) {
  option_->check(std::move(objection));
  return *this;
}

Option Option::needs(Option other) {
  option_->needs(other.option_);
  return *this;
}

Option Option::excludes(Option other) {
  option_->excludes(other.option_);
  return *this;
}

Option Option::type(const char* word) {
  option_->type_name(word);
  return *this;
}

Option Option::shows_default() {
  option_->capture_default_str();
  return *this;
}

Option OptionGroup::option(const std::string& name, std::string& value, const std::string& help) {
  return Option(group_->add_option(name, value, help));
}

Option OptionGroup::option(const std::string& name, std::vector<std::string>& values,
                           const std::string& help) {
  return Option(group_->add_option(name, values, help));
}

Option OptionGroup::option(const std::string& name, int& value, const std::string& help) {
  return Option(group_->add_option(name, value, help));
}

Option OptionGroup::option(const std::string& name, std::uint64_t& value, const std::string& help) {
  return Option(group_->add_option(name, value, help));
}

Option OptionGroup::option(const std::string& name, double& value, const std::string& help) {
  return Option(group_->add_option(name, value, help)->check(&not_finite));
}

Option OptionGroup::option(const std::string& name, std::optional<double>& value,
                           const std::string& help) {
  return Option(group_->add_option(name, value, help)->check(&not_finite));
}

Option OptionGroup::option(const std::string& name, std::optional<Hand>& hand,
                           const std::string& help) {
  const auto take = [&hand](const std::string& word) { hand = hand_from_name(word); };
  return Option(group_->add_option_function<std::string>(name, take, help))
      .one_of({"right", "left"});
}

Option OptionGroup::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(group_->add_flag(name, value, help));
}

Subcommand Subcommand::subcommand(const std::string& name, const std::string& help) {
  return {group_->add_subcommand(name, help), chosen_};
}

void Subcommand::requires_subcommand() {
  group_->require_subcommand(1);
}

OptionGroup Subcommand::exactly_one(const std::string& group) {
  CLI::App* options = group_->add_option_group(group);
  options->require_option(1);
  return OptionGroup(options);
}

void Subcommand::footer(const std::string& text) {
  group_->footer(text);
}

void Subcommand::runs(Action action) {
  group_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

struct CommandLine::State {
  explicit State(const std::string& description) : app(description) {}
  CLI::App app;
  Action chosen;
};

CommandLine::CommandLine(const std::string& description, const std::string& version,
                         const std::string& footer)
    : state_(std::make_unique<State>(description)) {
  state_->app.footer(footer);
  state_->app.set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Subcommand CommandLine::subcommand(const std::string& name, const std::string& help) {
  return {state_->app.add_subcommand(name, help), &state_->chosen};
}

Result<Action> CommandLine::parse(int argc, const char* const* argv) {
  try {
    state_->app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    state_->app.exit(asked);
    return Action([]() -> Result<void> { return {}; });
  } catch (const CLI::ParseError& wrong) {
    return refused(Known{wrong.what()}, "see isograsp --help"_text);
  }
  return state_->chosen;
}

}  // namespace isograsp::app
