// SPDX-License-Identifier: GPL-3.0-or-later
// The entry test as a preparation: ten seconds at rest, from which the size of the hand is taken,
// then opened and closed three times (hand_entry.hpp). What came of it decides which objects the
// hand is offered.
#pragma once

#include <vector>

#include "hand/tracked_hand.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/tracked_hand/hand_entry.hpp"
#include "session/tracked_hand/hand_snapshot.hpp"
#include "virtual_hand/hand_model.hpp"

namespace isograsp::session {

/// PreparationRecord::kind.
inline constexpr const char* kHandEntry = "hand_entry";
/// Its reference that says whose size the hand has: 1 that of the other one, 0 its own.
inline constexpr const char* kSizeOfOtherHand = "size_of_other_hand";

class EntryCapture final : public Preparation {
 public:
  /// `model`: axes and limits of every hand. `of_other`: the size of the other hand, mirrored, in
  /// place of one of its own; nothing: it is measured here.
  EntryCapture(double period_s, double settle_s, Hand side, const virtual_hand::HandModel& model,
               std::optional<virtual_hand::HandModel> of_other);

  /// One frame; true: it has ended. Real-time safe.
  [[nodiscard]] bool add(const ShownHand& hand, double gap_m) noexcept;
  [[nodiscard]] double progress() const noexcept;
  [[nodiscard]] EntryShown shown() const noexcept;
  [[nodiscard]] const HandEntry& entry() const noexcept { return entry_; }

  // After its end; not real-time.
  /// The hand of the person. Errors: it was not seen whole.
  [[nodiscard]] Result<virtual_hand::HandModel> hand() const;
  [[nodiscard]] PreparationOutcome outcome() const override;

 private:
  static constexpr double kEach_s = 2.5;  ///< the hand is asked to open, then to close

  double period_s_;
  double wait_s_;
  Hand side_;
  virtual_hand::HandModel model_;
  std::optional<virtual_hand::HandModel> of_other_;
  HandEntry entry_;
  std::vector<HandFrame> at_rest_;  ///< has room for all of them
  std::int64_t opening_frames_ = 0;
};

}  // namespace isograsp::session
