// SPDX-License-Identifier: GPL-3.0-or-later
// On which lawful basis a person's data are used, and what they agreed to. Rows are only added:
// what counts is the last one of a purpose. In every database.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "storage/access/access.hpp"

namespace isograsp::storage {

/// Lawful bases of the GDPR: Art. 6(1) a to f, Art. 9(2) h (care) and j (research).
inline constexpr std::array<std::string_view, 8> kLawfulBases{"consent",
                                                              "contract",
                                                              "legal_obligation",
                                                              "vital_interests",
                                                              "public_interest",
                                                              "legitimate_interest",
                                                              "care",
                                                              "research"};
inline constexpr std::array<std::string_view, 3> kPurposes{"treatment", "research", "teaching"};
inline constexpr std::array<std::string_view, 3> kConsentStates{"given", "refused", "withdrawn"};
/// A camera may look at a person as long as one of these stands as given.
inline constexpr std::array<std::string_view, 2> kPurposesOfCameras{"treatment", "research"};

struct Consent {
  RowId id = 0;
  std::string on_date;  ///< ISO 8601: when it was said or signed
  std::string purpose;  ///< one of kPurposes
  std::string basis;    ///< one of kLawfulBases
  std::string state;    ///< one of kConsentStates
  std::string text;     ///< such as the version of the form; encrypted where protected
  std::string recorded_utc;
  std::string recorded_by;  ///< the account; empty: not protected
};

[[nodiscard]] Result<void> check_consent(const Consent& consent);
/// Uses on_date, purpose, basis, state, text.
[[nodiscard]] Result<RowId> add_consent(Access& access, const std::string& code,
                                        const Consent& consent);
/// As they were recorded.
[[nodiscard]] Result<std::vector<Consent>> consents(Access& access, const std::string& code);
/// What counts of those, as they were recorded: the last one of each purpose, in the order of
/// kPurposes.
[[nodiscard]] std::vector<Consent> standing(std::span<const Consent> recorded);
/// One of kPurposesOfCameras stands as given.
[[nodiscard]] bool allow_cameras(std::span<const Consent> recorded);

}  // namespace isograsp::storage
