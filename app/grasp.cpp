// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp grasp: what a scene's contacts can do, and the plan that moves its object.
#include "grasp_model/grasp.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/console.hpp"
#include "core/csv.hpp"
#include "grasp_model/plan.hpp"
#include "grasp_model/plan_words.hpp"
#include "session/platform/plan_cost.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct GraspOptions {
  std::string scene;
  std::optional<double> length_scale_m;
  std::optional<double> torsion_scale_m;
  bool json = false;
};

constexpr std::array<const char*, 6> kRowNames{"Fx", "Fy", "Fz", "Tx", "Ty", "Tz"};
constexpr double kHold_s = 0.01;

struct Subset {
  std::vector<Contact> contacts;
  Criteria criteria;
  bool closed = false;
  bool opposed = false;
  bool acts = false;  ///< moves the object under the scene's grasp rule
};

/// All non-empty sets of contacts: single ones, pairs, all three, each in the order of the file.
std::vector<Subset> subsets_of(const Scene& scene, const Scales& scales) {
  const auto rows = rows_of(scene);
  std::vector<unsigned> masks;
  for (unsigned mask = 1; mask < 1u << scene.contacts.size(); ++mask) masks.push_back(mask);
  std::stable_sort(masks.begin(), masks.end(), [](unsigned a, unsigned b) {
    return __builtin_popcount(a) < __builtin_popcount(b);
  });
  std::vector<Subset> subsets;
  for (const unsigned mask : masks) {
    Subset subset;
    unsigned fingers = 0;
    for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
      if ((mask >> i & 1u) == 0) continue;
      subset.contacts.push_back(scene.contacts[i]);
      fingers |= 1u << index_of(scene.contacts[i].finger);
    }
    subset.criteria = criteria(subset.contacts, rows, scales);
    subset.closed = force_closure(subset.contacts, rows);
    subset.opposed = opposition(subset.contacts);
    subset.acts = grasp_rule_holds(scene, fingers);
    subsets.push_back(std::move(subset));
  }
  return subsets;
}

Json as_json(const Plan& plan, const Scales& scales, const std::vector<Subset>& subsets) {
  const Scene& scene = plan.scene();
  Json document;
  document["scene"] = scene.name;
  document["rows"] = Json::array();
  for (const auto row : rows_of(scene))
    document["rows"].push_back(kRowNames[static_cast<std::size_t>(row)]);
  document["columns"] = grasp_map_columns(scene.contacts);
  const GraspMatrix G = grasp_map(scene.contacts);
  document["G"] = Json::array();
  for (Eigen::Index r = 0; r < 6; ++r) {
    Json row = Json::array();
    for (Eigen::Index c = 0; c < G.cols(); ++c) row.push_back(G(r, c) + 0.0);  // no -0
    document["G"].push_back(std::move(row));
  }
  document["length_scale_m"] = scales.length_m;
  document["torsion_scale_m"] = scales.torsion_m;
  document["subsets"] = Json::array();
  for (const auto& subset : subsets) {
    Json entry;
    entry["fingers"] = Json::array();
    for (const auto& contact : subset.contacts) entry["fingers"].push_back(name_of(contact.finger));
    entry["rank"] = subset.criteria.rank;
    entry["singular_values"] = subset.criteria.singular_values;
    entry["G_min"] = subset.criteria.G_min;
    entry["G_det"] = subset.criteria.G_det;
    entry["G_rat"] = subset.criteria.G_rat;
    entry["force_closure"] = subset.closed;
    entry["opposition"] = subset.opposed;
    entry["acts"] = subset.acts;
    document["subsets"].push_back(std::move(entry));
  }
  Json choices;
  for (const auto& [name, text] : words_of(plan)) choices[name] = text;
  choices["hold_s"] = plan.hold_s();
  choices["flops_per_frame"] = flops_per_frame(plan);
  choices["cost_ns_per_frame"] = session::cost_ns_per_frame(plan);
  document["plan"] = std::move(choices);
  return document;
}

