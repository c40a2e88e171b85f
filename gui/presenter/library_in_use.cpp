// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/library_in_use.hpp"

#include <filesystem>
#include <utility>

#include "gui/library/task_groups.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

/// The protocol that is proposed at first.
constexpr const char* kUsualProtocol = "battery";

std::optional<int> place_of_usual(const std::vector<session::ReadyProtocol>& protocols) {
  for (std::size_t i = 0; i < protocols.size(); ++i)
    if (fs::path(protocols[i].spec.file).stem() == kUsualProtocol) return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace

LibraryInUse::LibraryInUse(const ActContext& with, SessionChoices& choices, NextWork& next)
    : state_(with.state), flow_(with.flow), worker_(with.worker), choices_(choices), next_(next) {
  const GuiConfig& config = state_.config;
  take(read_session_library(config.library, session::own_library_folder(config.database)));
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
  if (newer_ && !opening && !flow_.view().may_stop && !starting)
    take(*std::exchange(newer_, std::nullopt));
}

void LibraryInUse::take(SessionLibrary library) {
  const SessionLibrary before = std::exchange(state_.library, std::move(library));
  keep_tasks(before);
  next_.look_at_task();
  const bool first = before.tasks.empty() && before.protocols.empty();
  if (first)
    state_.choices.protocol = place_of_usual(state_.library.protocols);
  else
    keep_protocol(before);
  Q_EMIT flow_.library_changed();
}

/// By the file that it was read from; where that is gone, the first that is to be done.
void LibraryInUse::keep_tasks(const SessionLibrary& before) {
  const auto keep = [&](std::optional<int>& task) {
    if (task)
      task =
          place_of_file(state_.library.tasks, before.tasks[static_cast<std::size_t>(*task)].file);
    if (!task) task = first_task(state_.library.tasks, is_rest);
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
