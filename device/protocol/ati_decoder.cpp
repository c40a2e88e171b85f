// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/protocol/ati_decoder.hpp"

#include <algorithm>

namespace isograsp {

std::optional<AtiSample> AtiDecoder::push(const BusFrame& frame, Timestamp stamp) noexcept {
  switch (ati_word(frame)) {
    case AtiWord::foreign: ++foreign_; return std::nullopt;
    case AtiWord::request: hear_request(frame); return std::nullopt;
    case AtiWord::either:  // a slot is asked for, then echoed: both mean the same
      echo_due_ = !echo_due_;
      ++(echo_due_ ? requests_ : answers_);
      select(frame.data[0]);
      return std::nullopt;
    case AtiWord::answer: return hear_answer(frame, stamp);
  }
  return std::nullopt;
}

void AtiDecoder::hear_request(const BusFrame& frame) noexcept {
  ++requests_;
  sees_requests_ = true;
  switch (ati_opcode(frame)) {
    case AtiOpcode::gages: return pairing_.ask();
    case AtiOpcode::matrix_row: row_ = frame.data[0]; return assembly_.forget();
    case AtiOpcode::reset: return select(0);  // every reset selects slot 0
    default: return;
  }
}

/// Another slot: what was learned is forgotten, since it belongs to the slot before. The same slot
/// again changes nothing.
void AtiDecoder::select(std::uint8_t slot) noexcept {
  if (slot_ && *slot_ != slot) calibration_.reset();
  slot_ = slot;
  rows_ = {};
  row_ = 0;
  assembly_.forget();
}

std::optional<AtiSample> AtiDecoder::hear_answer(const BusFrame& frame, Timestamp stamp) noexcept {
  const AtiOpcode opcode = ati_opcode(frame);
  if (opcode != AtiOpcode::gages && opcode != AtiOpcode::odd_gages) ++answers_;
  switch (opcode) {
    case AtiOpcode::gages:
    case AtiOpcode::odd_gages: {
      const auto paired = pairing_.push(frame, stamp);
      if (!paired) return std::nullopt;
      if (!calibration_) {
        ++uncalibrated_;
        return std::nullopt;
      }
      return AtiSample{paired->stamp, paired->reading,
                       wrench_of(paired->reading.gages, Vec6::Zero(), *calibration_),
                       paired->reading.valid()};
    }
    case AtiOpcode::matrix_row:
    case AtiOpcode::row_middle:
    case AtiOpcode::row_end:
      if (const auto row = assembly_.push(frame)) hear_row(*row);
      break;
    case AtiOpcode::counts:
      counts_ = ati_counts_of(frame);
      if (!first_counts_) first_counts_ = counts_;
      if (calibration_ && counts_->per_force != 0 && counts_->per_torque != 0)
        calibration_->counts = *counts_;
      break;
    case AtiOpcode::units:
      units_ = ati_units_of(frame);
      if (!first_units_) first_units_ = units_;
      if (calibration_ && ati_newton(units_->force) && ati_newton_metre(units_->torque))
        calibration_->units = *units_;
      break;
    default: break;
  }
  return std::nullopt;
}

void AtiDecoder::hear_row(const AtiRow& row) noexcept {
  // An answer does not say which row it is. Without requests in the log they come in the order of
  // the start-up, from the first on.
  if (row_ < rows_.size()) rows_[row_] = row;
  row_ = sees_requests_ ? rows_.size() : row_ + 1;
  if (!std::all_of(rows_.begin(), rows_.end(), [](const auto& r) { return r.has_value(); })) return;
  AtiCalibration calibration;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (std::size_t j = 0; j < rows_.size(); ++j)
      calibration.matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          (*rows_[i])[j];
  calibration.counts = counts_.value_or(AtiCounts{});
  calibration.units = units_.value_or(AtiUnits{});
  rows_ = {};
  row_ = 0;
  calibration_.reset();
  if (!calibration.usable()) return;
  calibration_ = calibration;
  if (!first_) first_ = calibration;
}

std::optional<AtiCalibration> AtiDecoder::learned() const noexcept {
  if (!first_) return std::nullopt;
  AtiCalibration learned = *first_;
  learned.counts = first_counts_.value_or(AtiCounts{});
  learned.units = first_units_.value_or(AtiUnits{});
  if (!learned.usable()) return std::nullopt;
  return learned;
}

}  // namespace isograsp
