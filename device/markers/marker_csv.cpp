// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/marker_csv.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/csv.hpp"

namespace isograsp {

namespace {

constexpr const char* kPositionEndings[] = {"_x_m", "_y_m", "_z_m"};

class MarkerCsv final : public MarkerReader {
 public:
  MarkerCsv(CsvReader csv, std::vector<std::string> markers)
      : csv_(std::move(csv)), row_(csv_.columns().size()) {
    markers_ = std::move(markers);
    simulated_ = std::any_of(csv_.comments().begin(), csv_.comments().end(),
                             [](const std::string& line) { return line.starts_with("simulated"); });
  }

  Result<bool> next(double& t_s, std::span<Vec3> p_W) override {
    const auto more = csv_.next(row_);
    if (!more || !*more) return more;
    t_s = row_[0];
    if (std::isnan(t_s))
      return csv_.error_here("t_s", "the time is empty"_text, "give every row a time"_text);
    if (t_s <= last_s_)
      return csv_.error_here("t_s", "time does not increase"_text,
                             "sort the rows and remove repeats"_text);
    last_s_ = t_s;
    for (std::size_t k = 0; k < p_W.size(); ++k) {
      const double* p = &row_[1 + 3 * k];
      const int empty = std::isnan(p[0]) + std::isnan(p[1]) + std::isnan(p[2]);
      if (empty == 1 || empty == 2)
        return csv_.error_here(markers_[k], "a part of the position is empty"_text,
                               "give x, y and z, or none of them if it was not seen"_text);
      p_W[k] = {p[0], p[1], p[2]};
    }
    return true;
  }

 private:
  CsvReader csv_;
  std::vector<double> row_;
  double last_s_ = -std::numeric_limits<double>::infinity();
};

Result<std::vector<std::string>> markers_in(const CsvReader& csv) {
  constexpr Words kRemedy = "name t_s and then NAME_x_m, NAME_y_m, NAME_z_m for each marker"_text;
  const auto& columns = csv.columns();
  if (columns.front() != "t_s")
    return csv.error_here(columns.front(), "the first column is not t_s"_text, kRemedy);
  std::vector<std::string> markers;
  for (std::size_t c = 1; c < columns.size(); c += 3) {
    const std::string& first = columns[c];
    const std::string name =
        first.ends_with(kPositionEndings[0]) ? first.substr(0, first.size() - 4) : "";
    if (name.empty()) return csv.error_here(first, "begins no position of a marker"_text, kRemedy);
    for (std::size_t a = 1; a < 3; ++a)
      if (c + a >= columns.size() || columns[c + a] != name + kPositionEndings[a])
        return csv.error_here(
            c + a < columns.size() ? columns[c + a] : first,
            "column '%1' does not stand in its place"_text(name + kPositionEndings[a]), kRemedy);
    markers.push_back(name);
  }
  if (markers.empty()) return csv.error_here("", "names no marker"_text, kRemedy);
  return markers;
}

}  // namespace

Result<std::unique_ptr<MarkerReader>> open_marker_csv(const std::string& path) {
  auto csv = CsvReader::open(path);
  if (!csv) return csv.error();
  auto markers = markers_in(*csv);
  if (!markers) return markers.error();
  if (auto good = check_labels(*markers, path); !good) return good.error();
  return std::unique_ptr<MarkerReader>(
      std::make_unique<MarkerCsv>(std::move(*csv), std::move(*markers)));
}

Result<MarkerCsvWriter> MarkerCsvWriter::create(const std::string& path,
                                                const std::vector<std::string>& markers) {
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  std::string head = "t_s";
  for (const std::string& marker : markers)
    for (const char* axis : kPositionEndings) head += "," + without_formula(marker + axis);
  file->write(head + "\n");
  return MarkerCsvWriter(std::move(*file));
}

void MarkerCsvWriter::write(double t_s, std::span<const Vec3> p_W) {
  constexpr std::size_t kWriteAtOnce = std::size_t{1} << 16;
  append_number(text_, t_s);
  for (const Vec3& p : p_W)
    for (const double coordinate : p) {
      text_ += ',';
      append_number(text_, coordinate);
    }
  text_ += '\n';
  if (text_.size() < kWriteAtOnce) return;
  file_.write(text_);
  text_.clear();
}

Result<void> MarkerCsvWriter::commit() {
  file_.write(text_);
  return file_.commit();
}

}  // namespace isograsp
