// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/patient_file.hpp"

#include <map>

#include "core/csv.hpp"
#include "core/toml_reader.hpp"

namespace isograsp::virtual_patient {

namespace {

void check_range(TomlReader& table, std::string_view key, double value, double least, double most) {
  if (value >= least && value <= most) return;
  table.fail(key, "is out of range"_text,
             "write a value from %1 to %2"_text(shortest(least), shortest(most)));
}

std::array<double, 3> three(TomlReader& table, std::string_view key, double least, double most) {
  const std::vector<double> values = table.numbers(key, 3, 3);
  for (const double value : values) check_range(table, key, value, least, most);
  return {values[0], values[1], values[2]};
}

}  // namespace

Result<VirtualPatientFile> parse_patient(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-patient-1");
  if (!root) return root.error();
  VirtualPatientFile patient;
  patient.name = root->text("name");
  patient.description = root->text("description");
  std::map<std::string_view, TomlReader> tables;
  for (const TraitField& field : trait_fields()) {
    auto found = tables.find(field.table);
    if (found == tables.end()) found = tables.emplace(field.table, root->table(field.table)).first;
    TomlReader& table = found->second;
    const double value = table.number(field.key);
    check_range(table, field.key, value, field.least, field.most);
    patient.traits.*field.value = value;
  }
  TomlReader& direction = tables.at("direction");
  patient.traits.direction_error_rad =
      three(direction, "direction_error_deg", 0.0, kLargestDirectionError_deg);
  for (double& error : patient.traits.direction_error_rad) error *= kDegree_rad;
  patient.traits.arm_push = three(direction, "arm_push", -kLargestArmPush, kLargestArmPush);
  if (auto done = root->finish(); !done) return done.error();
  return patient;
}

}  // namespace isograsp::virtual_patient
