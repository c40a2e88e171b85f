// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/day.hpp"

#include <QDateTime>
#include <algorithm>
#include <map>
#include <tuple>

#include "session/resume.hpp"

namespace isograsp::gui {

namespace {

constexpr qint64 kWeek_days = 7;
constexpr qint64 kWeeksBack = 2;

QDate local_day(const std::string& utc) {
  return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate).toLocalTime().date();
}

bool is_usual(const QDate& day, const QDate& today) {
  const qint64 ago = day.isValid() ? day.daysTo(today) : 0;
  return ago > 0 && ago <= kWeeksBack * kWeek_days && ago % kWeek_days == 0;
}

std::string seen_last(const PersonOfDay& person) {
  return person.last ? std::max(person.last->started_utc, person.patient.created_utc)
                     : person.patient.created_utc;
}

void add_once(std::vector<std::string>& all, const std::string& one) {
  if (!one.empty() && std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// When the work began that the person's newest session has left open.
std::string unfinished_since(storage::SessionStore& store,
                             const std::vector<storage::SessionRecord>& sessions,
                             const std::string& now_utc) {
  storage::SessionRecord next = sessions.back();
  if (next.protocol_text.empty() || next.recorded) return {};
  next.id = 0;
  next.started_utc = now_utc;
  const auto work = session::read_earlier_work(store, next);
  if (!work || work->trials.empty()) return {};
  const auto first =
      std::find_if(sessions.begin(), sessions.end(), [&](const storage::SessionRecord& one) {
        return one.id == work->first_id.value_or(sessions.back().id);
      });
  return first == sessions.end() ? sessions.back().started_utc : first->started_utc;
}

Result<DayCard> what_finds(storage::SessionStore& store, const storage::PatientRecord& patient,
                           const std::vector<storage::SessionRecord>& sessions) {
  const auto marks = store.treatment_marks(patient.id);
  if (!marks) return marks.error();
  const auto profile = store.profile(patient.id);
  if (!profile) return profile.error();
  DayCard card;
  card.sessions = static_cast<int>(sessions.size());
  card.blank = sessions.empty() && marks->empty() && *profile == storage::PatientProfile{};
  if (!sessions.empty()) card.last = sessions.back();
  for (const auto& session : sessions) add_once(card.protocols, session.protocol_name);
  for (const auto& mark : *marks) {
    add_once(card.marks, mark.kind);
    add_once(card.marks, mark.text);
  }
  return card;
}

}  // namespace

std::vector<PersonOfDay> in_order_of_day(const std::vector<storage::PatientRecord>& patients,
                                         const std::vector<storage::SessionRecord>& newest_first,
                                         const QDate& today) {
  std::vector<PersonOfDay> people;
  std::map<storage::RowId, std::size_t> places;
  for (const auto& patient : patients) {
    places.emplace(patient.id, people.size());
    people.push_back(
        {patient, {}, local_day(patient.created_utc) == today ? Visit::here : Visit::none});
  }
  for (const auto& session : newest_first) {
    const auto place = places.find(session.patient_id);
    if (place == places.end()) continue;
    PersonOfDay& person = people[place->second];
    if (!person.last) person.last = session;
    const QDate day = local_day(session.started_utc);
    if (day == today) person.visit = Visit::here;
    if (person.visit == Visit::none && is_usual(day, today)) person.visit = Visit::usual;
  }
  std::sort(people.begin(), people.end(), [](const PersonOfDay& a, const PersonOfDay& b) {
    if (a.visit != b.visit) return a.visit < b.visit;
    return std::tuple(seen_last(a), a.patient.id) > std::tuple(seen_last(b), b.patient.id);
  });
  return people;
}

Result<DayCard> read_what_finds(storage::SessionStore& store,
                                const storage::PatientRecord& patient) {
  const auto sessions = store.sessions(patient.id);
  return sessions ? what_finds(store, patient, *sessions) : Result<DayCard>(sessions.error());
}

Result<DayCard> read_day_card(storage::SessionStore& store, const storage::PatientRecord& patient,
                              const std::string& now_utc) {
  const auto sessions = store.sessions(patient.id);
  if (!sessions) return sessions.error();
  auto card = what_finds(store, patient, *sessions);
  if (!card || sessions->empty()) return card;
  card->unfinished_since_utc = unfinished_since(store, *sessions, now_utc);
  const auto primaries = store.primary_measures(patient.id);
  if (!primaries) return primaries.error();
  if (primaries->empty()) return card;
  auto verdicts = reports::gather_verdicts(store, patient.code);
  if (!verdicts) return verdicts.error();
  if (!verdicts->empty()) card->primary = std::move(verdicts->front());
  return card;
}

}  // namespace isograsp::gui
