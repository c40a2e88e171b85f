// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/presenter/seating.hpp"

#include <algorithm>

namespace isograsp::gui {

namespace {

struct LastTime {
  std::optional<OfHands<SittingPosture>> postures;
  std::optional<Presentation> presentation;
};

LastTime read_last_time(storage::SessionStore& store, const std::string& code,
                        std::optional<Hand> hand) {
  LastTime last;
  const auto patient = store.find_patient(code);
  if (!patient || !*patient) return last;
  auto sessions = store.sessions((*patient)->id);
  if (!sessions) return last;
  std::sort(sessions->begin(), sessions->end(),
            [](const auto& a, const auto& b) { return a.id > b.id; });
  for (const auto& session : *sessions) {
    const auto answers = store.answers(session.id);
    if (!answers) break;
    const auto has = [&](const char* topic) {
      return std::any_of(answers->begin(), answers->end(),
                         [&](const auto& answer) { return answer.topic == topic; });
    };
    if (!last.postures && session.hand == hand && has("posture")) {
      if (hand)
        last.postures.emplace()[*hand] = posture_in(*answers);
      else
        last.postures = postures_in(*answers);
    }
    if (!last.presentation && has("screen")) last.presentation = presentation_in(*answers);
    if (last.presentation && last.postures) break;
  }
  return last;
}

}  // namespace

Seating::Seating(Clinic& clinic, QObject* parent) : QObject(parent), clinic_(clinic) {}

void Seating::look(const std::string& code, std::optional<Hand> hand) {
  if (code != code_) {
    presentation_ = {};
    presentation_said_ = false;
  }
  if (code != code_ || hand != hand_) {
    postures_ = last_postures_ = {};
    posture_said_ = false;
  }
  code_ = code;
  hand_ = hand;
  const int lookup = ++lookups_;
  Q_EMIT changed();
  if (code.empty()) return;
  (void)clinic_.read(
      this,
      [code, hand](storage::SessionStore& store) { return read_last_time(store, code, hand); },
      [this, lookup](LastTime last) {
        if (lookup != lookups_) return;
        last_postures_ = last.postures.value_or(OfHands<SittingPosture>{});
        if (!posture_said_) postures_ = last_postures_;
        if (!presentation_said_ && last.presentation) presentation_ = *last.presentation;
        Q_EMIT changed();
      });
}

void Seating::say_posture(Hand hand, const SittingPosture& posture) {
  if (posture == postures_[hand]) return;
  postures_[hand] = posture;
  if (!hand_) postures_[other_than(hand)].of(PostureItem::seat) = posture.of(PostureItem::seat);
  posture_said_ = true;
  Q_EMIT changed();
}

std::vector<storage::SessionAnswer> Seating::posture_answers() const {
  return hand_ ? stored(postures_[*hand_]) : stored(postures_);
}

void Seating::say_presentation(const Presentation& presentation) {
  if (presentation == presentation_) return;
  presentation_ = presentation;
  presentation_said_ = true;
  Q_EMIT changed();
}

}  // namespace isograsp::gui
