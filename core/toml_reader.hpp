// SPDX-License-Identifier: GPL-3.0-or-later
// A strict view of a TOML document: every key must be known and of the right kind.
//
// The getters return a plain value; the first problem is remembered with its line and reported by
// finish(), together with any key that nobody asked for. So a reader is a list of getters followed
// by one `if`:
//
//   auto root = TomlReader::parse(text, file, "isograsp-scene-1");
//   if (!root) return root.error();
//   scene.name = root->text("name", "");
//   if (auto done = root->finish(); !done) return done.error();
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/spatial.hpp"

namespace isograsp {

class TomlReader {
 public:
  /// Parses the text and requires `format = "<format>"`. `file` is used in errors only.
  [[nodiscard]] static Result<TomlReader> parse(std::string_view text, std::string file,
                                                std::string_view format);

  [[nodiscard]] bool has(std::string_view key) const;
  /// Of this table, in the order of their letters: where keys are names that the file gives.
  [[nodiscard]] std::vector<std::string> keys() const;

  /// A finite number; an integer is accepted. Without `fallback` the key is required.
  double number(std::string_view key, std::optional<double> fallback = {});
  std::int64_t integer(std::string_view key, std::optional<std::int64_t> fallback = {});
  bool boolean(std::string_view key, std::optional<bool> fallback = {});
  std::string text(std::string_view key, std::optional<std::string> fallback = {});
  /// The index of the text among `names`; anything else is an error that lists them.
  std::size_t choice(std::string_view key, std::span<const std::string_view> names,
                     std::optional<std::size_t> fallback = {});
  std::size_t choice(std::string_view key, std::initializer_list<std::string_view> names,
                     std::optional<std::size_t> fallback = {}) {
    return choice(key, std::span(names.begin(), names.size()), fallback);
  }
  /// An array of finite numbers, between `least` and `most` of them. An absent key gives an empty
  /// vector if `required` is false.
  std::vector<double> numbers(std::string_view key, std::size_t least, std::size_t most,
                              bool required = true);
  Vec3 vec3(std::string_view key, std::optional<Vec3> fallback = {});
  std::vector<std::string> texts(std::string_view key, bool required = true);
  /// One text or an array of texts.
  std::vector<std::string> text_or_texts(std::string_view key);
  /// An array of arrays of `length` finite numbers each.
  std::vector<std::vector<double>> number_lists(std::string_view key, std::size_t length);
  /// The same of three.
  std::vector<Vec3> vec3s(std::string_view key);

  /// A table below; absent and not required: an empty table.
  TomlReader table(std::string_view key, bool required = true);
  /// An array of tables; absent: empty.
  std::vector<TomlReader> tables(std::string_view key);

  /// Reports a problem of the value at `key` (or of this table if there is no such key).
  void fail(std::string_view key, Text what, Text remedy);

  /// The first problem found in the whole document, or the first key that nobody asked for.
  [[nodiscard]] Result<void> finish() const;

 private:
  struct Document;  // the parsed tree, the first error and the keys asked for
  struct Node;
  TomlReader(std::shared_ptr<Document> document, std::shared_ptr<Node> node);
  std::shared_ptr<Document> document_;
  std::shared_ptr<Node> node_;
};

}  // namespace isograsp
