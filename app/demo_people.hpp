// SPDX-License-Identifier: GPL-3.0-or-later
// Who comes to the demonstration clinic, when, and what the clinic knows of them. Simulated people:
// their courses are assumptions (docs/virtual_patient.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::app {

/// A session that was, or is to be, made.
struct DemoVisit {
  std::string started_utc;    ///< ISO 8601
  std::string protocol;       ///< NAME of library/protocols/NAME.toml
  std::string protocol_text;  ///< of a protocol that is no file; empty: as in the library
  Hand hand = Hand::right;
  std::string device;
  int broken_off_in = -1;  ///< step of the protocol in which it ends; negative: it is complete
  std::optional<Rating> rating = std::nullopt;
};

struct DemoPerson {
  std::string code;
  storage::PatientProfile profile;
  std::vector<DemoVisit> visits;  ///< oldest first
  std::vector<storage::TreatmentMark> treatments;
  std::vector<storage::ClinicalScore> scores;
  std::vector<storage::PrimaryMeasure> primaries;
  std::optional<storage::StablePeriod> stable;
};

/// People whose sessions are made in one go and in order.
using DemoGroup = std::vector<DemoPerson>;

/// Four patients (one better, one worse, one treated a week ago, one whose session of today was
/// broken off), enough stable people for verdicts and enough healthy ones for a band. `now_utc`:
/// ISO 8601; the newest session lies less than an hour before it.
[[nodiscard]] std::vector<DemoGroup> small_clinic(const std::string& now_utc);
/// The same people and twelve patients of the library who train over two months.
[[nodiscard]] std::vector<DemoGroup> large_clinic(const std::string& now_utc);

/// The session of now of the first patient, who has become better.
[[nodiscard]] DemoVisit demo_visit_of_today(const std::string& now_utc);

}  // namespace isograsp::app
