// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/day_book.hpp"

#include <QDateTime>
#include <QStringList>
#include <algorithm>
#include <ctime>
#include <utility>

#include "core/time.hpp"
#include "gui/words/profile_words.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kMostSessions = 1000;        // the newest of all people: read in milliseconds
constexpr std::size_t kPeopleAtOnce = 50;  // of a search: other readers come between them

QStringList words_that_find(const DayCard& card) {
  QStringList words;
  for (const auto& protocol : card.protocols) words << translated(protocol);
  for (const auto& mark : card.marks) words << treatment_words(mark) << qt(mark);
  return words;
}

}  // namespace

DayBook::DayBook(Clinic& clinic, QObject* parent) : QObject(parent), clinic_(clinic) {
  connect(&clinic_, &Clinic::patients_changed, this, &DayBook::renew);
  renew();  // the window may be made anew in a clinic that is open
}

void DayBook::renew() {
  begin_anew();
  if (!clinic_.is_open()) return;
  clinic_.read(
      this, [](storage::SessionStore& store) { return store.recent_sessions(kMostSessions); },
      [this, edition = edition_](const Result<std::vector<storage::SessionRecord>>& sessions) {
        if (!sessions || edition != edition_) return;
        people_ = in_order_of_day(clinic_.patients(), *sessions, QDate::currentDate());
        cards_.clear();
        Q_EMIT changed();
      });
}

void DayBook::forget() {
  begin_anew();
  people_.clear();
  cards_.clear();
  Q_EMIT changed();
}

/// What is under way counts no more.
void DayBook::begin_anew() {
  ++edition_;
  wanted_.clear();
  reading_ = false;
  words_.clear();
  without_words_.clear();
  searched_ = false;
}

void DayBook::look_at(const std::vector<storage::PatientRecord>& patients) {
  wanted_.clear();
  for (const auto& patient : patients)
    if (!cards_.contains(patient.code)) wanted_.push_back(patient);
  read_next();
}

void DayBook::read_next() {
  if (reading_ || wanted_.empty()) return;
  auto patient = std::move(wanted_.front());
  wanted_.pop_front();
  reading_ = clinic_.read(
      this,
      [patient, now = utc_text(std::time(nullptr))](storage::SessionStore& store) {
        return read_day_card(store, patient, now);
      },
      [this, code = patient.code, edition = edition_](Result<DayCard> card) {
        if (edition != edition_) return;
        reading_ = false;
        if (card) {
          cards_[code] = *std::move(card);
          Q_EMIT card_read(QString::fromStdString(code));
        }
        read_next();
      });
}

void DayBook::prepare_search() {
  if (std::exchange(searched_, true)) return;
  for (const auto& person : people_) without_words_.push_back(person.patient);
  read_next_words();
}

void DayBook::read_next_words() {
  if (without_words_.empty()) return;
  const auto count = static_cast<std::ptrdiff_t>(std::min(kPeopleAtOnce, without_words_.size()));
  std::vector<storage::PatientRecord> some(without_words_.begin(), without_words_.begin() + count);
  without_words_.erase(without_words_.begin(), without_words_.begin() + count);
  clinic_.read(
      this,
      [some = std::move(some)](storage::SessionStore& store) {
        std::map<std::string, DayCard> found;
        for (const auto& patient : some)
          if (auto card = read_what_finds(store, patient)) found.emplace(patient.code, *card);
        return found;
      },
      [this, edition = edition_](const std::map<std::string, DayCard>& found) {
        if (edition != edition_) return;
        for (const auto& [code, card] : found) words_[code] = words_that_find(card);
        Q_EMIT searchable();
        read_next_words();
      });
}

const DayCard* DayBook::card(const std::string& code) const {
  const auto found = cards_.find(code);
  return found == cards_.end() ? nullptr : &found->second;
}

bool DayBook::found_by(const std::string& code, const QString& wanted) const {
  const auto words = words_.find(code);
  return words != words_.end() &&
         std::any_of(words->second.begin(), words->second.end(),
                     [&](const QString& one) { return one.contains(wanted, Qt::CaseInsensitive); });
}

}  // namespace isograsp::gui
