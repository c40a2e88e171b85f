// SPDX-License-Identifier: GPL-3.0-or-later
// Recording files: TOML in, RecordingSpec out.
#include "session/import/recording.hpp"

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"
#include "hand/columns.hpp"
#include "session/arm/marker_arm.hpp"
#include "storage/records/patient_code.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::session {

namespace {

constexpr double kStandardGravity = 9.80665;  // m/s^2, exact by definition
constexpr double kPound_N = 0.45359237 * kStandardGravity;
constexpr double kInch_m = 0.0254;  // exact by definition

struct Unit {
  std::string_view name;
  std::string_view ending;  ///< of the stored column: its SI unit
  double factor;
};
constexpr std::array kUnits{Unit{"N", "_N", 1.0},
                            Unit{"mN", "_N", 1e-3},
                            Unit{"kgf", "_N", kStandardGravity},
                            Unit{"lbf", "_N", kPound_N},
                            Unit{"Nm", "_Nm", 1.0},
                            Unit{"Nmm", "_Nm", 1e-3},
                            Unit{"lbf*in", "_Nm", kPound_N* kInch_m},
                            Unit{"m", "_m", 1.0},
                            Unit{"mm", "_m", 1e-3},
                            Unit{"1", "", 1.0}};

/// The unit in a column's own name: "Fx [N]" -> "N"; empty: none.
std::string_view stated_unit(std::string_view column) {
  const auto open = column.rfind('[');
  if (open == std::string_view::npos || !column.ends_with(']')) return "";
  return column.substr(open + 1, column.size() - open - 2);
}

/// The keys in braces.
std::vector<std::string> keys_in(TomlReader& root, const std::string& pattern) {
  std::vector<std::string> keys;
  for (std::size_t at = pattern.find('{'); at != std::string::npos; at = pattern.find('{', at)) {
    const auto end = pattern.find('}', at);
    if (end == std::string::npos || end == at + 1) {
      root.fail("file", "has a brace without its key"_text, "write e.g. \"S{person}.txt\""_text);
      return keys;
    }
    keys.push_back(pattern.substr(at + 1, end - at - 1));
    at = end;
  }
  return keys;
}

RecordedColumn read_column(TomlReader& table, const RecordingSpec& spec) {
  RecordedColumn column;
  column.name = table.text("name");
  column.from = table.texts("from");
  column.combine = static_cast<RecordedColumn::Combine>(
      table.choice("combine", {"none", "sum", "magnitude"}, 0));
  column.unit = table.text("unit");
  const bool several = column.combine != RecordedColumn::Combine::none;
  if (table.has("from") && (column.from.empty() || (column.from.size() > 1) != several))
    table.fail("from", "is %1 columns"_text(column.from.size()),
               "name one column, or several and how to combine them: sum or magnitude"_text);
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(),
                                 [&](const Unit& one) { return one.name == column.unit; });
  if (unit == kUnits.end()) {
    table.fail("unit", "'%1' is not a unit"_text(column.unit),
               "write N, mN, kgf, lbf, Nm, Nmm, lbf*in, m, mm, or 1 for a plain number"_text);
    return column;
  }
  column.factor = unit->factor;
  if (!column.name.ends_with(unit->ending) || column.name == columns::t_s)
    table.fail(
        "name", "'%1' does not carry the SI unit of its values"_text(column.name),
        "let it end in %1"_text(unit->ending.empty() ? Text("no unit"_text)
                                                     : Text(Known{std::string(unit->ending)})));
  for (const std::string& from : column.from)
    if (const auto stated = stated_unit(from);
        !stated.empty() && stated != column.unit && spec.unit_reason.empty())
      table.fail("unit", "is not the one that '%1' states"_text(from),
                 "say in unit_reason how the true unit is known"_text);
  return column;
}

void read_who(TomlReader& root, RecordingSpec& spec) {
  spec.patient_prefix = root.text("patient_prefix");
  if (root.has("patient_prefix"))
    if (const auto good = storage::check_patient_code(spec.patient_prefix + "-01"); !good)
      root.fail("patient_prefix", good.error().what, "write some letters, e.g. \"EDRAKI\""_text);
  spec.patient_key = root.text("patient", "");
  spec.session_key = root.text("session", "");
  spec.sessions = root.texts("sessions", !spec.session_key.empty());
  if (spec.session_key.empty() != spec.sessions.empty())
    root.fail("sessions", "goes with the key session"_text, "give both or neither"_text);
  spec.trial_keys = root.texts("trial", false);
  if (root.has("hand"))
    spec.hand = root.choice("hand", {"right", "left"}) == 0 ? Hand::right : Hand::left;
}

void read_files(TomlReader& root, RecordingSpec& spec) {
  spec.file = root.text("file");
  if (spec.file.find('/') != std::string::npos)
    root.fail("file", "holds a folder"_text,
              "name the files only; the folder is given with --from"_text);
  spec.file_keys = keys_in(root, spec.file);
}

