// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers against a slow second reader: fields cut at commas, numbers by std::from_chars.
#include "core/csv.hpp"

#include <cmath>
#include <vector>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    fields.push_back(trimmed(line.substr(0, comma)));
    if (comma != std::string_view::npos) line.remove_prefix(comma + 1);
  }
  return fields;
}

/// The lines that are neither empty nor comments.
std::vector<std::string_view> content(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (!line.empty() && line.front() != '#') lines.push_back(line);
  }
  return lines;
}

bool as_written(std::string_view field, double value) {
  if (field.empty()) return std::isnan(value);
  double expected = 0.0;
  return parse_number(field, expected) && fuzz::same_bits(expected, value);
}

void check_rows(CsvReader& table, std::span<const std::string_view> lines, std::string_view text) {
  std::vector<double> row(table.columns().size());
  for (const auto line : lines) {
    const auto fields = split(line);
    const auto more = table.next(row);
    bool good = fields.size() == row.size();
    double ignored = 0.0;
    for (const auto field : fields) good &= field.empty() || parse_number(field, ignored);
    fuzz::require(more.ok() == good, "a row is refused exactly if it is damaged");
    if (!more) return fuzz::require_helpful(more.error(), text);
    fuzz::require(*more, "no row is left out");
    for (std::size_t i = 0; i < row.size(); ++i) {
      fuzz::require(as_written(fields[i], row[i]), "every field has the bits of its number");
      fuzz::require(as_written(format_number(row[i]), row[i]), "a number is written exactly");
    }
  }
  const auto more = table.next(row);
  fuzz::require(more.ok() && !*more, "behind the last row there is nothing");
}

void check_column(CsvReader& table, std::span<const std::string_view> lines) {
  const std::size_t column = table.columns().size() - 1;
  for (const auto line : lines) {
    const auto fields = split(line);
    double value = 0.0;
    const auto more = table.next(static_cast<int>(column), value);
    if (!more) return;
    fuzz::require(*more && fields.size() > column && as_written(fields[column], value),
                  "one column is read as in the whole row");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const auto text = fuzz::as_text(data, size);
  file.write(text);
  auto table = CsvReader::open(file.path());
  if (!table) {
    fuzz::require_helpful(table.error(), text);
    return 0;
  }
  const auto lines = content(text);
  fuzz::require(!lines.empty() && split(lines[0]).size() == table->columns().size(),
                "the first line names the columns");
  const auto rows = std::span(lines).subspan(1);
  check_rows(*table, rows, text);
  auto again = CsvReader::open(file.path());
  check_column(*again, rows);
  return 0;
}
