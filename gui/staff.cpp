// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/staff.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QPointer>
#include <optional>
#include <utility>

#include "gui/texts.hpp"
#include "storage/audit_log.hpp"

namespace isograsp {

namespace {
constexpr int kLookEvery_ms = 1000;
constexpr double kMs = 1e-3;  // in seconds
}  // namespace

struct Staff::Answer {
  std::shared_ptr<Access> access;
  std::vector<User> users;
  AccessPolicy policy;
  std::optional<Error> error;
  bool in = false;
  std::string user;
};

namespace {

/// Who is there and who is in, after whatever was asked for.
template <class Answer>
void look_around(Answer& answer) {
  if (auto users = answer.access->users()) answer.users = *std::move(users);
  if (auto policy = answer.access->policy()) answer.policy = *policy;
  answer.in = answer.access->allows(Right::read_records);
  if (const auto user = answer.access->user()) answer.user = user->name;
}

}  // namespace

Staff::Staff(std::string database, QObject* parent)
    : QObject(parent),
      database_(std::move(database)),
      protected_(is_protected_database(database_)) {
  if (!protected_) return;
  untouched_.start();
  qApp->installEventFilter(this);
  watch_.setInterval(kLookEvery_ms);
  connect(&watch_, &QTimer::timeout, this, &Staff::lock_if_due);
  watch_.start();
}

Staff::~Staff() = default;

void Staff::open() {
  if (!protected_) {
    if (!std::exchange(opened_, true)) Q_EMIT opened();
    return;
  }
  busy_ = true;
  worker_.run(
      [database = database_] {
        Answer answer;
        auto access = Access::open(database);
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
  if (busy_ || access_ == nullptr) return;
  busy_ = true;
  worker_.run(
      [access = access_, key, user,
       secret = std::make_shared<Secret>(Secret::taken_from(plain))]() -> Answer {
        Answer answer;
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
    Q_EMIT refused(shown(*answer.error));
    return;
  }
  in_ = answer.in;
  user_ = answer.user;
  if (in_) locked_ = false;
  untouched_.restart();
  Q_EMIT changed();
  if (in_ && !std::exchange(opened_, true)) Q_EMIT opened();
}

void Staff::lock() {
  if (!protected_ || !in_) return;
  Q_EMIT locking();
  worker_.run([access = access_] { return access->lock(), true; }, [](bool) {});
  names_.clear();
  in_ = false;
  locked_ = true;
  Q_EMIT changed();
}

void Staff::lock_if_due() {
  if (!in_ || busy_) return;
  const double idle_s = static_cast<double>(untouched_.elapsed()) * kMs;
  if (is_lock_due(policy_, idle_s, trial_runs_ && trial_runs_())) lock();
}

bool Staff::allows(Right right) const {
  return !protected_ ? right != Right::identities : in_ && access_->allows(right);
}

void Staff::read_identity(QObject* reader, const std::string& code, IdentityRead done) {
  if (access_ == nullptr) return;
  using Read = Result<std::optional<Identity>>;
  worker_.run([access = access_, code]() -> Read { return isograsp::read_identity(*access, code); },
              [reader = QPointer<QObject>(reader), done = std::move(done)](const Read& read) {
                if (reader) done(read);
              });
}

void Staff::store_identity(QObject* reader, const std::string& code, const Identity& identity,
                           std::function<void(const Result<void>&)> done) {
  if (access_ == nullptr) return;
  worker_.run(
      [access = access_, code, identity]() -> Result<void> {
        return set_identity(*access, code, identity);
      },
      [reader = QPointer<QObject>(reader), done = std::move(done)](const Result<void>& stored) {
        if (reader) done(stored);
      });
}

void Staff::show_names() {
  if (!allows(Right::identities)) return;
  using Names = Result<std::vector<std::pair<std::string, Identity>>>;
  worker_.run([access = access_]() -> Names { return all_identities(*access); },
              [this](const Names& names) {
                if (!names) {
                  Q_EMIT refused(shown(names.error()));
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
      [access = access_, database = database_, act, object, done]() -> std::optional<Error> {
        std::shared_ptr<Access> log_to = access;
        if (log_to == nullptr) {
          auto opened = Access::open(database);
          if (!opened) return opened.error();
          log_to = *std::move(opened);
        }
        if (!log_to->can_log()) return std::nullopt;
        auto logged = log_act(*log_to, act, object, done);
        if (!logged) return logged.error();
        return std::nullopt;
      },
      [this](const std::optional<Error>& error) {
        if (error) Q_EMIT refused(shown(*error));
      });
}

/// Whatever a hand does at this station puts the lock off.
bool Staff::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::KeyPress:
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TouchBegin: untouched_.restart(); break;
    default: break;
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace isograsp
