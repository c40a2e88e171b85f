// SPDX-License-Identifier: GPL-3.0-or-later
// isograsp markers box.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/console.hpp"
#include "app/markers/marker_commands.hpp"
#include "core/files.hpp"
#include "core/tables/word_table.hpp"
#include "statistics/box_plot.hpp"
#include "statistics/holm.hpp"
#include "statistics/rank_tests.hpp"

namespace isograsp::app {

namespace {

using Json = nlohmann::ordered_json;

struct BoxOptions {
  std::string values;
  bool json = false;
};

/// Values of conditions, one row for each subject; missing ones NaN.
struct ValueColumns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

Result<ValueColumns> read_values(const std::string& path) {
  auto table = WordTable::open(path);
  if (!table) return table.error();
  if (table->columns().size() < 2)
    return table->error_here("", "has no column of values"_text,
                             "name the subject first, then each condition"_text);
  ValueColumns columns;
  columns.names.assign(table->columns().begin() + 1, table->columns().end());
  columns.values.resize(columns.names.size());
  for (;;) {
    const auto more = table->next();
    if (!more) return more.error();
    if (!*more) return columns;
    for (std::size_t c = 0; c < columns.names.size(); ++c) {
      const auto value = table->number(c + 1);
      if (!value) return value.error();
      columns.values[c].push_back(value->value_or(kMissing));
    }
  }
}

Json box_of(const std::vector<double>& column) {
  std::vector<double> values;
  for (const double value : column)
    if (!std::isnan(value)) values.push_back(value);
  Json one{{"n", values.size()}};
  const auto box = statistics::box_plot(values);
  if (!box) return one;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  one["min"] = *least;
  one["q1"] = box->lower_quartile;
  one["median"] = box->median;
  one["q3"] = box->upper_quartile;
  one["max"] = *most;
  one["whisker_low"] = box->lower_whisker;
  one["whisker_high"] = box->upper_whisker;
  one["outliers"] = box->outside;
  return one;
}

struct ComparedPair {
  std::size_t a = 0;
  std::size_t b = 0;
  std::size_t n = 0;
  std::optional<double> w_plus;
};

/// Pairs of conditions by the signed rank of their differences, and p of each.
struct Comparison {
  std::vector<ComparedPair> pairs;
  std::vector<std::optional<double>> p;
};

/// Values are printed numbers: differences are rounded to this, so that equal ones are equal.
constexpr double kDifferenceDigits = 1e12;

Comparison compared(const ValueColumns& columns) {
  Comparison all;
  for (std::size_t a = 0; a < columns.names.size(); ++a)
    for (std::size_t b = a + 1; b < columns.names.size(); ++b) {
      std::vector<double> differences;
      for (std::size_t row = 0; row < columns.values[a].size(); ++row) {
        const double difference = columns.values[a][row] - columns.values[b][row];
        if (!std::isnan(difference))
          differences.push_back(std::round(difference * kDifferenceDigits) / kDifferenceDigits);
      }
      const auto test = statistics::signed_rank(differences, 0.5 / kDifferenceDigits);
      all.pairs.push_back({a, b, differences.size(), test.w_plus.value});
      all.p.push_back(test.p.value);
    }
  return all;
}

/// A cell of a printed table, at the right.
std::string cell(const Json& of, const char* key) {
  const Json value = of.value(key, Json());
  char text[32];
  if (value.is_number_integer())
    std::snprintf(text, sizeof text, "%14lld", value.get<long long>());
  else if (value.is_number())
    std::snprintf(text, sizeof text, "%14.6g", value.get<double>());
  else
    std::snprintf(text, sizeof text, "%14s", "-");
  return text;
}

void print_table(const Json& boxes, const Json& pairs) {
  constexpr std::array kOfBox{"n",   "median", "q1",          "q3",
                              "min", "max",    "whisker_low", "whisker_high"};
  constexpr std::array kOfPair{"n", "w_plus", "p", "p_holm"};
  Lines lines;
  std::string head;
  const auto add_head = [&](const auto& keys) {
    head.clear();
    for (const char* key : keys) head += std::string(14 - std::string_view(key).size(), ' ') + key;
    lines.add_row(head);
  };
  add_head(kOfBox);
  for (const auto& [name, box] : boxes.items()) {
    std::string row;
    for (const char* key : kOfBox) row += cell(box, key);
    lines.add_row(row + "  " + printable(name));
  }
  add_head(kOfPair);
  for (const Json& pair : pairs) {
    std::string row;
    for (const char* key : kOfPair) row += cell(pair, key);
    lines.add_row(row + "  " + printable(pair.at("a").get<std::string>()) + " - " +
                  printable(pair.at("b").get<std::string>()));
  }
  print_lines(lines);
}

Result<void> run_box(const BoxOptions& options) {
  const auto columns = read_values(options.values);
  if (!columns) return columns.error();
  Json boxes = Json::object();
  for (std::size_t c = 0; c < columns->names.size(); ++c)
    boxes[columns->names[c]] = box_of(columns->values[c]);
  const Comparison all = compared(*columns);
  const auto corrected = statistics::holm(all.p);
  auto pairs = Json::array();
  for (std::size_t k = 0; k < all.pairs.size(); ++k)
    pairs.push_back({{"a", columns->names[all.pairs[k].a]},
                     {"b", columns->names[all.pairs[k].b]},
                     {"n", all.pairs[k].n},
                     {"w_plus", number_or_null(all.pairs[k].w_plus)},
                     {"p", number_or_null(all.p[k])},
                     {"p_holm", number_or_null(corrected[k])}});
  if (options.json)
    print_json({{"boxes", std::move(boxes)}, {"pairs", std::move(pairs)}});
  else
    print_table(boxes, pairs);
  return {};
}

}  // namespace

void add_marker_box(Subcommand markers) {
  auto options = std::make_shared<BoxOptions>();
  Subcommand box = markers.subcommand("box", "Box plots of conditions, and their pairs compared");
  box.option("--values", options->values, "Subject, then one column for each condition (CSV)")
      .required()
      .type("FILE");
  box.flag("--json", options->json, "Print one JSON document");
  box.runs([options] { return run_box(*options); });
}

}  // namespace isograsp::app
