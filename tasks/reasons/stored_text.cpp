// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/reasons/stored_text.hpp"

namespace isograsp::tasks::stored_text_detail {

namespace {

bool is_number(std::string_view text) {
  const bool digits_only = text.find_first_not_of("0123456789.-+e") == std::string_view::npos;
  return digits_only && text.find_first_of("0123456789") != std::string_view::npos;
}

}  // namespace

std::optional<std::vector<Argument>> values_in(std::string_view english,
                                               std::string_view sentence) {
  std::vector<Argument> values;
  while (!english.empty()) {
    if (text_detail::place_at(english, 0) == 0) {
      if (sentence.empty() || sentence.front() != english.front()) return std::nullopt;
      english.remove_prefix(1);
      sentence.remove_prefix(1);
      continue;
    }
    english.remove_prefix(2);
    std::size_t next = 0;  // of the words behind the place, up to the next one
    while (next < english.size() && text_detail::place_at(english, next) == 0) ++next;
    const std::string_view behind = english.substr(0, next);
    const std::size_t end = next == english.size() && sentence.ends_with(behind)
                                ? sentence.size() - behind.size()
                                : sentence.find(behind);
    if (end == std::string_view::npos || end == 0) return std::nullopt;
    const std::string value(sentence.substr(0, end));
    if (is_number(value))
      values.emplace_back(Number{value});
    else
      values.emplace_back(Known{value});
    sentence.remove_prefix(end);
  }
  if (!sentence.empty()) return std::nullopt;
  return values;
}

}  // namespace isograsp::tasks::stored_text_detail
