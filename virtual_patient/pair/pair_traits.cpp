// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/pair/pair_traits.hpp"

#include <array>

#include "core/toml_reader.hpp"

namespace isograsp::virtual_patient {

namespace {

struct PairField {
  std::string_view key;
  double PairTraits::*value;
  double most;  ///< from 0 on
};
constexpr std::array<PairField, 5> kPairFields{
    {{"crosstalk", &PairTraits::crosstalk, 0.9},
     {"crosstalk_delay_s", &PairTraits::crosstalk_delay_s, 1.0},
     {"share_exponent", &PairTraits::share_exponent, 3.0},
     {"common_noise", &PairTraits::common_noise, 1.0},
     {"lag_s", &PairTraits::lag_s, 1.0}}};

}  // namespace

Result<PairFile> parse_pair(std::string_view text, const std::string& file) {
  auto root = TomlReader::parse(text, file, "isograsp-pair-1");
  if (!root) return root.error();
  PairFile pair;
  pair.name = root->text("name");
  pair.description = root->text("description");
  for (const Hand hand : kBothHands) pair.people[hand] = root->text(name_of(hand));
  TomlReader together = root->table("together");
  for (const PairField& field : kPairFields) {
    const double value = together.number(field.key);
    if (!(value >= 0.0 && value <= field.most))
      together.fail(field.key, "is out of range"_text,
                    "write a value from 0 to %1"_text(shortest(field.most)));
    pair.traits.*field.value = value;
  }
  if (auto done = root->finish(); !done) return done.error();
  return pair;
}

}  // namespace isograsp::virtual_patient
