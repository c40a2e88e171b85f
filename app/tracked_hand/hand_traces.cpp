// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp hand assist, score.
#include <algorithm>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/tracked_hand/hand_commands.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "virtual_hand/assistance.hpp"
#include "virtual_hand/placement.hpp"

namespace isograsp::app {

namespace {

using namespace virtual_hand;

struct HandTraceOptions {
  std::string trace;
  std::string out;
  double release_N = 0.0;
  bool json = false;
};

/// "thumb+index"; empty: none.
DigitSet read_set(CaseTable& row, const std::string& column) {
  const std::string text = row.word(column);
  DigitSet set = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('+', from), text.size());
    const std::string name = text.substr(from, end - from);
    const auto known = std::find(kDigitNames.begin(), kDigitNames.end(), name);
    if (known == kDigitNames.end()) {
      row.fail(column, "'%1' is no finger"_text(name),
               "write thumb, index, middle, ring or little"_text);
      return 0;
    }
    set |= 1U << static_cast<unsigned>(known - kDigitNames.begin());
    from = end + 1;
  }
  return set;
}

AssistanceRow read_assistance_row(CaseTable& row) {
  AssistanceRow read;
  read.t_s = row.number("t_s");
  read.tracked = row.flag("tracked");
  read.feasible = read_set(row, "feasible");
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const std::string name(kDigitNames[d]);
    read.digits[d] = {row.flag(name + "_contact"), row.number(name + "_pull_N"),
                      row.number(name + "_gap_m")};
  }
  return read;
}

Result<void> run_hand_assist(const HandTraceOptions& options) {
  if (auto different = check_different(options.trace, options.out); !different) return different;
  auto out = FileWriter::create(options.out);
  if (!out) return out.error();
  std::string text = "t_s";
  for (const std::string_view name : kDigitNames) text += "," + std::string(name);
  out->write(text + "\n");
  Assistance assistance(options.release_N);
  const auto read = read_cases(options.trace, [&](CaseTable& row) {
    const AssistanceRow now = read_assistance_row(row);
    assistance.step(now);
    text = format_number(now.t_s);
    for (const DigitState state : assistance.states())
      text += "," + std::string(kDigitStateNames[static_cast<std::size_t>(state)]);
    out->write(text + "\n");
  });
  if (!read) return read;
  return out->commit();
}

Result<void> run_hand_score(const HandTraceOptions& options) {
  std::map<int, std::vector<PlacementRow>> placements;
  const auto read = read_cases(options.trace, [&](CaseTable& row) {
    PlacementRow now;
    now.t_s = row.number("t_s");
    now.held = row.flag("held");
    now.supported = row.flag("supported");
    now.X_WO = {row.three("", "_m"), row.attitude("")};
    now.X_WT = {row.three("target_", "_m"), row.attitude("target_")};
    auto& rows = placements[row.whole("placement")];
    if (!rows.empty() && !(now.t_s > rows.back().t_s))
      row.fail("t_s", "time does not increase"_text, "sort the rows and remove repeats"_text);
    rows.push_back(now);
  });
  if (!read) return read;
  const auto or_null = [](const std::optional<double>& value) {
    return value ? HandJson(*value) : HandJson(nullptr);
  };
  auto list = HandJson::array();
  for (const auto& [placement, rows] : placements) {
    const PlacementScore score = score_placement(rows);
    if (!options.json) {
      print("%d %s, %d, %.3f s, %.2f mm\n", placement, score.completed ? "1" : "0", score.fails,
            score.manipulation_s.value_or(0.0), 1e3 * score.hold_distance_m.value_or(0.0));
      continue;
    }
    list.push_back({{"placement", placement},
                    {"completed", score.completed ? 1 : 0},
                    {"fails", score.fails},
                    {"manipulation_s", or_null(score.manipulation_s)},
                    {"done_s", or_null(score.done_s)},
                    {"hold_distance_m", or_null(score.hold_distance_m)},
                    {"hold_axis_angle_rad", or_null(score.hold_axis_angle_rad)},
                    {"hold_geodesic_rad", or_null(score.hold_geodesic_rad)}});
  }
  if (options.json) print_json({{"placements", std::move(list)}});
  return {};
}

}  // namespace

void add_hand_traces(Subcommand hand) {
  auto trace = std::make_shared<HandTraceOptions>();
  Subcommand assist =
      hand.subcommand("assist", "Which fingers a trace ties to the object, and lets go");
  assist.option("--trace", trace->trace, "Contacts, pulls and feasible grasps (CSV)")
      .required()
      .type("FILE");
  assist.option("--release", trace->release_N, "Pull that lets a finger go [N]")
      .required()
      .range(1e-6, 1e4);
  assist.option("--out", trace->out, "States to write (CSV)").required().type("FILE");
  assist.runs([trace] { return run_hand_assist(*trace); });

  auto scored = std::make_shared<HandTraceOptions>();
  Subcommand score = hand.subcommand("score", "What became of each placement of a trace");
  score.option("--trace", scored->trace, "Object, target, held, supported (CSV)")
      .required()
      .type("FILE");
  score.flag("--json", scored->json, "Print one JSON document");
  score.runs([scored] { return run_hand_score(*scored); });
}

}  // namespace isograsp::app