void print_table(const Plan& plan, const Scales& scales, const std::vector<Subset>& subsets) {
  const Scene& scene = plan.scene();
  print("%s\n\nGrasp map G (object axes, force [N] then torque [N m])\n    ",
        printable(scene.name.empty() ? scene.file : scene.name).c_str());
  for (const auto& column : grasp_map_columns(scene.contacts)) print("%10s", column.c_str());
  const GraspMatrix G = grasp_map(scene.contacts);
  for (Eigen::Index r = 0; r < 6; ++r) {
    print("\n %s ", kRowNames[static_cast<std::size_t>(r)]);
    for (Eigen::Index c = 0; c < G.cols(); ++c) print("%10.4g", G(r, c) + 0.0);
  }
  print("\n\nFinger sets (rows");
  for (const auto row : rows_of(scene)) print(" %s", kRowNames[static_cast<std::size_t>(row)]);
  print("; length scale %.4g m, torsion scale %.4g m)\n", scales.length_m, scales.torsion_m);
  const auto yes = [](bool it_is) { return it_is ? "yes" : "no"; };
  print(" %-18s %4s %8s %9s %8s  %-7s  %-10s  %-5s  %s\n", "fingers", "rank", "G_min", "G_det",
        "G_rat", "closure", "opposition", "moves", "singular values");
  for (const auto& subset : subsets) {
    std::string fingers;
    for (const auto& contact : subset.contacts)
      fingers += (fingers.empty() ? "" : " ") + std::string(name_of(contact.finger));
    print(" %-18s %4d %8.4f %9.3g %8.4f  %-7s  %-10s  %-5s ", fingers.c_str(), subset.criteria.rank,
          subset.criteria.G_min, subset.criteria.G_det, subset.criteria.G_rat, yes(subset.closed),
          yes(subset.opposed), yes(subset.acts));
    for (const double value : subset.criteria.singular_values) print(" %.4g", value);
    print("\n");
  }
  print("\nPlan\n");
  for (const auto& [name, text] : words_of(plan)) print(" %-13s %s\n", name.c_str(), text.c_str());
  print(" %-13s %.0f ns per frame, measured here\n", "cost", session::cost_ns_per_frame(plan));
}

Result<void> grasp(const GraspOptions& options) {
  auto text = read_text(options.scene);
  if (!text) return text.error();
  const auto scene = parse_scene(*text, options.scene);
  if (!scene) return scene.error();
  const auto plan = Plan::compile(*scene, kHold_s);
  if (!plan) return plan.error();
  Scales scales = default_scales(scene->contacts);
  for (const auto& [given, scale, name] :
       {std::tuple{options.length_scale_m, &scales.length_m, "--length-scale"},
        std::tuple{options.torsion_scale_m, &scales.torsion_m, "--torsion-scale"}}) {
    if (!given) continue;
    if (!(*given > 0.0) || !std::isfinite(*given))
      return refused("is not a positive length"_text, "give metres"_text).about(name);
    *scale = *given;
  }
  const auto subsets = subsets_of(*scene, scales);
  if (options.json)
    print_json(as_json(*plan, scales, subsets));
  else
    print_table(*plan, scales, subsets);
  return {};
}

}  // namespace

void add_grasp(CommandLine& line) {
  Subcommand command =
      line.subcommand("grasp", "Grasp map, criteria and the compiled plan of a scene");
  const auto options = std::make_shared<GraspOptions>();
  command.option("--scene", options->scene, "Scene (TOML)").required();
  command.option("--length-scale", options->length_scale_m,
                 "Length that makes torques comparable to forces [m]; default: rms distance of "
                 "the contacts from the COM");
  command.option("--torsion-scale", options->torsion_scale_m,
                 "Length that makes torsion comparable to forces [m]; default: torsion_m / "
                 "friction of the soft contacts");
  command.flag("--json", options->json, "Print one JSON document");
  command.footer("Example: isograsp grasp --scene library/scenes/planar_block.toml --json");
  command.runs([options] { return grasp(*options); });
}

}  // namespace isograsp::app
