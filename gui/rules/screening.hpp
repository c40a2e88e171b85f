// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked before any force is: once per session, answered by pressing. Pure: the answers, and
// what they suggest; the therapist decides. No widget.
#pragma once

#include <QString>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "storage/records/session_store.hpp"
#include "tasks/references.hpp"

namespace isograsp::gui {

/// Reasons to ask for less, in the order in which they are shown.
enum class Caution : std::uint8_t {
  no_clearance,  ///< for maximal effort: heart, blood pressure, vessels, brain, eyes
  injury,        ///< fracture, tendon repair, wound, acute arthritis, CRPS
  skin,          ///< broken or insensate skin
  treatment,     ///< botulinum toxin or another drug since the last session
  seizures
};
inline constexpr std::size_t kCautionCount = 5;
inline constexpr std::array<Caution, kCautionCount> kCautions{
    Caution::no_clearance, Caution::injury, Caution::skin, Caution::treatment, Caution::seizures};
/// As stored.
[[nodiscard]] const char* name_of(Caution caution) noexcept;
/// The question in a few words, and what it is about at length.
[[nodiscard]] QString words_of(Caution caution);
[[nodiscard]] QString details_of(Caution caution);

struct Screening {
  std::array<bool, kCautionCount> applies{};
  std::optional<int> pain;               ///< now, at rest, 0 to 10; nothing: not asked yet
  std::optional<tasks::Effort> allowed;  ///< the therapist's decision; nothing: not made yet
  std::optional<double> ceiling_N;       ///< no target may exceed it

  [[nodiscard]] bool complete() const noexcept { return pain && allowed; }
  friend bool operator==(const Screening&, const Screening&) = default;
};

/// Pain from here on is a reason not to work with the hand today [of 10].
inline constexpr int kTooMuchPain = 4;

/// As stored with the session. @pre screening.complete()
[[nodiscard]] std::vector<storage::SessionAnswer> stored(const Screening& screening);

/// What the answers suggest; nothing while the pain is not known.
[[nodiscard]] std::optional<tasks::Effort> suggested(const Screening& screening);
/// What to mind in the session; empty: nothing.
[[nodiscard]] QString advice(const Screening& screening);
/// "Maximum allowed", "Comfortable force only", "No force".
[[nodiscard]] QString words_of(tasks::Effort effort);
/// "maximum, pain 0, ≤ 40 N"
[[nodiscard]] QString summary(const Screening& screening);

}  // namespace isograsp::gui
