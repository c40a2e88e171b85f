// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/recording/csv_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"

namespace isograsp {

namespace {

constexpr std::array<const char*, 6> kAxisKeys{"fx", "fy", "fz", "tx", "ty", "tz"};
constexpr std::array<const char*, 6> kAxisColumns{"fx_N",  "fy_N",  "fz_N",
                                                  "tx_Nm", "ty_Nm", "tz_Nm"};
constexpr double kStandardGravity = 9.80665;  // m/s^2, exact by definition
constexpr double kPound_kg = 0.45359237;      // exact by definition
constexpr double kInch_m = 0.0254;            // exact by definition
constexpr double kLeastRate_Hz = 1e-6;        // a row in eleven days

struct MappedUnit {
  std::string name;
  double value = 1.0;  ///< N, N m, or per second
};

/// Refuses a scale of zero and one that over- or underflows in SI units.
void require_size(TomlReader& reader, std::string_view key, double scale, double size) {
  if (scale == 0.0)
    reader.fail(key, "is zero"_text, "write how many units one step is"_text);
  else if (!std::isnormal(size))
    reader.fail(key, "is out of range"_text, "write how many units one step is"_text);
}

/// A unit and its scale: how many units one step of the log is (1, or e.g. newtons per count).
MappedUnit force_unit(TomlReader& reader, const MappedUnit& fallback) {
  constexpr std::array<double, 6> kNewtons{
      1.0, 1e-3, 1e3, kStandardGravity, 1e-3 * kStandardGravity, kPound_kg * kStandardGravity};
  MappedUnit unit = fallback;
  if (reader.has("force_unit")) {
    const auto choice = reader.choice("force_unit", {"N", "mN", "kN", "kg", "g", "lb"});
    unit = {reader.text("force_unit"), kNewtons[choice]};
  }
  if (reader.has("force_scale")) {
    const double scale = reader.number("force_scale");
    require_size(reader, "force_scale", scale, scale * unit.value);
    unit = {format_number(scale) + " " + unit.name, scale * unit.value};
  }
  return unit;
}

MappedUnit torque_unit(TomlReader& reader, const MappedUnit& fallback) {
  constexpr std::array<double, 5> kNewtonMetres{1.0, 1e-3, 1e-2, 1e-2 * kStandardGravity,
                                                kInch_m * kPound_kg * kStandardGravity};
  MappedUnit unit = fallback;
  if (reader.has("torque_unit")) {
    const auto choice = reader.choice("torque_unit", {"Nm", "Nmm", "Ncm", "kgcm", "lbin"});
    unit = {reader.text("torque_unit"), kNewtonMetres[choice]};
  }
  if (reader.has("torque_scale")) {
    const double scale = reader.number("torque_scale");
    require_size(reader, "torque_scale", scale, scale * unit.value);
    unit = {format_number(scale) + " " + unit.name, scale * unit.value};
  }
  return unit;
}

MappedAxis read_axis(TomlReader& axes, const char* key, bool required) {
  std::string text = required ? axes.text(key) : axes.text(key, "");
  MappedAxis axis;
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) {
    axis.sign = text.front() == '-' ? -1.0 : 1.0;
    text.erase(0, 1);
  }
  if (text.empty() && axes.has(key))
    axes.fail(key, "names no column"_text,
              "write the column's name, with '-' before it to turn the sign"_text);
  axis.column = text;
  return axis;
}

void read_time(TomlReader& root, CsvMapping& mapping) {
  if (root.has("rate_Hz") == root.has("time_column")) {
    root.fail("rate_Hz", "give either the rate or the column that holds the time"_text,
              "write rate_Hz = 100, or time_column = \"t\" and time_unit = \"s\""_text);
    return;
  }
  if (root.has("rate_Hz")) {
    mapping.rate_Hz = root.number("rate_Hz");
    if (!(*mapping.rate_Hz > 0.0))
      root.fail("rate_Hz", "is not positive"_text, "write rows per second, e.g. 120"_text);
    else if (*mapping.rate_Hz < kLeastRate_Hz)
      root.fail("rate_Hz", "is out of range"_text, "write rows per second, e.g. 120"_text);
    return;
  }
  constexpr std::array<double, 4> kPerSecond{1.0, 1e3, 1e6, 1e9};
  mapping.time_column = root.text("time_column");
  mapping.units_per_second = kPerSecond[root.choice("time_unit", {"s", "ms", "us", "ns"})];
  mapping.time_unit = root.text("time_unit");
}

/// One log while it is read.
struct Log {
  const MappedFinger* finger = nullptr;
  CsvReader reader;
  std::vector<double> fields;
  std::array<std::optional<std::size_t>, 6> columns{};  ///< nothing: the axis is not measured
  std::optional<std::size_t> time;                      ///< nothing: the mapping names a rate
};

Result<std::size_t> column_of(const CsvReader& reader, const std::string& name) {
  if (const auto column = reader.find(name)) return *column;
  std::string names;
  for (const auto& existing : reader.columns()) names += (names.empty() ? "" : ", ") + existing;
  return reader.error_here(name, "the column is missing"_text,
                           "correct the mapping; the file has: %1"_text(names));
}

Result<Log> open_log(const CsvMapping& mapping, const MappedFinger& finger,
                     const std::filesystem::path& folder) {
  auto reader = CsvReader::open(folder / finger.file);
  if (!reader) return reader.error();
  Log log{&finger, std::move(*reader), {}, {}, {}};
  log.fields.resize(log.reader.columns().size());
  for (std::size_t axis = 0; axis < 6; ++axis) {
    if (finger.axes[axis].column.empty()) continue;
    const auto column = column_of(log.reader, finger.axes[axis].column);
    if (!column) return column.error();
    log.columns[axis] = *column;
  }
  if (!mapping.rate_Hz) {
    const auto column = column_of(log.reader, mapping.time_column);
    if (!column) return column.error();
    log.time = *column;
  }
  return log;
}

/// Appends ",fx,fy,…" of the row read last; empty fields if the finger has no sample there.
Result<void> append_sample(std::string& text, const Log& log) {
  int given = 0;
  std::optional<std::size_t> empty;
  for (const auto& column : log.columns) {
    if (!column) continue;
    if (std::isnan(log.fields[*column]))
      empty = column;
    else
      ++given;
  }
  if (empty && given > 0)
    return log.reader.error_here(log.reader.columns()[*empty],
                                 "the field is empty while others of this finger are not"_text,
                                 "give the value, or leave all fields of the finger empty"_text);
  for (std::size_t axis = 0; axis < 6; ++axis) {
    text += ',';
    if (empty) continue;
    const auto& column = log.columns[axis];
    const double scale = axis < 3 ? log.finger->N_per_unit : log.finger->Nm_per_unit;
    const double value = column ? log.finger->axes[axis].sign * scale * log.fields[*column] : 0.0;
    if (!std::isfinite(value))
      return log.reader.error_here(log.finger->axes[axis].column, "is too large in SI units"_text,
                                   "correct the number, or the scale of the mapping"_text);
    append_number(text, value + 0.0);  // + 0: a turned sign makes no "-0"
  }
  return {};
}

/// One line each: label, mapping, sources, and everything that the files themselves do not say.
std::vector<std::string> provenance(const CsvMapping& mapping) {
  std::vector<std::string> lines;
  if (!mapping.label.empty()) lines.push_back(mapping.label);
  lines.push_back("converted by mapping " +
                  std::filesystem::path(mapping.path).filename().string() +
                  (mapping.name.empty() ? "" : " (" + mapping.name + ")"));
  lines.push_back(mapping.rate_Hz
                      ? "stated by the mapping: rate " + format_number(*mapping.rate_Hz) + " Hz"
                      : "stated by the mapping: time is column " + mapping.time_column + " in " +
                            mapping.time_unit);
  for (const MappedFinger& finger : mapping.fingers) {
    std::string axes;
    bool torque = false;
    for (std::size_t axis = 0; axis < 6; ++axis) {
      const MappedAxis& source = finger.axes[axis];
      axes += std::string(axes.empty() ? "" : ", ") + kAxisKeys[axis] + " = ";
      axes += source.column.empty() ? "0 (not measured)"
                                    : (source.sign < 0.0 ? "-" : "") + source.column;
      torque |= axis >= 3 && !source.column.empty();
    }
    lines.push_back(std::string(name_of(finger.finger)) + " from " + finger.file);
    lines.push_back("stated by the mapping: " + std::string(name_of(finger.finger)) + " " + axes +
                    "; force in " + finger.force_unit +
                    (torque ? ", torque in " + finger.torque_unit : ""));
  }
  for (const auto& note : mapping.notes) lines.push_back("note: " + note);
  for (auto& line : lines) std::replace(line.begin(), line.end(), '\n', ' ');
  return lines;
}

/// Time of the row that all logs have read: the first log's; the others must agree.
Result<double> row_time(const CsvMapping& mapping, const std::vector<Log>& logs, std::int64_t row) {
  if (mapping.rate_Hz) return static_cast<double>(row) / *mapping.rate_Hz;
  const double time = logs.front().fields[*logs.front().time];
  for (const Log& log : logs) {
    const double here = log.fields[*log.time];
    if (std::isnan(here))
      return log.reader.error_here(mapping.time_column, "the time is empty"_text,
                                   "give every row a time"_text);
    if (here != time)
      return log.reader.error_here(mapping.time_column,
                                   "differs from the time in %1"_text(logs.front().reader.path()),
                                   "resample the files to one time axis first"_text);
  }
  return time / mapping.units_per_second;
}

}  // namespace

