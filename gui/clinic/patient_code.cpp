// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/patient_code.hpp"

#include <algorithm>
#include <string_view>

namespace isograsp::gui {

std::string generate_patient_code(const std::vector<storage::PatientRecord>& taken,
                                  std::mt19937_64& entropy) {
  constexpr std::string_view kDigits = "23456789";
  constexpr std::string_view kLetters = "ABCDEFGHJKLMNPQRSTUVWXYZ";
  constexpr int kLength = 5;  // 8^3 * 24^2: 295,000 codes
  std::string code;
  do {
    code = "P-";
    for (int i = 0; i < kLength; ++i) {
      const auto from = i % 2 == 0 ? kDigits : kLetters;
      code += from[static_cast<std::size_t>(entropy() % from.size())];
    }
  } while (std::any_of(taken.begin(), taken.end(), [&](const storage::PatientRecord& patient) {
    return patient.code == code;
  }));
  return code;
}

}  // namespace isograsp::gui
