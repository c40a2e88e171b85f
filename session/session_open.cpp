// SPDX-License-Identifier: GPL-3.0-or-later
// How a session begins: device, clock, database, in an order in which a refusal leaves no trace.
#include <algorithm>
#include <ctime>

#include "core/csv.hpp"
#include "core/time.hpp"
#include "device/config/uri.hpp"
#include "session/session_parts.hpp"
#include "session/simulated_person.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/records/patient_code.hpp"

namespace isograsp::session {

std::string cpu_features() {
  std::string text = "x86-64";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx512f")) text += " avx512f";
  return text;
}

namespace {

/// Of the newest session, if that lies ahead of the clock of this computer.
std::optional<std::string> clock_behind(const std::vector<storage::SessionRecord>& newest) {
  if (newest.empty()) return std::nullopt;
  const storage::SessionRecord& last = newest.front();
  // Sessions in virtual time end ahead of every clock.
  const bool lived = !last.simulated && !last.recorded;
  const std::string latest = lived ? std::max(last.started_utc, last.ended_utc) : last.started_utc;
  if (latest <= utc_text(std::time(nullptr))) return std::nullopt;
  return latest;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

/// How counts became forces, a line a finger; empty if the device has no counts.
std::string calibration_text(const DeviceInfo& info) {
  std::string text;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (info.units_per_count[f].isZero(0.0)) continue;
    text += std::string(kFingerNames[f]) + ": N or N m per count";
    for (const double unit : info.units_per_count[f]) text += " " + format_number(unit);
    if (!info.calibration[f].empty()) text += "; matrix " + info.calibration[f];
    text += "\n";
  }
  return text;
}

/// Coarsest step of a force component; 0: the device has no counts.
double resolution_N(const DeviceInfo& info) {
  double coarsest_N = 0.0;
  for (const Vec6& unit : info.units_per_count)
    coarsest_N = std::max(coarsest_N, unit.head<3>().cwiseAbs().maxCoeff());
  return coarsest_N;
}

}  // namespace

Result<void> check_hand(const std::string& device_uri, std::string_view mounted_for, Hand hand) {
  if (mounted_for == name_of(hand)) return {};
  return refused("the device is set up for the " + std::string(mounted_for) +
                     " hand, the session for the " + std::string(name_of(hand)),
                 "turn the platform and choose the configuration for that hand, or choose the " +
                     std::string(mounted_for) + " hand")
      .at(device_uri)
      .about("hand");
}

Result<std::unique_ptr<Session>> Session::open(const SessionConfig& config) {
  auto parts = std::make_unique<Parts>();
  parts->config = config;
  const auto uri = Uri::parse(config.device_uri);
  if (!uri) return uri.error();
  const std::string said = uri->text_or("hand", std::string(name_of(config.hand)));
  if (auto same = check_hand(config.device_uri, said, config.hand); !same) return same.error();
  if (auto good = storage::check_patient_code(config.patient_code); !good) return good.error();
  for (const storage::SessionAnswer& answer : config.answers)
    if (auto good = storage::check_answer(answer); !good) return good.error();
  if (config.scratch_database && !config.virtual_time)
    return refused("a session in real time is not recorded into a scratch file",
                   "give a database that is kept")
        .at(uri->text);
  auto viewer = simulated_person(*uri, config.library);
  if (!viewer) return viewer.error();
  parts->viewer = std::move(*viewer);
  DeviceOptions device_options;
  device_options.source = parts->viewer.get();
  auto device = open_device(config.device_uri, device_options);
  if (!device) return device.error();
  parts->device = std::move(*device);
  const DeviceInfo& info = parts->device->info();
  if (info.hand)
    if (auto same = check_hand(config.device_uri, name_of(*info.hand), config.hand); !same)
      return same.error();
  if (config.virtual_time && !info.simulated && !info.recorded)
    return refused("a real device cannot run in virtual time", "leave out --fast").at(uri->text);
  if (!config.virtual_time)
    if (auto made = parts->make_acquisition_thread(); !made) return made.error();

  // Real sensors tell who they are only when they are started; if they do not answer, nothing is
  // written.
  if (config.virtual_time)
    parts->clock = std::make_unique<ManualClock>();
  else
    parts->clock = std::make_unique<SteadyClock>();
  if (auto started = parts->device->start(*parts->clock); !started) return started.error();
  parts->streaming = true;
  const Timestamp start = parts->device->now(*parts->clock);
  auto store =
      storage::open_store(config.database, config.scratch_database  ? storage::OpenMode::scratch
                                           : config.create_database ? storage::OpenMode::create
                                                                    : storage::OpenMode::existing);
  if (!store) return store.error();
  const auto newest = (*store)->recent_sessions(1);
  if (!newest) return newest.error();
  const auto behind = config.started_utc.empty() ? clock_behind(*newest) : std::nullopt;
  if (behind && !config.clock_is_right)
    return refused("the clock of this computer says " + utc_text(std::time(nullptr)) +
                       ", but the newest session of this file is of " + *behind,
                   "set the clock, or say that it is right")
        .at(config.database)
        .about("clock");
  auto patient = (*store)->find_patient(config.patient_code);
  if (!patient) return patient.error();
  if (!*patient) {
    const auto added = (*store)->add_patient(config.patient_code, config.started_utc);
    if (!added) return added.error();
    *patient = *added;
    parts->patient_is_new = true;
  }
  storage::SessionRecord& record = parts->record;
  record.patient_id = (*patient)->id;
  record.started_utc =
      config.started_utc.empty() ? utc_text(std::time(nullptr)) : config.started_utc;
  record.hand = config.hand;
  record.device_uri = config.device_uri;
  record.device_description = info.description;
  record.simulated = info.simulated;
  record.recorded = info.recorded;
  record.provenance = joined_lines(info.provenance);
  record.protocol_name = config.protocol_name;
  record.protocol_text = config.protocol_text;
  record.rate_Hz = 1.0 / info.frame_period_s;
  record.device_delay_s = info.delay_s;
  record.software_version = config.software_version;
  record.cpu_features = cpu_features();
  record.serial_numbers = info.serial_numbers;
  record.calibration = calibration_text(info);
  record.operator_name = config.operator_name;
  record.realtime = describe(parts->realtime);
  if (config.allowed) record.allowed = tasks::name_of(*config.allowed);
  record.ceiling_N = config.ceiling_N;
  if (uri->parameters.contains("seed"))
    record.seed = std::strtoull(uri->parameters.at("seed").c_str(), nullptr, 10);
  const auto last_zero = (*store)->last_zero(record);
  if (!last_zero) return last_zero.error();
  auto training = Training::read(**store, record);
  if (!training) return training.error();
  if (config.resume) {
    auto earlier = read_earlier_work(**store, record);
    if (!earlier) return earlier.error();
    parts->earlier = *std::move(earlier);
    record.resumes_id = parts->earlier.last_id;
    // What the screening forbade this hand today stays forbidden, unless it was asked again.
    if (record.allowed.empty()) record.allowed = parts->earlier.allowed;
    if (!record.ceiling_N) record.ceiling_N = parts->earlier.ceiling_N;
  }
  parts->lesson.training = *std::move(training);
  tasks::ForceReferences& references = parts->lesson.references;
  references.baseline_N = parts->lesson.training.baseline_N();
  references.allowed = tasks::effort_from_name(record.allowed).value_or(tasks::Effort::maximum);
  references.ceiling_N = record.ceiling_N;
  references.resolution_N = resolution_N(info);
  for (const EarlierTrial& trial : parts->earlier.trials)
    if (!trial.record.helped) learn_maxima(trial.measures, references);
  if (!config.scratch_database) record.uuid = storage::random_uuid();
  const auto session_id = (*store)->begin_session(record, config.answers);
  if (!session_id) return session_id.error();
  record.id = *session_id;
  // Progress is put in order by these times.
  std::optional<storage::EventRecord> clock_event;
  if (behind)
    clock_event = storage::EventRecord{
        0, 0.0, "clock",
        "The clock of this computer is behind the newest session of this file (" + *behind + ")."};

  Acquisition::Options options;
  options.resume_by_itself = info.recorded;
  options.viewer = parts->viewer.get();
  if (*last_zero) options.last_zero = (*last_zero)->mean;
  parts->acquisition = std::make_unique<Acquisition>(*parts->device, *parts->clock, start, options);
  auto writer = std::make_unique<SessionWriter>(std::move(*store), **patient, record,
                                                config.answers, !config.scratch_database);
  parts->recorder = std::make_unique<Recorder>(std::move(writer), record,
                                               parts->acquisition->records(), !config.virtual_time);
  if (clock_event) parts->recorder->add_event(*clock_event);
  if (!config.virtual_time) parts->start_threads();
  return std::unique_ptr<Session>(new Session(std::move(parts)));
}

}  // namespace isograsp::session
