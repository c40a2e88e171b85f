// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand: the hand that follows a tracked one, its grasps and what helps them, offline
// (docs/virtual_hand.md).
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/files.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp::app {

HandJson place_json(const Vec3& p) {
  return HandJson::array({p.x(), p.y(), p.z()});
}

Result<virtual_hand::HandModel> load_hand(const std::string& path) {
  const auto text = read_text(path);
  if (!text) return text.error();
  return virtual_hand::parse_hand(*text, path);
}

Result<CaseTable> CaseTable::open(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  return CaseTable(*std::move(table));
}

void CaseTable::fail(const std::string& column, Text what, Text remedy) {
  if (!first_) first_ = table_.error_here(column, std::move(what), std::move(remedy));
}

void CaseTable::fail(Error error) {
  if (!first_) first_ = std::move(error);
}

const virtual_hand::HandModel* HandsOfTable::of(CaseTable& row) {
  const std::string name = row.word("hand");
  if (const auto known = read_.find(name); known != read_.end()) return &known->second;
  auto hand = load_hand(folder_ / (name + ".toml"));
  if (hand) return &(read_[name] = *std::move(hand));
  row.fail(hand.error());
  return nullptr;
}

Result<void> CaseTable::good() const {
  if (first_) return *first_;
  return {};
}

std::optional<std::size_t> CaseTable::column(const std::string& name) {
  const auto found = table_.require(name);
  if (found) return *found;
  if (!first_) first_ = found.error();
  return std::nullopt;
}

std::optional<double> CaseTable::number_if_any(const std::string& name) {
  const auto at = column(name);
  if (!at) return std::nullopt;
  const auto value = table_.number(*at);
  if (value) return *value;
  if (!first_) first_ = value.error();
  return std::nullopt;
}

double CaseTable::number(const std::string& name) {
  const auto at = column(name);
  if (!at) return 0.0;
  const auto value = table_.required_number(*at);
  if (value) return *value;
  if (!first_) first_ = value.error();
  return 0.0;
}

bool CaseTable::flag(const std::string& name) {
  const std::string text = word(name);
  if (text != "0" && text != "1")
    fail(name, "'%1' is neither 0 nor 1"_text(text), "write 1 for yes and 0 for no"_text);
  return text == "1";
}

int CaseTable::whole(const std::string& name) {
  constexpr double kMost = 1e9;
  const double value = number(name);
  if (!(value >= 0.0 && value <= kMost && value == std::floor(value))) {
    fail(name, "is no whole number"_text, "count from 0"_text);
    return 0;
  }
  return static_cast<int>(value);
}

std::string CaseTable::word(const std::string& name) {
  const auto at = column(name);
  return at ? std::string(table_.word(*at)) : std::string();
}

Vec3 CaseTable::three(const std::string& prefix, const std::string& ending) {
  return {number(prefix + "x" + ending), number(prefix + "y" + ending),
          number(prefix + "z" + ending)};
}

Quat CaseTable::attitude(const std::string& prefix) {
  const auto q = unit_quaternion(number(prefix + "qw"), number(prefix + "qx"),
                                 number(prefix + "qy"), number(prefix + "qz"));
  if (!q)
    fail(prefix + "qw", "is no attitude"_text,
         "write a quaternion w, x, y, z that is not zero"_text);
  return q.value_or(Quat::Identity());
}

std::array<virtual_hand::DigitAngles, kDigitCount> CaseTable::angles() {
  std::array<virtual_hand::DigitAngles, kDigitCount> angles{};
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t a = 0; a < virtual_hand::kAngleCount; ++a)
      angles[d][a] = number(std::string(kDigitNames[d]) + "_" +
                            std::string(virtual_hand::kDigitAngleNames[a]) + "_rad");
  return angles;
}

void add_hand(CommandLine& line) {
  Subcommand hand =
      line.subcommand("hand", "A tracked hand: its size and pose, its grasps, what helps them");
  hand.requires_subcommand();
  add_hand_geometry(hand);
  add_hand_grasp(hand);
  add_hand_traces(hand);
  add_hand_streams(hand);
  add_hand_world(hand);
  add_hand_live(hand);
  add_hand_study(hand);
  add_hand_simulate(hand);
  add_hand_simulated_study(hand);
  hand.footer("Example:\n  isograsp hand calibrate --stream open.csv --side right --out hand.toml");
}

}  // namespace isograsp::app
