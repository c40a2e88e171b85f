// SPDX-License-Identifier: GPL-3.0-or-later
// What limits this hand: strength, opening, release, control, individuation or direction? Each is
// compared with the other hand of the same person, or with its own best; never with other people.
// The rule: docs/report.md. SI units.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "hand/finger.hpp"
#include "storage/records/profile.hpp"
#include "tasks/kind_facts.hpp"

namespace isograsp::reports {

struct PatientRecords;

using tasks::Component;
inline constexpr std::size_t kComponentCount = 6;
[[nodiscard]] Words words_of(Component component) noexcept;
/// Name of the task of the library that trains it.
[[nodiscard]] std::string_view training_for(Component component) noexcept;

/// One day of one hand; in the unit of the measure.
struct ComponentDay {
  double day = 0.0;
  std::string date;
  double value = 0.0;
};

/// How a measure becomes a share of the reference, 1 being as good: larger is better, smaller is
/// better, or it is a logarithm already (larger is better).
enum class Comparison : std::uint8_t { larger, smaller, logarithm };

/// How well a hand does as a share of a reference.
struct Share {
  double share = 0.0;  ///< 1: as good, below 1 worse
  double low = 0.0;    ///< 95 % interval
  double high = 0.0;
};
/// Least day-to-day SD of a logarithm that is assumed: the upper end of what the
/// verdicts of change are proven for (docs/change.md).
inline constexpr double kLeastDaySd = 0.20;
/// Of means of logarithms over days, each with the SD of its days, kLeastDaySd at least.
/// @pre neither is empty; values are positive unless they are logarithms
[[nodiscard]] Share share_of(std::span<const ComponentDay> hand,
                             std::span<const ComponentDay> reference, Comparison comparison);

enum class Standing : std::uint8_t { cannot_be_said, below, not_clear, as_good };

struct ComponentResult {
  Component component = Component::strength;
  std::string task;
  Text measure;
  std::string unit;
  std::optional<double> value;      ///< of this hand, mean of its newest days as they are
  std::optional<double> reference;  ///< of what it is compared with
  Text reference_basis;             ///< "right hand, 2 days", "own best day, 5 Mar 2026"
  std::optional<Share> share;
  Standing standing = Standing::cannot_be_said;
  Text reason;  ///< why it cannot be said
  /// The newest mark of treatment between assessments, with the value before and now; empty: none.
  Text treatment;
};

struct LimitsOfHand {
  Hand hand = Hand::right;
  bool other_hand = false;                  ///< compared with the other one; else with its own best
  std::vector<ComponentResult> components;  ///< all six; empty: nothing is stored
};
/// Of the affected hand; of the hand of the newest session where none or both are affected.
[[nodiscard]] LimitsOfHand limits_of(const PatientRecords& records,
                                     std::span<const storage::TreatmentMark> marks);

/// The component with the smallest share among those clearly below; none: no component is.
[[nodiscard]] const ComponentResult* main_limit(const LimitsOfHand& limits);
/// Others that are clearly below, too, and whose intervals overlap that of the main one.
[[nodiscard]] std::vector<const ComponentResult*> beside(const LimitsOfHand& limits,
                                                         const ComponentResult& main);

}  // namespace isograsp::reports
