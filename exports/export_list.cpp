// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/export_list.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "core/files.hpp"
#include "storage/access/signing.hpp"

namespace isograsp::exports {

namespace {

namespace fs = std::filesystem;

/// As an export names its files: below the folder, without a step back, a link or a line's end.
bool is_plain_name(const std::string& name) {
  const fs::path path(name);
  if (name.empty() || path.is_absolute() || path.lexically_normal().string() != name) return false;
  if (name == kExportList || name == kExportSignature) return false;
  return std::all_of(name.begin(), name.end(),
                     [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '\\'; }) &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) {
           return part == "." || part == ".." || part.empty();
         });
}

struct Found {
  std::vector<std::string> files;     ///< plain files but the list and its signature, sorted
  std::vector<std::string> no_files;  ///< links, pipes, …
};

Result<Found> found_below(const std::string& folder) {
  Found found;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const auto status = entry->symlink_status(failure);
    if (failure) break;
    std::string name = entry->path().lexically_relative(folder).string();
    if (fs::is_directory(status)) continue;
    if (!fs::is_regular_file(status))
      found.no_files.push_back(std::move(name));
    else if (name != kExportList && name != kExportSignature)
      found.files.push_back(std::move(name));
  }
  if (failure)
    return failed("cannot be read: %1"_text(Known{failure.message()}), "check its permissions"_text)
        .at(folder);
  std::sort(found.files.begin(), found.files.end());
  std::sort(found.no_files.begin(), found.no_files.end());
  return found;
}

using Listed = std::map<std::string, std::string>;  ///< hash of each name

Result<Listed> read_list(const std::string& path) {
  constexpr std::size_t kHash = 64;
  constexpr std::string_view kBetween = "  ";
  const auto text = read_text(path);
  if (!text) return text.error();
  Listed listed;
  int line = 0;
  for (std::size_t at = 0; at < text->size();) {
    ++line;
    const auto end = text->find('\n', at);
    const std::string one = text->substr(at, end == std::string::npos ? end : end - at);
    const bool whole = end != std::string::npos && one.size() > kHash + kBetween.size() &&
                       storage::is_hex(std::string_view(one).substr(0, kHash), kHash) &&
                       one.compare(kHash, kBetween.size(), kBetween) == 0;
    const std::string name = whole ? one.substr(kHash + kBetween.size()) : "";
    if (!whole || !is_plain_name(name) || !listed.emplace(name, one.substr(0, kHash)).second)
      return failed("is no line of a list of isograsp"_text,
                    "take a copy of the export that is as it was made"_text)
          .at(path, line);
    at = end + 1;
  }
  return listed;
}

std::string below(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

bool is_plain_file(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(path, ignored));
}

}  // namespace

Result<void> list_and_sign(const std::string& folder, const std::string& database) {
  const auto found = found_below(folder);
  if (!found) return found.error();
  std::string text;
  for (const std::string& name : found->files) {
    const auto hash = storage::hash_of_file(below(folder, name));
    if (!hash) return hash.error();
    text += hash->sha256 + "  " + name + "\n";
  }
  const std::string list = below(folder, kExportList);
  if (auto written = write_text(list, text); !written) return written;
  const auto key = storage::sign_file(database, list, storage::SignedKind::export_list);
  if (!key) return key.error();
  return {};
}

Result<ExportProof> prove_export(const std::string& folder, const std::string& key) {
  std::error_code failure;
  if (!fs::is_directory(folder, failure))
    return refused("is no folder"_text, "name the folder of an export"_text).at(folder);
  const std::string list = below(folder, kExportList);
  if (!is_plain_file(list))
    return failed("holds no list of its files (SHA256SUMS), so nothing proves it"_text,
                  "take an export that has one"_text)
        .at(folder);
  ExportProof proof;
  if (fs::exists(fs::symlink_status(below(folder, kExportSignature), failure))) {
    const auto signature = storage::check_signature(list, storage::SignedKind::export_list, key);
    if (!signature) return signature.error();
    proof.key = signature->key;
  }
  const auto listed = read_list(list);
  if (!listed) return listed.error();
  const auto found = found_below(folder);
  if (!found) return found.error();
  proof.files = listed->size();
  for (const std::string& name : found->no_files)
    proof.problems.push_back("%1 is no plain file: it was added"_text(name));
  for (const std::string& name : found->files) {
    const auto line = listed->find(name);
    if (line == listed->end()) {
      proof.problems.push_back("%1 was added"_text(name));
      continue;
    }
    const auto hash = storage::hash_of_file(below(folder, name));
    if (!hash)
      proof.problems.push_back("%1 cannot be read"_text(name));
    else if (hash->sha256 != line->second)
      proof.problems.push_back("%1 was altered"_text(name));
  }
  for (const auto& [name, hash] : *listed)
    if (!std::binary_search(found->files.begin(), found->files.end(), name))
      proof.problems.push_back("%1 is missing"_text(name));
  return proof;
}

}  // namespace isograsp::exports
