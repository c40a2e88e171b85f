// SPDX-License-Identifier: GPL-3.0-or-later
// The presenter's part that takes what the therapist chooses: patient, hand, device, protocol,
// task.
#include <algorithm>
#include <ctime>
#include <filesystem>

#include "gui/library/task_groups.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

/// The protocol that is proposed; any other is one choice away.
constexpr const char* kUsualProtocol = "battery";

/// "The target is … : run …."
std::string sentence_of(const Error& error) {
  QString words = shown(error.what);
  if (!error.remedy.empty()) words += QStringLiteral(": ") + shown(error.remedy);
  words[0] = words[0].toUpper();
  return (words + QLatin1Char('.')).toStdString();
}

/// The first force that the task is scaled to and that was not measured, in words; empty: none.
std::string lack_of(const tasks::TaskSpec& spec, const tasks::ForceReferences& references) {
  for (const tasks::Scale scale :
       {tasks::Scale::of_maximum, tasks::Scale::of_comfortable, tasks::Scale::of_baseline})
    for (const ForceChannel channel : spec.channels_needed(scale)) {
      const auto unit = references.unit_N(scale, channel, spec.largest_level());
      if (!unit) return sentence_of(unit.error());
    }
  return "";
}

/// As far as the work of an earlier session is looked for by it.
storage::SessionRecord session_to_come(storage::RowId patient, Hand hand,
                                       const std::string& device_uri,
                                       const tasks::ProtocolSpec& protocol) {
  storage::SessionRecord session;
  session.patient_id = patient;
  session.hand = hand;
  session.simulated = device_uri.rfind("sim://", 0) == 0;
  session.started_utc = utc_text(std::time(nullptr));
  session.protocol_name = protocol.name;
  session.protocol_text = protocol.text;
  return session;
}

}  // namespace

// What is chosen: whoever goes on with the next session has read why the last one ended.

void SessionPresenter::choose_patient(const std::string& code) {
  if (busy() || code == choices_.patient) return;
  choices_.patient = code;
  ask_anew();
  connection_.failure.reset();
  left_ = {};
  clinic_.load_history(code);
  clinic_.load_profile(code);
  seating_.look(code, choices_.today.hand);
  update();
}

void SessionPresenter::choose_hand(Hand hand) {
  if (!view_.may_change_hand) return;
  connection_.failure.reset();
  auto& today = choices_.today;
  if (today.hand != hand) today.screening = {};  // its outcome is that of one hand
  today.hand = hand;
  today.hand_confirmed = false;
  look_for_earlier();
  seating_.look(choices_.patient, hand);
  update();
}

/// Looked up whenever it is asked: what is known of the person may be read, or told, after the hand
/// was chosen. A session that is open has its hand.
bool SessionPresenter::hand_to_confirm() const noexcept {
  const auto& file = clinic_.file();
  const auto& today = choices_.today;
  if (!today.hand || today.hand_confirmed || busy()) return false;
  if (!file || clinic_.file_of() != choices_.patient) return false;
  return file->profile.affected ==
         (*today.hand == Hand::right ? storage::Side::left : storage::Side::right);
}

void SessionPresenter::confirm_hand() {
  if (!hand_to_confirm()) return;
  choices_.today.hand_confirmed = true;
  update();
}

/// Before every session: hand and screening.
void SessionPresenter::ask_anew() {
  choices_.today = {};
  look_for_earlier();  // for nobody yet: what was asked before counts no more
}

void SessionPresenter::choose_device(const std::string& uri) {
  if (!view_.may_change_device) return;
  choices_.device_uri = uri;
  connection_.failure.reset();
  look_for_earlier();
  update();
}

void SessionPresenter::answer_screening(const Screening& answers) {
  if (busy() || answers == choices_.today.screening) return;
  connection_.failure.reset();
  choices_.today.screening = answers;
  update();
}

void SessionPresenter::choose_protocol(int index) {
  if (busy() || index == choices_.protocol) return;
  connection_.failure.reset();
  choices_.protocol = index;
  look_for_earlier();
  update();
}

/// Asks the database whether the chosen protocol was interrupted today.
void SessionPresenter::look_for_earlier() {
  const int lookup = ++lookups_;
  choices_.interrupted = {};
  const auto& hand = choices_.today.hand;
  if (choices_.patient.empty() || !hand || choices_.device_uri.empty() || !has_protocol()) return;
  choices_.interrupted.sought = clinic_.read(
      this,
      [code = choices_.patient, hand = *hand, uri = choices_.device_uri,
       protocol = library_.protocols[static_cast<std::size_t>(choices_.protocol)]](
          storage::SessionStore& store) -> std::optional<int> {
        const auto patient = store.find_patient(code);
        if (!patient || !*patient) return std::nullopt;
        const auto session = session_to_come((*patient)->id, hand, uri, protocol.spec);
        const auto work = session::read_earlier_work(store, session);
        if (!work) return std::nullopt;  // nothing to resume
        const session::ProtocolWalk walk(protocol, *work, session::order_seed(session, *work));
        return walk.acts_done() > 0 ? std::optional(walk.acts_done()) : std::nullopt;
      },
      [this, lookup](std::optional<int> acts) {
        if (lookup != lookups_) return;  // something else was chosen meanwhile
        choices_.interrupted.sought = false;
        choices_.interrupted.acts = acts;
        update();
      });
}

