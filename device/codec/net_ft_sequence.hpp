// SPDX-License-Identifier: GPL-3.0-or-later
// The order of the records of one Net F/T box: which are new, missing, repeated or late, which
// cannot be its, and whether the box began anew. Pure, no allocation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "device/codec/net_ft_codec.hpp"

namespace isograsp {

/// All differences are modulo 2^32, so the counters may wrap. With n records sent, d of them sent
/// twice and k lost on the way, whatever their order: lost - late = k and duplicate = d, as long as
/// nothing is late by more than 63 records and the newest record arrives.
///
/// Anybody on the network can send a record. But no box sends more records than its rate and the
/// time since its start allow, however long the network kept them: a higher number is impossible.
/// So lost() agrees with the time that has passed, and one forged record changes nothing. This
/// holds in the tenth hour as in the first second, within the jitter that the network shows. A long
/// delay becomes the new normal after a while; when it ends, the stream goes on from there.
class NetFtSequence {
 public:
  enum class Place : std::uint8_t {
    in_order,    ///< newer than all before; what is missing in between is counted as lost
    stalled,     ///< a new record of an old measurement: the sensor inside does not measure
    late,        ///< older than one before, but not seen yet; it was counted as lost
    duplicate,   ///< seen before
    stale,       ///< of a stream before start(): not counted
    unplaced,    ///< contradicts the stream; the next record tells why. Counted as late
    impossible,  ///< cannot have been sent yet; the next record tells why. Counted as such
    restarted    ///< a second record confirms that the box, or its stream, began anew
  };

  /// `rate_Hz`: of the records; if it is not known, the fastest that any box can measure.
  explicit NetFtSequence(double rate_Hz = kNetFtFastest_Hz) noexcept : rate_Hz_(rate_Hz) {}

  /// From now on only records of a stream that was started at `when` count: their numbers begin
  /// with 1 and are not higher than the time since then allows. Without start(), the first record
  /// of any number begins.
  void start(Timestamp when) noexcept;
  [[nodiscard]] Place push(const NetFtRecord& record, Timestamp stamp) noexcept;

  [[nodiscard]] std::uint64_t lost() const noexcept { return lost_; }
  [[nodiscard]] std::uint64_t duplicate() const noexcept { return duplicate_; }
  [[nodiscard]] std::uint64_t late() const noexcept { return late_; }
  [[nodiscard]] std::uint64_t stalled() const noexcept { return stalled_; }
  [[nodiscard]] std::uint64_t impossible() const noexcept { return impossible_; }
  [[nodiscard]] std::uint64_t restarts() const noexcept { return restarts_; }
  /// The counters begin anew; the place in the stream stays.
  void reset_counters() noexcept;

 private:
  static constexpr std::uint32_t kWindow = 64;  ///< records that are remembered

  void join(const NetFtRecord& record, Timestamp stamp, double spare) noexcept;
  [[nodiscard]] Place begin(const NetFtRecord& record, Timestamp stamp) noexcept;
  [[nodiscard]] Place go_on(const NetFtRecord& record, Timestamp stamp) noexcept;
  [[nodiscard]] double sent_in(double seconds) const noexcept;
  [[nodiscard]] double slack() const noexcept;
  void advance(const NetFtRecord& record, Timestamp stamp) noexcept;
  void remember(const NetFtRecord& record) noexcept;
  [[nodiscard]] bool remembers(std::uint32_t rdt_sequence) const noexcept;
  [[nodiscard]] Place before_its_time(const NetFtRecord& record, Timestamp stamp) noexcept;
  [[nodiscard]] Place contradiction(const NetFtRecord& record, Timestamp stamp,
                                    Place what) noexcept;

  struct Number {
    std::uint32_t rdt = 0;
    std::uint32_t ft = 0;
  };
  struct Arrival {
    Number number;
    Timestamp stamp{0};
  };
  double rate_Hz_;
  std::optional<Timestamp> started_;  ///< waiting for the first record of this stream
  std::optional<Number> newest_;
  std::optional<Arrival> unplaced_;
  Timestamp newest_stamp_{0};
  double jitter_ = 0.0;     ///< records that one record has caught up lately
  double spare_ = 0.0;      ///< records beyond the newest that could have come by newest_stamp_
  std::uint64_t seen_ = 0;  ///< bit k: record number newest - k has come
  std::array<std::uint32_t, kWindow> ft_of_{};
  std::uint64_t lost_ = 0;
  std::uint64_t duplicate_ = 0;
  std::uint64_t late_ = 0;
  std::uint64_t stalled_ = 0;
  std::uint64_t impossible_ = 0;
  std::uint64_t restarts_ = 0;
};

}  // namespace isograsp
