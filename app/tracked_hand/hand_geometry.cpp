// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand fk, distance.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/csv.hpp"
#include "virtual_hand/capsule.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;

struct HandCaseOptions {
  std::string cases;
  bool json = false;
};

HandJson joints_json(const HandInSpace& hand) {
  HandJson joints;
  const auto poses = joint_poses(hand);
  for (std::size_t j = 0; j < kHandJointCount; ++j) {
    const Pose& X = poses[j];
    joints[std::string(kHandJointNames[j])] = {X.p.x(), X.p.y(), X.p.z(), X.q.w(),
                                               X.q.x(), X.q.y(), X.q.z()};
  }
  return joints;
}

/// Of the tips, which move with the last link.
HandJson jacobians_json(const HandInSpace& hand) {
  HandJson all;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const PointJacobian J = point_jacobian(hand, static_cast<Digit>(d), kLinkCount - 1,
                                           hand.digits[d].joints[kLinkCount]);
    auto rows = HandJson::array();
    for (const auto& row : J.rowwise()) {
      auto values = HandJson::array();
      for (const double value : row) values.push_back(value);
      rows.push_back(std::move(values));
    }
    all[std::string(kDigitNames[d])] = std::move(rows);
  }
  return all;
}

Result<void> run_hand_fk(const HandCaseOptions& options) {
  HandsOfTable hands(options.cases);
  auto poses = HandJson::array();
  const auto read = read_cases(options.cases, [&](CaseTable& row) {
    const HandPose pose{{row.three("", "_m"), row.attitude("")}, row.angles()};
    const HandModel* const model = hands.of(row);
    if (!row.good()) return;
    const HandInSpace hand = hand_in_space(*model, pose);
    const int id = row.whole("id");
    if (options.json) {
      poses.push_back(
          {{"id", id}, {"joints", joints_json(hand)}, {"jacobian", jacobians_json(hand)}});
      return;
    }
    const auto joints = joint_poses(hand);
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      print("%d %s %.6f %.6f %.6f m\n", id, std::string(kHandJointNames[j]).c_str(),
            joints[j].p.x(), joints[j].p.y(), joints[j].p.z());
  });
  if (!read) return read;
  if (options.json) print_json({{"poses", std::move(poses)}});
  return {};
}

ObjectShape shape_of(CaseTable& row) {
  const std::string kind = row.word("shape");
  ObjectShape shape;
  if (kind == "box") {
    shape.half_m = 0.5 * row.three("s", "_m");
  } else if (kind == "cylinder") {
    const double radius_m = 0.5 * row.number("sx_m");
    shape = {ObjectShape::Kind::cylinder, {radius_m, radius_m, 0.5 * row.number("sy_m")}};
  } else {
    row.fail("shape", "'%1' is no shape"_text(kind), "write box or cylinder"_text);
  }
  if (!(shape.half_m.minCoeff() > 0.0))
    row.fail("sx_m", "is out of range"_text, "write lengths above 0 in metres"_text);
  return shape;
}

Result<void> run_hand_distance(const HandCaseOptions& options) {
  auto cases = HandJson::array();
  const auto read = read_cases(options.cases, [&](CaseTable& row) {
    const Capsule capsule{row.three("a", "_m"), row.three("b", "_m"), row.number("r_m")};
    const ObjectShape shape = shape_of(row);
    const int id = row.whole("id");
    if (!row.good()) return;
    const CapsuleContact contact = capsule_contact(capsule, shape);
    if (options.json)
      cases.push_back({{"id", id},
                       {"distance_m", contact.distance_m},
                       {"normal", place_json(contact.normal)},
                       {"point_m", place_json(contact.point)}});
    else
      print("%d %.9f m\n", id, contact.distance_m);
  });
  if (!read) return read;
  if (options.json) print_json({{"cases", std::move(cases)}});
  return {};
}

}  // namespace

void add_hand_geometry(Subcommand hand) {
  auto poses = std::make_shared<HandCaseOptions>();
  Subcommand fk = hand.subcommand("fk", "Joints of a hand from its angles, Jacobians of its tips");
  fk.option("--poses", poses->cases, "Poses (CSV); column hand: a hand file beside it")
      .required()
      .type("FILE");
  fk.flag("--json", poses->json, "Print one JSON document");
  fk.runs([poses] { return run_hand_fk(*poses); });

  auto cases = std::make_shared<HandCaseOptions>();
  Subcommand distance =
      hand.subcommand("distance", "Distance of capsules from boxes and cylinders");
  distance.option("--cases", cases->cases, "Capsules and shapes (CSV)").required().type("FILE");
  distance.flag("--json", cases->json, "Print one JSON document");
  distance.runs([cases] { return run_hand_distance(*cases); });
}

}  // namespace isograsp::app
