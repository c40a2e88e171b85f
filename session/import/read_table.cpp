// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of a recording: rows of numbers in columns, each row to the trial that its keys name.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "session/import/recorded_trials.hpp"

namespace isograsp::session {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::vector<std::string_view> fields_of(std::string_view line, RecordingSpec::Separator separator) {
  using Separator = RecordingSpec::Separator;
  std::vector<std::string_view> fields;
  if (separator == Separator::space) {
    for (line = trimmed(line); !line.empty();) {
      const auto end = std::min(line.find_first_of(" \t"), line.size());
      fields.push_back(line.substr(0, end));
      line = trimmed(line.substr(end));
    }
    return fields;
  }
  const char mark = separator == Separator::tab ? '\t' : ',';
  for (;;) {
    const auto end = line.find(mark);
    fields.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    line.remove_prefix(end + 1);
  }
}

class RecordedTable {
 public:
  RecordedTable(const RecordingSpec& spec, RecordedTrials& trials, std::string path)
      : spec_(spec), trials_(trials), path_(std::move(path)), columns_(spec.file_columns) {}

  Result<void> read(const KeyValues& of_file) {
    const auto text = read_text(path_);
    if (!text) return text.error();
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    bool header = columns_.empty();
    KeyValues values = of_file;
    while (!rest.empty()) {
      const auto end = rest.find('\n');
      const std::string_view line = trimmed_end(rest.substr(0, end));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      ++line_;
      if (trimmed(line).empty()) continue;
      const auto fields = fields_of(line, spec_.separator);
      const bool is_header = std::exchange(header, false);
      if (is_header) columns_.assign(fields.begin(), fields.end());
      if (sources_.empty())
        if (auto found = find_columns(of_file); !found) return found;
      if (is_header) continue;
      if (auto added = add_row(fields, values); !added) return added;
    }
    return {};
  }

 private:
  static std::string_view trimmed_end(std::string_view line) {
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }

  Result<std::size_t> column(const std::string& name) const {
    const auto found = std::find(columns_.begin(), columns_.end(), name);
    if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
    std::string names;
    for (const auto& existing : columns_) names += (names.empty() ? "" : ", ") + existing;
    return refused("the column is missing"_text,
                   "correct the recording file; this file has: %1"_text(names))
        .at(path_, line_, name);
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names{columns::t_s};
    for (const RecordedColumn& column : spec_.columns) names.push_back(column.name);
    return names;
  }

  /// Where in this file the stored columns, the time and the keys are.
  Result<void> find_columns(const KeyValues& of_file) {
    sources_.clear();
    key_columns_.clear();
    for (const RecordedColumn& stored : spec_.columns) {
      sources_.emplace_back();
      for (const std::string& from : stored.from) {
        const auto at = column(from);
        if (!at) return at.error();
        sources_.back().push_back(*at);
      }
    }
    if (!spec_.time_column.empty()) {
      const auto at = column(spec_.time_column);
      if (!at) return at.error();
      time_ = *at;
    }
    std::vector<std::string> keys = spec_.trial_keys;
    keys.push_back(spec_.patient_key);
    keys.push_back(spec_.session_key);
    for (const std::string& key : keys) {
      if (key.empty() || of_file.contains(key)) continue;
      const auto at = column(key);
      if (!at) return at.error();
      key_columns_[key] = *at;
    }
    return {};
  }

  Result<double> number(const std::vector<std::string_view>& fields, std::size_t at) const {
    double value = 0.0;
    if (parse_number(fields[at], value)) return value;
    return refused("'%1' is not a finite number"_text(fields[at]),
                   "correct the file; a number has '.' as the decimal sign"_text)
        .at(path_, line_, columns_[at]);
  }

  Result<double> value_of(std::size_t stored, const std::vector<std::string_view>& fields) const {
    using Combine = RecordedColumn::Combine;
    const RecordedColumn& column = spec_.columns[stored];
    double sum = 0.0;
    double squares = 0.0;
    for (const std::size_t at : sources_[stored]) {
      const auto value = number(fields, at);
      if (!value) return value;
      sum += *value;
      squares += *value * *value;
    }
    return column.factor * (column.combine == Combine::magnitude ? std::sqrt(squares) : sum);
  }

  Result<void> add_row(const std::vector<std::string_view>& fields, KeyValues& values) {
    if (fields.size() != columns_.size())
      return refused("has %1 fields"_text(fields.size()),
                     "give every line %1 fields"_text(columns_.size()))
          .at(path_, line_, "");
    for (const auto& [key, at] : key_columns_) values[key] = fields[at];
    const auto trial = trials_.trial_of(values, {path_, line_});
    if (!trial) return trial.error();
    Signals& signals = (*trial)->signals;
    if (signals.names().empty()) signals = Signals(names());
    std::vector<double> row{static_cast<double>(signals.rows()) / spec_.rate_Hz};
    if (!spec_.time_column.empty()) {
      const auto t_s = number(fields, time_);
      if (!t_s) return t_s.error();
      row[0] = *t_s;
    }
    if (signals.rows() > 0 && !(row[0] > signals.column(columns::t_s).back()))
      return refused("time does not increase"_text,
                     "sort the rows, or name the column that tells the trials apart"_text)
          .at(path_, line_, spec_.time_column);
    for (std::size_t c = 0; c < spec_.columns.size(); ++c) {
      const auto value = value_of(c, fields);
      if (!value) return value.error();
      row.push_back(*value);
    }
    signals.append_row(row);
    return {};
  }

  const RecordingSpec& spec_;
  RecordedTrials& trials_;
  std::string path_;
  int line_ = 0;
  std::vector<std::string> columns_;               ///< of the file
  std::vector<std::vector<std::size_t>> sources_;  ///< per stored column: where in the file
  std::map<std::string, std::size_t> key_columns_;
  std::size_t time_ = 0;
};

}  // namespace

Result<void> read_recorded_table(const std::filesystem::path& path, const KeyValues& of_file,
                                 const RecordingSpec& spec, RecordedTrials& trials) {
  return RecordedTable(spec, trials, path).read(of_file);
}

}  // namespace isograsp::session
