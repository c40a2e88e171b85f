// SPDX-License-Identifier: GPL-3.0-or-later
// Lawful bases and consents as they stand on the screen.
#pragma once

#include <QString>
#include <string_view>

#include "storage/person/consent.hpp"

namespace isograsp::gui {

// Of the words of storage/person/consent.hpp; an unknown one as it is.
/// "Treatment"
[[nodiscard]] QString purpose_words(std::string_view purpose);
/// "Care"
[[nodiscard]] QString basis_words(std::string_view basis);
/// "Art. 9 (2) h GDPR"; empty: of no known one.
[[nodiscard]] QString article_of(std::string_view basis);
/// "given"
[[nodiscard]] QString answer_words(std::string_view state);

/// "✓ Treatment: given on 2026-03-05 (Care), recorded by Ada"; ✗ where it is not given.
[[nodiscard]] QString consent_words(const storage::Consent& consent);

}  // namespace isograsp::gui
