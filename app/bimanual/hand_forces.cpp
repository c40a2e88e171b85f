// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bimanual/hand_forces.hpp"

#include <algorithm>
#include <cmath>

#include "app/simulation/table_files.hpp"
#include "device/config/platform.hpp"
#include "hand/columns.hpp"

namespace isograsp::app {

namespace {

using bimanual::Side;

std::string push_column(Side side, std::size_t axis) {
  return prefix_of(side) + "push_" + "xyz"[axis] + "_N";
}

/// Of the first column that begins so.
std::optional<std::string> column_from(const TableReader& table, const std::string& begin) {
  const auto& names = table.columns();
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&](const std::string& name) { return name.starts_with(begin); });
  return found == names.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::string> column_of_fingers(const TableReader& table, Side side) {
  for (const std::string_view finger : kFingerNames)
    if (auto found = column_from(table, prefix_of(side) + std::string(finger) + "_")) return found;
  return std::nullopt;
}

Wrench push_of(const FingerWrenches& wrench_C, Side side) noexcept {
  Wrench push = net_wrench(Platform(), wrench_C);
  if (side == Side::left)
    for (Vec3* part : {&push.force, &push.torque}) *part = Vec3(-part->x(), part->y(), -part->z());
  return push;
}

}  // namespace

std::string prefix_of(Side side) {
  return side == Side::left ? "left_" : "right_";
}

Result<HandForcesReader> HandForcesReader::open(const std::string& path, Side side,
                                                const HandNeeds& needs) {
  auto table = open_table(path);
  if (!table) return table.error();
  HandForcesReader reader(*std::move(table), side);
  const auto time = reader.table_->find(columns::t_s);
  if (!time)
    return reader.table_->error_here(columns::t_s, "the column is missing"_text,
                                     "add the time of each row in seconds"_text);
  reader.time_ = *time;
  reader.fields_.resize(reader.table_->columns().size());
  reader.clutch_ = reader.table_->find(prefix_of(side) + "clutch");
  const auto push = column_from(*reader.table_, prefix_of(side) + "push_");
  const auto finger = column_of_fingers(*reader.table_, side);
  if (push && finger)
    return reader.table_->error_here(*finger, "the file has pushes of this hand, too"_text,
                                     "keep either pushes or fingers of one hand"_text);
  const bool needs_finger =
      std::any_of(needs.fingers.begin(), needs.fingers.end(), [](bool used) { return used; });
  if (finger || needs_finger) {
    const auto used = needs.push ? std::array{true, true, true} : needs.fingers;
    auto again = open_table(path);
    if (!again) return again.error();
    auto fingers = FingerForcesReader::open(*std::move(again), used, prefix_of(side));
    if (!fingers) return fingers.error();
    reader.fingers_ = std::move(*fingers);
    return reader;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    reader.push_[axis] = reader.table_->find(push_column(side, axis));
    if (!reader.push_[axis] && (push || needs.push))
      return reader.table_->error_here(push_column(side, axis), "the column is missing"_text,
                                       "add the column"_text);
  }
  return reader;
}

Result<bool> HandForcesReader::next(HandForcesRow& row) {
  const auto more = table_->next(fields_);
  if (!more || !*more) return more;
  row.t_s = fields_[time_];
  row.clutch = clutch_ && fields_[*clutch_] != 0.0 && !std::isnan(fields_[*clutch_]);
  row.push_W.reset();
  if (fingers_) {
    if (const auto read = fingers_->next(row.fingers); !read) return read.error();
    const auto& present = row.fingers.present;
    if (std::all_of(present.begin(), present.end(), [](bool there) { return there; }))
      row.push_W = push_of(row.fingers.wrench_C, side_);
    return true;
  }
  if (!push_.front()) return true;
  Vec3 force_N = Vec3::Zero();
  std::size_t empty = 0, an_empty_axis = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = fields_[*push_[axis]];
    force_N[static_cast<Eigen::Index>(axis)] = value;
    if (!std::isnan(value)) continue;
    ++empty;
    an_empty_axis = axis;
  }
  if (empty > 0 && empty < 3)
    return table_->error_here(push_column(side_, an_empty_axis),
                              "the field is empty while others of this push are not"_text,
                              "give the value, or leave all fields of the push empty"_text);
  if (empty == 0) row.push_W = Wrench{force_N, Vec3::Zero()};
  return true;
}

Error HandForcesReader::no_sample() const {
  return table_->error_here(fingers_ ? *column_of_fingers(*table_, side_) : push_column(side_, 0),
                            "is empty, and hands that are points need a push in each row"_text,
                            "give the value"_text);
}

}  // namespace isograsp::app
