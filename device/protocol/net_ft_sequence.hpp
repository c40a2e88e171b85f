// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the records of one Net F/T box: which are new, missing, repeated or late, and
// whether the box began anew. Pure, no allocation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "device/protocol/net_ft_codec.hpp"

namespace isograsp {

/// All differences are modulo 2^32, so the counters may wrap. With n records sent, d of them sent
/// twice and k lost on the way, whatever their order: lost - late = k and duplicate = d, as long as
/// nothing is late by more than 63 records and the newest record arrives.
class NetFtSequence {
 public:
  enum class Place : std::uint8_t {
    in_order,   ///< newer than all before; what is missing in between is counted as lost
    stalled,    ///< a new record of an old measurement: the sensor inside does not measure
    late,       ///< older than one before, but not seen yet; it was counted as lost
    duplicate,  ///< seen before
    stale,      ///< of a stream before start(): not counted
    unplaced,   ///< contradicts the stream; the next record tells why. Counted as late
    restarted   ///< a second record confirms that the box, or its stream, began anew
  };

  /// From here on only the records of a stream that was begun at `when`: those from number 1 on, as
  /// far as so many can have been measured since. Without it the first record of any number begins.
  void start(Timestamp when) noexcept;
  [[nodiscard]] Place push(const NetFtRecord& record, Timestamp stamp) noexcept;

  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return duplicate_; }
  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }
  [[nodiscard]] std::uint64_t stalled() const noexcept { return stalled_; }
  [[nodiscard]] std::uint64_t restarts() const noexcept { return restarts_; }
  /// The counters begin anew; the place in the stream stays.
  void reset_counters() noexcept;

 private:
  static constexpr std::uint32_t kWindow = 64;  ///< records that are remembered

  void join(const NetFtRecord& record) noexcept;
  void remember(const NetFtRecord& record) noexcept;
  [[nodiscard]] bool remembers(std::uint32_t rdt_sequence) const noexcept;
  [[nodiscard]] Place contradiction(const NetFtRecord& record) noexcept;

  struct Number {
    std::uint32_t rdt = 0;
    std::uint32_t ft = 0;
  };
  std::optional<Timestamp> started_;  ///< waiting for the first record of this stream
  std::optional<Number> newest_;
  std::optional<Number> unplaced_;
  std::uint64_t seen_ = 0;  ///< bit k: record number newest - k has come
  std::array<std::uint32_t, kWindow> ft_of_{};
  std::uint64_t lost_ = 0;
  std::uint64_t duplicate_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t stalled_ = 0;
  std::uint64_t restarts_ = 0;
};

}  // namespace isograsp
