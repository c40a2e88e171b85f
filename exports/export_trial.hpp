// SPDX-License-Identifier: GPL-3.0-or-later
// A trial as it may leave the clinic: nothing in it tells who the person is, on which day it was or
// who was there. All formats of the research export write from this and from nothing else
// (docs/file_formats.md, "Research export").
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/english.hpp"
#include "core/measure.hpp"
#include "core/signals.hpp"
#include "hand/platform_records.hpp"
#include "storage/records/profile.hpp"
#include "storage/records/records.hpp"

namespace isograsp::exports {

/// Where a trial stands in an export: numbers, so that no name from the database gets into a path.
struct ExportPlace {
  int patient = 0;        ///< place in the database: the same in every export from it
  int session = 0;        ///< 1, 2, … of the patient
  int trial = 0;          ///< 1, 2, … of the session
  std::string task_kind;  ///< KindFacts::name; "unknown": its task file cannot be read
  bool has_scene = false;
  bool tracked = false;  ///< its signals have segments or markers that cameras saw
};

struct ExportTrial {
  ExportPlace place;
  std::string patient_code;
  std::optional<storage::Side> affected;  ///< nothing: not told
  std::optional<Hand> dominant;           ///< nothing: not told
  std::optional<int> onset_day;    ///< days from the person's first session, as a rule negative
  std::optional<int> session_day;  ///< days from the person's first session
  /// Without times of day, operator, serial numbers, provenance and protocol text; device_uri is
  /// the scheme alone.
  storage::SessionRecord session;
  std::string instruction;     ///< of the task; empty: its task file cannot be read
  storage::TrialRecord trial;  ///< its groups name all columns of `signals`
  /// Without time of day and operator; of both where two platforms measured.
  std::optional<storage::PreparationRecord> zero;
  std::optional<storage::PreparationRecord> rest;  ///< likewise; both have wrenches of the fingers
  std::vector<Measure> measures;
  std::vector<storage::EventRecord> events;  ///< without notes
  /// As stored, then the forces in the axes of the hand and how far the links of an arm turned.
  Signals signals;
};

/// Mean or SD (`row`) of such a preparation.
[[nodiscard]] inline SixAxes wrenches_of(const storage::PreparationRecord& of,
                                         const std::vector<double>& row) {
  return platform::six_axes_of(of.columns, row).value_or(SixAxes{});
}

/// One thing that is said about a session or a trial; monostate: not known.
using ExportValue =
    std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string>;
struct ExportFact {
  std::string name;  ///< with its unit
  ExportValue value;
};
[[nodiscard]] std::vector<ExportFact> patient_facts(const ExportTrial& trial);
[[nodiscard]] std::vector<ExportFact> session_facts(const ExportTrial& trial);
[[nodiscard]] std::vector<ExportFact> trial_facts(const ExportTrial& trial);

/// Which of kColumnAxes are explained only where something was seen by cameras.
[[nodiscard]] bool are_of_cameras(std::string_view axes) noexcept;

/// All of it but signals and texts as one JSON document (`isograsp-trial-2`).
/// Descriptions are in `language`. `infinite`: values that the format beside it had to leave empty.
[[nodiscard]] std::string trial_as_json(const ExportTrial& trial, std::int64_t infinite,
                                        const Language& language = kEnglish);

}  // namespace isograsp::exports
