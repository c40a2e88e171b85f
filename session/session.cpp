// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <future>
#include <latch>
#include <limits>
#include <thread>

#include "core/csv.hpp"
#include "core/time.hpp"
#include "device/uri.hpp"
#include "session/acquisition.hpp"
#include "session/contact_threshold.hpp"
#include "session/recorder.hpp"
#include "session/resting.hpp"
#include "session/simulated_person.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp {

std::string cpu_features() {
  std::string text = "x86-64";
  if (__builtin_cpu_supports("avx2")) text += " avx2";
  if (__builtin_cpu_supports("fma")) text += " fma";
  if (__builtin_cpu_supports("avx512f")) text += " avx512f";
  return text;
}

namespace {

namespace fs = std::filesystem;

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

/// Coarsest step of a force component; 0: the device has no counts.
double resolution_N(const DeviceInfo& info) {
  double coarsest_N = 0.0;
  for (const Vec6& unit : info.units_per_count)
    coarsest_N = std::max(coarsest_N, unit.head<3>().cwiseAbs().maxCoeff());
  return coarsest_N;
}

/// The noise of the empty device: SD of each force component.
std::array<Vec3, kFingerCount> noise_of(const InstrumentZeroRecord& zero) {
  std::array<Vec3, kFingerCount> sd_N;
  for (std::size_t f = 0; f < kFingerCount; ++f) sd_N[f] = zero.sd[f].head<3>();
  return sd_N;
}

FingerWrenches wrenches_of(const RestingForceRecord& rest) {
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    wrench_C[f].force = rest.mean[f].head<3>();
    wrench_C[f].torque = rest.mean[f].tail<3>();
  }
  return wrench_C;
}

/// Fresh sequences and waits of each trial, from the seed of the session and the trial's number.
std::uint64_t trial_seed(const SessionRecord& session, std::size_t trials_before) {
  constexpr std::uint64_t kTrialsPerSession = 1000;
  // Without a seed of the device every session has its own.
  const std::uint64_t own =
      session.seed != 0 ? session.seed : static_cast<std::uint64_t>(session.id);
  return own * kTrialsPerSession + trials_before + 1;
}

/// Forces that this trial measured raise the references of their channels.
void learn_maxima(const TrialOutcome& outcome, ForceReferences& references) {
  for (const Measure& measure : outcome.measures) {
    if (!measure.value) continue;
    auto* const known = measure.name == "maximum_force"       ? &references.maximum_N
                        : measure.name == "comfortable_force" ? &references.comfortable_N
                                                              : nullptr;
    const auto channel = force_channel_from_name(measure.channel);
    if (known == nullptr || !channel) continue;
    double& value_N = (*known)[*channel];
    value_N = std::max(value_N, *measure.value);
  }
}

}  // namespace

struct Session::Parts {
  SessionConfig config;
  SessionRecord record;
  std::unique_ptr<Clock> clock;
  std::unique_ptr<VirtualPatient> viewer;
  std::unique_ptr<ForceDevice> device;
  std::unique_ptr<Acquisition> acquisition;
  std::unique_ptr<Recorder> recorder;
  std::vector<std::unique_ptr<TrialSetup>> setups;  ///< live as long as the threads
  std::atomic<bool> stop{false};
  std::thread acquisition_thread;
  std::thread recorder_thread;
  bool pending = false;   ///< a zero or a trial was asked for and has not ended
  bool finished = false;  ///< virtual time: the device has finished
  bool closed = false;
  bool patient_is_new = false;
  ForceReferences references;
  Training training;
  std::optional<InstrumentZeroRecord> zero;  ///< in force
  std::optional<double> strapped_at_s;       ///< session time
  RealtimeGrant realtime;
  std::latch go{1};  ///< the acquisition thread may begin
  bool gone = false;
  bool streaming = false;  ///< the device is started

  ~Parts() {
    stop_threads();
    stop_device();
  }

  void stop_device() {
    if (std::exchange(streaming, false)) device->stop();
  }

