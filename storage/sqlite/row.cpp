// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/sqlite/row.hpp"

#include <algorithm>
#include <deque>

#include <soci/soci.h>

namespace isograsp::storage {

std::string as_lines(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : "\n") + names[i];
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

/// Hands values to a statement; SOCI keeps their addresses until it has been executed.
class GivenValues {
 public:
  explicit GivenValues(soci::session& sql) : sql_(sql) {}
  void use(soci::statement& statement, const SqlValue& value) {
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
      soci::blob& blob = blobs_.emplace_back(sql_);
      blob.append(reinterpret_cast<const char*>(list->data()), list->size() * sizeof(double));
      statement.exchange(soci::use(blob));
    } else if (const auto* number = std::get_if<double>(&value)) {
      statement.exchange(soci::use(*number));
    } else if (const auto* text = std::get_if<std::string>(&value)) {
      statement.exchange(soci::use(*text));
    } else {
      statement.exchange(soci::use(std::get<std::int64_t>(value)));
    }
  }

 private:
  soci::session& sql_;
  std::deque<soci::blob> blobs_;
};

struct Row::Parts {
  explicit Parts(soci::session& session) : sql(session), given(session), statement(session) {}
  template <class Into>
  void ask(const std::string& expression, Into into) {
    columns += (columns.empty() ? "" : ", ") + expression;
    statement.exchange(into);
  }
  /// A number that may be NULL: it and what it says of that.
  template <class Stored, class T>
  void ask_optional(const std::string& expression,
                    std::deque<std::pair<Stored, soci::indicator>>& in, std::optional<T>& to) {
    auto& found = in.emplace_back();
    after.push_back([&found, &to] {
      to =
          found.second == soci::i_ok ? std::optional<T>(static_cast<T>(found.first)) : std::nullopt;
    });
    ask(expression, soci::into(found.first, found.second));
  }
  soci::session& sql;
  std::string columns;
  std::vector<SqlValue> used;
  // Deques: SOCI keeps the addresses of what they hold.
  std::deque<int> flags;
  std::deque<std::string> texts;
  std::deque<soci::blob> blobs;
  std::deque<std::pair<double, soci::indicator>> numbers;
  std::deque<std::pair<long long, soci::indicator>> integers;
  std::vector<std::function<void()>> after;  ///< a row has come
  GivenValues given;
  soci::statement statement;
};

Row::Row(soci::session& sql) : parts_(std::make_unique<Parts>(sql)) {}
Row::~Row() = default;

Row& Row::get(const std::string& expression, double& to) {
  parts_->ask(expression, soci::into(to));
  return *this;
}
Row& Row::get(const std::string& expression, int& to) {
  parts_->ask(expression, soci::into(to));
  return *this;
}
Row& Row::get(const std::string& expression, std::int64_t& to) {
  parts_->ask(expression, soci::into(to));
  return *this;
}
Row& Row::get(const std::string& expression, std::string& to) {
  parts_->ask(expression, soci::into(to));
  return *this;
}
Row& Row::get(const std::string& expression, bool& to) {
  int& flag = parts_->flags.emplace_back();
  parts_->after.push_back([&flag, &to] { to = flag != 0; });
  parts_->ask(expression, soci::into(flag));
  return *this;
}
Row& Row::get(const std::string& expression, std::vector<double>& to) {
  soci::blob& blob = parts_->blobs.emplace_back(parts_->sql);
  parts_->after.push_back([&blob, &to] {
    to.resize(blob.get_len() / sizeof(double));
    if (!to.empty()) blob.read(0, reinterpret_cast<char*>(to.data()), to.size() * sizeof(double));
  });
  parts_->ask(expression, soci::into(blob));
  return *this;
}
Row& Row::get(const std::string& expression, std::optional<double>& to) {
  parts_->ask_optional(expression, parts_->numbers, to);
  return *this;
}
Row& Row::get(const std::string& expression, std::optional<int>& to) {
  parts_->ask_optional(expression, parts_->integers, to);
  return *this;
}
Row& Row::get(const std::string& expression, std::optional<std::int64_t>& to) {
  parts_->ask_optional(expression, parts_->integers, to);
  return *this;
}
Row& Row::text(const std::string& expression, std::function<void(const std::string&)> take) {
  std::string& text = parts_->texts.emplace_back();
  parts_->after.push_back([&text, take = std::move(take)] { take(text); });
  parts_->ask(expression, soci::into(text));
  return *this;
}

void Row::select(const std::string& from, std::vector<SqlValue> used) {
  parts_->used = std::move(used);
  soci::statement& statement = parts_->statement;
  for (const SqlValue& value : parts_->used) parts_->given.use(statement, value);
  statement.alloc();
  statement.prepare("SELECT " + parts_->columns + " " + from);
  statement.define_and_bind();
  statement.execute();
}

bool Row::fetch() {
  if (!parts_->statement.fetch()) return false;
  for (const auto& work : parts_->after) work();
  return true;
}

void get_measure(Row& row, Measure& measure, const std::string& of) {
  row.get(of + "name", measure.name)
      .get(of + "channel", measure.channel)
      .get(of + "value", measure.value)
      .get(of + "unit", measure.unit)
      .get(of + "version", measure.version)
      .get(of + "sample_count", measure.samples)
      .get(of + "excluded_count", measure.excluded)
      .get(of + "reason", measure.reason);
}

void NewRow::insert(const std::string& otherwise) {
  std::string names;
  std::string places;
  GivenValues given(sql_);
  soci::statement statement(sql_);
  for (const auto& [column, value] : columns_) {
    const char* const comma = names.empty() ? "" : ", ";
    names += comma + column;
    places += std::string(comma) + ":" + column;
    given.use(statement, value);
  }
  statement.alloc();
  statement.prepare("INSERT INTO " + table_ + " (" + names + ") VALUES (" + places + ") " +
                    otherwise);
  statement.define_and_bind();
  statement.execute(true);
}

}  // namespace isograsp::storage
