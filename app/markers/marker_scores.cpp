// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers score, rom, box.
#include <algorithm>
#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"
#include "kinematics/range_of_motion.hpp"
#include "kinematics/tables/event_csv.hpp"
#include "kinematics/tables/pose_csv.hpp"
#include "kinematics/tables/word_table.hpp"
#include "statistics/box_plot.hpp"
#include "statistics/rank_tests.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct MarkerScoreOptions {
  std::string rig;
  std::string poses;
  std::string events;
  std::string bands;
  std::string values;
  bool json = false;
};

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}
std::string number_or_dash(const std::optional<double>& value) {
  return value ? fixed(*value, 4).digits : "-";
}

Result<void> run_movement_score(const MarkerScoreOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  auto targets = read_pose_targets(options.events);
  if (!targets) return targets.error();
  const auto scores = score_movements(*rig, *series, std::move(*targets));
  if (!scores) return about_file(scores.error(), options.rig);
  if (!options.bands.empty()) {
    for (const std::string& read : {options.rig, options.poses, options.events})
      if (auto different = check_different(read, options.bands); !different) return different;
    const auto band = movement_bands(*rig, *series, *scores);
    if (!band) return band.error();
    if (auto done = write_bands(options.bands, *band); !done) return done;
  }
  auto list = Json::array();
  for (const auto& [movement, measure] : movement_measures(*rig, *scores)) {
    if (!options.json) {
      print("%zu %s %s: %s\n", movement, measure.name.c_str(), printable(measure.channel).c_str(),
            measure.value ? (number_or_dash(measure.value) + " " + measure.unit).c_str()
                          : measure.reason.c_str());
      continue;
    }
    Json one{{"name", measure.name},
             {"channel", measure.channel},
             {"movement", movement},
             {"value", number_or_null(measure.value)},
             {"unit", measure.unit}};
    if (!measure.value) one["reason"] = measure.reason;
    list.push_back(std::move(one));
  }
  if (options.json) print_json({{"measures", std::move(list)}});
  return {};
}

Result<void> run_rom(const MarkerScoreOptions& options) {
  const auto rig = load_rig(options.rig);
  if (!rig) return rig.error();
  const auto series = read_poses(options.poses);
  if (!series) return series.error();
  auto list = Json::array();
  for (const RigLink& link : rig->links) {
    const auto poses = link_poses(*series, link.parent, link.child);
    if (!poses) return poses.error();
    std::vector<std::vector<double>> angles(3);
    for (const Pose& X_L : *poses) {
      const Vec3 three =
          is_missing(X_L) ? Vec3(Vec3::Constant(kMissing)) : link_angles(X_L.q, link);
      for (std::size_t a = 0; a < 3; ++a) angles[a].push_back(three[static_cast<Eigen::Index>(a)]);
    }
    for (std::size_t a = 0; a < 3; ++a) {
      const Range range = range_of_motion(series->t_s, angles[a]);
      if (options.json)
        list.push_back({{"link", link.name},
                        {"angle", a + 1},
                        {"min_rad", number_or_null(range.min_rad)},
                        {"max_rad", number_or_null(range.max_rad)},
                        {"min_held_rad", number_or_null(range.min_held_rad)},
                        {"max_held_rad", number_or_null(range.max_held_rad)}});
      else
        print("%s angle %zu: %s to %s rad, held %s to %s rad\n", printable(link.name).c_str(),
              a + 1, number_or_dash(range.min_rad).c_str(), number_or_dash(range.max_rad).c_str(),
              number_or_dash(range.min_held_rad).c_str(),
              number_or_dash(range.max_held_rad).c_str());
    }
  }
  if (options.json) print_json({{"rom", std::move(list)}});
  return {};
}

/// Values of conditions, one row for each subject; missing ones NaN.
struct ValueColumns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

Result<ValueColumns> read_values(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  if (table->columns().size() < 2)
    return table->error_here("", "has no column of values"_text,
                             "name the subject first, then each condition"_text);
  ValueColumns columns;
  columns.names.assign(table->columns().begin() + 1, table->columns().end());
  columns.values.resize(columns.names.size());
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) return columns;
    for (std::size_t c = 0; c < columns.names.size(); ++c) {
      const auto value = table->number(c + 1);
      if (!value) return value.error();
      columns.values[c].push_back(value->value_or(kMissing));
    }
  }
}

