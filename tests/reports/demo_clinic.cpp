// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reports/demo_clinic.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include <gtest/gtest.h>

#include "hand/platform_records.hpp"
#include "tasks/kinds/object/pose_targets.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tasks/task_spec.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::test {

namespace {

constexpr double kRate_Hz = 100.0;
constexpr double kPi = std::numbers::pi;
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct Row {
  tasks::Phase phase = tasks::Phase::active;
  double target_N = kMissing;
  double actual_N = 0.0;
  Vec3 target = Vec3::Constant(kMissing);  // x, y, angle
  Vec3 actual = Vec3::Constant(kMissing);
  int index = -1;
  int reached = 0;
};

/// A slow, repeatable unsteadiness.
double wobble(double t, double seed) {
  return std::sin(2.1 * t + seed) + 0.6 * std::sin(5.3 * t + 2.0 * seed) +
         0.3 * std::sin(11.7 * t + 3.0 * seed);
}

std::vector<Row> rest_rows(double seed) {
  std::vector<Row> rows(1000);
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i].actual_N = 0.4 + 0.05 * wobble(static_cast<double>(i) / kRate_Hz, seed);
  return rows;
}

std::vector<Row> maximum_rows(double maximum_N, double seed) {
  std::vector<Row> rows(400);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = static_cast<double>(i) / kRate_Hz;
    rows[i].phase = t < 1.0 ? tasks::Phase::lead_in : tasks::Phase::active;
    const double rise = t < 1.3 ? 0.0 : 1.0 - std::exp(-(t - 1.3) / 0.3);
    rows[i].actual_N =
        0.4 + maximum_N * rise * (1.0 - 0.05 * std::max(0.0, t - 2.0)) + 0.2 * wobble(t, seed);
  }
  return rows;
}

std::vector<Row> sine_rows(double maximum_N, double skill, double seed) {
  std::vector<Row> rows(3200);
  const auto target = [&](double t) {
    const double phase = 2.0 * kPi * 0.2 * std::max(0.0, t - 2.0);
    return maximum_N * (0.2 - 0.1 * std::cos(phase));
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double t = static_cast<double>(i) / kRate_Hz;
    rows[i].phase = t < 2.0 ? tasks::Phase::lead_in : tasks::Phase::active;
    rows[i].target_N = target(t);
    rows[i].actual_N =
        target(t - 0.3 + 0.15 * skill) + 0.03 * maximum_N * (1.2 - skill) * wobble(t, seed);
  }
  return rows;
}

std::vector<Row> pose_rows(const tasks::PoseTargetsSpec& spec, double skill, double seed) {
  std::vector<Row> rows;
  Vec3 from = Vec3::Zero();
  int reached = 0;
  for (std::size_t k = 0; k < spec.targets.size(); ++k) {
    const auto& target = spec.targets[k];
    const Vec3 to(target.p_WT.x(), target.p_WT.y(), target.angle_rad);
    const bool fails = k == 4 && skill < 0.3;
    const double way_s = fails ? spec.time_limit_s - 0.5 : 4.0 + 6.0 * (1.0 - skill);
    const int frames = static_cast<int>((way_s + 0.5 + target.hold_s) * kRate_Hz);
    for (int i = 0; i < frames; ++i) {
      const double t = i / kRate_Hz;
      const double s = std::min(1.0, t / way_s);
      const double progress = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * (fails ? 0.7 : 1.0);
      Row row;
      row.target = to;
      row.index = static_cast<int>(k);
      const double shake = (1.2 - skill) * wobble(t, seed + static_cast<double>(k));
      const double swing = std::sin(kPi * progress);
      row.actual =
          from + progress * (to - from) + swing * Vec3(0.006 * shake, 0.008 * shake, 0.08 * shake);
      row.phase = progress > 0.97 ? tasks::Phase::hold : tasks::Phase::transport;
      row.actual_N = 4.0 + 0.4 * wobble(t, seed);
      if (i == frames - 1 && !fails) ++reached;
      row.reached = reached;
      rows.push_back(row);
    }
    from = rows.back().actual;
  }
  return rows;
}

