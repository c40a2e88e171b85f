// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/codec/net_ft_sequence.hpp"

#include <algorithm>

namespace isograsp {

namespace {

constexpr std::uint32_t kHalf = 0x80000000;
/// Longest delay of a datagram.
constexpr double kLongestDelay_s = 1.0;
/// Most measurements that a sensor makes in that time.
constexpr std::uint32_t kLongestLate = 8000;
/// Largest difference between the delays of a record and the next but one. Within it, a gap between
/// them is believed: the missing records were sent.
constexpr double kLongestJitter_s = 0.05;
/// Error of the arrival time of a datagram: it may seem to come before the start.
constexpr double kStampJitter_s = 0.001;
/// The first records of a stream need not be a whole period apart.
constexpr double kPartOfRecord = 0.25;
/// Relative error of the rate: a box rounds it to a fraction of its own rate and has its own clock.
constexpr double kRateTolerance = 0.02;
/// sent_in() assumes a rate that is one tolerance too high, and a box may be one tolerance too
/// slow: then `spare_` grows by two tolerances of the time that passes. It is reduced a little
/// faster, so that a slow clock never makes room for a forged record.
constexpr double kGivenBack = 2.1;
/// `spare_` is not reduced below `jitter_`, which the network has shown to need: the most that one
/// record has caught up is remembered for about this time.
constexpr double kJitterMemory_s = 60.0;

}  // namespace

void NetFtSequence::start(Timestamp when) noexcept {
  started_ = when;
  newest_.reset();
  unplaced_.reset();
}

/// Most records that a box sends in this time.
double NetFtSequence::sent_in(double seconds) const noexcept {
  return seconds * rate_Hz_ * (1.0 + kRateTolerance);
}

/// By how many records a record may come too early.
double NetFtSequence::slack() const noexcept {
  return kPartOfRecord + sent_in(kStampJitter_s);
}

void NetFtSequence::join(const NetFtRecord& record, Timestamp stamp, double spare) noexcept {
  started_.reset();
  unplaced_.reset();
  jitter_ = 0.0;
  newest_ = Number{record.rdt_sequence, record.ft_sequence};
  newest_stamp_ = stamp;
  spare_ = std::min(spare, kLongestDelay_s * rate_Hz_);
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
  if (started_) return begin(record, stamp);
  if (!newest_) {
    join(record, stamp, kLongestDelay_s * rate_Hz_);
    return Place::in_order;
  }
  if (remembers(record.rdt_sequence)) {
    if (ft_of_[record.rdt_sequence % kWindow] != record.ft_sequence)
      return contradiction(record, stamp, Place::unplaced);
    ++duplicate_;
    return Place::duplicate;
  }
  if (record.rdt_sequence - newest_->rdt < kHalf) return go_on(record, stamp);
  if (newest_->ft - record.ft_sequence > kLongestLate)
    return contradiction(record, stamp, Place::unplaced);
  ++late_;
  if (newest_->rdt - record.rdt_sequence < kWindow) remember(record);
  return Place::late;
}

/// Record 1 may have been sent at the start itself.
NetFtSequence::Place NetFtSequence::begin(const NetFtRecord& record, Timestamp stamp) noexcept {
  const double since_s = to_seconds(stamp - *started_) + kStampJitter_s;
  const double sent = 1.0 + sent_in(since_s);
  if (since_s < 0.0 || record.rdt_sequence == 0 || record.rdt_sequence > sent + kPartOfRecord)
    return Place::stale;
  lost_ += record.rdt_sequence - 1;
  join(record, stamp, sent - record.rdt_sequence);
  return Place::in_order;
}

/// Makes this record the newest one.
void NetFtSequence::advance(const NetFtRecord& record, Timestamp stamp) noexcept {
  const std::uint32_t ahead = record.rdt_sequence - newest_->rdt;
  lost_ += ahead - 1;
  seen_ = ahead < kWindow ? seen_ << ahead : 0;
  newest_ = Number{record.rdt_sequence, record.ft_sequence};
  newest_stamp_ = std::max(newest_stamp_, stamp);
  unplaced_.reset();
  remember(record);
}

/// A record with a higher number than all before.
NetFtSequence::Place NetFtSequence::go_on(const NetFtRecord& record, Timestamp stamp) noexcept {
  const std::uint32_t ahead = record.rdt_sequence - newest_->rdt;
  const std::uint32_t ft_ahead = record.ft_sequence - newest_->ft;
  if (ft_ahead >= kHalf) return contradiction(record, stamp, Place::unplaced);
  const double since_s = std::max(0.0, to_seconds(stamp - newest_stamp_));
  // A record that follows the newest one directly may have had a long delay. If records before it
  // are missing, a shorter delay is accepted: a gap must agree with the time.
  const double given_back = kGivenBack * kRateTolerance * sent_in(since_s);
  const double spare = std::max(spare_ - given_back, std::min(spare_, jitter_));
  const double kept = ahead == 1 ? spare : std::min(spare, kLongestJitter_s * rate_Hz_);
  const double most_ft = (since_s + kLongestDelay_s) * kNetFtFastest_Hz * (1.0 + kRateTolerance);
  if (ft_ahead > most_ft) return contradiction(record, stamp, Place::impossible);
  if (ahead > sent_in(since_s) + kept + slack()) return before_its_time(record, stamp);
  advance(record, stamp);
  const double caught_up = ahead - sent_in(since_s);
  spare_ = std::min(spare - caught_up, kLongestDelay_s * rate_Hz_);
  jitter_ = std::max(jitter_ * std::max(0.0, 1.0 - since_s / kJitterMemory_s), caught_up);
  if (ft_ahead != 0) return Place::in_order;
  ++stalled_;
  return Place::stalled;
}

/// If all records come earlier from now on, a long delay of the network has ended. The stream goes
/// on with the first record that is not too early after the one before.
NetFtSequence::Place NetFtSequence::before_its_time(const NetFtRecord& record,
                                                    Timestamp stamp) noexcept {
  if (record.rdt_sequence - newest_->rdt >= kWindow || !unplaced_)
    return contradiction(record, stamp, Place::impossible);
  const std::uint32_t ahead = record.rdt_sequence - unplaced_->number.rdt;
  const bool follows = ahead >= 1 && ahead < kWindow;
  if (follows && ahead <= sent_in(to_seconds(stamp - unplaced_->stamp)) + slack()) {
    advance(record, stamp);
    spare_ = 0.0;
    return Place::in_order;
  }
  ++impossible_;
  unplaced_ = Arrival{{record.rdt_sequence, record.ft_sequence}, stamp};
  return Place::impossible;
}

/// If this record continues the last one that did not fit, the stream began anew; else it is a
/// stray record.
NetFtSequence::Place NetFtSequence::contradiction(const NetFtRecord& record, Timestamp stamp,
                                                  Place what) noexcept {
  if (unplaced_) {
    const std::uint32_t ahead = record.rdt_sequence - unplaced_->number.rdt;
    const std::uint32_t ft_ahead = record.ft_sequence - unplaced_->number.ft;
    if (ahead >= 1 && ahead < kWindow && ft_ahead < kHalf) {
      ++restarts_;
      lost_ += ahead - 1;
      join(record, stamp, kLongestDelay_s * rate_Hz_);
      return Place::restarted;
    }
  }
  ++(what == Place::impossible ? impossible_ : late_);
  unplaced_ = Arrival{{record.rdt_sequence, record.ft_sequence}, stamp};
  return what;
}

void NetFtSequence::reset_counters() noexcept {
  lost_ = 0;
  duplicate_ = 0;
  late_ = 0;
  stalled_ = 0;
  impossible_ = 0;
  restarts_ = 0;
}

}  // namespace isograsp
