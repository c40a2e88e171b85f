// SPDX-License-Identifier: GPL-3.0-or-later
// Who works at this station. A protected database needs a login before it opens, locks itself when
// nobody touches anything, and names the person in every record; one without protection knows
// nobody. Every call returns at once: logins take the time of Argon2id on a worker. GUI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "gui/clinic/background.hpp"
#include "storage/access/access.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"

namespace isograsp::gui {

class Staff final : public QObject {
  Q_OBJECT

 public:
  /// Reads whether the file is protected; one that is not there is not.
  /// The clock says how long nobody has touched anything; null: the steady one.
  explicit Staff(std::string database, const Clock* clock = nullptr, QObject* parent = nullptr);
  ~Staff() override;

  /// Who has an account, and the policy -> changed(). Without protection opened() at once.
  void open();
  [[nodiscard]] bool is_protected() const noexcept { return protected_; }
  /// Nobody is in: the windows show no patient.
  [[nodiscard]] bool closed() const noexcept { return protected_ && !in_; }
  /// Somebody was in: a PIN is enough.
  [[nodiscard]] bool locked() const noexcept { return locked_; }
  [[nodiscard]] bool busy() const noexcept { return busy_; }
  [[nodiscard]] const std::vector<storage::User>& users() const noexcept { return users_; }
  /// Who is in; empty: nobody, or not protected.
  [[nodiscard]] const std::string& user() const noexcept { return user_; }
  [[nodiscard]] bool allows(storage::Right right) const;
  /// What the last login with a password found strange though it opened (Access::notices()).
  [[nodiscard]] const std::vector<Text>& notices() const noexcept { return notices_; }
  /// Null: not protected.
  [[nodiscard]] std::shared_ptr<storage::Access> access() const noexcept { return access_; }

  enum class Key : std::uint8_t { password, pin, passphrase, recovery_key };
  /// `user` is ignored with the clinic's own keys. -> changed() or login_refused(). The text is
  /// wiped. Where open() has failed, it is tried again first.
  void log_in(Key key, const std::string& user, QString& text);
  void lock();
  /// lock(), if nobody has touched anything for as long as the policy says. Asked every second.
  void lock_if_due();
  /// What is stored on locking() needs rights that end with the lock: `then` is called when it is
  /// stored.
  using AfterStoring = std::function<void(std::function<void()> then)>;
  void set_after_storing(AfterStoring after_storing) { after_storing_ = std::move(after_storing); }
  /// While a trial or a protocol runs or will begin by itself, nothing locks; afterwards the time
  /// without a touch is counted from zero.
  void set_trial_runs(std::function<bool()> trial_runs) { trial_runs_ = std::move(trial_runs); }
  // Who a code is. Refused without Right::identities; every reading is logged with its reader.
  /// Nothing: not told.
  using IdentityRead = std::function<void(const Result<std::optional<storage::Identity>>&)>;
  void read_identity(QObject* reader, const std::string& code, IdentityRead done);
  void store_identity(QObject* reader, const std::string& code, const storage::Identity& identity,
                      std::function<void(const Result<void>&)> done);
  // On which lawful basis a person's data are used: in every database, under the name of whoever
  // is in. What is recorded is logged.
  using ConsentsRead = std::function<void(const Result<std::vector<storage::Consent>>&)>;
  void read_consents(QObject* reader, const std::string& code, ConsentsRead done);
  void record_consent(QObject* reader, const std::string& code, const storage::Consent& consent,
                      std::function<void(const Result<void>&)> done);
  /// Names of all, to look for one -> changed(). Forgotten with the lock.
  void show_names();
  [[nodiscard]] const std::map<std::string, std::string>& names() const noexcept { return names_; }
  /// An act that the database cannot see: a report, an export, paper, a backup.
  void log(const std::string& act, const std::string& object, bool done);

 Q_SIGNALS:
  void locking();  ///< what was typed is stored now
  void opened();   ///< the database may be opened: once
  void changed();  ///< closed(), locked(), user(), busy(), users()
  void refused(const QString& why);
  void login_refused(const QString& why);
  void noticed(const QString& what);  ///< at a login: notices(), those that were not said before

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Answer;
  void take(const Answer& answer);

  SteadyClock steady_;
  const Clock* clock_;
  std::string database_;
  bool protected_ = false;
  bool in_ = false;
  bool locked_ = false;
  bool busy_ = false;
  bool opened_ = false;
  std::string user_;
  std::vector<storage::User> users_;
  std::vector<Text> notices_;
  std::map<std::string, std::string> names_;  ///< by code
  storage::AccessPolicy policy_;
  std::function<bool()> trial_runs_;
  AfterStoring after_storing_;
  Timestamp touched_{0};
  QTimer watch_;
  std::shared_ptr<storage::Access> access_;
  Background worker_;  ///< last: its jobs end before anything else goes away
};

}  // namespace isograsp::gui