Result<CsvMapping> parse_csv_mapping(std::string_view text, const std::string& path) {
  auto root = TomlReader::parse(text, path, "isograsp-mapping-1");
  if (!root) return root.error();
  CsvMapping mapping;
  mapping.path = path;
  mapping.name = root->text("name", "");
  mapping.label = root->text("label", "");
  mapping.notes = root->texts("notes", false);
  read_time(*root, mapping);
  const MappedUnit force = force_unit(*root, {"N", 1.0});
  const MappedUnit torque = torque_unit(*root, {"Nm", 1.0});
  for (TomlReader& table : root->tables("finger")) {
    MappedFinger finger;
    finger.finger = kFingers[table.choice("finger", {"thumb", "index", "middle"})];
    for (const MappedFinger& other : mapping.fingers)
      if (other.finger == finger.finger)
        table.fail("finger", "is mapped twice"_text, "map every finger once"_text);
    finger.file = table.text("file");
    const MappedUnit own_force = force_unit(table, force);
    const MappedUnit own_torque = torque_unit(table, torque);
    finger.force_unit = own_force.name;
    finger.N_per_unit = own_force.value;
    finger.torque_unit = own_torque.name;
    finger.Nm_per_unit = own_torque.value;
    TomlReader axes = table.table("axes");
    for (std::size_t axis = 0; axis < 6; ++axis)
      finger.axes[axis] = read_axis(axes, kAxisKeys[axis], axis == 2);
    mapping.fingers.push_back(std::move(finger));
  }
  if (mapping.fingers.empty())
    root->fail("finger", "no finger is mapped"_text, "add a [[finger]] table for each sensor"_text);
  if (auto done = root->finish(); !done) return done.error();
  return mapping;
}

