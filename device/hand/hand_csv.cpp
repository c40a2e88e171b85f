// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/hand_csv.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>

#include "core/csv.hpp"
#include "core/tables/word_table.hpp"

namespace isograsp {

namespace {

constexpr std::array<std::string_view, 3> kPointAxes{"_x_m", "_y_m", "_z_m"};

/// Where in the table the joints are.
using JointColumns = std::array<std::optional<std::array<std::size_t, 3>>, kHandJointCount>;

Error unknown_column(const WordTable& table, const std::string& name) {
  return table.error_here(
      name, "is no column of a tracked hand"_text,
      "name t_s, hand, tracked, confidence, then JOINT_x_m, JOINT_y_m, JOINT_z_m"_text);
}

Result<JointColumns> joint_columns(const WordTable& table) {
  JointColumns joints;
  std::size_t known = 0;
  for (std::size_t j = 0; j < kHandJointCount; ++j) {
    const std::string name(kHandJointNames[j]);
    const auto x = table.find(name + std::string(kPointAxes[0]));
    const auto y = table.find(name + std::string(kPointAxes[1]));
    const auto z = table.find(name + std::string(kPointAxes[2]));
    if (x && y && z) joints[j] = {*x, *y, *z};
    known += std::size_t{x.has_value()} + std::size_t{y.has_value()} + std::size_t{z.has_value()};
    if (x.has_value() != y.has_value() || y.has_value() != z.has_value())
      return table.error_here(name, "an axis of the joint is missing"_text,
                              "give x, y and z of a joint, or none of them"_text);
    known += std::size_t{table.find(name + "_radius_m").has_value()};
  }
  for (const char* name : {"t_s", "hand", "tracked", "confidence"})
    known += std::size_t{table.find(name).has_value()};
  if (known == table.columns().size()) return joints;
  for (const std::string& name : table.columns()) {
    const bool of_row =
        name == "t_s" || name == "hand" || name == "tracked" || name == "confidence";
    const bool of_joint =
        std::any_of(kHandJointNames.begin(), kHandJointNames.end(), [&](std::string_view joint) {
          if (!name.starts_with(joint)) return false;
          const std::string_view rest = std::string_view(name).substr(joint.size());
          return rest == "_radius_m" ||
                 std::find(kPointAxes.begin(), kPointAxes.end(), rest) != kPointAxes.end();
        });
    if (!of_row && !of_joint) return unknown_column(table, name);
  }
  return joints;
}

class HandCsvReader {
 public:
  static Result<HandCsvReader> open(const std::string& path) {
    auto table = WordTable::open(path);
    if (!table) return table.error();
    HandCsvReader reader(*std::move(table));
    for (const auto& [name, column] :
         {std::pair{"t_s", &reader.time_}, std::pair{"hand", &reader.hand_},
          std::pair{"tracked", &reader.tracked_}}) {
      const auto found = reader.table_.require(name);
      if (!found) return found.error();
      *column = *found;
    }
    reader.confidence_ = reader.table_.find("confidence");
    auto joints = joint_columns(reader.table_);
    if (!joints) return joints.error();
    reader.joints_ = *joints;
    return reader;
  }

  Result<bool> next(HandFrame& frame) {
    const auto more = table_.next();
    if (!more || !*more) return more;
    if (auto read = read_row(frame); !read) return read.error();
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      if (auto read = read_joint(j, frame.joints[j]); !read) return read.error();
    double& last_s = last_s_[static_cast<std::size_t>(frame.side)];
    if (!(frame.t_s > last_s))
      return table_.error_here("t_s", "time does not increase"_text,
                               "sort the rows and remove repeats"_text);
    last_s = frame.t_s;
    return true;
  }

 private:
  explicit HandCsvReader(WordTable table) : table_(std::move(table)) {}

  Result<void> read_row(HandFrame& frame) {
    const auto t_s = table_.required_number(time_);
    if (!t_s) return t_s.error();
    frame.t_s = *t_s;
    const auto side = hand_from_name(table_.word(hand_));
    if (!side)
      return table_.error_here("hand", "'%1' is no hand"_text(table_.word(hand_)),
                               "write right or left"_text);
    frame.side = *side;
    const std::string_view tracked = table_.word(tracked_);
    if (tracked != "0" && tracked != "1")
      return table_.error_here("tracked", "'%1' is neither 0 nor 1"_text(tracked),
                               "write 1 where the hand was seen, else 0"_text);
    frame.tracked = tracked == "1";
    frame.confidence = 1.0;
    if (!confidence_) return {};
    const auto confidence = table_.number(*confidence_);
    if (!confidence) return confidence.error();
    frame.confidence = confidence->value_or(1.0);
    if (!(frame.confidence >= 0.0 && frame.confidence <= 1.0))
      return table_.error_here("confidence", "is out of range"_text, "write 0 to 1"_text);
    return {};
  }

  Result<void> read_joint(std::size_t j, Vec3& p) {
    p = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    if (!joints_[j]) return {};
    int empty = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const auto value = table_.number((*joints_[j])[a]);
      if (!value) return value.error();
      empty += value->has_value() ? 0 : 1;
      if (*value) p[static_cast<Eigen::Index>(a)] = **value;
    }
    if (empty == 1 || empty == 2)
      return table_.error_here(std::string(kHandJointNames[j]),
                               "a part of the position is empty"_text,
                               "give x, y and z, or none of them if it was not seen"_text);
    return {};
  }

  WordTable table_;
  std::size_t time_ = 0;
  std::size_t hand_ = 0;
  std::size_t tracked_ = 0;
  std::optional<std::size_t> confidence_;
  JointColumns joints_;
  std::array<double, 2> last_s_{-std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};
};

}  // namespace

Result<std::vector<HandFrame>> read_hand_csv(const std::string& path) {
  auto reader = HandCsvReader::open(path);
  if (!reader) return reader.error();
  std::vector<HandFrame> frames;
  for (;;) {
    HandFrame frame;
    const auto more = reader->next(frame);
    if (!more) return more.error();
    if (!*more) return frames;
    frames.push_back(frame);
  }
}

Result<HandCsvWriter> HandCsvWriter::create(const std::string& path) {
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  HandCsvWriter writer(*std::move(file));
  std::string header = "t_s,hand,tracked,confidence";
  for (const std::string_view joint : kHandJointNames)
    for (const std::string_view axis : kPointAxes)
      header += "," + std::string(joint) + std::string(axis);
  writer.file_.write(header + "\n");
  return writer;
}

void HandCsvWriter::write(const HandFrame& frame) {
  text_.clear();
  append_number(text_, frame.t_s);
  text_ += ",";
  text_ += name_of(frame.side);
  text_ += frame.tracked ? ",1," : ",0,";
  append_number(text_, frame.confidence);
  for (const Vec3& p : frame.joints)
    for (const double value : p) {
      text_ += ",";
      if (std::isfinite(value)) append_number(text_, value);
    }
  text_ += "\n";
  file_.write(text_);
}

bool begins_like_hand_csv(const std::string& path) {
  constexpr std::string_view kBegin = "t_s,hand,tracked";
  std::ifstream file(path, std::ios::binary);
  std::string begin(kBegin.size(), ' ');
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kBegin;
}

}  // namespace isograsp