/// Of files with markers: what a table would tell in its columns.
void read_arm(TomlReader& root, const RecordingSpec& spec) {
  if (!spec.hand)
    root.fail("hand", "is missing"_text,
              "write \"right\" or \"left\": a left arm is seen in its reflection"_text);
  const auto in_the_name = [&](const char* field, const std::string& key) {
    if (!key.empty() &&
        std::find(spec.file_keys.begin(), spec.file_keys.end(), key) == spec.file_keys.end())
      root.fail(field, "'%1' is no key of `file`"_text(key),
                "write it in braces where the names of the files have it"_text);
  };
  in_the_name("patient", spec.patient_key);
  in_the_name("session", spec.session_key);
  for (const std::string& key : spec.trial_keys) in_the_name("trial", key);
}

void read_table(TomlReader& root, RecordingSpec& spec) {
  constexpr double kLeastRate_Hz = 1.0;
  constexpr double kMostRate_Hz = 1e4;
  spec.separator =
      static_cast<RecordingSpec::Separator>(root.choice("separator", {"comma", "tab", "space"}));
  const bool header = root.boolean("header");
  spec.file_columns = root.texts("file_columns", root.has("header") && !header);
  if (header && root.has("file_columns"))
    root.fail("file_columns", "are named in the header"_text, "leave them out"_text);
  spec.rate_Hz = root.number("rate_Hz");
  if (root.has("rate_Hz") && !(spec.rate_Hz >= kLeastRate_Hz && spec.rate_Hz <= kMostRate_Hz))
    root.fail("rate_Hz", "is out of range"_text, "write rows per second, 1 to 10000"_text);
  spec.time_column = root.text("time_column", "");
  for (TomlReader& table : root.tables("column")) {
    RecordedColumn column = read_column(table, spec);
    for (const RecordedColumn& other : spec.columns)
      if (other.name == column.name)
        table.fail("name", "appears twice"_text, "give every column its own name"_text);
    spec.columns.push_back(std::move(column));
  }
  if (spec.columns.empty())
    root.fail("column", "is missing"_text, "add at least one [[column]]"_text);
}

/// The task is one of those that the files can answer.
Result<void> check_task(const RecordingSpec& spec) {
  const std::string where = spec.path + ", task";
  const auto task = tasks::parse_task(spec.task, where);
  if (!task) return task.error();
  const bool of_arm = task->apparatus() == MarkerArm::kKind;
  if (of_arm == !spec.rig.empty()) return {};
  return refused(of_arm ? "is one of an arm seen by markers"_text
                        : "is not one of an arm seen by markers"_text,
                 of_arm ? "name the rig of the files: rig = \"NAME\""_text
                        : "choose such a kind, for example active_range"_text)
      .at(where)
      .about("kind");
}

}  // namespace

Result<RecordingSpec> parse_recording(std::string_view text, const std::string& path) {
  auto root = TomlReader::parse(text, path, "isograsp-recording-1");
  if (!root) return root.error();
  RecordingSpec spec;
  spec.path = path;
  spec.text = std::string(text);
  spec.name = root->text("name");
  spec.label = root->text("label");
  spec.source = root->text("source");
  spec.licence = root->text("licence");
  spec.device = root->text("device");
  spec.notes = root->texts("notes", false);
  spec.unit_reason = root->text("unit_reason", "");
  spec.rig = root->text("rig", "");
  read_files(*root, spec);
  read_who(*root, spec);
  if (spec.rig.empty())
    read_table(*root, spec);
  else
    read_arm(*root, spec);
  spec.task = root->text("task");
  if (auto done = root->finish(); !done) return done.error();
  if (const auto fits = check_task(spec); !fits) return fits.error();
  return spec;
}

std::vector<std::string> provenance_of(const RecordingSpec& spec) {
  const std::string stated = "stated by the recording file: ";
  std::vector<std::string> lines{spec.label,
                                 "imported by " +
                                     std::filesystem::path(spec.path).filename().string() + " (" +
                                     spec.name + ")",
                                 "source: " + spec.source, "licence: " + spec.licence};
  if (!spec.rig.empty())
    lines.push_back(stated + "segments and links are made of the markers by rig " + spec.rig);
  else
    lines.push_back(spec.time_column.empty()
                        ? stated + "rate " + format_number(spec.rate_Hz) + " Hz"
                        : stated + "time is column " + spec.time_column + " in s, about " +
                              format_number(spec.rate_Hz) + " rows per second");
  for (const RecordedColumn& column : spec.columns) {
    constexpr std::array<const char*, 3> kWords{"", "sum of ", "magnitude of "};
    std::string from;
    for (const std::string& one : column.from) from += (from.empty() ? "" : ", ") + one;
    lines.push_back(stated + column.name + " = " +
                    kWords[static_cast<std::size_t>(column.combine)] + from +
                    (column.unit == "1" ? "" : ", in " + column.unit));
  }
  if (!spec.unit_reason.empty()) lines.push_back("units: " + spec.unit_reason);
  if (!spec.hand) lines.push_back("the hand is not known: stored as right");
  lines.push_back("the dates are not known: sessions carry the time of the import, in their order");
  for (const std::string& note : spec.notes) lines.push_back("note: " + note);
  for (std::string& line : lines) std::replace(line.begin(), line.end(), '\n', ' ');
  return lines;
}

}  // namespace isograsp::session