struct Recorded {
  storage::SignalGroup group;
  std::vector<double> values;  // row-major
};

Recorded as_group(const std::vector<Row>& rows, bool object, bool faults) {
  Recorded r{
      {"task",
       {"t_s", "phase", "sample_flags", "target_force_N", "actual_force_N", "resting_force_N"}},
      {}};
  if (object)
    for (const char* name :
         {"target_x_m", "actual_x_m", "target_y_m", "actual_y_m", "target_angle_rad",
          "actual_angle_rad", "target_index", "targets_reached", "contact_thumb"})
      r.group.columns.emplace_back(name);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const bool held = faults && i % 500 >= 490;
    for (const double value : {static_cast<double>(i) / kRate_Hz, static_cast<double>(row.phase),
                               held ? 1.0 : 0.0, row.target_N, row.actual_N, 0.4})
      r.values.push_back(value);
    if (!object) continue;
    for (int c = 0; c < 3; ++c) {
      r.values.push_back(row.target[c]);
      r.values.push_back(row.actual[c]);
    }
    r.values.push_back(row.index);
    r.values.push_back(row.reached);
    r.values.push_back(1.0);
  }
  return r;
}

class Writer {
 public:
  Writer(storage::SessionStore& store, storage::RowId session, const DemoSession& demo)
      : store_(store), session_(session), demo_(demo) {}

  void add(const std::string& text, const std::vector<Row>& rows, bool practice,
           storage::TrialStatus status = storage::TrialStatus::completed) {
    auto versioned = text;
    if (const auto at = versioned.find("version = 1"); at != std::string::npos)
      versioned[at + 10] = static_cast<char>('0' + demo_.task_version);
    const auto spec = tasks::parse_task(versioned, "task.toml");
    ASSERT_TRUE(spec.ok()) << spec.error().message();
    const bool object = !spec->scene().empty();
    const auto recorded = as_group(rows, object, demo_.with_faults);
    storage::TrialRecord trial;
    trial.session_id = session_;
    trial.number = ++number_;
    trial.task_name = spec->name;
    trial.task_version = spec->version;
    trial.task_text = versioned;
    trial.practice = practice;
    trial.groups = {recorded.group};
    const auto id = store_.begin_trial(trial);
    ASSERT_TRUE(id.ok()) << id.error().message();
    const std::size_t width = recorded.group.columns.size();
    const std::size_t block = static_cast<std::size_t>(kRate_Hz) * width;
    int second = 0;
    for (std::size_t at = 0; at < recorded.values.size(); at += block) {
      const auto begin = recorded.values.begin() + static_cast<long>(at);
      const auto end =
          recorded.values.begin() + static_cast<long>(std::min(at + block, recorded.values.size()));
      const std::vector<std::vector<double>> one{{begin, end}};
      const auto done = store_.append_blocks(*id, second++, one);
      ASSERT_TRUE(done.ok()) << done.error().message();
    }
    Signals signals(recorded.group.columns);
    for (std::size_t at = 0; at < recorded.values.size(); at += width)
      signals.append_row(std::span(recorded.values).subspan(at, width));
    trial.id = *id;
    trial.status = status;
    trial.samples = static_cast<std::int64_t>(rows.size());
    trial.worst_lateness_s = 0.0012;
    trial.health_json = R"({"thumb": {"lost": 0}, "index": {"lost": 2}, "kernel_drops": 0})";
    const auto measures = status == storage::TrialStatus::completed ? tasks::score(*spec, signals)
                                                                    : std::vector<Measure>{};
    const auto done = store_.end_trial(trial, measures);
    ASSERT_TRUE(done.ok()) << done.error().message();
    if (demo_.with_faults && number_ == 2) {
      const auto event =
          store_.add_event(session_, {*id, 12.0, "fault", "index finger: no samples for 50 ms"});
      ASSERT_TRUE(event.ok()) << event.error().message();
    }
  }

