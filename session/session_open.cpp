// SPDX-License-Identifier: GPL-3.0-or-later
// How a session begins: device, clock, database, in an order in which a refusal leaves no trace.
#include <algorithm>
#include <ctime>
#include <filesystem>

#include "core/time.hpp"
#include "device/config/uri.hpp"
#include "hand/two_hands_columns.hpp"
#include "session/arm/marker_arm.hpp"
#include "session/arm/passive_range.hpp"
#include "session/open_two_platforms.hpp"
#include "session/session_parts.hpp"
#include "session/tracked_hand/hand_size.hpp"
#include "session/tracked_hand/tracked_hand.hpp"
#include "session/two_platforms/two_zeros.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/person/consent.hpp"
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

/// What a tracked hand must know of its person: the size of the other hand, and whether its joints
/// may be kept. Nobody's are those of a simulated hand.
Result<void> tell_of_person(TrackedHand& hand, storage::SessionStore& store,
                            storage::RowId patient) {
  const bool simulated = hand.info().simulated;
  const auto other = other_hand_measured(store, patient, hand.side(), simulated);
  if (!other) return other.error();
  const auto research = store.consent_state(patient, "research");
  if (!research) return research.error();
  std::optional<storage::PreparationRecord> entry;
  if (*other) entry = (*other)->entry;
  return hand.know_person(entry, simulated || *research == "given");
}

/// The one hand that is affected; nothing: not known, both or neither.
std::optional<Hand> affected_hand(const storage::PatientProfile& profile) {
  if (profile.affected == storage::Side::left) return Hand::left;
  if (profile.affected == storage::Side::right) return Hand::right;
  return std::nullopt;
}

/// Of an apparatus that is no platform: what it has of such a device.
DeviceInfo device_of(const ApparatusInfo& apparatus, const Uri& uri) {
  DeviceInfo device;
  device.uri = uri.text;
  device.description = apparatus.description;
  device.simulated = apparatus.simulated;
  device.recorded = apparatus.recorded;
  device.frame_period_s = apparatus.period_s;
  device.delay_s = apparatus.delay_s;
  device.provenance = apparatus.provenance;
  return device;
}

}  // namespace

/// The steps of opening, in the order in which they are taken.
struct Session::Opening {
  const SessionConfig& config;
  Parts& parts;
  Uri uri;
  std::unique_ptr<storage::SessionStore> store;
  /// Of the newest session of the file, if the clock of this computer is behind it.
  std::optional<std::string> latest;
  storage::PatientRecord patient;
  std::optional<storage::PreparationRecord> last_zero;
  std::vector<storage::SessionAnswer> answers;  ///< that are stored with its row

  [[nodiscard]] storage::SessionRecord& record() const { return parts.known.record; }

  // Nothing is written.
  Result<void> check_request();
  Result<void> check_hands() const;
  Result<void> open_device();
  Result<void> check_basis();
  Result<void> start_device();
  // The file is made if it is absent, and the patient if new.
  Result<void> open_file();
  Result<void> find_patient();
  Result<void> describe_session();
  Result<void> read_what_is_known();
  Result<void> take_up_earlier_work();
  Result<void> set_references();
  // The session has its row.
  Result<void> write_session();
  void start_recording();
};

Result<std::unique_ptr<Session>> Session::open(const SessionConfig& config) {
  auto parts = std::make_unique<Parts>();
  parts->config = config;
  Opening opening{config, *parts, {}, {}, {}, {}, {}, config.answers};
  for (const auto step :
       {&Opening::check_request, &Opening::open_device, &Opening::check_basis,
        &Opening::start_device, &Opening::open_file, &Opening::find_patient,
        &Opening::describe_session, &Opening::read_what_is_known, &Opening::take_up_earlier_work,
        &Opening::set_references, &Opening::write_session})
    if (auto done = (opening.*step)(); !done) return done.error();
  opening.start_recording();
  return std::unique_ptr<Session>(new Session(std::move(parts)));
}

