// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a recording to trials, each row to the patient, session and trial that it belongs
// to.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <tuple>

#include "core/csv.hpp"
#include "hand/columns.hpp"
#include "session/import/recording.hpp"

namespace isograsp::session {

namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;  ///< of keys

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

/// {key} -> its value, where there is one.
std::string filled(std::string text, const Values& values) {
  for (const auto& [key, value] : values)
    for (std::size_t at = 0; (at = text.find("{" + key + "}", at)) != std::string::npos;
         at += value.size())
      text.replace(at, key.size() + 2, value);
  return text;
}

/// The pattern of file names; each key is a group.
std::regex regex_of(const std::string& pattern) {
  constexpr std::string_view kSpecial = ".^$|()[]*+?\\";
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] == '{') {
      text += "([A-Za-z0-9]+)";
      at = pattern.find('}', at);
      continue;
    }
    if (kSpecial.find(pattern[at]) != std::string_view::npos) text += '\\';
    text += pattern[at];
  }
  return std::regex(text);
}

/// Where a trial stands among all.
struct Place {
  int patient = 1;
  std::size_t session = 0;
  std::size_t order = 0;  ///< of appearance
  auto operator<=>(const Place&) const = default;
};
struct Found {
  Place place;
  RecordedTrial trial;
};

class RecordingReader {
 public:
  explicit RecordingReader(const RecordingSpec& spec) : spec_(spec) {}

  Result<void> read(const fs::path& path, const Values& of_file) {
    path_ = path;
    line_ = 0;
    columns_ = spec_.file_columns;
    const auto text = read_text(path_);
    if (!text) return text.error();
    std::string_view rest = *text;
    if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);
    bool header = columns_.empty();
    Values values = of_file;
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
    sources_.clear();
    return {};
  }

  Result<std::vector<RecordedTrial>> take() {
    std::sort(found_.begin(), found_.end(),
              [](const Found& a, const Found& b) { return a.place < b.place; });
    std::vector<RecordedTrial> trials;
    for (Found& found : found_) {
      if (found.trial.signals.rows() < 2)
        return refused("a trial has fewer than two rows"_text,
                       "complete the file, or correct the keys of the recording file"_text)
            .at(found.trial.file)
            .about(found.trial.task.name);
      trials.push_back(std::move(found.trial));
    }
    return trials;
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

  /// Where in this file the stored columns, the time and the keys are.
  Result<void> find_columns(const Values& of_file) {
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

  Result<void> add_row(const std::vector<std::string_view>& fields, Values& values) {
    if (fields.size() != columns_.size())
      return refused("has %1 fields"_text(fields.size()),
                     "give every line %1 fields"_text(columns_.size()))
          .at(path_, line_, "");
    for (const auto& [key, at] : key_columns_) values[key] = fields[at];
    const auto trial = trial_of(values);
    if (!trial) return trial.error();
    Signals& signals = (*trial)->signals;
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

  /// The trial with these values of the keys; a new one where there is none.
  Result<RecordedTrial*> trial_of(const Values& values) {
    if (last_ < found_.size() && values == last_values_) return &found_[last_].trial;
    const auto known = index_.find(values);
    if (known == index_.end()) {
      auto made = new_trial(values);
      if (!made) return made.error();
      index_[values] = found_.size();
      found_.push_back(*std::move(made));
    }
    last_values_ = values;
    last_ = index_[values];
    return &found_[last_].trial;
  }

  Result<Found> new_trial(const Values& values) const {
    Found found;
    found.place.order = found_.size();
    if (!spec_.patient_key.empty()) {
      constexpr double kMostPatients = 9999.0;
      const std::string& text = values.at(spec_.patient_key);
      double number = 0.0;
      if (!parse_number(text, number) || number != std::floor(number) || number < 1.0 ||
          number > kMostPatients)
        return refused("'%1' is not the number of a person"_text(text),
                       "number them from 1 on: names and dates are not stored"_text)
            .at(path_, line_, spec_.patient_key);
      found.place.patient = static_cast<int>(number);
    }
    if (!spec_.session_key.empty()) {
      const std::string& name = values.at(spec_.session_key);
      const auto at = std::find(spec_.sessions.begin(), spec_.sessions.end(), name);
      if (at == spec_.sessions.end())
        return refused("'%1' is none of the sessions"_text(name),
                       "add it to `sessions` of the recording file"_text)
            .at(path_, line_, spec_.session_key);
      found.place.session = static_cast<std::size_t>(at - spec_.sessions.begin());
      found.trial.session_name = name;
    }
    auto task = tasks::parse_task(filled(spec_.task, values), spec_.path + ", task");
    if (!task) return task.error();
    const std::string number = std::to_string(found.place.patient);
    found.trial.patient_code = spec_.patient_prefix + "-" + (number.size() < 2 ? "0" : "") + number;
    found.trial.session = found.place.session;
    found.trial.file = fs::path(path_).filename();
    found.trial.task = *std::move(task);
    std::vector<std::string> names{columns::t_s};
    for (const RecordedColumn& column : spec_.columns) names.push_back(column.name);
    found.trial.signals = Signals(std::move(names));
    return found;
  }

  const RecordingSpec& spec_;
  std::string path_;
  int line_ = 0;
  std::vector<std::string> columns_;               ///< of the file
  std::vector<std::vector<std::size_t>> sources_;  ///< per stored column: where in the file
  std::map<std::string, std::size_t> key_columns_;
  std::size_t time_ = 0;
  std::vector<Found> found_;
  std::map<Values, std::size_t> index_;  ///< in found_
  Values last_values_;
  std::size_t last_ = static_cast<std::size_t>(-1);
};

}  // namespace

Result<std::vector<RecordedTrial>> read_recording(const RecordingSpec& spec,
                                                  const std::string& folder) {
  const std::regex pattern = regex_of(spec.file);
  std::map<std::string, Values> files;  // by name
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end;
       at.increment(failure)) {
    const std::string name = at->path().filename();
    std::smatch match;
    if (!std::regex_match(name, match, pattern)) continue;
    Values values;
    for (std::size_t k = 0; k < spec.file_keys.size(); ++k)
      values[spec.file_keys[k]] = match[k + 1].str();
    files[name] = std::move(values);
  }
  if (failure)
    return refused("cannot be listed: %1"_text(Known{failure.message()}),
                   "name the folder that holds the recording"_text)
        .at(folder)
        .about("--from");
  if (files.empty())
    return refused("holds no file %1"_text(spec.file),
                   "name the folder that holds the recording"_text)
        .at(folder)
        .about("--from");
  RecordingReader reader(spec);
  for (const auto& [name, values] : files)
    if (auto done = reader.read(fs::path(folder) / name, values); !done) return done.error();
  auto trials = reader.take();
  if (trials && trials->empty())
    return refused("holds no rows"_text, "give a file with data"_text)
        .at(fs::path(folder) / files.begin()->first);
  return trials;
}

}  // namespace isograsp::session