Result<ConvertedCsv> convert_csv(const CsvMapping& mapping, const std::string& folder,
                                 const std::string& out_path) {
  const auto beside = std::filesystem::path(mapping.path).parent_path();
  const auto logs_folder = folder.empty() ? beside : std::filesystem::path(folder);
  std::vector<Log> logs;
  for (const MappedFinger& finger : mapping.fingers) {
    auto log = open_log(mapping, finger, logs_folder);
    if (!log) return log.error();
    logs.push_back(std::move(*log));
  }
  auto writer = FileWriter::create(out_path);
  if (!writer) return writer.error();

  ConvertedCsv converted;
  converted.comments = provenance(mapping);
  std::string text;
  for (const auto& comment : converted.comments) text += "# " + comment + "\n";
  text += "t_s";
  for (const MappedFinger& finger : mapping.fingers)
    for (const char* column : kAxisColumns)
      text += "," + std::string(name_of(finger.finger)) + "_" + column;
  text += "\n";

  for (;; ++converted.rows) {
    const Log* ended = nullptr;
    const Log* going_on = nullptr;
    for (Log& log : logs) {
      const auto more = log.reader.next(log.fields);
      if (!more) return more.error();
      (*more ? going_on : ended) = &log;
    }
    if (ended != nullptr && going_on != nullptr)
      return ended->reader.error_here(
          "", "ends after %1 rows, before %2"_text(converted.rows, going_on->reader.path()),
          "give logs of the same length"_text);
    if (ended != nullptr) break;
    const auto t_s = row_time(mapping, logs, converted.rows);
    if (!t_s) return t_s.error();
    if (converted.rows > 0 && *t_s <= converted.last_s)
      return logs.front().reader.error_here(mapping.time_column, "time does not increase"_text,
                                            "sort the rows and remove repeats"_text);
    if (converted.rows == 0) converted.first_s = *t_s;
    converted.last_s = *t_s;
    append_number(text, *t_s);
    for (const Log& log : logs)
      if (auto done = append_sample(text, log); !done) return done.error();
    text += '\n';
    constexpr std::size_t kBlock = 1 << 16;
    if (text.size() < kBlock) continue;
    writer->write(text);
    text.clear();
  }
  if (converted.rows < 2)
    return logs.front().reader.error_here("", "fewer than two rows"_text,
                                          "give at least two rows"_text);
  writer->write(text);
  if (auto done = writer->commit(); !done) return done.error();
  return converted;
}

}  // namespace isograsp
