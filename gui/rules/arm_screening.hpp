// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked before an arm seen by cameras moves: once per session, answered by pressing. Pure:
// the answers, and what they suggest; the therapist decides. No widget.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "session/arm/passive_range.hpp"
#include "storage/records/profile.hpp"
#include "tasks/references.hpp"

namespace isograsp::gui {

/// In the order in which they are asked. The last two are what an arm has to be able to do.
enum class ArmQuestion : std::uint8_t {
  shoulder,     ///< pain or subluxation
  contracture,  ///< of elbow, forearm, wrist or fingers
  tape,         ///< allergy to it, or broken skin below
  turns,        ///< the forearm by 10 degrees, by itself
  holds         ///< the object for 10 s
};
inline constexpr std::size_t kArmQuestionCount = 5;
inline constexpr std::array<ArmQuestion, kArmQuestionCount> kArmQuestions{
    ArmQuestion::shoulder, ArmQuestion::contracture, ArmQuestion::tape, ArmQuestion::turns,
    ArmQuestion::holds};
/// As stored.
[[nodiscard]] const char* name_of(ArmQuestion question) noexcept;
[[nodiscard]] QString words_of(ArmQuestion question);
[[nodiscard]] QString details_of(ArmQuestion question);

/// A joint whose passive range may be entered: degrees from neutral, thumb up, to either side. A
/// negative number: neutral is not reached from there.
struct PassiveJoint {
  LinkAngle angle;
  const char* name;      ///< of widgets
  const char* title;     ///< both sides, the negative one first; to be translated, as are the next
  const char* negative;  ///< supination, …
  const char* positive;
};
inline constexpr std::size_t kPassiveJointCount = 3;
[[nodiscard]] const std::array<PassiveJoint, kPassiveJointCount>& passive_joints() noexcept;
/// "Supination / pronation", "Supination" and "Pronation" of the first, …
[[nodiscard]] QString words_of(const PassiveJoint& joint);
[[nodiscard]] QString negative_words(const PassiveJoint& joint);
[[nodiscard]] QString positive_words(const PassiveJoint& joint);

struct PassiveDegrees {
  int negative = 0;  ///< how far to the side whose angles are negative
  int positive = 0;
  bool operator==(const PassiveDegrees&) const = default;
};

struct ArmScreening {
  std::array<bool, kArmQuestionCount> yes{};
  std::optional<int> pain;  ///< now, at rest, 0 to 10; nothing: not asked yet
  /// Of passive_joints(); nothing: not measured, no limit.
  std::array<std::optional<PassiveDegrees>, kPassiveJointCount> passive{};
  /// The therapist's decision: maximum is the arm's own range, comfortable a small one; nothing:
  /// not made yet.
  std::optional<tasks::Effort> allowed;

  [[nodiscard]] bool is(ArmQuestion question) const noexcept {
    return yes[static_cast<std::size_t>(question)];
  }
  /// This arm can do what the tasks ask at least.
  [[nodiscard]] bool offered() const noexcept {
    return is(ArmQuestion::turns) && is(ArmQuestion::holds);
  }
  /// Every range has its smaller angle first.
  [[nodiscard]] bool ranges_hold() const noexcept;
  [[nodiscard]] bool complete() const noexcept { return pain && allowed && ranges_hold(); }
  friend bool operator==(const ArmScreening&, const ArmScreening&) = default;
};

/// As stored with the session. @pre screening.complete()
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const ArmScreening& screening);
/// What the answers suggest; nothing while the pain is not known.
[[nodiscard]] std::optional<tasks::Effort> suggested(const ArmScreening& screening);
/// What to mind in the session; empty: nothing.
[[nodiscard]] QString advice(const ArmScreening& screening);
/// "Own range", "Small range: half of the way", "No movement".
[[nodiscard]] QString range_words(tasks::Effort effort);
/// "own range, pain 0"
[[nodiscard]] QString summary(const ArmScreening& screening);

}  // namespace isograsp::gui