Result<void> Session::Opening::check_request() {
  auto parsed = parse_address(config.device_uri);
  if (!parsed) return parsed.error();
  uri = *std::move(parsed);
  if (auto same = check_hands(); !same) return same;
  if (auto good = storage::check_patient_code(config.patient_code); !good) return good;
  for (const storage::SessionAnswer& answer : config.answers)
    if (auto good = storage::check_answer(answer); !good) return good;
  auto passive = passive_limits_in(config.answers);
  if (!passive) return passive.error();
  parts.known.arm_screening.passive = *std::move(passive);
  if (config.scratch_database && !config.virtual_time)
    return refused("a session in real time is not recorded into a scratch file"_text,
                   "give a database that is kept"_text)
        .at(uri.text);
  return {};
}

/// Both hands are on two platforms, one hand is on one device that is for it.
Result<void> Session::Opening::check_hands() const {
  const bool two = two_platforms_in(config.device_uri).has_value();
  if (!config.hand && two) return {};
  if (!config.hand || two)
    return refused(
               "a session of both hands has two platforms, one of one hand has one device"_text,
               "give the left and the right platform and no hand, or one device and its hand"_text)
        .at(config.device_uri)
        .about("hand");
  const std::string named = uri.text_or("hand", std::string(name_of(*config.hand)));
  return check_hand(config.device_uri, named, *config.hand);
}

Result<void> Session::Opening::open_device() {
  auto opened = open_apparatus(
      {uri, config.hand.value_or(Hand::right), config.library, config.display_delay_s},
      config.apparatuses);
  if (!opened) return opened.error();
  parts.apparatus = *std::move(opened);
  parts.platform = dynamic_cast<ForcePlatform*>(parts.apparatus.get());
  parts.two_platforms = dynamic_cast<TwoPlatforms*>(parts.apparatus.get());
  const ApparatusInfo& info = parts.apparatus->info();
  if (auto fits = check_apparatus(config.apparatus, info); !fits) return fits;
  if (config.virtual_time && !info.simulated && !info.recorded)
    return refused("a real device cannot run in virtual time"_text, "leave out --fast"_text)
        .at(uri.text);
  return {};
}

/// No camera is opened on a person of whom no lawful basis is on record.
Result<void> Session::Opening::check_basis() {
  if (!parts.apparatus->info().watches_person) return {};
  const auto none = [this] {
    return refused("no lawful basis is on record for a camera that sees this person"_text,
                   "record it first: isograsp db consent add … --purpose treatment"_text)
        .at(config.database)
        .about("consent");
  };
  if (config.create_database && !std::filesystem::exists(config.database)) return none();
  auto file = storage::open_store(config.database, storage::OpenMode::existing);
  if (!file) return file.error();
  const auto person = (*file)->find_patient(config.patient_code);
  if (!person) return person.error();
  if (!*person) return none();
  for (const std::string_view purpose : storage::kPurposesOfCameras) {
    const auto state = (*file)->consent_state((*person)->id, std::string(purpose));
    if (!state) return state.error();
    if (*state == "given") return {};
  }
  return none();
}

/// Real sensors tell who they are only when they are started; if they do not answer, or if real
/// time is refused, nothing is written.
Result<void> Session::Opening::start_device() {
  SessionKnowledge& known = parts.known;
  if (config.virtual_time) {
    parts.clock = std::make_unique<ManualClock>();
  } else {
    auto granted = parts.threads.make(config.realtime);
    if (!granted) return granted.error();
    known.realtime = *std::move(granted);
    parts.clock = std::make_unique<SteadyClock>();
  }
  if (auto started = parts.apparatus->start(*parts.clock); !started) return started;
  known.apparatus = parts.apparatus->info();
  const auto steps = parts.apparatus->steps();
  known.steps.assign(steps.begin(), steps.end());
  known.device =
      parts.platform != nullptr ? parts.platform->device() : device_of(known.apparatus, uri);
  if (const auto* arm = dynamic_cast<const MarkerArm*>(parts.apparatus.get()))
    known.arm = arm->setup();
  return {};
}

