// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of `isograsp hand`, and what they share.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "app/command_line.hpp"
#include "core/result.hpp"
#include "core/tables/word_table.hpp"
#include "virtual_hand/hand_pose.hpp"

namespace isograsp::app {

/// fk, distance (app/tracked_hand/hand_geometry.cpp).
void add_hand_geometry(Subcommand hand);
/// grasp, gains, couple, least-force (app/tracked_hand/hand_grasp.cpp).
void add_hand_grasp(Subcommand hand);
/// assist, score (app/tracked_hand/hand_traces.cpp).
void add_hand_traces(Subcommand hand);
/// calibrate, angles, convert (app/tracked_hand/hand_streams.cpp).
void add_hand_streams(Subcommand hand);
/// hold, squeeze, slide (app/tracked_hand/hand_world.cpp).
void add_hand_world(Subcommand hand);
/// record, emulate (app/tracked_hand/hand_live.cpp).
void add_hand_live(Subcommand hand);
/// plan (app/tracked_hand/hand_study.cpp).
void add_hand_study(Subcommand hand);
/// study (app/tracked_hand/hand_simulated_study.cpp).
void add_hand_simulated_study(Subcommand hand);
/// simulate, thresholds (app/tracked_hand/hand_simulate.cpp).
void add_hand_simulate(Subcommand hand);

/// The hand of a file (isograsp-hand-1).
[[nodiscard]] Result<virtual_hand::HandModel> load_hand(const std::string& path);

/// Rows of a table by the names of its columns. Getters return a plain value; the first problem is
/// remembered, with line and column, and told by good().
class CaseTable {
 public:
  [[nodiscard]] static Result<CaseTable> open(const std::string& path);
  [[nodiscard]] Result<bool> next() { return table_.next(); }

  double number(const std::string& column);
  /// Nothing: the field is empty.
  std::optional<double> number_if_any(const std::string& column);
  bool flag(const std::string& column);  ///< 0 or 1
  int whole(const std::string& column);
  std::string word(const std::string& column);
  /// PREFIXx…, PREFIXy…, PREFIXz… with the ending behind them.
  Vec3 three(const std::string& prefix, const std::string& ending = "");
  /// PREFIXqw … PREFIXqz, normalised.
  Quat attitude(const std::string& prefix);
  /// Twenty columns DIGIT_ANGLE_rad.
  std::array<virtual_hand::DigitAngles, kDigitCount> angles();

  void fail(const std::string& column, Text what, Text remedy);
  void fail(Error error);
  [[nodiscard]] Result<void> good() const;
  [[nodiscard]] bool has(const std::string& column) const {
    return table_.find(column).has_value();
  }

 private:
  explicit CaseTable(WordTable table) : table_(std::move(table)) {}
  std::optional<std::size_t> column(const std::string& name);
  WordTable table_;
  std::optional<Error> first_;
};

/// Reads every row by `read(table)`; errors of the table or of its fields end it.
template <class Read>
[[nodiscard]] Result<void> read_cases(const std::string& path, const Read& read) {
  auto table = CaseTable::open(path);
  if (!table) return table.error();
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) return {};
    read(*table);
    if (auto good = table->good(); !good) return good;
  }
}

/// The hand files that a table names in its column `hand`; they lie beside it, each is read once.
class HandsOfTable {
 public:
  explicit HandsOfTable(std::filesystem::path table) : folder_(table.parent_path()) {}
  /// That of a row; null: it cannot be read, and the row fails.
  [[nodiscard]] const virtual_hand::HandModel* of(CaseTable& row);

 private:
  std::filesystem::path folder_;
  std::map<std::string, virtual_hand::HandModel> read_;
};

using HandJson = nlohmann::ordered_json;
/// [x, y, z]
[[nodiscard]] HandJson place_json(const Vec3& p);

}  // namespace isograsp::app
