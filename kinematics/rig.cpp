// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/rig.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/toml_reader.hpp"
#include "kinematics/read_attitude.hpp"
#include "kinematics/rigid_body.hpp"

namespace isograsp {

namespace {

constexpr std::array<std::string_view, 6> kSignedAxes{"x", "y", "z", "-x", "-y", "-z"};
/// No rig comes near; an arm has five.
constexpr std::size_t kMostFrames = 64;

template <class Named>
std::optional<std::size_t> find_named(const std::vector<Named>& all, std::string_view name) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name == name) return i;
  return std::nullopt;
}

/// Reads the frames with what they may refer to.
class RigReader {
 public:
  explicit RigReader(TomlReader& root) : root_(root) {}

  Rig read() {
    rig_.name = root_.text("name", "");
    rig_.max_residual_m = residual_limit(root_).value_or(rig_.max_residual_m);
    read_landmarks();
    read_markers();
    for (TomlReader& table : root_.tables("frame")) read_frame(table);
    if (rig_.frames.empty() && rig_.markers.empty())
      root_.fail("frame", "is missing"_text, "describe each frame in [[frame]]"_text);
    if (rig_.frames.size() > kMostFrames)
      root_.fail("frame", "are %1 frames"_text(rig_.frames.size()),
                 "give at most %1"_text(kMostFrames));
    check_landmarks();
    for (TomlReader& table : root_.tables("link")) read_link(table);
    read_score();
    read_alias();
    if (root_.has("view")) {
      TomlReader table = root_.table("view");
      rig_.view = {std::string(kSignedAxes[table.choice("right", kSignedAxes, 0)]),
                   std::string(kSignedAxes[table.choice("up", kSignedAxes, 1)])};
      if (rig_.view->right.back() == rig_.view->up.back())
        table.fail("up", "is along the axis that points to the right"_text,
                   "name another axis"_text);
    }
    return std::move(rig_);
  }

 private:
  static std::optional<double> residual_limit(TomlReader& table) {
    if (!table.has("max_residual_m")) return std::nullopt;
    const double limit_m = table.number("max_residual_m");
    if (!(limit_m > 0.0))
      table.fail("max_residual_m", "is not above zero"_text, "write a length in metres"_text);
    return limit_m;
  }

  std::string new_name(TomlReader& table) {
    std::string name = table.text("name");
    // It becomes part of column names.
    if (name.empty() || name == kWorld || name.find_first_of("=+-@#' ") == 0 ||
        name.find_first_of(",\"\n\r\t") != std::string::npos)
      table.fail("name", "'%1' cannot be a name"_text(name),
                 "take a word that begins with a letter, without commas and quotes"_text);
    return name;
  }

  void read_landmarks() {
    for (TomlReader& table : root_.tables("landmark")) {
      RigLandmark landmark{new_name(table), table.text("frame"), table.vec3("position_m")};
      if (find_named(rig_.landmarks, landmark.name))
        table.fail("name", "'%1' appears twice"_text(landmark.name), "keep one of them"_text);
      rig_.landmarks.push_back(std::move(landmark));
    }
  }

  void read_markers() {
    if (!root_.has("markers")) return;
    rig_.markers = root_.texts("markers");
    for (const std::string& marker : rig_.markers) {
      if (std::count(rig_.markers.begin(), rig_.markers.end(), marker) > 1)
        root_.fail("markers", "'%1' appears twice"_text(marker), "keep one of them"_text);
      if (find_named(rig_.landmarks, marker))
        root_.fail("markers", "'%1' is a landmark"_text(marker), "name markers"_text);
    }
  }

  RigPoint read_point(TomlReader& table, std::string_view key) {
    RigPoint point = table.text_or_texts(key);
    if (point.empty() && table.has(key))
      table.fail(key, "names no point"_text, "name markers or landmarks"_text);
    for (const std::string& name : point) {
      const auto landmark = find_named(rig_.landmarks, name);
      if (landmark && !rig_.frame(rig_.landmarks[*landmark].frame))
        table.fail(key, "the frame of landmark '%1' does not stand before this one"_text(name),
                   "write the frames in the order in which they need each other"_text);
    }
    return point;
  }

