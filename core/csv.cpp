// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <system_error>

namespace isograsp {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

void append_number(std::string& text, double value) {
  if (std::isnan(value)) return;
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  text.append(buffer, end);
}

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

bool parse_number(std::string_view field, double& value) noexcept {
  const char* const end = field.data() + field.size();
  if (!field.empty() && field.front() == '+') field.remove_prefix(1);
  double parsed = 0.0;
  const auto [stop, failure] = std::from_chars(field.data(), end, parsed);
  if (failure != std::errc{} || stop != end || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

Result<CsvReader> CsvReader::open(const std::string& path) {
  CsvReader reader;
  reader.path_ = path;
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) reader.in_.open(path, std::ios::binary);
  if (!reader.in_.is_open()) return cannot_open(path, "reading");
  do {
    if (!reader.read_line())
      return Error{Error::Code::bad_input,
                   "holds no header line",
                   "give a CSV file whose first line names the columns",
                   path,
                   0,
                   ""};
    if (!reader.text_.empty() && reader.text_.front() == '#')
      reader.comments_.emplace_back(trimmed(std::string_view(reader.text_).substr(1)));
  } while (reader.text_.empty() || reader.text_.front() == '#');
  std::string_view rest = reader.text_;
  for (bool more = true; more;) {
    const auto comma = rest.find(',');
    const std::string name(trimmed(rest.substr(0, comma)));
    if (name.empty())
      return reader.error_here("", "the header has an empty column name", "name every column");
    if (reader.find(name) >= 0)
      return reader.error_here(name, "the column appears twice", "keep one of them");
    reader.columns_.push_back(name);
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return reader;
}

bool CsvReader::read_line() {
  if (!std::getline(in_, text_)) return false;
  ++line_;
  if (line_ == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  if (!text_.empty() && text_.back() == '\r') text_.pop_back();
  return true;
}

int CsvReader::find(std::string_view name) const noexcept {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i] == name) return static_cast<int>(i);
  return -1;
}

Error CsvReader::error_here(std::string field, std::string what, std::string remedy) const {
  return {Error::Code::bad_input, std::move(what), std::move(remedy), path_, line_,
          std::move(field)};
}

Result<bool> CsvReader::next(std::span<double> row) {
  do {
    if (!read_line()) return false;
  } while (text_.empty() || text_.front() == '#');
  std::string_view rest = text_;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto comma = rest.find(',');
    const bool last = i + 1 == row.size();
    if (last != (comma == std::string_view::npos))
      return error_here(
          last ? "" : columns_[i + 1],
          last ? "the line has more fields than the header" : "the line ends before this column",
          "give every line " + std::to_string(row.size()) + " fields");
    const std::string_view field = trimmed(rest.substr(0, comma));
    if (field.empty())
      row[i] = std::numeric_limits<double>::quiet_NaN();
    else if (!parse_number(field, row[i]))
      return error_here(columns_[i], "'" + std::string(field) + "' is not a finite number",
                        "write a number with '.' as the decimal sign, or leave the field empty if "
                        "the value is missing");
    if (!last) rest.remove_prefix(comma + 1);
  }
  return true;
}

Result<Signals> read_signals(const std::string& path) {
  auto reader = CsvReader::open(path);
  if (!reader) return reader.error();
  const int time = reader->find("t_s");
  if (time < 0)
    return reader->error_here("t_s", "the column is missing",
                              "add the time of each row in seconds");
  Signals signals(reader->columns());
  std::vector<double> row(reader->columns().size());
  double previous = -std::numeric_limits<double>::infinity();
  for (;;) {
    const auto more = reader->next(row);
    if (!more) return more.error();
    if (!*more) break;
    const double t = row[static_cast<std::size_t>(time)];
    if (std::isnan(t))
      return reader->error_here("t_s", "the time is empty", "give every row a time");
    if (t <= previous)
      return reader->error_here("t_s", "time does not increase",
                                "sort the rows and remove repeats");
    previous = t;
    signals.append_row(row);
  }
  if (signals.rows() < 2)
    return reader->error_here("", "fewer than two rows", "give at least two rows");
  return signals;
}

Result<void> write_signals(const Signals& signals, const std::string& path,
                           std::span<const std::string> comments) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  std::string text;
  for (const auto& comment : comments) text += "# " + comment + "\n";
  for (std::size_t c = 0; c < signals.names().size(); ++c)
    text += (c == 0 ? "" : ",") + signals.names()[c];
  text += "\n";
  for (std::size_t r = 0; r < signals.rows(); ++r) {
    for (std::size_t c = 0; c < signals.names().size(); ++c) {
      if (c > 0) text += ',';
      append_number(text, signals.column(c)[r]);
    }
    text += '\n';
    if (text.size() > 1 << 16) {
      writer->write(text);
      text.clear();
    }
  }
  writer->write(text);
  return writer->commit();
}

}  // namespace isograsp