 private:
  storage::SessionStore& store_;
  storage::RowId session_;
  DemoSession demo_;
  int number_ = 0;
};

}  // namespace

storage::RowId add_session(storage::SessionStore& store, const std::string& code,
                           const DemoSession& demo) {
  auto patient = store.find_patient(code);
  EXPECT_TRUE(patient.ok());
  storage::RowId patient_id = 0;
  if (patient->has_value()) {
    patient_id = (*patient)->id;
  } else {
    const auto added = store.add_patient(code);
    EXPECT_TRUE(added.ok()) << added.error().message();
    patient_id = added->id;
  }
  storage::SessionRecord session;
  session.patient_id = patient_id;
  session.started_utc = demo.date + "T09:30:00Z";
  session.hand = demo.hand;
  session.device_uri = demo.simulated ? "sim://paretic?seed=1" : "can://can0?protocol=rft";
  session.device_description =
      demo.simulated ? "simulated paretic hand" : "three Robotous sensors on one CAN bus";
  session.simulated = demo.simulated;
  session.recorded = demo.recorded;
  if (demo.recorded) {
    session.device_description = "recording handover_07.csv";
    session.provenance = "index sensor stands in for the thumb\ngrip is -Fz";
  }
  session.protocol_name = "Demonstration";
  session.rate_Hz = kRate_Hz;
  session.device_delay_s = 0.0248;
  session.software_version = "0.1.0";
  const auto id = store.begin_session(session);
  EXPECT_TRUE(id.ok()) << id.error().message();
  storage::PreparationRecord zero;
  zero.session_id = *id;
  zero.kind = platform::kInstrumentZero;
  zero.columns = platform::six_axes_columns();
  zero.mean.assign(zero.columns.size(), 0.1);
  zero.sd.assign(zero.columns.size(), 0.023);
  EXPECT_TRUE(store.add_preparation(zero).ok());

  Writer writer(store, *id, demo);
  const double seed = 7.0 * demo.skill + 3.0;
  const double maximum_N = 9.0 + 11.0 * demo.skill;
  writer.add(library_task_text("resting_force.toml"), rest_rows(seed), false);
  writer.add(library_task_text("maximum_grip.toml"), maximum_rows(maximum_N * 0.94, seed), false);
  writer.add(library_task_text("maximum_grip.toml"), maximum_rows(maximum_N, seed + 1.0), false);
  writer.add(library_task_text("grip_sine.toml"), sine_rows(maximum_N, 0.0, seed), true);
  writer.add(library_task_text("grip_sine.toml"), sine_rows(maximum_N, demo.skill, seed), false);
  writer.add(library_task_text("grip_sine.toml"),
             sine_rows(maximum_N, demo.skill + 0.15, seed + 1.0), false);
  const auto spec = library_task("two_target.toml");
  writer.add(spec.text, pose_rows(spec.kind.as<tasks::PoseTargetsSpec>(), demo.skill, seed), false);
  if (demo.with_faults)
    writer.add(library_task_text("grip_sine.toml"), sine_rows(maximum_N, demo.skill, seed), false,
               storage::TrialStatus::aborted);
  EXPECT_TRUE(store.end_session(*id).ok());
  return *id;
}

void add_course(storage::SessionStore& store, const std::string& code, bool simulated) {
  const char* const dates[] = {"2026-03-02", "2026-03-04", "2026-03-11",
                               "2026-03-18", "2026-03-25", "2026-04-08"};
  const double skills[] = {0.05, 0.2, 0.45, 0.4, 0.62, 0.75};
  for (std::size_t i = 0; i < std::size(dates); ++i) {
    DemoSession demo;
    demo.date = dates[i];
    demo.simulated = simulated;
    demo.skill = skills[i];
    demo.with_faults = i + 1 == std::size(dates);
    add_session(store, code, demo);
  }
}

}  // namespace isograsp::test