  [[nodiscard]] bool virtual_time() const { return clock->is_virtual(); }

  /// Virtual time: one frame, recorded at once.
  void step() {
    if (!finished) finished = !acquisition->tick();
    recorder->pump();
  }

  /// The acquisition thread asks for real time and waits; before anything is written, so that a
  /// refusal leaves no trace.
  Result<void> make_acquisition_thread() {
    std::promise<Result<RealtimeGrant>> granted;
    auto grant = granted.get_future();
    acquisition_thread = std::thread([this, granted = std::move(granted)]() mutable {
      granted.set_value(enter_realtime(config.realtime));
      go.wait();
      while (!stop.load(std::memory_order_relaxed) && acquisition->tick()) {
      }
    });
    auto got = grant.get();
    if (!got) return got.error();
    realtime = *std::move(got);
    return {};
  }

  void let_go() {
    if (!std::exchange(gone, true)) go.count_down();
  }

  void start_threads() {
    let_go();
    recorder_thread = std::thread([this] {
      constexpr auto kPoll = std::chrono::milliseconds(10);
      while (!stop.load(std::memory_order_relaxed)) {
        recorder->pump();
        std::this_thread::sleep_for(kPoll);
      }
    });
  }

  void stop_threads() {
    stop = true;
    let_go();
    if (acquisition_thread.joinable()) acquisition_thread.join();
    if (recorder_thread.joinable()) recorder_thread.join();
  }

  Result<void> send(const Command& command) {
    if (acquisition->commands().push(command)) return {};
    return Error{
        Error::Code::failed, "the session does not answer", "close it and start again", "", 0, ""};
  }

  void learn(const std::vector<SessionNews>& news) {
    for (const auto& item : news) {
      if (item.zero || item.trial || item.failure) pending = false;
      if (item.zero && item.zero->accepted) {
        zero = item.zero->zero;
        references.noise_sd_N = noise_of(*zero);
      }
      if (!item.trial || item.trial->trial.status != TrialStatus::completed) continue;
      learn_maxima(*item.trial, references);
      training.learn(setups.back()->spec, item.trial->trial, item.trial->measures);
      if (item.trial->rest) references.resting_C = wrenches_of(item.trial->rest->rest);
    }
  }
};

Result<void> check_hand(const std::string& device_uri, std::string_view mounted_for, Hand hand) {
  if (mounted_for == name_of(hand)) return {};
  return Error{Error::Code::bad_input,
               "the device is set up for the " + std::string(mounted_for) +
                   " hand, the session for the " + std::string(name_of(hand)),
               "turn the platform and choose the configuration for that hand, or choose the " +
                   std::string(mounted_for) + " hand",
               device_uri,
               0,
               "hand"};
}

