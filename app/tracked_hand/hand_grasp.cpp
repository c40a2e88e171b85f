// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand grasp, gains, couple, least-force.
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "virtual_hand/assistance.hpp"
#include "virtual_hand/pinch.hpp"
#include "virtual_hand/tracked_link.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;

struct HandGraspOptions {
  std::string cases;
  std::string contacts;
  std::string sets;
  PadFriction pad;
  bool json = false;
};

using ContactsOfCase = std::map<int, std::vector<DigitContact>>;

std::optional<Digit> digit_from_name(std::string_view name) {
  for (std::size_t d = 0; d < kDigitCount; ++d)
    if (kDigitNames[d] == name) return static_cast<Digit>(d);
  return std::nullopt;
}

DigitContact read_contact(CaseTable& row) {
  DigitContact contact;
  const std::string name = row.word("finger");
  const auto digit = digit_from_name(name);
  if (!digit)
    row.fail("finger", "'%1' is no finger"_text(name),
             "write thumb, index, middle, ring or little"_text);
  contact.digit = digit.value_or(Digit::thumb);
  const int link = row.whole("link");
  if (link >= static_cast<int>(kLinkCount))
    row.fail("link", "is out of range"_text, "write 0, 1 or 2, from the palm on"_text);
  contact.link = static_cast<std::size_t>(link);
  contact.p_OC = row.three("p", "_m");
  const Vec3 normal = row.three("n");
  const Vec3 tangent = row.three("t");
  contact.R_OC << tangent, normal.cross(tangent), normal;
  constexpr double kWritten = 1e-6;  // a table may be rounded
  if (!((contact.R_OC.transpose() * contact.R_OC - Mat3::Identity()).cwiseAbs().maxCoeff() <=
        kWritten))
    row.fail("nx", "is no normal with its tangent"_text,
             "write unit vectors at a right angle to each other"_text);
  return contact;
}

Result<ContactsOfCase> read_contacts(const std::string& path) {
  ContactsOfCase all;
  const auto read = read_cases(path, [&](CaseTable& row) {
    const int id = row.whole("id");
    const DigitContact contact = read_contact(row);
    for (const DigitContact& other : all[id])
      if (!(index_of(other.digit) < index_of(contact.digit)))
        row.fail("finger", "does not stand here"_text, "write each finger once, thumb first"_text);
    all[id].push_back(contact);
  });
  if (!read) return read.error();
  return all;
}

struct LimitsOfCase {
  int set = 0;
  GraspLimits limits;
};
Result<std::map<int, std::vector<LimitsOfCase>>> read_limits(const std::string& path) {
  std::map<int, std::vector<LimitsOfCase>> all;
  if (path.empty()) return all;
  const auto read = read_cases(path, [&](CaseTable& row) {
    const int id = row.whole("id");
    all[id].push_back({row.whole("set"),
                       {row.number("G_min_2"), row.number("H_min_2"), row.number("H_det_2"),
                        row.number("G_min_3"), row.number("H_det_3"), false}});
  });
  if (!read) return read.error();
  return all;
}

HandJson digits_json(DigitSet set) {
  auto names = HandJson::array();
  for (const Digit digit : digits_of(set)) names.push_back(kDigitNames[index_of(digit)]);
  return names;
}

HandJson criteria_json(const GraspCriteria& set) {
  return {{"fingers", digits_json(set.digits)},
          {"length_scale_m", set.length_scale_m},
          {"singular_values", set.G.values},
          {"G_min", set.G.least},
          {"G_det", set.G.product},
          {"h_singular_values", set.H.values},
          {"H_min", set.H.least},
          {"H_det", set.H.product},
          {"raw",
           {{"G_min", set.G_raw.least}, {"H_min", set.H_raw.least}, {"H_det", set.H_raw.product}}},
          {"force_closure", set.force_closure}};
}

HandJson best_json(std::span<const GraspCriteria> sets, std::span<const LimitsOfCase> limits) {
  auto all = HandJson::array();
  for (const LimitsOfCase& of : limits) {
    const auto best = best_grasp(sets, of.limits);
    all.push_back({{"set", of.set},
                   {"fingers", digits_json(best ? best->digits : 0)},
                   {"product", best ? best->product : 0.0}});
  }
  return all;
}