Result<void> Session::Opening::open_file() {
  auto opened =
      storage::open_store(config.database, config.scratch_database  ? storage::OpenMode::scratch
                                           : config.create_database ? storage::OpenMode::create
                                                                    : storage::OpenMode::existing);
  if (!opened) return opened.error();
  store = *std::move(opened);
  const auto newest = store->recent_sessions(1);
  if (!newest) return newest.error();
  if (config.started_utc.empty()) latest = clock_behind(*newest);
  if (latest && !config.clock_is_right)
    return refused(
               "the clock of this computer says %1, but the newest session of this file is of %2"_text(
                   utc_text(std::time(nullptr)), *latest),
               "set the clock, or say that it is right"_text)
        .at(config.database)
        .about("clock");
  return {};
}

Result<void> Session::Opening::find_patient() {
  auto found = store->find_patient(config.patient_code);
  if (!found) return found.error();
  if (*found) {
    patient = **std::move(found);
    return {};
  }
  auto added = store->add_patient(config.patient_code, config.started_utc);
  if (!added) return added.error();
  patient = *std::move(added);
  parts.known.patient_is_new = true;
  return {};
}

Result<void> Session::Opening::describe_session() {
  const ApparatusInfo& info = parts.known.apparatus;
  storage::SessionRecord& session = record();
  session.patient_id = patient.id;
  session.started_utc =
      config.started_utc.empty() ? utc_text(std::time(nullptr)) : config.started_utc;
  session.hand = config.hand;
  session.device_uri = config.device_uri;
  session.device_description = english(info.description);
  session.simulated = info.simulated;
  session.recorded = info.recorded;
  session.provenance = joined_lines(info.provenance);
  session.protocol_name = config.protocol_name;
  session.protocol_text = config.protocol_text;
  session.rate_Hz = 1.0 / info.period_s;
  session.device_delay_s = info.delay_s;
  session.software_version = config.software_version;
  session.cpu_features = cpu_features();
  session.operator_name = config.operator_name;
  session.realtime = english(words_of(parts.known.realtime));
  parts.apparatus->describe(session);
  if (config.allowed) session.allowed = tasks::name_of(*config.allowed);
  storage::set_value(session.references, platform::kCeiling_N, config.ceiling_N);
  for (const Hand hand : kBothHands)
    storage::set_value(session.references, platform::kCeilings_N[hand], config.ceilings_N[hand]);
  if (uri.parameters.contains("seed"))
    session.seed = std::strtoull(uri.parameters.at("seed").c_str(), nullptr, 10);
  return {};
}

Result<void> Session::Opening::read_what_is_known() {
  auto zero = store->last_preparation(record(), parts.two_platforms != nullptr
                                                    ? platform::kTwoInstrumentZeros
                                                    : platform::kInstrumentZero);
  if (!zero) return zero.error();
  last_zero = *std::move(zero);
  auto training = Training::read(*store, record());
  if (!training) return training.error();
  parts.known.training = *std::move(training);
  if (parts.two_platforms != nullptr) {
    const auto profile = store->profile(patient.id);
    if (!profile) return profile.error();
    if (config.affected && profile->affected && affected_hand(*profile) != config.affected)
      return refused("the affected side of this person is on record as '%1'"_text(
                         Known{std::string(storage::name_of(*profile->affected))}),
                     "leave it out, or correct the record first"_text)
          .at(config.database)
          .about("affected");
    parts.known.two_hands.affected = profile->affected ? affected_hand(*profile) : config.affected;
  }
  if (auto* hand = dynamic_cast<TrackedHand*>(parts.apparatus.get()))
    return tell_of_person(*hand, *store, patient.id);
  return {};
}

