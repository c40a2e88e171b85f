// SPDX-License-Identifier: GPL-3.0-or-later
#include "exports/fhir_codes.hpp"

#include <nlohmann/json.hpp>

namespace isograsp::exports {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void add_language(nlohmann::ordered_json& resource, const Language& language) {
  const std::string code = translated("en"_text, language);  // each language has its own code here
  if (code != "en") resource["language"] = code;
}

std::optional<std::string_view> ucum_code(std::string_view unit) {
  constexpr std::pair<std::string_view, std::string_view> kCodes[] = {
      {"N", "N"},     {"N m", "N.m"},     {"Nm", "N.m"},          {"N^2", "N2"},
      {"N/s", "N/s"}, {"m", "m"},         {"m/s", "m/s"},         {"s", "s"},
      {"1/s", "/s"},  {"Hz", "Hz"},       {"rad", "rad"},         {"rad/s", "rad/s"},
      {"deg", "deg"}, {"%", "%"},         {"%/s", "%/s"},         {"", "1"},
      {"bit", "bit"}, {"bit/s", "bit/s"}, {"counts", "{counts}"}, {"N s", "N.s"},
      {"d", "d"}};
  for (const auto& [name, code] : kCodes)
    if (unit == name) return code;
  if (unit.starts_with("of ")) return "1";  // "of 4": a count out of so many
  return {};
}

std::string fhir_code(const Measure& measure) {
  std::string code = measure.name + (measure.channel.empty() ? "" : ":" + measure.channel);
  for (char& letter : code)  // a code holds no blank
    if (letter == ' ') letter = '_';
  return code;
}

std::string FhirCodes::resource(const Language& language) const {
  Json list = Json::array();
  for (const auto& [code, meaning] : concepts_)
    list.push_back({{"code", code},
                    {"display", meaning.display},
                    {"definition", meaning.definition},
                    {"property", {{{"code", "kind"}, {"valueCode", meaning.kind}}}}});
  Json json{
      {"resourceType", "CodeSystem"},
      {"url", kFhirCodes},
      {"version", ISOGRASP_VERSION},
      {"name", "IsoGraspCodes"},
      {"title", translated("Tasks, measures and signals of IsoGrasp"_text, language)},
      {"status", "active"},
      {"experimental", false},
      {"description",
       "Local codes: no public code system has them. Those that this export uses; formulas of the "
       "measures stand in the program's docs/measures.md."},
      {"caseSensitive", true},
      {"content", "fragment"},
      {"property",
       {{{"code", "kind"}, {"description", "task, measure, signal or context"}, {"type", "code"}}}},
      {"concept", std::move(list)}};
  add_language(json, language);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace isograsp::exports
