// SPDX-License-Identifier: GPL-3.0-or-later
#include "languages/catalogue.hpp"

#include <algorithm>
#include <optional>

namespace isograsp::languages {

namespace {

/// The text between the quotes that begin and end `quoted`.
std::optional<std::string> unquoted(std::string_view quoted) {
  if (quoted.size() < 2 || quoted.front() != '"' || quoted.back() != '"') return std::nullopt;
  quoted = quoted.substr(1, quoted.size() - 2);
  std::string text;
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    if (quoted[i] == '"') return std::nullopt;
    if (quoted[i] != '\\') {
      text += quoted[i];
      continue;
    }
    if (++i == quoted.size()) return std::nullopt;
    if (quoted[i] == 'n')
      text += '\n';
    else if (quoted[i] == '"' || quoted[i] == '\\')
      text += quoted[i];
    else
      return std::nullopt;
  }
  return text;
}

}  // namespace

Result<std::vector<Translation>> read_translations(std::string_view po) {
  std::vector<Translation> all;
  std::string* open = nullptr;  // the text that the next line in quotes continues
  int number = 0;
  for (std::size_t from = 0; from < po.size();) {
    const std::size_t end = std::min(po.find('\n', from), po.size());
    std::string_view line = po.substr(from, end - from);
    from = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (line.starts_with("msgid ")) {
      open = &all.emplace_back().english;
      line.remove_prefix(6);
    } else if (line.starts_with("msgstr ") && !all.empty()) {
      open = &all.back().words;
      line.remove_prefix(7);
    }
    const auto text = unquoted(line);
    if (!text || open == nullptr)
      return refused("is no line of a file of translations"_text,
                     "write msgid \"…\", msgstr \"…\" or what they go on with in quotes"_text)
          .at("", number);
    *open += *text;
  }
  std::erase_if(all, [](const Translation& entry) { return entry.english.empty(); });
  return all;
}

Catalogue::Catalogue(std::string_view po, Forms forms) : forms_(std::move(forms)) {
  auto all = read_translations(po);
  if (!all) return;
  for (Translation& entry : *all)
    if (!entry.words.empty()) words_.emplace(std::move(entry.english), std::move(entry.words));
}

std::string_view Catalogue::words(std::string_view english) const {
  const auto found = words_.find(english);
  return found == words_.end() ? english : std::string_view(found->second);
}

std::string Catalogue::number(std::string_view digits) const {
  std::string written(digits);
  std::replace(written.begin(), written.end(), '.', forms_.decimal_sign);
  return written;
}

std::string Catalogue::day(Date date) const {
  const std::string iso = iso_text(date);
  std::string written = forms_.day;
  const auto put = [&](std::string_view part, std::size_t from) {
    if (const auto at = written.find(part); at != std::string::npos)
      written.replace(at, part.size(), iso, from, part.size());
  };
  put("yyyy", 0);
  put("MM", 5);
  put("dd", 8);
  return written;
}

}  // namespace isograsp::languages