Result<void> Session::Opening::take_up_earlier_work() {
  if (!config.resume) return {};
  auto earlier = read_earlier_work(*store, record());
  if (!earlier) return earlier.error();
  SessionKnowledge& known = parts.known;
  known.earlier = *std::move(earlier);
  known.record.resumes_id = known.earlier.last_id;
  // What the screening forbade this hand today stays forbidden, unless it was asked again.
  if (known.record.allowed.empty()) known.record.allowed = known.earlier.allowed;
  if (!known.record.references.contains(platform::kCeiling_N))
    storage::set_value(known.record.references, platform::kCeiling_N, known.earlier.ceiling_N);
  for (const Hand hand : kBothHands)  // what is said of both today is said of each
    if (!config.ceiling_N && !config.ceilings_N[hand])
      storage::set_value(known.record.references, platform::kCeilings_N[hand],
                         known.earlier.ceilings_N[hand]);
  if (!known.two_hands.affected) known.two_hands.affected = known.earlier.affected;
  if (parts.two_platforms != nullptr) parts.two_platforms->set_carries(known.earlier.carries);
  if (auto* hand = dynamic_cast<TrackedHand*>(parts.apparatus.get()))
    hand->set_placements(known.earlier.placements);
  if (known.arm_screening.passive.empty() && !known.earlier.passive.empty()) {
    known.arm_screening.passive = known.earlier.passive;
    const auto again = stored(known.earlier.passive);
    answers.insert(answers.end(), again.begin(), again.end());
  }
  return {};
}

Result<void> Session::Opening::set_references() {
  SessionKnowledge& known = parts.known;
  tasks::ForceReferences& references = known.references;
  references.baseline_N = known.training.baseline_N();
  references.allowed =
      tasks::effort_from_name(known.record.allowed).value_or(tasks::Effort::maximum);
  references.ceiling_N = storage::value_of(known.record.references, platform::kCeiling_N);
  if (parts.platform != nullptr) references.resolution_N = parts.platform->resolution_N();
  for (const Hand hand : kBothHands) {
    tasks::HandReferences& of = known.two_hands.of[hand];
    const auto own_N = storage::value_of(known.record.references, platform::kCeilings_N[hand]);
    of.ceiling_N = own_N ? own_N : references.ceiling_N;
    if (parts.two_platforms != nullptr) of.resolution_N = parts.two_platforms->resolution_N(hand);
  }
  if (const auto& affected = known.two_hands.affected)
    storage::set_value(known.record.references, columns::affected_hand,
                       *affected == Hand::left ? 0.0 : 1.0);
  if (!known.record.allowed.empty()) known.arm_screening.way_done = known.training.way_done();
  for (const EarlierTrial& trial : known.earlier.trials)
    if (!trial.record.helped) {
      known.learn_maxima(trial.measures);
      known.learn_hands(trial.measures);
      if (const auto spec = tasks::parse_task(trial.record.task_text, trial.record.task_name))
        known.learn_range(*spec, trial.measures);
    }
  return {};
}

Result<void> Session::Opening::write_session() {
  if (!config.scratch_database) record().uuid = storage::random_uuid();
  const auto id = store->begin_session(record(), answers);
  if (!id) return id.error();
  record().id = *id;
  return {};
}

void Session::Opening::start_recording() {
  if (last_zero && parts.platform != nullptr)
    if (const auto mean = platform::six_axes_of(last_zero->columns, last_zero->mean))
      parts.platform->set_last_zero(*mean);
  if (last_zero && parts.two_platforms != nullptr)
    if (const auto mean = platform::two_six_axes_of(last_zero->columns, last_zero->mean))
      parts.two_platforms->set_last_zeros(*mean);
  parts.acquisition = std::make_unique<Acquisition>(*parts.apparatus, *parts.clock);
  auto writer = std::make_unique<SessionWriter>(std::move(store), patient, record(), answers,
                                                !config.scratch_database);
  parts.recorder = std::make_unique<Recorder>(std::move(writer), record(),
                                              parts.acquisition->records(), !config.virtual_time);
  if (parts.apparatus->info().watches_person) parts.recorder->watch_basis(config.database);
  // Progress is put in order by the times of sessions.
  if (latest)
    parts.recorder->add_event({std::nullopt, 0.0, "clock",
                               "The clock of this computer is behind the newest session of this "
                               "file (" +
                                   *latest + ")."});
  if (!config.virtual_time) parts.threads.start(*parts.acquisition, *parts.recorder);
}

}  // namespace isograsp::session
