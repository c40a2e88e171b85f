// SPDX-License-Identifier: GPL-3.0-or-later
// TRC: line 1 PathFileType…, 2 names of values, 3 values (DataRate … Units …), 4 Frame#, Time and
// labels, three columns each, 5 X1 Y1 Z1 …, then rows. TSV: lines KEY<tab>value (FREQUENCY,
// MARKER_NAMES with all labels, …), perhaps a line of column names with Frame and Time, then rows
// of three columns a marker.
#include "device/markers/text_markers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/csv.hpp"
#include "core/lines.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kLongestTabLine = std::size_t{1} << 20;

std::vector<std::string_view> tab_fields(std::string_view text) {
  if (text.ends_with('\r')) text.remove_suffix(1);
  std::vector<std::string_view> fields;
  for (;;) {
    const auto tab = text.find('\t');
    std::string_view field = text.substr(0, tab);
    while (field.starts_with(' ')) field.remove_prefix(1);
    while (field.ends_with(' ')) field.remove_suffix(1);
    fields.push_back(field);
    if (tab == std::string_view::npos) return fields;
    text.remove_prefix(tab + 1);
  }
}

bool is_nothing(std::string_view field) {
  return field.empty() || field == "nan" || field == "NaN" || field == "NAN" || field == "null";
}

/// Rows of numbers between tabs behind a head.
class TabMarkers final : public MarkerReader {
 public:
  struct Head {
    std::vector<std::string> labels;
    double scale_m = 1e-3;            ///< from the unit of the file
    std::optional<std::size_t> time;  ///< column of the time
    double rate_Hz = 0.0;             ///< where there is none
    std::size_t first = 0;            ///< column of the first position
  };

  TabMarkers(LineReader lines, Head head, bool row_waits)
      : lines_(std::move(lines)), head_(std::move(head)), row_waits_(row_waits) {
    markers_ = head_.labels;
  }

  Result<bool> next(double& t_s, std::span<Vec3> p_W) override {
    std::vector<std::string_view> fields;
    do {
      if (!std::exchange(row_waits_, false)) {
        const auto more = lines_.next();
        if (!more || !*more) return more;
      }
      fields = tab_fields(lines_.text());
    } while (fields.size() == 1 && fields[0].empty());
    t_s = head_.time ? std::numeric_limits<double>::quiet_NaN()
                     : static_cast<double>(rows_) / head_.rate_Hz;
    if (head_.time && (*head_.time >= fields.size() || !parse_number(fields[*head_.time], t_s)))
      return error_here("Time", "is no time"_text, "write a number of seconds"_text);
    if (t_s <= last_s_)
      return error_here("Time", "time does not increase"_text,
                        "sort the rows and remove repeats"_text);
    last_s_ = t_s;
    ++rows_;
    if (const std::size_t most = head_.first + 3 * markers_.size();
        fields.size() > most &&
        !std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(most), fields.end(),
                     [](std::string_view field) { return field.empty(); }))
      return error_here("", "the line has more fields than markers"_text,
                        "give three for each marker"_text);
    for (std::size_t k = 0; k < markers_.size(); ++k) {
      const auto p = position(fields, k);
      if (!p) return p.error();
      p_W[k] = *p;
    }
    return true;
  }

 private:
  Error error_here(std::string field, Text what, Text remedy) const {
    return refused(std::move(what), std::move(remedy))
        .at(lines_.path(), lines_.line(), std::move(field));
  }

  Result<Vec3> position(const std::vector<std::string_view>& fields, std::size_t marker) const {
    Vec3 p = unseen_marker();
    int given = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::size_t c = head_.first + 3 * marker + a;
      if (c >= fields.size() || is_nothing(fields[c])) continue;
      double value = 0.0;
      if (!parse_number(fields[c], value))
        return error_here(markers_[marker], "'%1' is not a finite number"_text(fields[c]),
                          "write a number with '.' as the decimal sign, or leave the field empty "
                          "if the value is missing"_text);
      p[static_cast<Eigen::Index>(a)] = head_.scale_m * value;
      ++given;
    }
    if (given == 1 || given == 2)
      return error_here(markers_[marker], "a part of the position is empty"_text,
                        "give x, y and z, or none of them if it was not seen"_text);
    return unseen_at_origin(p);
  }

  LineReader lines_;
  Head head_;
  bool row_waits_;  ///< the line read last is a row
  std::size_t rows_ = 0;
  double last_s_ = -std::numeric_limits<double>::infinity();
};

