// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/staff.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QPointer>
#include <algorithm>
#include <optional>
#include <utility>

#include "gui/words/texts.hpp"
#include "storage/access/audit_log.hpp"

namespace isograsp::gui {

namespace {
constexpr int kLookAtRights_ms = 1000;
}  // namespace

struct Staff::Answer {
  std::shared_ptr<storage::Access> access;
  std::vector<storage::User> users;
  storage::AccessPolicy policy;
  std::optional<Error> error;
  std::vector<Text> notices;
  bool in = false;
  std::string user;
};

namespace {

/// The users and the one who is logged in, after any of these requests.
template <class Answer>
void look_around(Answer& answer) {
  if (auto users = answer.access->users()) answer.users = *std::move(users);
  if (auto policy = answer.access->policy()) answer.policy = *policy;
  answer.in = answer.access->allows(storage::Right::read_records);
  if (const auto user = answer.access->user()) answer.user = user->name;
  answer.notices = answer.access->notices();
}

/// Of the one who is in; into a database that nobody logs into there is a door for every act.
Result<std::shared_ptr<storage::Access>> access_to(const std::string& database,
                                                   const std::shared_ptr<storage::Access>& in) {
  if (in != nullptr) return in;
  auto opened = storage::Access::open(database);
  if (!opened) return opened.error();
  return std::shared_ptr<storage::Access>(*std::move(opened));
}

}  // namespace

Staff::Staff(std::string database, const Clock* clock, QObject* parent)
    : QObject(parent),
      clock_(clock == nullptr ? &steady_ : clock),
      database_(std::move(database)),
      protected_(storage::is_protected_database(database_)) {
  if (!protected_) return;
  touched_ = clock_->now();
  qApp->installEventFilter(this);
  watch_.setInterval(kLookAtRights_ms);
  connect(&watch_, &QTimer::timeout, this, &Staff::lock_if_due);
  watch_.start();
}

Staff::~Staff() {
  if (access_ != nullptr)
    worker_.run([access = access_] { return access->log_out(), true; }, [](bool) {});
}

void Staff::open() {
  if (!protected_) {
    if (!std::exchange(opened_, true)) Q_EMIT opened();
    return;
  }
  busy_ = true;
  worker_.run(
      [database = database_] {
        Answer answer;
        auto access = storage::Access::open(database);
        if (!access) {
          answer.error = access.error();
          return answer;
        }
        answer.access = *std::move(access);
        look_around(answer);
        return answer;
      },
      [this](const Answer& answer) { take(answer); });
  Q_EMIT changed();
}

void Staff::log_in(Key key, const std::string& user, QString& text) {
  std::string plain = text.toStdString();
  text.fill(QChar(u' '));
  text.clear();
  if (busy_) return;
  busy_ = true;
  worker_.run(
      [access = access_, database = database_, locked = locked_, key, user,
       secret = std::make_shared<storage::Secret>(
           storage::Secret::taken_from(plain))]() mutable -> Answer {
        Answer answer;
        if (access == nullptr) {
          auto opened = storage::Access::open(database);
          if (!opened) {
            answer.error = opened.error();
            return answer;
          }
          access = *std::move(opened);
        }
        // The lock may still wait for what is being stored.
        if (locked) access->lock();
        answer.access = access;
        const auto done = [&]() -> Result<void> {
          switch (key) {
            case Key::password: return access->log_in(user, *secret);
            case Key::pin: return access->switch_user(user, *secret);
            case Key::passphrase: return access->log_in_with_passphrase(*secret);
            case Key::recovery_key: break;
          }
          return access->log_in_with_recovery_key(*secret);
        }();
        if (!done) answer.error = done.error();
        look_around(answer);
        return answer;
      },
      [this](const Answer& answer) { take(answer); });
  Q_EMIT changed();
}

void Staff::take(const Answer& answer) {
  busy_ = false;
  if (answer.access != nullptr) {
    access_ = answer.access;
    users_ = answer.users;
    policy_ = answer.policy;
  }
  if (answer.error) {
    Q_EMIT changed();
    // Whoever stands at the login knows which file it is and what was typed.
    Error why = *answer.error;
    if (answer.access != nullptr) why.file = why.field = "";
    Q_EMIT login_refused(translated(why));
    return;
  }
  in_ = answer.in;
  user_ = answer.user;
  if (in_) locked_ = false;
  touched_ = clock_->now();
  QString news;
  for (const Text& notice : answer.notices)
    if (std::find(notices_.begin(), notices_.end(), notice) == notices_.end())
      news += (news.isEmpty() ? "" : "\n") + translated(notice);
  notices_ = answer.notices;
  Q_EMIT changed();
  if (in_ && !std::exchange(opened_, true)) Q_EMIT opened();
  if (in_ && !news.isEmpty()) Q_EMIT noticed(news);
}

void Staff::lock() {
  if (!protected_ || !in_) return;
  Q_EMIT locking();
  names_.clear();
  in_ = false;
  locked_ = true;
  const auto lock_now = [this] {
    // Somebody may have come back meanwhile; whoever tries to has locked it (log_in()).
    if (locked_ && !busy_)
      worker_.run([access = access_] { return access->lock(), true; }, [](bool) {});
  };
  if (after_storing_)
    after_storing_(lock_now);
  else
    lock_now();
  Q_EMIT changed();
}

void Staff::lock_if_due() {
  if (!in_ || busy_) return;
  // After a long trial the time without a touch begins at zero.
  if (trial_runs_ && trial_runs_()) {
    touched_ = clock_->now();
    return;
  }
  const double idle_s = to_seconds(clock_->now() - touched_);
  if (storage::is_lock_due(policy_, idle_s, false)) lock();
}

bool Staff::allows(storage::Right right) const {
  return !protected_ ? right != storage::Right::identities : in_ && access_->allows(right);
}

void Staff::read_identity(QObject* reader, const std::string& code, IdentityRead done) {
  if (access_ == nullptr) return;
  using Read = Result<std::optional<storage::Identity>>;
  worker_.run([access = access_,
               code]() -> Read { return isograsp::storage::read_identity(*access, code); },
              [reader = QPointer<QObject>(reader), done = std::move(done)](const Read& read) {
                if (reader) done(read);
              });
}

void Staff::store_identity(QObject* reader, const std::string& code,
                           const storage::Identity& identity,
                           std::function<void(const Result<void>&)> done) {
  if (access_ == nullptr) return;
  worker_.run(
      [access = access_, code, identity]() -> Result<void> {
        return storage::set_identity(*access, code, identity);
      },
      [reader = QPointer<QObject>(reader), done = std::move(done)](const Result<void>& stored) {
        if (reader) done(stored);
      });
}

void Staff::read_consents(QObject* reader, const std::string& code, ConsentsRead done) {
  using Read = Result<std::vector<storage::Consent>>;
  worker_.run(
      [access = access_, database = database_, code]() -> Read {
        const auto opened = access_to(database, access);
        if (!opened) return opened.error();
        return storage::consents(**opened, code);
      },
      [reader = QPointer<QObject>(reader), done = std::move(done)](const Read& read) {
        if (reader) done(read);
      });
}

void Staff::record_consent(QObject* reader, const std::string& code,
                           const storage::Consent& consent,
                           std::function<void(const Result<void>&)> done) {
  worker_.run(
      [access = access_, database = database_, code, consent]() -> Result<void> {
        const auto opened = access_to(database, access);
        if (!opened) return opened.error();
        const auto added = storage::add_consent(**opened, code, consent);
        return added ? Result<void>{} : Result<void>{added.error()};
      },
      [reader = QPointer<QObject>(reader), done = std::move(done)](const Result<void>& stored) {
        if (reader) done(stored);
      });
}

void Staff::show_names() {
  if (!allows(storage::Right::identities)) return;
  using Names = Result<std::vector<std::pair<std::string, storage::Identity>>>;
  worker_.run([access = access_]() -> Names { return storage::all_identities(*access); },
              [this](const Names& names) {
                if (!names) {
                  Q_EMIT refused(translated(names.error()));
                  return;
                }
                if (closed()) return;
                names_.clear();
                for (const auto& [code, identity] : *names) names_[code] = identity.name;
                Q_EMIT changed();
              });
}

void Staff::log(const std::string& act, const std::string& object, bool done) {
  if (protected_ && access_ == nullptr) return;
  worker_.run(
      [access = access_, database = database_, act, object, done]() -> Result<void> {
        return storage::log_act_of(database, access.get(), act, object, done);
      },
      [this](const Result<void>& logged) {
        if (!logged) Q_EMIT refused(translated(logged.error()));
      });
}

/// Every press or movement at this station delays the lock.
bool Staff::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::ShortcutOverride:  // all that arrives of a key that is a shortcut
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TabletPress:
    case QEvent::TabletMove: touched_ = clock_->now(); break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace isograsp::gui
