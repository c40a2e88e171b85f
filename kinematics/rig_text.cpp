// SPDX-License-Identifier: GPL-3.0-or-later
// A rig as TOML, in the order of docs/markers.md.
#include <utility>

#include "core/csv.hpp"
#include "kinematics/read_attitude.hpp"
#include "kinematics/rig.hpp"

namespace isograsp {

namespace {

std::string names_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + toml_text(name);
  return "[" + text + "]";
}

std::string point_text(const RigPoint& point) {
  return point.size() == 1 ? toml_text(point.front()) : names_text(point);
}

std::string axis_text(const RigAxis& axis) {
  return "{ axis = \"" + std::string(axis.negative ? "-" : "") + "xyz"[axis.axis] +
         "\", from = " + point_text(axis.from) + ", to = " + point_text(axis.to) + " }";
}

struct MethodText {
  std::string operator()(const ClusterFrame& frame) const {
    std::string text = "method = \"cluster\"\nmarkers = " + names_text(frame.markers);
    text += "\ntemplate_m = [";
    for (std::size_t i = 0; i < frame.template_m.size(); ++i)
      text += (i == 0 ? "" : ", ") + toml_numbers(frame.template_m[i]);
    text += "]\n";
    if (frame.max_residual_m)
      text += "max_residual_m = " + format_number(*frame.max_residual_m) + "\n";
    if (frame.calibration)
      text += "calibration = { origin = " + point_text(frame.calibration->origin) +
              ", primary = " + axis_text(frame.calibration->primary) +
              ", secondary = " + axis_text(frame.calibration->secondary) + " }\n";
    if (frame.unlabelled) text += "unlabelled = true\n";
    return text;
  }
  std::string operator()(const PointsFrame& frame) const {
    return "method = \"points\"\norigin = " + point_text(frame.origin) +
           "\nprimary = " + axis_text(frame.primary) +
           "\nsecondary = " + axis_text(frame.secondary) + "\n";
  }
  std::string operator()(const PointFrame& frame) const {
    return "method = \"point\"\norigin = " + point_text(frame.origin) +
           "\norientation = " + toml_text(frame.orientation) + "\n";
  }
};

}  // namespace

std::string rig_text(const Rig& rig) {
  std::string text = "format = \"isograsp-rig-1\"\nname = " + toml_text(rig.name) +
                     "\nmax_residual_m = " + format_number(rig.max_residual_m) + "\n";
  if (!rig.markers.empty()) text += "markers = " + names_text(rig.markers) + "\n";
  for (const RigFrame& frame : rig.frames)
    text += "\n[[frame]]\nname = " + toml_text(frame.name) + "\n" +
            std::visit(MethodText(), frame.method);
  for (const RigLandmark& landmark : rig.landmarks)
    text += "\n[[landmark]]\nname = " + toml_text(landmark.name) +
            "\nframe = " + toml_text(landmark.frame) +
            "\nposition_m = " + toml_numbers(landmark.position_m) + "\n";
  for (const RigLink& link : rig.links) {
    text += "\n[[link]]\nname = " + toml_text(link.name) + "\nparent = " + toml_text(link.parent) +
            "\nchild = " + toml_text(link.child) + "\nsequence = \"" +
            std::string(kAngleSequenceNames[static_cast<std::size_t>(link.sequence)]) + "\"\n";
    if (link.zero) text += "zero_quaternion_wxyz = " + toml_numbers(*link.zero) + "\n";
  }
  if (rig.score) {
    text += "\n[score]\nforearm = " + toml_text(rig.score->forearm) +
            "\nsync = " + toml_text(rig.score->sync) +
            "\nobject = " + toml_text(rig.score->object) + "\n";
    for (const auto& [key, frame] : {std::pair("trunk", &rig.score->trunk),
                                     {"brace", &rig.score->brace},
                                     {"elbow", &rig.score->elbow}})
      if (*frame) text += std::string(key) + " = " + toml_text(**frame) + "\n";
  }
  if (!rig.alias.empty()) text += "\n[alias]\n";
  for (const RigAlias& alias : rig.alias)
    text += toml_text(alias.label) + " = " + toml_text(alias.marker) + "\n";
  if (rig.view)
    text += "\n[view]\nright = " + toml_text(rig.view->right) +
            "\nup = " + toml_text(rig.view->up) + "\n";
  return text;
}

}  // namespace isograsp
