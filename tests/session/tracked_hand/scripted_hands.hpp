// SPDX-License-Identifier: GPL-3.0-or-later
// A tracker of hands that gives what a test says, each row when the test says, in virtual time.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "device/hand/hand_device.hpp"

namespace isograsp::test {

/// A hand with all joints at one place.
inline HandFrame hand_at(double x_m, bool tracked = true, Hand side = Hand::right) {
  HandFrame hand;
  hand.side = side;
  hand.tracked = tracked;
  hand.joints.fill(tracked ? Vec3(x_m, 0.0, 0.0)
                           : Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
  return hand;
}

class ScriptedHands final : public HandDevice {
 public:
  struct Row {
    double stamp_s;
    HandFrame frame;
    double late_s = 0.0;  ///< from stamp to arrival
  };
  ScriptedHands(std::vector<Row> rows, double period_s) : rows_(std::move(rows)) {
    info_.period_s = period_s;
  }
  [[nodiscard]] const HandDeviceInfo& info() const noexcept override { return info_; }
  [[nodiscard]] HandHealth health() const noexcept override { return {}; }
  [[nodiscard]] Result<void> start(Clock& clock) override {
    clock_ = &clock;
    return {};
  }
  [[nodiscard]] ReadStatus read(Timestamp deadline, HandSample& out) noexcept override {
    if (next_ == rows_.size()) {
      if (ends) return ReadStatus::finished;
      clock_->wait_until(deadline);
      return ReadStatus::timeout;
    }
    const Row& row = rows_[next_];
    const Timestamp arrival = from_seconds(row.stamp_s + row.late_s);
    clock_->wait_until(std::min(arrival, deadline));
    if (arrival > deadline) return ReadStatus::timeout;
    out = {from_seconds(row.stamp_s), static_cast<std::int64_t>(next_), row.frame};
    ++next_;
    return ReadStatus::sample;
  }
  void stop() noexcept override {}

  bool ends = false;  ///< behind the last row; else it falls silent

 private:
  HandDeviceInfo info_;
  std::vector<Row> rows_;
  std::size_t next_ = 0;
  Clock* clock_ = nullptr;
};

}  // namespace isograsp::test