Result<void> run_hand_grasp(const HandGraspOptions& options) {
  const auto contacts = read_contacts(options.contacts);
  if (!contacts) return contacts.error();
  const auto limits = read_limits(options.sets);
  if (!limits) return limits.error();
  HandsOfTable hands(options.cases);
  auto cases = HandJson::array();
  const auto read = read_cases(options.cases, [&](CaseTable& row) {
    const int id = row.whole("id");
    const HandPose pose{{row.three("palm_", "_m"), row.attitude("palm_")}, row.angles()};
    const Pose X_WO{row.three("object_", "_m"), row.attitude("object_")};
    const auto touching = contacts->find(id);
    if (touching == contacts->end() || touching->second.size() < 2)
      row.fail("id", "has no two contacts"_text, "write them in the file of --contacts"_text);
    const HandModel* const hand = hands.of(row);
    if (!row.good()) return;
    const auto sets = criteria_of_sets(touching->second, hand_in_space(*hand, pose), X_WO,
                                       hand_scale_m(*hand), options.pad);
    if (!options.json) {
      for (const GraspCriteria& set : sets)
        print("%d %s G_min %.4f H_min %.4f H_det %.3g\n", id, name_of(set.digits).c_str(),
              set.G.least, set.H.least, set.H.product);
      return;
    }
    HandJson one{{"id", id}, {"subsets", HandJson::array()}};
    for (const GraspCriteria& set : sets) one["subsets"].push_back(criteria_json(set));
    const auto of_case = limits->find(id);
    one["best"] = of_case == limits->end() ? HandJson::array() : best_json(sets, of_case->second);
    cases.push_back(std::move(one));
  });
  if (!read) return read;
  if (options.json) print_json({{"cases", std::move(cases)}});
  return {};
}

struct HandGainOptions {
  TieDesign design;
  bool json = false;
};
Result<void> run_hand_gains(const HandGainOptions& options) {
  const TieGains gains = tie_gains(options.design);
  if (options.json) {
    print_json({{"stiffness_N_m", gains.stiffness_N_m},
                {"damping_N_s_m", gains.damping_N_s_m},
                {"torsion_N_m_rad", gains.torsion_N_m_rad},
                {"release_N", gains.release_N}});
    return {};
  }
  print("%.6g N/m\n%.6g N s/m\n%.6g N m/rad\n%.6g N\n", gains.stiffness_N_m, gains.damping_N_s_m,
        gains.torsion_N_m_rad, gains.release_N);
  return {};
}

LinkMotion read_motion(CaseTable& row, const std::string& of) {
  const auto parts = [&](const std::string& letter) { return row.three(letter + of + "_"); };
  LinkMotion motion;
  const std::string q = "q" + of + "_";
  const Quat given(row.number(q + "w"), row.number(q + "x"), row.number(q + "y"),
                   row.number(q + "z"));
  if (!(given.norm() > 0.0))
    row.fail(q + "w", "is no attitude"_text, "write a quaternion w, x, y, z that is not zero"_text);
  motion.X_W = {parts("x"), given.normalized()};
  motion.v_m_s = parts("v");
  motion.w_rad_s = parts("w");
  return motion;
}

Result<void> run_hand_couple(const HandGraspOptions& options) {
  auto cases = HandJson::array();
  const auto read = read_cases(options.cases, [&](CaseTable& row) {
    const int id = row.whole("id");
    const LinkCoupling coupling{row.number("K_N_m"),    row.number("D_N_s_m"),
                                row.number("F_max_N"),  row.number("Kr_N_m_rad"),
                                row.number("Dr_N_m_s"), row.number("T_max_N_m")};
    const LinkMotion is = read_motion(row, "");
    const LinkMotion tracked = read_motion(row, "t");
    if (!row.good()) return;
    const Wrench wrench = coupling_wrench(coupling, is, tracked);
    if (options.json)
      cases.push_back({{"id", id},
                       {"force_N", place_json(wrench.force)},
                       {"torque_N_m", place_json(wrench.torque)}});
    else
      print("%d %.6g N, %.6g N m\n", id, wrench.force.norm(), wrench.torque.norm());
  });
  if (!read) return read;
  if (options.json) print_json({{"cases", std::move(cases)}});
  return {};
}