Error bad_head(const LineReader& lines, Text what) {
  return refused(std::move(what), "export the file again"_text).at(lines.path(), lines.line());
}

Result<LineReader> open_lines(const std::string& path) {
  return LineReader::open(path, kLongestTabLine,
                          "check that it is a table of markers with line ends"_text);
}

/// The next line of a head, which must be there.
Result<std::vector<std::string_view>> head_line(LineReader& lines) {
  const auto more = lines.next();
  if (!more) return more.error();
  if (!*more) return bad_head(lines, "ends within its head"_text);
  return tab_fields(lines.text());
}

Result<std::unique_ptr<MarkerReader>> opened(LineReader lines, TabMarkers::Head head,
                                             bool row_waits) {
  if (auto good = check_labels(head.labels, lines.path()); !good) return good.error();
  return std::unique_ptr<MarkerReader>(
      std::make_unique<TabMarkers>(std::move(lines), std::move(head), row_waits));
}

}  // namespace

Result<std::unique_ptr<MarkerReader>> open_trc(const std::string& path) {
  auto lines = open_lines(path);
  if (!lines) return lines.error();
  if (const auto first = head_line(*lines); !first) return first.error();
  const auto names = head_line(*lines);
  if (!names) return names.error();
  const auto units = std::find(names->begin(), names->end(), "Units") - names->begin();
  const auto values = head_line(*lines);
  if (!values) return values.error();
  TabMarkers::Head head;
  const auto unit = static_cast<std::size_t>(units) < values->size()
                        ? (*values)[static_cast<std::size_t>(units)]
                        : std::string_view();
  if (unit == "m")
    head.scale_m = 1.0;
  else if (unit != "mm")
    return bad_head(*lines, "its lengths are in '%1', not in m or mm"_text(unit));
  const auto labels = head_line(*lines);
  if (!labels) return labels.error();
  if (labels->size() < 3 || (*labels)[1] != "Time")
    return bad_head(*lines, "has no Time beside the frame"_text);
  head.time = 1;
  head.first = 2;
  for (std::size_t c = 2; c < labels->size(); c += 3)
    if (!(*labels)[c].empty()) head.labels.emplace_back(without_subject((*labels)[c]));
  if (const auto axes = head_line(*lines); !axes) return axes.error();
  return opened(std::move(*lines), std::move(head), false);
}

Result<std::unique_ptr<MarkerReader>> open_qualisys_tsv(const std::string& path) {
  auto lines = open_lines(path);
  if (!lines) return lines.error();
  TabMarkers::Head head;
  for (;;) {
    const auto fields = head_line(*lines);
    if (!fields) return fields.error();
    const std::string_view key = fields->front();
    double number = 0.0;
    if (key.empty() && fields->size() == 1) continue;
    if (key == "FREQUENCY" && fields->size() > 1 && parse_number((*fields)[1], number))
      head.rate_Hz = number;
    if (key == "MARKER_NAMES")
      for (std::size_t c = 1; c < fields->size(); ++c)
        if (!(*fields)[c].empty()) head.labels.emplace_back(without_subject((*fields)[c]));
    const bool names_columns = key == "Frame" && fields->size() > 1 && (*fields)[1] == "Time";
    if (names_columns) {
      head.time = 1;
      head.first = 2;
    }
    const bool row = parse_number(key, number);
    if (!names_columns && !row) continue;
    if (!(head.rate_Hz > 0.0) && !head.time)
      return bad_head(*lines, "its head names no FREQUENCY"_text);
    return opened(std::move(*lines), std::move(head), row);
  }
}

}  // namespace isograsp