  RigAxis read_axis(TomlReader& frame, std::string_view key) {
    TomlReader table = frame.table(key);
    const std::size_t axis = table.choice("axis", kSignedAxes);
    return {static_cast<int>(axis % 3), axis >= 3, read_point(table, "from"),
            read_point(table, "to")};
  }

  PointsFrame read_points(TomlReader& table) {
    PointsFrame frame{read_point(table, "origin"), read_axis(table, "primary"),
                      read_axis(table, "secondary")};
    if (frame.primary.axis == frame.secondary.axis)
      table.fail("secondary", "has the same axis as the primary one"_text,
                 "name another axis"_text);
    return frame;
  }

  ClusterFrame read_cluster(TomlReader& table) {
    ClusterFrame frame;
    frame.markers = table.texts("markers");
    frame.template_m = table.vec3s("template_m");
    frame.max_residual_m = residual_limit(table);
    if (frame.markers.size() != frame.template_m.size())
      table.fail("template_m",
                 "has %1 points for %2 markers"_text(frame.template_m.size(), frame.markers.size()),
                 "give one point for each marker"_text);
    if (frame.markers.size() < 3 || frame.markers.size() > RigidBody::kMostMarkers)
      table.fail("markers", "are %1 markers"_text(frame.markers.size()),
                 "give 3 to %1"_text(RigidBody::kMostMarkers));
    for (const std::string& marker : frame.markers) {
      if (std::count(frame.markers.begin(), frame.markers.end(), marker) > 1)
        table.fail("markers", "'%1' appears twice"_text(marker), "keep one of them"_text);
      if (find_named(rig_.landmarks, marker))
        table.fail("markers", "'%1' is a landmark"_text(marker), "name markers"_text);
    }
    if (table.has("calibration")) {
      TomlReader recipe = table.table("calibration");
      frame.calibration = read_points(recipe);
    }
    frame.unlabelled = table.boolean("unlabelled", false);
    return frame;
  }

  void read_frame(TomlReader& table) {
    RigFrame frame;
    frame.name = new_name(table);
    if (rig_.frame(frame.name))
      table.fail("name", "'%1' appears twice"_text(frame.name), "keep one of them"_text);
    switch (table.choice("method", {"cluster", "points", "point"})) {
      case 0: frame.method = read_cluster(table); break;
      case 1: frame.method = read_points(table); break;
      default: {
        PointFrame point{read_point(table, "origin"), table.text("orientation")};
        if (!rig_.frame(point.orientation))
          table.fail("orientation", "'%1' is no frame before this one"_text(point.orientation),
                     "write the frames in the order in which they need each other"_text);
        frame.method = std::move(point);
      }
    }
    rig_.frames.push_back(std::move(frame));
  }

  void check_landmarks() {
    for (const RigLandmark& landmark : rig_.landmarks)
      if (!rig_.frame(landmark.frame))
        root_.fail("landmark",
                   "'%1' belongs to '%2', which is no frame"_text(landmark.name, landmark.frame),
                   "name a frame of this file"_text);
  }

  void read_link(TomlReader& table) {
    RigLink link;
    link.name = new_name(table);
    link.parent = table.text("parent");
    link.child = table.text("child");
    link.sequence = static_cast<AngleSequence>(table.choice("sequence", kAngleSequenceNames, 0));
    if (table.has("zero_quaternion_wxyz")) link.zero = read_attitude(table, "zero_quaternion_wxyz");
    if (rig_.link(link.name))
      table.fail("name", "'%1' appears twice"_text(link.name), "keep one of them"_text);
    for (const auto* key : {"parent", "child"}) {
      const std::string& frame = key == std::string_view("parent") ? link.parent : link.child;
      if (!rig_.frame(frame) && !(frame == kWorld && &frame == &link.parent))
        table.fail(key, "'%1' is no frame"_text(frame), "name a frame of this file"_text);
    }
    rig_.links.push_back(std::move(link));
  }

