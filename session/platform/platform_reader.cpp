// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/platform_reader.hpp"

#include <algorithm>
#include <utility>

#include "core/csv.hpp"

namespace isograsp::session {

PlatformReader::PlatformReader(std::unique_ptr<ForceDevice> device) : device_(std::move(device)) {}

std::optional<double> PlatformReader::resolution_N() const noexcept {
  double coarsest_N = 0.0;
  for (const Vec6& unit : info().units_per_count)
    coarsest_N = std::max(coarsest_N, unit.head<3>().cwiseAbs().maxCoeff());
  return coarsest_N > 0.0 ? std::optional(coarsest_N) : std::nullopt;  // 0: it has no counts
}

std::string PlatformReader::calibration() const {
  std::string text;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (info().units_per_count[f].isZero(0.0)) continue;
    text += std::string(kFingerNames[f]) + ": N or N m per count";
    for (const double unit : info().units_per_count[f]) text += " " + format_number(unit);
    if (!info().calibration[f].empty()) text += "; matrix " + info().calibration[f];
    text += "\n";
  }
  return text;
}

Result<void> PlatformReader::start(Clock& clock) {
  if (auto started = device_->start(clock); !started) return started;
  streaming_ = true;
  clock_ = &clock;
  return {};
}

void PlatformReader::begin(Timestamp start) {
  frames_.emplace(*device_, *clock_, start);
}

void PlatformReader::stop() noexcept {
  if (std::exchange(streaming_, false)) device_->stop();
}

void PlatformReader::begin(InstrumentZero& zero) noexcept {
  zero.zeroing = Zeroing(info().frame_period_s);
  zero.wait_s = zero.settle_s;
  for (std::size_t f = 0; f < kFingerCount; ++f) zero.restarts[f] = health_.sensors[f].restarts;
}

bool PlatformReader::measure(InstrumentZero& zero, const FingerFrame& frame) noexcept {
  if (zero.wait_s > 0.0) {
    zero.wait_s -= info().frame_period_s;
    return false;
  }
  zero.zeroing.add(frame);
  if (!zero.zeroing.complete() && !zero.zeroing.hopeless()) return false;
  judge(zero);
  return true;
}

void PlatformReader::judge(InstrumentZero& zero) const noexcept {
  zero.refusal = ZeroRefusal{};
  if (!zero.zeroing.complete()) return;
  zero.statistics = zero.zeroing.statistics();
  const SixAxes& mean = zero.statistics.mean;
  const auto& last = zero_ ? zero_ : last_zero_;
  zero.refusal = check_zero(zero.statistics, zero.accept_changed ? std::nullopt : last);
  zero.change_confirmed = zero.accept_changed && check_zero(zero.statistics, last).has_value();
  if (last) zero.change_N = largest_force_change_N(mean, *last);
  if (zero_) zero.drift_N = largest_force_change_N(mean, *zero_);
}

void PlatformReader::accept(const InstrumentZero& zero) noexcept {
  zero_ = zero.statistics.mean;
  restarts_at_zero_ = zero.restarts;
}

Reception PlatformReader::receive(FingerFrame& frame,
                                  const std::array<bool, kFingerCount>& used) noexcept {
  health_ = device_->health();
  Reception reception;
  reception.gap = frame.any(SampleFlag::missing);
  watch_restarts();
  subtract_zero(frame);
  reception.sight = hold_missing(frame, used);
  return reception;
}

void PlatformReader::watch_restarts() noexcept {
  restarted_.reset();
  if (!zero_) return;
  for (const Finger finger : kFingers)
    if (health_.sensors[index_of(finger)].restarts != restarts_at_zero_[index_of(finger)])
      restarted_ = finger;
}

void PlatformReader::subtract_zero(FingerFrame& frame) const noexcept {
  if (!zero_) return;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    frame.wrench_C[f].force -= (*zero_)[f].head<3>();
    frame.wrench_C[f].torque -= (*zero_)[f].tail<3>();
  }
}

Reception::Sight PlatformReader::hold_missing(FingerFrame& frame,
                                              const std::array<bool, kFingerCount>& used) noexcept {
  std::array<bool, kFingerCount> present{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    present[f] = (frame.flags[f] & bit(SampleFlag::missing)) == 0;
  const auto verdict = stale_.apply(frame.wrench_C, present, used, info().frame_period_s);
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (stale_.held(f)) frame.flags[f] = bit(SampleFlag::held);
  return verdict == StaleRule::Verdict::frozen ? Reception::Sight::lost : Reception::Sight::clear;
}

ApparatusFault PlatformReader::fault() const noexcept {
  if (health_.fault == DeviceFault::none) return {};
  // One number for each pair of fault and finger.
  const auto finger = health_.finger ? 1 + index_of(*health_.finger) : 0;
  return {static_cast<int>(static_cast<std::size_t>(health_.fault) * (1 + kFingerCount) + finger),
          words_of(health_.fault, health_.finger)};
}

}  // namespace isograsp::session
