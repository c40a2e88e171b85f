// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bimanual/pad_case.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "core/files.hpp"

namespace isograsp::app {

namespace {

using bimanual::PadFace;
using bimanual::PadPoint;
using bimanual::PadStep;

/// Numbers of a JSON array. Throws what nlohmann throws; caught where the file is named.
template <int kRows>
Eigen::Matrix<double, kRows, 1> numbers_in(const nlohmann::json& array) {
  Eigen::Matrix<double, kRows, 1> numbers;
  for (int i = 0; i < kRows; ++i) numbers[i] = array.at(static_cast<std::size_t>(i)).get<double>();
  return numbers;
}

PadFace face_in(const nlohmann::json& json) {
  PadFace face;
  face.object = json.at("object");
  face.pad = json.at("pad");
  face.friction = json.at("friction");
  face.stiffness_N_m3 = json.at("stiffness_N_m3");
  const auto& object = json.at("p_object_m");
  for (std::size_t i = 0; i < object.size(); ++i)
    face.points.push_back({numbers_in<3>(object.at(i)), numbers_in<3>(json.at("p_pad_m").at(i)),
                           numbers_in<3>(json.at("normal").at(i)),
                           json.at("area_m2").at(i).get<double>(),
                           json.at("penetration_free_m").at(i).get<double>()});
  return face;
}

PadStep step_in(const nlohmann::json& json) {
  PadStep step;
  step.step_s = json.at("step_s");
  for (const auto& rows : json.at("inertia_kg")) {
    bimanual::Mat6 inertia;
    for (int i = 0; i < 6; ++i)
      inertia.row(i) = numbers_in<6>(rows.at(static_cast<std::size_t>(i))).transpose();
    step.inertia.push_back(inertia);
  }
  for (const auto& velocity : json.at("velocity_free"))
    step.velocity_free.push_back(numbers_in<6>(velocity));
  for (const auto& pad : json.at("pads")) step.faces.push_back(face_in(pad));
  return step;
}

Result<void> check_step(const PadStep& step) {
  const auto bad = [](Text what) { return refused(std::move(what), "correct the case"_text); };
  if (!(step.step_s > 0.0)) return bad("step_s is not above zero"_text);
  if (step.inertia.empty() || step.inertia.size() != step.velocity_free.size())
    return bad("inertia_kg and velocity_free are not of as many bodies"_text);
  for (const auto& inertia : step.inertia)
    if (!(inertia.determinant() > 0.0) || !inertia.allFinite())
      return bad("an inertia cannot be inverted"_text);
  std::vector<bool> is_pad(step.inertia.size(), false), is_object = is_pad;
  for (const PadFace& face : step.faces) {
    if (face.object >= step.inertia.size() || face.pad >= step.inertia.size() ||
        face.object == face.pad)
      return bad("a pad names a body that is not there"_text);
    if (is_pad[face.pad] || is_object[face.pad] || is_pad[face.object])
      return bad("a body is that of two pads, or of a pad and an object"_text);
    is_pad[face.pad] = is_object[face.object] = true;
    if (!(face.friction >= 0.0) || !(face.stiffness_N_m3 > 0.0))
      return bad("a pad has no friction or no stiffness"_text);
    constexpr double kPlace_m = 1e-9, kUnit = 1e-9;  // of numbers in a file
    for (const PadPoint& point : face.points) {
      if (!(point.area_m2 > 0.0) || !(std::abs(point.normal.norm() - 1.0) <= kUnit))
        return bad("a point has no area or no unit normal"_text);
      const PadPoint& first = face.points.front();
      const Vec3 apart = point.p_object - point.p_pad - (first.p_object - first.p_pad);
      if (!(apart.norm() <= kPlace_m))
        return bad("a point is not at one place for both bodies"_text);
    }
  }
  return {};
}

}  // namespace

Result<bimanual::PadStep> read_pad_case(const std::string& file) {
  const auto text = read_text(file);
  if (!text) return text.error();
  PadStep step;
  try {
    step = step_in(nlohmann::json::parse(*text));
  } catch (const nlohmann::json::exception& bad) {
    return refused("is no case of pads: %1"_text(std::string(bad.what())),
                   "see docs/bimanual.md, Pads"_text)
        .at(file);
  }
  if (auto good = check_step(step); !good) return Error(good.error()).at(file);
  return step;
}

}  // namespace isograsp::app