Session::Session(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Session::~Session() {
  close();
}

Result<std::unique_ptr<Session>> Session::open(const SessionConfig& config) {
  auto parts = std::make_unique<Parts>();
  parts->config = config;
  const auto uri = Uri::parse(config.device_uri);
  if (!uri) return uri.error();
  const std::string said = uri->text_or("hand", std::string(name_of(config.hand)));
  if (auto same = check_hand(config.device_uri, said, config.hand); !same) return same.error();
  if (auto good = check_patient_code(config.patient_code); !good) return good.error();
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
    return uri->error("", "a real device cannot run in virtual time", "leave out --fast");
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
      SessionStore::open(config.database, config.create_database ? SessionStore::Open::create
                                                                 : SessionStore::Open::existing);
  if (!store) return store.error();
  auto patient = (*store)->find_patient(config.patient_code);
  if (!patient) return patient.error();
  if (!*patient) {
    const auto added = (*store)->add_patient(config.patient_code, config.started_utc);
    if (!added) return added.error();
    *patient = *added;
    parts->patient_is_new = true;
  }
  SessionRecord& record = parts->record;
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
  record.operator_name = config.operator_name;
  record.realtime = describe(parts->realtime);
  if (uri->parameters.contains("seed"))
    record.seed = std::strtoull(uri->parameters.at("seed").c_str(), nullptr, 10);
  const auto last_zero = (*store)->last_zero(record);
  if (!last_zero) return last_zero.error();
  auto training = Training::read(**store, record);
  if (!training) return training.error();
  parts->training = *std::move(training);
  parts->references.baseline_N = parts->training.baseline_N();
  parts->references.allowed = config.allowed;
  parts->references.ceiling_N = config.ceiling_N;
  parts->references.resolution_N = resolution_N(info);
  const auto session_id = (*store)->begin_session(record);
  if (!session_id) return session_id.error();
  record.id = *session_id;

  Acquisition::Options options;
  options.resume_by_itself = info.recorded;
  options.viewer = parts->viewer.get();
  if (*last_zero) options.last_zero = (*last_zero)->mean;
  parts->acquisition = std::make_unique<Acquisition>(*parts->device, *parts->clock, start, options);
  parts->recorder = std::make_unique<Recorder>(std::move(*store), record,
                                               parts->acquisition->records(), !config.virtual_time);
  if (!config.virtual_time) parts->start_threads();
  return std::unique_ptr<Session>(new Session(std::move(parts)));
}

const DeviceInfo& Session::device() const noexcept {
  return parts_->device->info();
}
const SessionRecord& Session::record() const noexcept {
  return parts_->record;
}
bool Session::patient_is_new() const noexcept {
  return parts_->patient_is_new;
}
const Snapshot& Session::snapshot() noexcept {
  return parts_->acquisition->snapshots().read();
}
std::vector<Measure> Session::live_score() const {
  return parts_->recorder->live_score();
}
const Training& Session::training() const noexcept {
  return parts_->training;
}
const ForceReferences& Session::references() const noexcept {
  return parts_->references;
}
TaskContext Session::next_context() const {
  TaskContext context;
  context.period_s = parts_->device->info().frame_period_s;
  context.references = parts_->references;
  context.seed = trial_seed(parts_->record, parts_->setups.size());
  return context;
}
double Session::maximum_force_N() const noexcept {
  const double maximum_N = parts_->references.maximum({});
  return std::isnan(maximum_N) ? 0.0 : maximum_N;
}
double Session::resting_force_N() const noexcept {
  const double resting_N = parts_->references.resting({});
  return std::isnan(resting_N) ? 0.0 : resting_N;
}

std::array<std::optional<double>, kFingerCount> Session::contact_thresholds_N() const {
  return contact_thresholds(parts_->zero, maximum_force_N());
}
const RealtimeGrant& Session::realtime() const noexcept {
  return parts_->realtime;
}

void Session::strapped() {
  const double now_s = snapshot().session_time_s;
  parts_->strapped_at_s = now_s;
  parts_->recorder->add_event({0, now_s, "strapped", ""});
}

double Session::settling_s() noexcept {
  const auto& at_s = parts_->strapped_at_s;
  return at_s ? std::max(0.0, *at_s + kSettleAfterStrapping_s - snapshot().session_time_s) : 0.0;
}

Result<void> Session::start_zero(const ZeroRequest& request) {
  if (!request.device_is_empty)
    return Error{Error::Code::bad_input,
                 "nobody has confirmed that the device is empty",
                 "take the hand out, let nothing touch the supports, and confirm that",
                 "",
                 0,
                 ""};
  if (parts_->pending)
    return Error{
        Error::Code::failed, "a trial or a zero is still running", "wait for its end", "", 0, ""};
  auto sent =
      parts_->send({Command::Kind::zero, nullptr, "", request.accept_changed, request.settle_s});
  parts_->pending = sent.ok();
  if (sent) parts_->strapped_at_s.reset();
  return sent;
}

Result<void> Session::start_trial(const TaskSpec& spec, bool practice) {
  Parts& p = *parts_;
  if (p.pending)
    return Error{
        Error::Code::failed, "a trial or a zero is still running", "wait for its end", "", 0, ""};
  if (const double wait_s = settling_s();
      wait_s > 0.0 && std::holds_alternative<RestSpec>(spec.kind))
    return Error{Error::Code::failed,
                 "the hand was strapped less than a minute ago and still settles",
                 "wait another " + std::to_string(std::lround(std::ceil(wait_s))) + " s",
                 "",
                 0,
                 ""};
  auto setup = std::make_unique<TrialSetup>();
  if (p.strapped_at_s) setup->since_strapping_s = snapshot().session_time_s - *p.strapped_at_s;
  setup->spec = spec;
  const TaskContext context = next_context();
  setup->constants.device_delay_s = p.device->info().delay_s;
  if (p.references.resolution_N > 0.0) setup->constants.resolution_N = p.references.resolution_N;
  TrialRecord& record = setup->record;
  if (const std::string name = spec.scene(); !name.empty()) {
    const auto path = find_in_library(p.config.library, "scenes", name, spec.file);
    if (!path) return path.error();
    const auto text = read_text(*path);
    if (!text) return text.error();
    auto scene = parse_scene(*text, *path);
    if (!scene) return scene.error();
    const Scene used =
        with_thresholds(for_hand(*std::move(scene), p.config.hand), contact_thresholds_N());
    auto plan = Plan::compile(used, context.period_s);
    if (!plan) return plan.error();
    setup->plan = std::move(*plan);
    record.threshold_N = thresholds_of(used);
    record.scene_text = *text;
  }
  auto task = make_task(spec, context);
  if (!task) return task.error();
  setup->task = std::move(*task);
  record.session_id = p.record.id;
  record.number = static_cast<int>(p.setups.size()) + 1;
  record.task_name = spec.name;
  record.task_version = spec.version;
  record.task_text = spec.text;
  record.practice = practice;
  record.maximum_force_N = maximum_force_N();
  record.resting_force_N = resting_force_N();
  auto sent = p.send({Command::Kind::begin, setup.get()});
  if (!sent) return sent;
  p.setups.push_back(std::move(setup));
  p.pending = true;
  return {};
}

void Session::pause() {
  (void)parts_->send({Command::Kind::pause});
}
void Session::resume() {
  (void)parts_->send({Command::Kind::resume});
}
void Session::abort(const char* reason) {
  (void)parts_->send({Command::Kind::abort, nullptr, reason});
}

void Session::note(const std::string& text) {
  parts_->recorder->add_event({0, snapshot().session_time_s, "note", text});
}

std::vector<SessionNews> Session::take_news() {
  auto news = parts_->recorder->take_news();
  parts_->learn(news);
  return news;
}

std::vector<SessionNews> Session::wait_for_news() {
  Parts& p = *parts_;
  for (;;) {
    auto news = take_news();
    if (!news.empty() || !p.pending) return news;
    if (p.virtual_time()) {
      if (p.finished) return take_news();
      p.step();
    } else {
      if (snapshot().stage == Stage::finished) {
        // The recorder may still be writing what came last.
        constexpr double kGrace_s = 5.0;
        p.recorder->wait_for_news(kGrace_s);
        return take_news();
      }
      constexpr double kLook_s = 0.5;
      p.recorder->wait_for_news(kLook_s);
    }
  }
}

void Session::let_pass(double duration_s) {
  Parts& p = *parts_;
  if (!p.virtual_time()) {
    std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
    return;
  }
  const double until_s = snapshot().session_time_s + duration_s;
  while (!p.finished && snapshot().session_time_s < until_s) p.step();
}

void Session::close() {
  Parts& p = *parts_;
  if (p.closed) return;
  p.closed = true;
  if (p.pending) {
    abort("The session was closed.");
    (void)wait_for_news();
  }
  p.stop_threads();
  p.stop_device();
  p.recorder->pump();
  // Virtual time has its own end.
  (void)p.recorder->end_session(p.virtual_time() ? std::optional(snapshot().session_time_s)
                                                 : std::nullopt);
}

}  // namespace isograsp
