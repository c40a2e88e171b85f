// SPDX-License-Identifier: GPL-3.0-or-later
// The codes of a FHIR export: no public code system has the measures of a three-digit grip, so they
// are those of a local one, which is written beside the data. Units are UCUM. Inside exports/ only.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/measure.hpp"
#include "core/text.hpp"

namespace isograsp::exports {

/// Canonical name of the code system: the same in every export of every clinic.
inline constexpr const char* kFhirCodes = "urn:uuid:6f9b0d52-3f0e-4e0b-9d3a-5f3c1f7c9a41";

/// The language of a resource, unless it is English.
void add_language(nlohmann::ordered_json& resource, const Language& language);

/// UCUM code of a unit of measures and columns; nothing: it has none.
[[nodiscard]] std::optional<std::string_view> ucum_code(std::string_view unit);

/// Code of a measure: "rmse" of "force" is "rmse:force".
[[nodiscard]] std::string fhir_code(const Measure& measure);

/// Concepts that an export uses, by code, in the order of the alphabet.
class FhirCodes {
 public:
  struct Concept {
    std::string kind;  ///< "task", "measure", "signal", "context"
    std::string display;
    std::string definition;
  };
  void add(const std::string& code, Concept meaning) {
    concepts_.try_emplace(code, std::move(meaning));
  }
  [[nodiscard]] const std::string& display(const std::string& code) const {
    return concepts_.at(code).display;
  }
  /// The CodeSystem resource as JSON; its displays are in that language.
  [[nodiscard]] std::string resource(const Language& language) const;

 private:
  std::map<std::string, Concept> concepts_;
};

}  // namespace isograsp::exports
