// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/seal_summary.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "storage/crypto/secret.hpp"

namespace isograsp::storage {

namespace {

constexpr std::string_view kNoDigest = "-";

std::string hexadecimal(const ContentHash& hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : hash) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

/// Takes the text before the next `end` away; nothing: there is none.
std::optional<std::string_view> part_before(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(at + 1);
  return part;
}

}  // namespace

bool is_compared_at_login(std::string_view table) noexcept {
  return std::ranges::find(kTablesOfAccounts, table) != kTablesOfAccounts.end() ||
         std::ranges::find(kTablesOfTexts, table) != kTablesOfTexts.end();
}

std::int64_t number_of_row(std::string_view row) noexcept {
  std::int64_t number = 0;
  const auto read = std::from_chars(row.data(), row.data() + row.size(), number);
  return read.ptr == row.data() + row.size() && number > 0 ? number : 0;
}

void SealSummary::note(std::string_view table, std::string_view row) {
  const std::int64_t number = number_of_row(row);
  if (number == 0) return;
  auto place = highest.find(table);
  if (place == highest.end()) place = highest.emplace(table, 0).first;
  place->second = std::max(place->second, number);
}

std::string digest_of(const Secret* key, std::string_view table, const RowHashes& hashes) {
  ContentHasher whole(key != nullptr ? key->text() : std::string_view());
  whole.add_text("IsoGrasp table 1");
  whole.add_text(table);
  for (const auto& [row, hash] : hashes) {
    whole.add_text(row);
    whole.add_text(hash);
  }
  return hexadecimal(whole.hash());
}

std::string written(const SealSummary& summary) {
  std::set<std::string_view> tables;
  for (const auto& [table, number] : summary.highest) tables.insert(table);
  for (const auto& [table, digest] : summary.digests) tables.insert(table);
  std::string text;
  for (const std::string_view table : tables) {
    const auto highest = summary.highest.find(table);
    const auto digest = summary.digests.find(table);
    text += table;
    text += " " + std::to_string(highest != summary.highest.end() ? highest->second : 0) + " ";
    text += digest != summary.digests.end() ? std::string_view(digest->second) : kNoDigest;
    text += "\n";
  }
  return text.empty() ? "\n" : text;
}

std::optional<SealSummary> read_summary(std::string_view text) {
  if (text.empty()) return std::nullopt;
  SealSummary summary;
  if (text == "\n") return summary;
  while (!text.empty()) {
    auto line = part_before(text, '\n');
    if (!line) return std::nullopt;
    const auto table = part_before(*line, ' ');
    const auto highest = table ? part_before(*line, ' ') : std::nullopt;
    if (!highest || table->empty()) return std::nullopt;
    if (*highest != "0") {
      const std::int64_t number = number_of_row(*highest);
      if (number == 0) return std::nullopt;
      summary.highest.emplace(*table, number);
    }
    if (*line != kNoDigest) summary.digests.emplace(*table, *line);
  }
  return summary;
}

}  // namespace isograsp::storage
