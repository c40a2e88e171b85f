// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/rules/two_hands_rules.hpp"

#include <algorithm>

namespace isograsp::gui {

namespace {

/// From what allows most to what allows nothing.
int strictness(tasks::Effort effort) noexcept {
  switch (effort) {
    case tasks::Effort::maximum: return 0;
    case tasks::Effort::comfortable: return 1;
    case tasks::Effort::none: break;
  }
  return 2;
}

const Screening& stricter(const BothScreenings& both) noexcept {
  return strictness(*both.right.allowed) > strictness(*both.left.allowed) ? both.right : both.left;
}

}  // namespace

bool complete(const BothScreenings& both) noexcept {
  return both.left.complete() && both.right.complete();
}

tasks::Effort allowed(const BothScreenings& both) noexcept {
  return *stricter(both).allowed;
}

bool applies_to_one(const BothScreenings& both, Caution caution) noexcept {
  const auto place = static_cast<std::size_t>(caution);
  return both.left.applies[place] || both.right.applies[place];
}

std::vector<storage::SessionAnswer> stored(const BothScreenings& both) {
  std::vector<storage::SessionAnswer> answers;
  for (const Hand hand : kBothHands) {
    const std::string side = std::string(name_of(hand)) + "_";
    for (storage::SessionAnswer& answer : stored(both[hand])) {
      answer.item = side + answer.item;
      answers.push_back(std::move(answer));
    }
    answers.push_back(
        {"screening", side + "allowed", std::string(tasks::name_of(*both[hand].allowed))});
  }
  return answers;
}

QString summary(const BothScreenings& both) {
  if (!complete(both)) return {};
  Screening shown = stricter(both);
  shown.pain = std::max(*both.left.pain, *both.right.pain);
  shown.ceiling_N.reset();  // each has its own
  return summary(shown);
}

std::vector<storage::SessionAnswer> stored(const HandsSafety& safety) {
  const auto yes = [](bool is) { return is ? "yes" : "no"; };
  return {{"safety", "stop_tested", yes(safety.stop_tested)},
          {"safety", "within_reach", yes(safety.within_reach)},
          {"safety", "less_affected_hand_strapped", yes(safety.other_strapped)}};
}

}  // namespace isograsp::gui
