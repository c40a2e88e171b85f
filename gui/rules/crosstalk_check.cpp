// SPDX-License-Identifier: GPL-3.0-or-later
//   moved = 100 |mean(push of the other) - mean(it before)| / |mean(push of the pressed one)|
#include "gui/rules/crosstalk_check.hpp"

#include <QString>
#include <algorithm>
#include <string>

namespace isograsp::gui {

namespace {

constexpr double kUnpressed_N = 2.0;   // nobody presses
constexpr int kLeastBefore = 10;       // frames of rest to compare with
constexpr double kLongestGap_s = 0.1;  // between two looks: what happened in between is not known
constexpr double kOfAll_percent = 100.0;

std::string number(double value) {
  return QString::number(value, 'f', 2).toStdString();
}

}  // namespace

void CrossTalkCheck::Mean::add(const Vec3& value) noexcept {
  sum += value;
  ++frames;
}

Vec3 CrossTalkCheck::Mean::value() const noexcept {
  return frames == 0 ? Vec3(Vec3::Zero()) : Vec3(sum / frames);
}

void CrossTalkCheck::begin_way(State state) noexcept {
  state_ = state;
  since_s_.reset();
  before_ = pressed_ = felt_ = {};
}

void CrossTalkCheck::begin() noexcept {
  ways_ = {};
  last_s_ = -1.0;
  begin_way(State::press_left);
}

void CrossTalkCheck::stop() noexcept {
  ways_ = {};
  begin_way(State::idle);
}

void CrossTalkCheck::skip() noexcept {
  ways_ = {};
  begin_way(State::skipped);
}

bool CrossTalkCheck::add(const session::TwoPlatformsSnapshot& now) noexcept {
  if (!running() || now.session_time_s <= last_s_) return false;
  const bool gap = last_s_ >= 0.0 && now.session_time_s - last_s_ > kLongestGap_s;
  last_s_ = now.session_time_s;
  const Hand hand = state_ == State::press_left ? Hand::left : Hand::right;
  const auto& push = now.of[hand].push_W;
  const auto& other = now.of[other_than(hand)].push_W;
  if (!push || !other || gap) {
    begin_way(state_);  // from the beginning
    return false;
  }
  const double force_N = push->norm();
  if (force_N < kUnpressed_N && other->norm() < kUnpressed_N)
    before_.add(*other);
  else if (force_N < kUnpressed_N)
    before_ = {};  // the other one is still pressed, or is touched
  if (force_N < kPress_N || before_.frames < kLeastBefore) {
    since_s_.reset();
    pressed_ = felt_ = {};
    return false;
  }
  if (!since_s_) since_s_ = now.session_time_s;
  pressed_.add(*push);
  felt_.add(*other - before_.value());
  if (now.session_time_s - *since_s_ < kPress_s) return false;
  const double pressed_N = pressed_.value().norm();
  ways_[hand] = Way{pressed_N, kOfAll_percent * felt_.value().norm() / pressed_N};
  begin_way(hand == Hand::left ? State::press_right : State::over);
  return true;
}

std::optional<bool> CrossTalkCheck::coupled() const noexcept {
  if (state_ != State::over) return std::nullopt;
  return moved_percent() > kMostMoved_percent;
}

double CrossTalkCheck::moved_percent() const noexcept {
  return std::max(ways_.left->moved_percent, ways_.right->moved_percent);
}

std::vector<storage::SessionAnswer> stored(const CrossTalkCheck& check) {
  constexpr const char* kTopic = "crosstalk";
  const auto coupled = check.coupled();
  std::vector<storage::SessionAnswer> answers{{kTopic, "outcome",
                                               !coupled   ? "skipped"
                                               : *coupled ? "coupled"
                                                          : "apart"}};
  for (const Hand hand : kBothHands) {
    const auto& way = check.ways()[hand];
    if (!way) continue;
    const std::string side(name_of(hand));
    answers.push_back({kTopic, side + "_pressed_N", number(way->pressed_N)});
    answers.push_back({kTopic, side + "_moves_other_percent", number(way->moved_percent)});
  }
  return answers;
}

}  // namespace isograsp::gui