Json box_of(const std::vector<double>& column) {
  std::vector<double> values;
  for (const double value : column)
    if (!std::isnan(value)) values.push_back(value);
  Json one{{"n", values.size()}};
  const auto box = statistics::box_plot(values);
  if (!box) return one;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  one["min"] = *least;
  one["q1"] = box->lower_quartile;
  one["median"] = box->median;
  one["q3"] = box->upper_quartile;
  one["max"] = *most;
  one["whisker_low"] = box->lower_whisker;
  one["whisker_high"] = box->upper_whisker;
  one["outliers"] = box->outside;
  return one;
}

struct ComparedPair {
  std::size_t a = 0;
  std::size_t b = 0;
  std::size_t n = 0;
  std::optional<double> w_plus;
  std::optional<double> p;
  std::optional<double> p_holm;
};

/// Values are printed numbers: differences are rounded to this, so that equal ones are equal.
constexpr double kDifferenceDigits = 1e12;

std::vector<ComparedPair> compared(const ValueColumns& columns) {
  std::vector<ComparedPair> pairs;
  for (std::size_t a = 0; a < columns.names.size(); ++a)
    for (std::size_t b = a + 1; b < columns.names.size(); ++b) {
      std::vector<double> differences;
      for (std::size_t row = 0; row < columns.values[a].size(); ++row) {
        const double difference = columns.values[a][row] - columns.values[b][row];
        if (!std::isnan(difference))
          differences.push_back(std::round(difference * kDifferenceDigits) / kDifferenceDigits);
      }
      const auto test = statistics::signed_rank(differences, 0.5 / kDifferenceDigits);
      pairs.push_back({a, b, differences.size(), test.w_plus.value, test.p.value, std::nullopt});
    }
  // Holm 1979: the smallest p times their number, the next times one less, never falling.
  std::vector<ComparedPair*> sorted;
  for (ComparedPair& pair : pairs)
    if (pair.p) sorted.push_back(&pair);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto* one, const auto* other) { return *one->p < *other->p; });
  double largest = 0.0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    const auto left = static_cast<double>(sorted.size() - k);
    largest = std::max(largest, std::min(1.0, left * *sorted[k]->p));
    sorted[k]->p_holm = largest;
  }
  return pairs;
}

Result<void> run_box(const MarkerScoreOptions& options) {
  const auto columns = read_values(options.values);
  if (!columns) return columns.error();
  Json boxes = Json::object();
  for (std::size_t c = 0; c < columns->names.size(); ++c)
    boxes[columns->names[c]] = box_of(columns->values[c]);
  auto pairs = Json::array();
  for (const ComparedPair& pair : compared(*columns))
    pairs.push_back({{"a", columns->names[pair.a]},
                     {"b", columns->names[pair.b]},
                     {"n", pair.n},
                     {"w_plus", number_or_null(pair.w_plus)},
                     {"p", number_or_null(pair.p)},
                     {"p_holm", number_or_null(pair.p_holm)}});
  if (options.json) {
    print_json({{"boxes", std::move(boxes)}, {"pairs", std::move(pairs)}});
    return {};
  }
  for (const auto& [name, box] : boxes.items())
    print("%s: %s\n", printable(name).c_str(), printable(box.dump()).c_str());
  for (const auto& pair : pairs) print("%s\n", printable(pair.dump()).c_str());
  return {};
}

}  // namespace

void add_marker_scores(Subcommand markers) {
  auto options = std::make_shared<MarkerScoreOptions>();
  const auto with_poses = [&options](Subcommand command) {
    command.option("--rig", options->rig, "Rig (isograsp-rig-1)").required().type("FILE.toml");
    command.option("--poses", options->poses, "Poses of its frames (CSV)").required().type("FILE");
    command.flag("--json", options->json, "Print one JSON document");
  };
  Subcommand score = markers.subcommand("score", "Measures of movements to targets");
  with_poses(score);
  score.option("--events", options->events, "Cues, matches and references (CSV)")
      .required()
      .type("FILE");
  score.option("--bands", options->bands, "Mean and SD of movements to write (CSV)").type("FILE");
  score.runs([options] { return run_movement_score(*options); });

  Subcommand rom = markers.subcommand("rom", "How far each angle of each link went");
  with_poses(rom);
  rom.runs([options] { return run_rom(*options); });

  Subcommand box = markers.subcommand("box", "Box plots of conditions, and their pairs compared");
  box.option("--values", options->values, "Subject, then one column for each condition (CSV)")
      .required()
      .type("FILE");
  box.flag("--json", options->json, "Print one JSON document");
  box.runs([options] { return run_box(*options); });
}

}  // namespace isograsp::app
