// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/facts/column_facts.hpp"

#include <algorithm>

#include "hand/columns.hpp"

namespace isograsp::tasks {

ColumnFacts describe_column(std::string_view name) {
  const std::string unit(unit_of(name));
  if (const Column* column = columns::find(name))
    return {unit,
            column->description.text(),
            std::string(column->axes),
            std::string(column->component),
            std::string(column->body),
            true};
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return {unit, "Column of a recording: %1"_text(words), "", "", "", false};
}

}  // namespace isograsp::tasks
