// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/net_ft_sequence.hpp"

namespace isograsp {

namespace {

constexpr std::uint32_t kHalf = 0x80000000;
/// Measurements inside the sensor, one second of them: no datagram is late by more.
constexpr std::uint32_t kLongestLate = 8000;
/// The arrival of a datagram is known no better than this: it may seem to come before the start.
constexpr double kStampJitter_s = 0.001;

}  // namespace

void NetFtSequence::start(Timestamp when) noexcept {
  started_ = when;
  newest_.reset();
  unplaced_.reset();
}

void NetFtSequence::join(const NetFtRecord& record) noexcept {
  started_.reset();
  unplaced_.reset();
  newest_ = Number{record.rdt_sequence, record.ft_sequence};
  seen_ = 0;
  remember(record);
}

void NetFtSequence::remember(const NetFtRecord& record) noexcept {
  seen_ |= std::uint64_t{1} << (newest_->rdt - record.rdt_sequence);
  ft_of_[record.rdt_sequence % kWindow] = record.ft_sequence;
}

bool NetFtSequence::remembers(std::uint32_t rdt_sequence) const noexcept {
  const std::uint32_t behind = newest_->rdt - rdt_sequence;
  return behind < kWindow && (seen_ >> behind & 1U) != 0;
}

NetFtSequence::Place NetFtSequence::push(const NetFtRecord& record, Timestamp stamp) noexcept {
  if (started_) {
    const double since_s = to_seconds(stamp - *started_) + kStampJitter_s;
    if (record.rdt_sequence == 0 || record.rdt_sequence > since_s * kNetFtFastest_Hz)
      return Place::stale;
    lost_ += record.rdt_sequence - 1;
    join(record);
    return Place::in_order;
  }
  if (!newest_) {
    join(record);
    return Place::in_order;
  }

  const std::uint32_t ahead = record.rdt_sequence - newest_->rdt;
  const std::uint32_t ft_ahead = record.ft_sequence - newest_->ft;
  if (remembers(record.rdt_sequence)) {
    if (ft_of_[record.rdt_sequence % kWindow] != record.ft_sequence) return contradiction(record);
    ++duplicate_;
    return Place::duplicate;
  }
  if (ahead < kHalf) {
    if (ft_ahead >= kHalf) return contradiction(record);
    lost_ += ahead - 1;
    seen_ = ahead < kWindow ? seen_ << ahead : 0;
    newest_ = Number{record.rdt_sequence, record.ft_sequence};
    unplaced_.reset();
    remember(record);
    if (ft_ahead != 0) return Place::in_order;
    ++stalled_;
    return Place::stalled;
  }
  if (newest_->ft - record.ft_sequence > kLongestLate) return contradiction(record);
  ++late_;
  if (newest_->rdt - record.rdt_sequence < kWindow) remember(record);
  return Place::late;
}

/// A stream that began anew goes on from its first record; a stray record stands alone.
NetFtSequence::Place NetFtSequence::contradiction(const NetFtRecord& record) noexcept {
  if (unplaced_) {
    const std::uint32_t ahead = record.rdt_sequence - unplaced_->rdt;
    const std::uint32_t ft_ahead = record.ft_sequence - unplaced_->ft;
    if (ahead >= 1 && ahead < kWindow && ft_ahead < kHalf) {
      ++restarts_;
      lost_ += ahead - 1;
      join(record);
      return Place::restarted;
    }
  }
  ++late_;
  unplaced_ = Number{record.rdt_sequence, record.ft_sequence};
  return Place::unplaced;
}

void NetFtSequence::reset_counters() noexcept {
  lost_ = 0;
  duplicate_ = 0;
  late_ = 0;
  stalled_ = 0;
  restarts_ = 0;
}

}  // namespace isograsp
