// SPDX-License-Identifier: GPL-3.0-or-later
// Reader of stored sentences: what a database holds as an English sentence is a text again. Only
// the words that wrote it can read it, so that no pattern stands beside them.
#pragma once

#include <optional>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::tasks {

namespace stored_text_detail {

/// What stands at each place of `english` in `sentence`, at the first way to divide it; nothing:
/// these words did not write it. A digit string is a number, all else words that may be known.
[[nodiscard]] std::optional<std::vector<Argument>> values_in(std::string_view english,
                                                             std::string_view sentence);

template <std::size_t Places, std::size_t... Place>
Text filled(const Phrase<Places>& phrase, const std::vector<Argument>& values,
            std::index_sequence<Place...> /*all*/) {
  return phrase(values[Place]...);
}

}  // namespace stored_text_detail

/// The text that wrote `sentence` with one of these phrases (all with places, each place once and
/// in order); a sentence that none of them wrote is looked up as a whole (Known).
template <std::size_t... Places>
[[nodiscard]] Text stored_text(std::string_view sentence, const Phrase<Places>&... phrases) {
  Text text;
  const auto is_of = [&]<std::size_t P>(const Phrase<P>& phrase) {
    const auto values = stored_text_detail::values_in(phrase.english(), sentence);
    if (values) text = stored_text_detail::filled(phrase, *values, std::make_index_sequence<P>());
    return values.has_value();
  };
  if (!(is_of(phrases) || ...)) text = Known{std::string(sentence)};
  return text;
}

}  // namespace isograsp::tasks
