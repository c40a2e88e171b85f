// SPDX-License-Identifier: GPL-3.0-or-later
// What the clinic knows of a person beside the code: side, onset, treatment, scores of the usual
// clinical scales, answers of a session; and what of it makes sense.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "hand/finger.hpp"
#include "storage/records/records.hpp"

namespace isograsp::storage {

/// Affected side; none: a healthy person.
enum class Side : std::uint8_t { right, left, both, none };
[[nodiscard]] std::string_view name_of(Side side) noexcept;
[[nodiscard]] std::optional<Side> side_from_name(std::string_view name) noexcept;

enum class Sex : std::uint8_t { female, male, other };
[[nodiscard]] std::string_view name_of(Sex sex) noexcept;
[[nodiscard]] std::optional<Sex> sex_from_name(std::string_view name) noexcept;

/// Absent: not told.
struct PatientProfile {
  std::optional<Side> affected = std::nullopt;
  std::optional<Hand> dominant = std::nullopt;
  std::string onset_date;  ///< ISO 8601 (2026-03-05); empty: not known
  std::string notes;       ///< identifying: never in a research export
  std::string goals;       ///< identifying: never in a research export
  std::optional<Sex> sex = std::nullopt;
  std::optional<int> birth_year = std::nullopt;  ///< the day is part of the identity
  bool operator==(const PatientProfile&) const = default;
};

/// A change of treatment: a mark on every trend.
struct TreatmentMark {
  RowId id = 0;
  std::string on_date;  ///< ISO 8601
  std::string kind;     ///< one of kTreatmentKinds
  std::string text;     ///< in the therapist's words; may be empty; never in a research export
  bool operator==(const TreatmentMark&) const = default;
};
inline constexpr std::array<std::string_view, 5> kTreatmentKinds{"botulinum_toxin", "drug",
                                                                 "orthosis", "therapy", "other"};

/// One score of a clinical scale.
struct ClinicalScore {
  RowId id = 0;
  std::string on_date;  ///< ISO 8601
  std::string scale;    ///< name of one of kClinicalScales
  double value = 0.0;
  std::string text;  ///< such as the muscle or the side; may be empty; never in a research export
  bool operator==(const ClinicalScore&) const = default;
};

struct ClinicalScale {
  std::string_view name;
  double least;
  double most;
  bool above_least = false;  ///< least itself is no score
  std::string_view unit;     ///< empty: points
};
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();
/// Ranges: Lyle 1981 (ARAT), Fugl-Meyer 1975 (upper extremity), Mathiowetz 1985 (box and block,
/// nine-hole peg), Taub 1993 (MAL), Bohannon and Smith 1987 (MAS; 1+ is 1.5). Sensation: as the
/// clinic counts it.
inline constexpr std::array<ClinicalScale, 7> kClinicalScales{{
    {"ARAT", 0.0, 57.0, false, ""},
    {"FMA-UE", 0.0, 66.0, false, ""},
    {"BBT", 0.0, kNoLimit, false, "blocks"},
    {"NHPT", 0.0, kNoLimit, true, "s"},
    {"MAL", 0.0, 5.0, false, ""},
    {"MAS", 0.0, 4.0, false, ""},
    {"sensation", -kNoLimit, kNoLimit, false, ""},
}};

/// Nothing: there is no such scale.
[[nodiscard]] const ClinicalScale* clinical_scale(std::string_view name) noexcept;

/// A measure of a person that gets verdicts of change (docs/change.md).
struct PrimaryMeasure {
  RowId id = 0;
  std::string task_name;
  std::optional<Hand> hand = Hand::right;  ///< nothing: both
  std::string measure;                     ///< name and channel as stored with a trial
  std::string channel;
  std::string chosen_utc;  ///< ISO 8601
  std::string chosen_by;   ///< as they wish to be called; never in a research export
  bool operator==(const PrimaryMeasure&) const = default;
};
inline constexpr int kMostPrimaryMeasures = 4;  ///< of a person

/// A clinician's judgement: in this time the person did not change.
struct StablePeriod {
  RowId id = 0;
  std::string from_date;   ///< ISO 8601; first day
  std::string until_date;  ///< last day
  std::string judged_utc;
  std::string judged_by;  ///< never in a research export
  std::string text;       ///< may be empty; never in a research export
  bool operator==(const StablePeriod&) const = default;
};

/// Which values may be pooled: all fields must be equal.
struct PoolQuery {
  std::string task_name;
  int task_version = 1;
  std::string task_text;
  /// Nothing: of any; the reader compares what PooledValue tells of them, as references of
  /// an arm differ from day to day.
  std::optional<std::string> scene_text;
  std::string measure;
  std::string channel;
  std::string unit;
  int measure_version = 1;
  bool simulated = false;
  bool recorded = false;
};
/// One trial of a person who is judged stable or is healthy, with what else decides what it is
/// compared with.
struct PooledValue {
  RowId patient_id = 0;
  RowId period_id = 0;  ///< judged stable; 0: a healthy person
  RowId session_id = 0;
  RowId trial_id = 0;
  std::string started_utc;                 ///< of the session
  std::optional<Hand> hand = Hand::right;  ///< nothing: both
  std::optional<Side> affected;            ///< of the person; nothing: not told
  std::optional<Hand> dominant;            ///< of the person, as are the next two
  std::optional<Sex> sex;
  std::optional<int> birth_year;
  double rate_Hz = 0.0;
  double device_delay_s = 0.0;
  std::optional<double> display_delay_s;
  References references;        ///< of the trial
  std::string scene_text;       ///< of the trial, where the query names none; else empty
  std::string calibration;      ///< of the session, likewise
  std::string device_uri;       ///< of the session, likewise
  std::optional<double> value;  ///< nothing: the trial has none
  int measure_version = 1;      ///< of the stored value: that of the query, or an older one
};

/// Posture and screening: one answer of a session.
struct SessionAnswer {
  std::string topic;  ///< "screening", "posture"
  std::string item;
  std::string value;
  bool operator==(const SessionAnswer&) const = default;
};

/// Other years are slips of the pen.
inline constexpr int kFirstYear = 1900;
inline constexpr int kLastYear = 2099;

// Errors name the field (`onset_date`, `birth_year`, `on_date`, `kind`, `scale`, `value`, `topic`,
// `item`, `task_name`, `measure`, `chosen_by`, `from_date`, `until_date`, `judged_by`).
/// A day of the calendar, ISO 8601, in these years.
[[nodiscard]] Result<void> check_date(const std::string& iso_date, std::string_view field);
[[nodiscard]] Result<void> check_profile(const PatientProfile& profile);
[[nodiscard]] Result<void> check_treatment_mark(const TreatmentMark& mark);
[[nodiscard]] Result<void> check_clinical_score(const ClinicalScore& score);
[[nodiscard]] Result<void> check_primary_measure(const PrimaryMeasure& primary);
[[nodiscard]] Result<void> check_stable_period(const StablePeriod& period);
[[nodiscard]] Result<void> check_answer(const SessionAnswer& answer);

}  // namespace isograsp::storage
