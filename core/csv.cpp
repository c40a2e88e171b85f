// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <system_error>
#include <unordered_set>

namespace isograsp {

namespace {

/// Memory stays bounded whatever the file is; a row of 10,000 numbers is shorter.
constexpr std::size_t kLongestLine = std::size_t{1} << 20;
constexpr Words kTableRemedy = "check that it is a table of numbers with line ends"_text;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

constexpr std::array<std::uint64_t, 20> kPowersOfTen = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

/// digits / 10^decimals to the nearest double, ties to even. @pre decimals < kPowersOfTen.size()
double decimal(std::uint64_t digits, std::size_t decimals) noexcept {
  // Two exact doubles: their quotient is rounded correctly.
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  if (digits <= kExact)
    return static_cast<double>(digits) / static_cast<double>(kPowersOfTen[decimals]);
  // Both sides shifted to 64 bits: the quotient of the integers has 63 bits at least, ten more than
  // a double, and its last bit tells whether anything follows. One conversion rounds correctly.
  __extension__ using Wide = unsigned __int128;
  const int shift = std::countl_zero(digits);
  const int divisor_shift = std::countl_zero(kPowersOfTen[decimals]);
  const std::uint64_t divisor = kPowersOfTen[decimals] << divisor_shift;
  const Wide dividend = Wide{digits << shift} << 63;
  auto quotient = static_cast<std::uint64_t>(dividend / divisor);
  if (dividend != Wide{quotient} * divisor) quotient |= 1;
  const auto exponent = static_cast<std::uint64_t>(1023 + divisor_shift - shift - 63);
  return static_cast<double>(quotient) * std::bit_cast<double>(exponent << 52);
}

/// Reads a field of at most 19 digits with or without a point, as nearly every number in a table is
/// written, and returns its end; null for any other field. The bits are those of std::from_chars,
/// which needs twice the time.
const char* read_plain_field(const char* at, const char* end, double& value) noexcept {
  constexpr std::ptrdiff_t kMostDigits = 19;  // 10^19 < 2^64
  const bool negative = at != end && *at == '-';
  if (negative) ++at;
  const bool zero = at != end && *at == '0';
  if (zero) ++at;
  std::uint64_t digits = 0;
  const auto read_digits = [&] {
    const char* const first = at;
    for (; at != end && *at >= '0' && *at <= '9'; ++at)
      digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
    return at - first;
  };
  const auto whole = read_digits();
  std::ptrdiff_t decimals = 0;
  if (at != end && *at == '.') {
    ++at;
    decimals = read_digits();
  }
  if ((whole == 0 && !zero) || whole + decimals > kMostDigits) return nullptr;
  if (at != end && *at != ',') return nullptr;
  const double size = decimal(digits, static_cast<std::size_t>(decimals));
  value = negative ? -size : size;
  return at;
}

/// Any field; an empty one is NaN. False if it is not a number.
bool read_field(std::string_view field, double& value) noexcept {
  field = trimmed(field);
  if (!field.empty()) return parse_number(field, value);
  value = std::numeric_limits<double>::quiet_NaN();
  return true;
}

/// Also after apostrophes that were put in front of it.
bool looks_like_formula(std::string_view text) noexcept {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
}

}  // namespace

char* print_number(char* at, double value) noexcept {
  return std::isnan(value) ? at : std::to_chars(at, at + kLongestNumber, value).ptr;
}

void append_number(std::string& text, double value) {
  std::array<char, kLongestNumber> number;
  text.append(number.data(), print_number(number.data(), value));
}

std::string without_formula(std::string text) {
  double number = 0.0;
  if (looks_like_formula(text) && !parse_number(text, number)) text.insert(0, 1, '\'');
  return text;
}

std::string_view with_formula(std::string_view text) noexcept {
  if (text.starts_with('\'') && looks_like_formula(text)) text.remove_prefix(1);
  return text;
}

std::string csv_field(std::string text) {
  text = without_formula(std::move(text));
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string format_number(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

bool parse_number(std::string_view field, double& value) noexcept {
  const char* const end = field.data() + field.size();
  if (field.starts_with('+') && !field.starts_with("+-")) field.remove_prefix(1);
  double parsed = 0.0;
  const auto [stop, failure] = std::from_chars(field.data(), end, parsed);
  if (failure != std::errc{} || stop != end || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

Result<CsvReader> CsvReader::open(const std::string& path) {
  auto lines = LineReader::open(path, kLongestLine, kTableRemedy);
  if (!lines) return lines.error();
  CsvReader reader(std::move(*lines));
  do {
    const auto more = reader.read_line();
    if (!more) return more.error();
    if (!*more)
      return refused("holds no header line"_text,
                     "give a CSV file whose first line names the columns"_text)
          .at(path);
    if (reader.text_.starts_with('#'))
      reader.comments_.emplace_back(trimmed(reader.text_.substr(1)));
  } while (reader.text_.empty() || reader.text_.starts_with('#'));
  if (const auto done = reader.read_columns(); !done) return done.error();
  return reader;
}

Result<void> CsvReader::read_columns() {
  const auto count = 1 + std::count(text_.begin(), text_.end(), ',');
  if (count > static_cast<std::ptrdiff_t>(kMostColumns))
    return error_here("", "the header names %1 columns"_text(count),
                      "give at most %1"_text(kMostColumns));
  std::unordered_set<std::string> seen;
  std::string_view rest = text_;
  for (bool more = true; more;) {
    const auto comma = rest.find(',');
    std::string name(with_formula(trimmed(rest.substr(0, comma))));
    if (name.empty())
      return error_here("", "the header has an empty column name"_text, "name every column"_text);
    if (!seen.insert(name).second)
      return error_here(name, "the column appears twice"_text, "keep one of them"_text);
    columns_.push_back(std::move(name));
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return {};
}

Result<bool> CsvReader::read_line() {
  auto more = lines_.next();
  if (!more || !*more) return more;
  text_ = lines_.text();
  if (line() == 1 && text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  return true;
}

/// Passes over comments and empty lines.
Result<bool> CsvReader::read_row_line() {
  for (;;) {
    auto more = read_line();
    if (!more || !*more || !(text_.empty() || text_.front() == '#')) return more;
  }
}

Error CsvReader::error_here(std::string field, Text what, Text remedy) const {
  return refused(std::move(what), std::move(remedy)).at(path(), line(), std::move(field));
}

Error CsvReader::too_short(std::size_t column) const {
  return error_here(columns_[column], "the line ends before this column"_text,
                    "give every line %1 fields"_text(columns_.size()));
}

Error CsvReader::not_a_number(std::size_t column, std::string_view field) const {
  return error_here(
      columns_[column], "'%1' is not a finite number"_text(trimmed(field)),
      "write a number with '.' as the decimal sign, or leave the field empty if the value is "
      "missing"_text);
}

Result<bool> CsvReader::next(std::span<double> row) {
  const auto more = read_row_line();
  if (!more || !*more) return more;
  const char* at = text_.data();
  const char* const end = at + text_.size();
  for (std::size_t i = 0; i < row.size(); ++i) {
    const char* stop = read_plain_field(at, end, row[i]);
    const bool plain = stop != nullptr;
    if (!plain) stop = std::find(at, end, ',');
    const bool last = i + 1 == row.size();
    if (!last && stop == end) return too_short(i + 1);
    if (last && stop != end)
      return error_here("", "the line has more fields than the header"_text,
                        "give every line %1 fields"_text(row.size()));
    if (!plain && !read_field({at, stop}, row[i])) return not_a_number(i, {at, stop});
    if (!last) at = stop + 1;
  }
  return true;
}

Result<bool> CsvReader::next(std::size_t column, double& value) {
  const auto more = read_row_line();
  if (!more || !*more) return more;
  std::string_view rest = text_;
  for (std::size_t i = 0; i < column; ++i) {
    const auto comma = rest.find(',');
    if (comma == std::string_view::npos) return too_short(i + 1);
    rest.remove_prefix(comma + 1);
  }
  const auto field = rest.substr(0, rest.find(','));
  if (!read_field(field, value)) return not_a_number(column, field);
  return true;
}

Result<std::unique_ptr<TableReader>> open_csv(const std::string& path) {
  auto csv = CsvReader::open(path);
  if (!csv) return csv.error();
  return std::unique_ptr<TableReader>(std::make_unique<CsvReader>(*std::move(csv)));
}

CsvWriter::CsvWriter(FileWriter file, std::size_t columns)
    : file_(std::move(file)), longest_row_(columns * (kLongestNumber + 1)) {
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  block_.resize(std::max(kBlock, longest_row_));
}

Result<std::unique_ptr<TableWriter>> CsvWriter::create(const std::string& path,
                                                       std::span<const std::string> columns) {
  auto file = FileWriter::create(path);
  if (!file) return file.error();
  std::string head;
  for (const std::string& name : columns) head += (head.empty() ? "" : ",") + without_formula(name);
  file->write(head + "\n");
  return std::unique_ptr<TableWriter>(new CsvWriter(*std::move(file), columns.size()));
}

void CsvWriter::add(std::span<const double> row) {
  if (block_.size() - used_ < longest_row_) flush();
  char* at = block_.data() + used_;
  for (const double number : row) {
    at = print_number(at, number);
    *at++ = ',';
  }
  at[-1] = '\n';
  used_ = static_cast<std::size_t>(at - block_.data());
}

Result<void> CsvWriter::commit() {
  flush();
  return file_.commit();
}

void CsvWriter::flush() {
  file_.write({block_.data(), used_});
  used_ = 0;
}

Result<Signals> read_signals(const std::string& path) {
  auto reader = CsvReader::open(path);
  if (!reader) return reader.error();
  const auto time = reader->find("t_s");
  if (!time)
    return reader->error_here("t_s", "the column is missing"_text,
                              "add the time of each row in seconds"_text);
  Signals signals(reader->columns());
  std::vector<double> row(reader->columns().size());
  double previous = -std::numeric_limits<double>::infinity();
  for (;;) {
    const auto more = reader->next(row);
    if (!more) return more.error();
    if (!*more) break;
    const double t = row[*time];
    if (std::isnan(t))
      return reader->error_here("t_s", "the time is empty"_text, "give every row a time"_text);
    if (t <= previous)
      return reader->error_here("t_s", "time does not increase"_text,
                                "sort the rows and remove repeats"_text);
    previous = t;
    signals.append_row(row);
  }
  if (signals.rows() < 2)
    return reader->error_here("", "fewer than two rows"_text, "give at least two rows"_text);
  return signals;
}

Result<void> write_signals(const Signals& signals, const std::string& path,
                           std::span<const std::string> comments) {
  auto writer = FileWriter::create(path);
  if (!writer) return writer.error();
  std::string text;
  for (const auto& comment : comments) text += "# " + comment + "\n";
  for (std::size_t c = 0; c < signals.names().size(); ++c)
    text += (c == 0 ? "" : ",") + without_formula(signals.names()[c]);
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
