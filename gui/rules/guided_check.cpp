// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/guided_check.hpp"

#include <QCoreApplication>
#include <algorithm>

namespace isograsp::gui {

void GuidedCheck::begin(double frame_period_s, Hand hand, std::int64_t frames) {
  check_ = std::make_unique<DeviceCheck>(frame_period_s, hand, std::nullopt);
  frames_ = frames;
  state_ = State::empty;
}

void GuidedCheck::stop() {
  if (state_ != State::over) state_ = State::idle;
}

bool GuidedCheck::look(const session::Snapshot& snapshot) {
  if (state_ != State::empty && state_ != State::pressing) return false;
  const State before = state_;
  const std::size_t found = check_->results().size();
  for (; frames_ < snapshot.frames; ++frames_) {
    if (state_ == State::empty) {
      if (check_->add_empty(snapshot.forces)) state_ = State::pressing;
    } else if (!check_->complete()) {
      (void)check_->add(snapshot.forces);
    }
  }
  if (check_->complete()) state_ = State::over;
  return state_ != before || check_->results().size() != found;
}

Text GuidedCheck::instruction() const {
  return state_ == State::empty
             ? Text("Take everything off the supports and do not touch them."_text)
             : step().instruction();
}

std::vector<CheckResult> GuidedCheck::results() const {
  return check_ == nullptr ? std::vector<CheckResult>{} : check_->results();
}

Text GuidedCheck::outcome() const {
  for (const auto& result : check_->results())
    if (result.verdict != CheckVerdict::good) return result.sentence();
  return "Guided check passed."_text;
}

}  // namespace isograsp::gui
