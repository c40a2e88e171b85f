// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/library_in_use.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "gui/library/task_groups.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

/// The protocols that are proposed at first, of platform, arm, tracked hand and two platforms.
constexpr std::array<const char*, 4> kUsualProtocols{"battery", "arm_assessment", "hand_assessment",
                                                     "two_hands_assessment"};

std::optional<int> place_of_usual(const std::vector<session::ReadyProtocol>& protocols) {
  for (std::size_t i = 0; i < protocols.size(); ++i)
    for (const char* const usual : kUsualProtocols)
      if (fs::path(protocols[i].spec.file).stem() == usual) return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace

LibraryInUse::LibraryInUse(const ActContext& with, SessionChoices& choices, NextWork& next)
    : state_(with.state), flow_(with.flow), worker_(with.worker), choices_(choices), next_(next) {
  const GuiConfig& config = state_.config;
  all_ = read_session_library(config.library, session::own_library_folder(config.database));
  take();
  QObject::connect(&flow_, &SessionFlow::changed, &flow_, [this] {
    if (!state_.busy() && apparatus_ != state_.choices.apparatus) take();
  });
}

void LibraryInUse::reload() {
  worker_.run(
      [shipped = state_.config.library, own = session::own_library_folder(state_.config.database)] {
        return read_session_library(shipped, own);
      },
      [this](SessionLibrary library) { newer_ = std::move(library); });
}

void LibraryInUse::look() {
  const bool opening = state_.connection.phase == Connection::opening;
  const bool starting = state_.open && state_.open->starting();
  if (!newer_ || opening || flow_.view().may_stop || starting) return;
  all_ = *std::exchange(newer_, std::nullopt);
  take();
}

void LibraryInUse::propose(const std::string& protocol) {
  if (protocol.empty()) return choices_.choose_protocol(std::nullopt);
  const auto& all = state_.library.protocols;
  const auto found = std::find_if(all.begin(), all.end(), [&](const session::ReadyProtocol& one) {
    return one.spec.name == protocol;
  });
  choices_.choose_protocol(found == all.end()
                               ? place_of_usual(all)
                               : std::optional(static_cast<int>(found - all.begin())));
}

/// What there is for the chosen apparatus.
void LibraryInUse::take() {
  Choices& choices = state_.choices;
  const SessionLibrary before =
      std::exchange(state_.library, for_apparatus(all_, choices.apparatus));
  const bool other = std::exchange(apparatus_, choices.apparatus) != choices.apparatus;
  const bool first = before.tasks.empty() && before.protocols.empty();
  keep_tasks(before);
  next_.look_at_task();
  if (first || (other && choices.protocol)) {
    choices.protocol = place_of_usual(state_.library.protocols);
    if (!first) choices_.look_for_earlier();
  } else {
    keep_protocol(before);
  }
  Q_EMIT flow_.library_changed();
}

/// By the file that it was read from; where that is gone, the first that is to be done.
void LibraryInUse::keep_tasks(const SessionLibrary& before) {
  const auto keep = [&](std::optional<int>& task) {
    if (task)
      task =
          place_of_file(state_.library.tasks, before.tasks[static_cast<std::size_t>(*task)].file);
    if (task) return;
    const bool is_seen = state_.measures_arm() || state_.measures_hand();
    task = first_task(state_.library.tasks, [&](const tasks::TaskSpec& spec) {
      return is_seen ? spec.apparatus() == apparatus_ : is_rest(spec);
    });
  };
  keep(state_.choices.task);
  if (state_.open) keep(state_.open->work.task);
}

void LibraryInUse::keep_protocol(const SessionLibrary& before) {
  std::optional<int>& protocol = state_.choices.protocol;
  if (!protocol) return;
  const session::ReadyProtocol& chosen = before.protocols[static_cast<std::size_t>(*protocol)];
  auto& protocols = state_.library.protocols;
  protocol = place_of_file(protocols, chosen.spec.file);
  // A session that follows a protocol whose file is gone follows it to its end.
  if (!protocol && state_.busy()) {
    protocol = static_cast<int>(protocols.size());
    protocols.push_back(chosen);
  }
  const bool same = protocol && state_.chosen_protocol().spec.text == chosen.spec.text;
  if (!same) choices_.look_for_earlier();
}

}  // namespace isograsp::gui