void SessionPresenter::decide_earlier(bool go_on) {
  if (!choices_.interrupted.acts || busy()) return;
  connection_.failure.reset();
  choices_.interrupted.go_on = go_on;
  update();
}

/// A recording follows none: whatever was done in it is done.
bool SessionPresenter::has_protocol() const noexcept {
  return choices_.protocol != kByHand && choices_.device_uri.rfind("replay://", 0) != 0;
}

void SessionPresenter::reload_library() {
  worker_.run(
      [shipped = config_.library, own = session::own_library_folder(config_.database)] {
        return read_session_library(shipped, own);
      },
      [this](SessionLibrary library) { newer_library_ = std::move(library); });
}

/// What is chosen stays chosen, by the file that it was read from.
void SessionPresenter::take_library(SessionLibrary library) {
  const auto file_of = [this](int task) {
    return task < 0 ? std::string() : library_.tasks[static_cast<std::size_t>(task)].file;
  };
  const bool first = library_.tasks.empty() && library_.protocols.empty();
  const std::string before = file_of(choices_.task);
  const std::string in_session = open_ ? file_of(open_->work.task) : "";
  std::optional<session::ReadyProtocol> chosen;
  if (choices_.protocol != kByHand)
    chosen = library_.protocols[static_cast<std::size_t>(choices_.protocol)];
  library_ = std::move(library);
  choices_.task = place_of_file(library_.tasks, before);
  if (choices_.task < 0) choices_.task = first_task(is_rest).value_or(-1);
  if (open_) {
    open_->work.task = place_of_file(library_.tasks, in_session);
    if (open_->work.task < 0) open_->work.task = first_task(is_rest).value_or(-1);
  }
  look_at_task();
  take_protocols(chosen);
  if (first) {
    const auto& protocols = library_.protocols;
    for (std::size_t i = 0; i < protocols.size(); ++i)
      if (fs::path(protocols[i].spec.file).stem() == kUsualProtocol)
        choices_.protocol = static_cast<int>(i);
  }
  Q_EMIT library_changed();
}

void SessionPresenter::take_protocols(const std::optional<session::ReadyProtocol>& chosen) {
  if (!chosen) return;
  auto& protocols = library_.protocols;
  choices_.protocol = place_of_file(protocols, chosen->spec.file);
  // A session that follows a protocol whose file is gone follows it to its end.
  if (choices_.protocol < 0 && busy()) {
    choices_.protocol = static_cast<int>(protocols.size());
    protocols.push_back(*chosen);
  }
  const bool same =
      choices_.protocol != kByHand &&
      protocols[static_cast<std::size_t>(choices_.protocol)].spec.text == chosen->spec.text;
  if (!same) look_for_earlier();
}

void SessionPresenter::choose_task(int index) {
  if (!view_.may_choose_task || index == task()) return;
  example_.stop();
  hold();
  if (open_) open_->work.by_hand = true;
  select(index);
  update();
}

void SessionPresenter::set_practice(bool practice) {
  choices_.practice = practice;
}

std::optional<int> SessionPresenter::first_task(bool (*fits)(const tasks::TaskSpec&)) const {
  const auto& tasks = library_.tasks;
  const auto found = std::find_if(tasks.begin(), tasks.end(), fits);
  if (found == tasks.end()) return std::nullopt;
  return static_cast<int>(found - tasks.begin());
}

/// By hand; nothing: the choice stays as it is.
void SessionPresenter::select(std::optional<int> task) {
  if (task) (open_ ? open_->work.task : choices_.task) = *task;
  look_at_task();
}

/// A target that follows the force just measured.
void SessionPresenter::select_task_after_maximum() {
  const auto& references = open_->session->references();
  const auto& tasks = library_.tasks;
  const auto found = std::find_if(tasks.begin(), tasks.end(), [&](const tasks::TaskSpec& spec) {
    return spec.kind->follows_curve && lack_of(spec, references).empty();
  });
  select(found == tasks.end() ? std::nullopt
                              : std::optional(static_cast<int>(found - tasks.begin())));
}

/// Once per choice and measurement: the flow is decided sixty times a second.
void SessionPresenter::look_at_task() {
  if (!open_) return;
  open_->work.task_lacks.clear();
  const auto* spec = next_task();
  // What a protocol asks is not refused beforehand: it is left out, with the reason.
  if (spec == nullptr || follows()) return;
  open_->work.task_lacks = lack_of(*spec, open_->session->references());
}

const tasks::TaskSpec* SessionPresenter::next_task() const noexcept {
  if (follows()) return open_->work.act_task ? &*open_->work.act_task : nullptr;
  if (!open_ && has_protocol()) return nullptr;  // the protocol will say
  const int task = task_by_hand();
  return task < 0 ? nullptr : &library_.tasks[static_cast<std::size_t>(task)];
}

}  // namespace isograsp::gui
