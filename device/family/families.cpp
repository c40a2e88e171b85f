// SPDX-License-Identifier: GPL-3.0-or-later
// The table of sensor families: one row each. Device files, addresses, the command line, the
// emulator and the decoder know a family by its row and by nothing else.
#include <array>

#include "device/config/ati_sensor.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/jr3_comedi_sensor.hpp"
#include "device/config/jr3_sensor.hpp"
#include "device/config/net_ft_sensor.hpp"
#include "device/config/rft_sensor.hpp"

namespace isograsp {

namespace {

// One row each, in the order in which they are listed for people.
// clang-format off
constexpr std::array kFamilies{
    &kRftFamily,
    &kAtiFamily,
    &kJr3Family,
    &kNetFtFamily,
    &kJr3ComediFamily,
};
// clang-format on

}  // namespace

std::span<const FamilyFacts* const> all_families() noexcept {
  return kFamilies;
}

}  // namespace isograsp