struct HandPinchOptions {
  Pinch pinch;
  bool json = false;
};
Result<void> run_hand_pinch(const HandPinchOptions& options) {
  const LeastPinchForce least = least_pinch_force(options.pinch);
  if (options.json)
    print_json({{"least_normal_force_exact_N", least.exact_N},
                {"least_normal_force_ellipsoid_N", least.ellipsoid_N}});
  else
    print("%.6g N\n%.6g N\n", least.exact_N, least.ellipsoid_N);
  return {};
}

constexpr double kTinyLength_m = 1e-6;
constexpr double kLargeLength_m = 1.0;
constexpr double kLeastMass_kg = 1e-6;
constexpr double kMostMass_kg = 1e3;

void add_pad(Subcommand command, double& friction, double& patch_radius_m) {
  command.option("--friction", friction, "Coefficient of friction")
      .range(1e-3, 10.0)
      .shows_default();
  command.option("--patch-radius", patch_radius_m, "Radius of a fingertip's patch [m]")
      .range(kTinyLength_m, kLargeLength_m)
      .shows_default();
}

}  // namespace

void add_hand_grasp(Subcommand hand) {
  auto grasp = std::make_shared<HandGraspOptions>();
  Subcommand criteria =
      hand.subcommand("grasp", "How well two or three fingertips hold and move an object");
  criteria.option("--cases", grasp->cases, "Poses of hand and object (CSV); hand files beside it")
      .required()
      .type("FILE");
  criteria.option("--contacts", grasp->contacts, "Contacts of each case (CSV)")
      .required()
      .type("FILE");
  criteria.option("--sets", grasp->sets, "Limits of each case (CSV): the best set is told")
      .type("FILE");
  add_pad(criteria, grasp->pad.friction, grasp->pad.patch_radius_m);
  criteria.flag("--json", grasp->json, "Print one JSON document");
  criteria.runs([grasp] { return run_hand_grasp(*grasp); });

  auto tie = std::make_shared<HandGainOptions>();
  TieDesign& design = tie->design;
  Subcommand gains =
      hand.subcommand("gains", "Springs and dampers that tie fingertips to an object");
  gains.option("--mass", design.mass_kg, "Of the object [kg]")
      .required()
      .range(kLeastMass_kg, kMostMass_kg);
  gains.option("--fingers", design.digits, "That carry it").range(1, 5).shows_default();
  gains.option("--deflection", design.deflection_m, "Of the springs under this load [m]")
      .range(kTinyLength_m, kLargeLength_m)
      .shows_default();
  gains.option("--damping-ratio", design.damping_ratio, "1: critical")
      .range(0.0, 100.0)
      .shows_default();
  gains.option("--gravity", design.gravity_m_s2, "[m/s2]").range(0.0, 1000.0).shows_default();
  gains.option("--acceleration", design.acceleration_m_s2, "Beside gravity [m/s2]")
      .range(0.0, 1000.0)
      .shows_default();
  gains.option("--patch-radius", design.patch_radius_m, "Radius of a fingertip's patch [m]")
      .range(kTinyLength_m, kLargeLength_m)
      .shows_default();
  gains.flag("--json", tie->json, "Print one JSON document");
  gains.runs([tie] { return run_hand_gains(*tie); });

  auto link = std::make_shared<HandGraspOptions>();
  Subcommand couple = hand.subcommand("couple", "What drags a virtual link to the tracked one");
  couple.option("--cases", link->cases, "Motions and gains (CSV)").required().type("FILE");
  couple.flag("--json", link->json, "Print one JSON document");
  couple.runs([link] { return run_hand_couple(*link); });

  auto pads = std::make_shared<HandPinchOptions>();
  Pinch& pinch = pads->pinch;
  Subcommand least =
      hand.subcommand("least-force", "The least force that holds an object by two pads");
  least.option("--mass", pinch.mass_kg, "Of the object [kg]")
      .required()
      .range(kLeastMass_kg, kMostMass_kg);
  least.option("--gravity", pinch.gravity_m_s2, "[m/s2]").range(0.0, 1000.0).shows_default();
  least.option("--offset", pinch.offset_m, "Of its centre from the line of the pads [m]")
      .range(0.0, kLargeLength_m)
      .shows_default();
  add_pad(least, pinch.friction, pinch.patch_radius_m);
  least.flag("--json", pads->json, "Print one JSON document");
  least.runs([pads] { return run_hand_pinch(*pads); });
}

}  // namespace isograsp::app
