// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/hand/ only. What live trackers share: messages are received and read by a thread of
// their own, which may allocate; rows and health cross to the session without a lock.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/latest.hpp"
#include "core/ring.hpp"
#include "device/hand/hand_intake.hpp"
#include "device/hand/wake.hpp"

namespace isograsp {

/// Where a receiving thread puts what it hears. That thread alone calls it, but for the parts that
/// are said to be the reader's.
class HandDesk {
 public:
  HandDesk(std::optional<Hand> side, Clock& clock) : clock_(clock), intake_(side), rows_(kRows) {}

  [[nodiscard]] Result<void> open() { return wake_.open(); }
  void begin();
  [[nodiscard]] Timestamp now() const noexcept { return clock_.now(); }
  void frame(double tracker_s, std::span<const HandFrame> hands);
  void malformed();
  void late();
  void foreign();
  void link(HandReception::Link link);
  /// What the tracker's program calls itself; kept until the first frame.
  void service(const std::string& version);

  // The reader's.
  [[nodiscard]] bool take(HandSample& out) noexcept { return rows_.pop(out); }
  void wait(Timestamp span) const noexcept { wake_.wait(span); }
  [[nodiscard]] const HandReception& reception() noexcept { return told_.read(); }
  /// @pre reception() has shown a frame
  [[nodiscard]] const std::string& service() const noexcept { return service_; }

 private:
  static constexpr std::size_t kRows = 1024;  // two hands at 120 Hz for four seconds
  void tell();

  Clock& clock_;
  HandIntake intake_;
  Ring<HandSample> rows_;
  Latest<HandReception> told_;
  Wake wake_;
  std::string service_;
};

/// One conversation with a tracker.
class HandReceiver {
 public:
  HandReceiver() = default;
  virtual ~HandReceiver() = default;
  HandReceiver(const HandReceiver&) = delete;
  HandReceiver& operator=(const HandReceiver&) = delete;

  /// Finds and opens what can be opened before a thread is there. Errors name the address.
  [[nodiscard]] virtual Result<void> open() = 0;
  /// Receives until end(). In a thread of its own.
  virtual void run(HandDesk& desk) = 0;
  /// Any thread.
  virtual void end() noexcept = 0;
  /// Why no frame has come, without the URI.
  [[nodiscard]] virtual Error nothing_came(HandReception::Link link) const = 0;
};

/// A device of what this makes; called once for each start().
[[nodiscard]] std::unique_ptr<HandDevice> live_hand(
    HandDeviceInfo info, std::optional<Hand> side,
    std::function<std::unique_ptr<HandReceiver>()> make_receiver);

}  // namespace isograsp