  void read_score() {
    if (!root_.has("score")) return;
    TomlReader table = root_.table("score");
    RigScore score{table.text("forearm"), table.text("sync"), table.text("object")};
    for (const auto& [key, name] : {std::pair("forearm", score.forearm), {"sync", score.sync}})
      if (!rig_.link(name))
        table.fail(key, "'%1' is no link"_text(name), "name a link of this file"_text);
    if (!rig_.frame(score.object))
      table.fail("object", "'%1' is no frame"_text(score.object), "name a frame of this file"_text);
    for (const auto& [key, frame] :
         {std::pair("trunk", &score.trunk), {"brace", &score.brace}, {"elbow", &score.elbow}}) {
      if (!table.has(key)) continue;
      *frame = table.text(key);
      if (!rig_.frame(**frame))
        table.fail(key, "'%1' is no frame"_text(**frame), "name a frame of this file"_text);
    }
    rig_.score = std::move(score);
  }

  void read_alias() {
    if (!root_.has("alias")) return;
    TomlReader table = root_.table("alias");
    const std::vector<std::string> markers = markers_of(rig_);
    for (const std::string& label : table.keys()) {
      const RigAlias alias{label, table.text(label)};
      if (std::find(markers.begin(), markers.end(), alias.marker) == markers.end())
        table.fail(label, "'%1' is no marker of this file"_text(alias.marker),
                   "name one of its markers"_text);
      rig_.alias.push_back(alias);
    }
  }

  TomlReader& root_;
  Rig rig_;
};

}  // namespace

std::optional<std::size_t> Rig::frame(std::string_view wanted) const noexcept {
  return find_named(frames, wanted);
}

std::optional<std::size_t> Rig::link(std::string_view wanted) const noexcept {
  return find_named(links, wanted);
}

Result<std::vector<std::string>> aliased(const Rig& rig, std::span<const std::string> labels) {
  std::vector<std::string> names(labels.begin(), labels.end());
  for (std::size_t i = 0; i < names.size(); ++i)
    for (const RigAlias& alias : rig.alias)
      if (alias.label == labels[i]) names[i] = alias.marker;
  for (const RigAlias& alias : rig.alias)
    if (std::count(names.begin(), names.end(), alias.marker) > 1)
      return refused("calls two markers '%1', by the names of the rig"_text(alias.marker),
                     "keep one of them in [alias]"_text);
  return names;
}

std::vector<std::string> markers_of(const Rig& rig) {
  std::vector<std::string> markers;
  const auto add = [&](const RigPoint& names) {
    for (const std::string& name : names)
      if (!find_named(rig.landmarks, name) &&
          std::find(markers.begin(), markers.end(), name) == markers.end())
        markers.push_back(name);
  };
  const auto add_points = [&](const PointsFrame& frame) {
    for (const RigPoint* point : {&frame.origin, &frame.primary.from, &frame.primary.to,
                                  &frame.secondary.from, &frame.secondary.to})
      add(*point);
  };
  for (const RigFrame& frame : rig.frames) {
    if (const auto* cluster = std::get_if<ClusterFrame>(&frame.method)) {
      add(cluster->markers);
      if (cluster->calibration) add_points(*cluster->calibration);
    } else if (const auto* points = std::get_if<PointsFrame>(&frame.method)) {
      add_points(*points);
    } else {
      add(std::get<PointFrame>(frame.method).origin);
    }
  }
  add(rig.markers);
  return markers;
}

Result<Rig> parse_rig(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-rig-1");
  if (!root) return root.error();
  Rig rig = RigReader(*root).read();
  if (auto done = root->finish(); !done) return done.error();
  return rig;
}

Rig mirrored(Rig rig) {
  for (RigFrame& frame : rig.frames)
    if (auto* cluster = std::get_if<ClusterFrame>(&frame.method))
      for (Vec3& point : cluster->template_m) point = mirrored(point);
  for (RigLandmark& landmark : rig.landmarks) landmark.position_m = mirrored(landmark.position_m);
  return rig;
}

}  // namespace isograsp
