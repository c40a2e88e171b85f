// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/task_acts.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::gui {

namespace {

/// One press on "easier" or "harder", of the whole range of levels.
constexpr double kLevelStep = 0.1;

}  // namespace

TaskActs::TaskActs(const ActContext& with, NextWork& next)
    : state_(with.state), flow_(with.flow), example_(with.example), next_(next) {}

void TaskActs::choose(int index) {
  if (!flow_.view().may_choose_task || index == state_.task()) return;
  example_.stop();
  next_.hold();
  if (state_.open) state_.open->work.by_hand = true;
  next_.select(index);
  flow_.update();
}

void TaskActs::set_practice(bool practice) {
  state_.choices.practice = practice;
}

std::optional<double> TaskActs::difficulty() const {
  const auto* spec = state_.next_task();
  if (spec == nullptr || !spec->difficulty) return std::nullopt;
  // An assessment is the same every time; only training becomes easier or harder.
  if (state_.follows() && !state_.guide().act()->adaptive) return std::nullopt;
  if (!state_.open) return spec->difficulty->start;
  const OpenSession& open = *state_.open;
  const auto chosen = open.work.levels.find(spec->file);
  if (chosen != open.work.levels.end()) return chosen->second;
  return open.work.follows() ? spec->difficulty->chosen
                             : open.session->known().training.level(*spec);
}

void TaskActs::adjust_difficulty(int direction) {
  const auto now = difficulty();
  if (!state_.open || !now || !flow_.view().may_choose_task) return;
  const double steps = std::round(*now / kLevelStep) + direction;
  state_.open->work.levels[state_.next_task()->file] = std::clamp(kLevelStep * steps, 0.0, 1.0);
  if (state_.follows()) next_.look_at_act();
  flow_.update();
}

void TaskActs::show_how() {
  if (example_.showing()) {
    example_.stop();
    return flow_.update();
  }
  if (!flow_.view().may_show_how) return;
  next_.hold();
  session::DemonstrationFor whom;
  whom.hand = state_.choices.today.hand.value_or(Hand::right);
  if (state_.open) {
    whom.references = state_.open->session->known().references;
    whom.ranges = state_.open->session->known().ranges;
  }
  example_.show(*state_.next_task(), whom, state_.config.library,
                [this](const Result<void>& shown) {
                  if (!shown) flow_.refuse(shown.error());
                  flow_.update();
                });
  flow_.update();
}

void TaskActs::look() {
  if (!example_.playing()) return;
  example_.tick();
  if (!flow_.view().may_show_how) example_.stop();
  if (!example_.showing()) Q_EMIT flow_.changed();
}

}  // namespace isograsp::gui
