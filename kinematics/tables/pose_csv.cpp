// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/tables/pose_csv.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/csv.hpp"
#include "core/tables/word_table.hpp"

namespace isograsp {

namespace {

constexpr std::array<const char*, 7> kPoseEndings{"_x_m", "_y_m", "_z_m", "_qw",
                                                  "_qx",  "_qy",  "_qz"};
constexpr std::array<const char*, 3> kFitEndings{"_residual_m", "_used", "_state"};
constexpr std::array<const char*, 3> kAngleEndings{"_a1_rad", "_a2_rad", "_a3_rad"};
constexpr std::size_t kColumnsOfFrame = kPoseEndings.size() + kFitEndings.size();
constexpr std::size_t kWriteAtOnce = std::size_t{1} << 16;

void append_field(std::string& text, double value) {
  text += ',';
  append_number(text, value);
}

void append_pose(std::string& text, const Pose& pose) {
  for (const double value :
       {pose.p.x(), pose.p.y(), pose.p.z(), pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()})
    append_field(text, value);
}

/// Names of the frames, if the header is one of poses.
Result<std::vector<std::string>> frames_in(const WordTable& table) {
  const auto& columns = table.columns();
  constexpr Words kRemedy =
      "name t_s and then, for each frame, NAME_x_m, _y_m, _z_m, _qw, _qx, _qy, _qz, _residual_m, "
      "_used, _state"_text;
  if (columns.front() != "t_s")
    return table.error_here(columns.front(), "the first column is not t_s"_text, kRemedy);
  std::vector<std::string> frames;
  for (std::size_t c = 1; c < columns.size(); c += kColumnsOfFrame) {
    const std::string& first = columns[c];
    if (!first.ends_with(kPoseEndings[0]))
      return table.error_here(first, "begins no pose of a frame"_text, kRemedy);
    const std::string name = first.substr(0, first.size() - std::string(kPoseEndings[0]).size());
    for (std::size_t k = 0; k < kColumnsOfFrame; ++k) {
      const std::string wanted =
          name + (k < kPoseEndings.size() ? kPoseEndings[k] : kFitEndings[k - kPoseEndings.size()]);
      if (c + k >= columns.size() || columns[c + k] != wanted)
        return table.error_here(c + k < columns.size() ? columns[c + k] : first,
                                "column '%1' does not stand in its place"_text(wanted), kRemedy);
    }
    frames.push_back(name);
  }
  if (frames.empty()) return table.error_here("", "names no frame"_text, kRemedy);
  return frames;
}

/// The pose whose seven columns begin at `column`; missing if all of them are empty.
Result<Pose> pose_at(const WordTable& table, std::size_t column) {
  std::array<double, kPoseEndings.size()> values{};
  std::size_t given = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto value = table.number(column + k);
    if (!value) return value.error();
    values[k] = value->value_or(kMissing);
    given += value->has_value() ? 1 : 0;
  }
  if (given == 0) return missing_pose();
  if (given < values.size())
    return table.error_here(table.columns()[column], "a part of the pose is empty"_text,
                            "give all seven numbers, or none if it is missing"_text);
  const auto q = unit_quaternion(values[3], values[4], values[5], values[6]);
  if (!q)
    return table.error_here(table.columns()[column + 3], "is no attitude"_text,
                            "write a quaternion w, x, y, z that is not zero"_text);
  return Pose{{values[0], values[1], values[2]}, *q};
}

}  // namespace

Result<PoseSeries> read_poses(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  auto frames = frames_in(*table);
  if (!frames) return frames.error();
  PoseSeries series;
  series.source = path;
  series.frames = std::move(*frames);
  series.X_W.resize(series.frames.size());
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) break;
    const auto t_s = table->required_number(0);
    if (!t_s) return t_s.error();
    if (!series.t_s.empty() && *t_s <= series.t_s.back())
      return table->error_here("t_s", "time does not increase"_text,
                               "sort the rows and remove repeats"_text);
    series.t_s.push_back(*t_s);
    for (std::size_t f = 0; f < series.frames.size(); ++f) {
      const auto pose = pose_at(*table, 1 + f * kColumnsOfFrame);
      if (!pose) return pose.error();
      series.X_W[f].push_back(*pose);
    }
  }
  if (series.t_s.empty())
    return table->error_here("", "holds no row"_text, "give at least one row"_text);
  return series;
}

Result<PoseWriter> PoseWriter::create(const std::string& path, const Rig& rig, Hand hand) {
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  std::string head = "# hand: " + std::string(name_of(hand)) + "\nt_s";
  for (const RigFrame& frame : rig.frames) {
    for (const char* ending : kPoseEndings) head += "," + frame.name + ending;
    for (const char* ending : kFitEndings) head += "," + frame.name + ending;
  }
  file->write(head + "\n");
  return PoseWriter(std::move(*file), rig);
}

void PoseWriter::write(double t_s, std::span<const FramePose> frames) {
  append_number(text_, t_s);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const FramePose& frame = frames[f];
    append_pose(text_, frame.X_W);
    append_field(text_, frame.residual_m);
    text_ += ',' + std::to_string(frame.used) + ',' + name_of(frame, rig_->frames[f]);
  }
  text_ += '\n';
  if (text_.size() < kWriteAtOnce) return;
  file_.write(text_);
  text_.clear();
}

Result<void> PoseWriter::commit() {
  file_.write(text_);
  return file_.commit();
}

Result<void> write_links(const std::string& path, const Rig& rig, const PoseSeries& series) {
  std::vector<std::vector<Pose>> links;
  std::string text = "t_s";
  for (const RigLink& link : rig.links) {
    auto poses = link_poses(series, link.parent, link.child);
    if (!poses) return poses.error();
    links.push_back(std::move(*poses));
    for (const char* ending : kPoseEndings) text += "," + link.name + ending;
    for (const char* ending : kAngleEndings) text += "," + link.name + ending;
  }
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  text += "\n";
  std::vector<Quat> last(links.size(), missing_pose().q);
  for (std::size_t row = 0; row < series.t_s.size(); ++row) {
    append_number(text, series.t_s[row]);
    for (std::size_t l = 0; l < links.size(); ++l) {
      Pose X_L = links[l][row];
      Vec3 angles = Vec3::Constant(kMissing);
      if (!is_missing(X_L)) {
        angles = link_angles(X_L.q, rig.links[l]);
        last[l] = X_L.q = continued(X_L.q, last[l]);
      }
      append_pose(text, X_L);
      for (const double angle : angles) append_field(text, angle);
    }
    text += '\n';
    if (text.size() < kWriteAtOnce) continue;
    file->write(text);
    text.clear();
  }
  file->write(text);
  return file->commit();
}

}  // namespace isograsp
