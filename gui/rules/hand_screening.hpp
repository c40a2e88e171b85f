// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked before a tracked hand moves: once per session, answered by pressing. Whether it
// opens far enough says the entry test. Pure: the answers, and what they suggest; the therapist
// decides. No widget.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "storage/records/profile.hpp"
#include "tasks/references.hpp"

namespace isograsp::gui {

/// In the order in which they are asked.
enum class HandQuestion : std::uint8_t {
  shoulder,   ///< pain or subluxation: the hand is carried to its targets
  injury,     ///< fracture, tendon repair, wound, acute arthritis, CRPS
  treatment,  ///< botulinum toxin or another drug since the last session
  seizures
};
inline constexpr std::size_t kHandQuestionCount = 4;
inline constexpr std::array<HandQuestion, kHandQuestionCount> kHandQuestions{
    HandQuestion::shoulder, HandQuestion::injury, HandQuestion::treatment, HandQuestion::seizures};
/// As stored.
[[nodiscard]] const char* name_of(HandQuestion question) noexcept;
[[nodiscard]] QString words_of(HandQuestion question);
[[nodiscard]] QString details_of(HandQuestion question);

struct HandScreening {
  std::array<bool, kHandQuestionCount> yes{};
  std::optional<int> pain;        ///< now, at rest, 0 to 10; nothing: not asked yet
  bool forearm_supported = true;  ///< it lies on something while the hand works
  /// The therapist's decision; nothing: not made yet.
  std::optional<bool> may_move;

  [[nodiscard]] bool is(HandQuestion question) const noexcept {
    return yes[static_cast<std::size_t>(question)];
  }
  [[nodiscard]] bool complete() const noexcept { return pain && may_move; }
  friend bool operator==(const HandScreening&, const HandScreening&) = default;
};

/// Of a session: nothing in it is about force. @pre screening.complete()
[[nodiscard]] tasks::Effort allowed(const HandScreening& screening) noexcept;
/// As stored with the session. @pre screening.complete()
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const HandScreening& screening);
/// What the answers suggest; nothing while the pain is not known.
[[nodiscard]] std::optional<bool> suggested(const HandScreening& screening);
/// What to mind in the session; empty: nothing.
[[nodiscard]] QString advice(const HandScreening& screening);
/// "may move, pain 0"
[[nodiscard]] QString summary(const HandScreening& screening);

}  // namespace isograsp::gui
