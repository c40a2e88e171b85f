// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/cameras/qtm_conversation.hpp"

#include <array>

namespace isograsp {

namespace {

constexpr std::size_t kLongestRefusal = 200;
/// A greeting may be left out; an answer may not.
constexpr Timestamp kGreeting = std::chrono::seconds(1);
constexpr Timestamp kAnswer = std::chrono::seconds(2);

/// Ways to say it, the best first; layouts of frames are the same in these versions.
constexpr std::array<std::string_view, 3> kVersions{"Version 1.23", "Version 1.19", "Version 1.12"};
constexpr std::array<std::string_view, 2> kParameters{"GetParameters General 3D",
                                                      "GetParameters 3D"};
constexpr std::array<std::string_view, 2> kFrames{"StreamFrames AllFrames 3DRes",
                                                  "StreamFrames AllFrames 3D"};

}  // namespace

QtmConversation::QtmConversation() {
  refusal_.reserve(kLongestRefusal);
}

void QtmConversation::begin(Timestamp now) noexcept {
  failure_ = Failure::none;
  refusal_.clear();
  stage_ = Stage::greeting;
  unsaid_ = false;
  due_ = now + kGreeting;
}

void QtmConversation::ask_again(Timestamp now) noexcept {
  failure_ = Failure::none;
  enter(Stage::parameters, 0, now);
}

void QtmConversation::hear(QtmRtStream::Step step, std::string_view message,
                           Timestamp now) noexcept {
  using Step = QtmRtStream::Step;
  switch (step) {
    case Step::more: return;
    case Step::lost: return fail(Failure::not_qtm);
    case Step::row:
      stage_ = Stage::streaming;
      due_ = Timestamp::max();
      return;
    case Step::refusal:
      refusal_.assign(message.substr(0, kLongestRefusal));
      return refused_here(now);
    case Step::message:
      if (stage_ == Stage::greeting) return enter(Stage::version, 0, now);
      if (stage_ == Stage::version) return enter(Stage::parameters, 0, now);
      return;
    case Step::labels:
      if (stage_ == Stage::parameters) return enter(Stage::frames, 0, now);
      return;
    case Step::no_labels:
    case Step::other_labels:
      if (stage_ == Stage::parameters) return fail(Failure::no_labels);
      return;
  }
}

void QtmConversation::refused_here(Timestamp now) noexcept {
  switch (stage_) {
    case Stage::greeting:
    case Stage::streaming: return;
    case Stage::version:
      if (form_ + 1 < kVersions.size()) return enter(stage_, form_ + 1, now);
      return fail(Failure::version);
    case Stage::parameters:
      if (form_ + 1 < kParameters.size()) return enter(stage_, form_ + 1, now);
      return fail(Failure::no_labels);
    case Stage::frames:
      if (form_ + 1 < kFrames.size()) return enter(stage_, form_ + 1, now);
      return fail(Failure::no_frames);
  }
}

void QtmConversation::look(Timestamp now) noexcept {
  if (now < due_) return;
  switch (stage_) {
    case Stage::greeting: return enter(Stage::version, 0, now);
    case Stage::version: return fail(Failure::no_answer);
    case Stage::parameters: return fail(Failure::no_labels);
    case Stage::frames: return fail(Failure::no_frames);
    case Stage::streaming: return;
  }
}

std::string_view QtmConversation::say() noexcept {
  if (!unsaid_) return {};
  unsaid_ = false;
  switch (stage_) {
    case Stage::version: return kVersions[form_];
    case Stage::parameters: return kParameters[form_];
    case Stage::frames: return kFrames[form_];
    default: return {};
  }
}

void QtmConversation::enter(Stage stage, std::size_t form, Timestamp now) noexcept {
  stage_ = stage;
  form_ = form;
  unsaid_ = true;
  due_ = now + kAnswer;
}

void QtmConversation::fail(Failure failure) noexcept {
  failure_ = failure;
  due_ = Timestamp::max();
}

}  // namespace isograsp
