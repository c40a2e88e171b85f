// SPDX-License-Identifier: GPL-3.0-or-later
// A language from a file of translations in the format of gettext (.po), as translators' programs
// write it: msgid is the English text with its places, msgstr the words in the language.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/result.hpp"
#include "core/text.hpp"

namespace isograsp::languages {

struct Translation {
  std::string english;
  std::string words;  ///< empty: not translated yet
};

/// In the order of the file, without its head (the entry of an empty msgid). Comments are passed
/// over, "…" lines behind msgid and msgstr are one text. Errors name the line.
[[nodiscard]] Result<std::vector<Translation>> read_translations(std::string_view po);

/// How numbers and days are written.
struct Forms {
  char decimal_sign = '.';
  std::string day = "yyyy-MM-dd";  ///< made of yyyy, MM and dd
};

class Catalogue : public Language {
 public:
  /// @pre `po` can be read; English texts that it repeats or does not translate stay English
  Catalogue(std::string_view po, Forms forms);

  [[nodiscard]] std::string_view words(std::string_view english) const override;
  [[nodiscard]] std::string number(std::string_view digits) const override;
  [[nodiscard]] std::string day(Date date) const override;

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const noexcept {
      return std::hash<std::string_view>()(text);
    }
  };
  std::unordered_map<std::string, std::string, Hash, std::equal_to<>> words_;
  Forms forms_;
};

}  // namespace isograsp::languages
