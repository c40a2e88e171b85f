// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/rescue_question.hpp"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

#include "gui/words/texts.hpp"
#include "storage/access/access.hpp"
#include "storage/care/emergency.hpp"

namespace isograsp::gui {

namespace {

QString say(const char* text) {
  return QCoreApplication::translate("Rescue", text);
}

/// Empty: it is in the database now.
QString take_back(const std::string& database, const storage::EmergencyFile& file) {
  const auto done = storage::rescue(database, file);
  if (!done) return translated(done.error());
  return done->conflicts.empty() ? QString() : translated(done->conflicts.front());
}

QString command_words(const std::string& database) {
  return say(QT_TRANSLATE_NOOP("Rescue", "Take them in with this command:")) +
         QStringLiteral("\nisograsp db rescue %1").arg(QString::fromStdString(database));
}

/// A box of this question; its buttons have names.
void name_buttons(QMessageBox& box) {
  box.setObjectName("rescue_question");
  box.setWindowTitle(QStringLiteral("IsoGrasp"));
  const std::pair<QMessageBox::StandardButton, const char*> names[]{
      {QMessageBox::Yes, "rescue_yes"},
      {QMessageBox::No, "rescue_no"},
      {QMessageBox::Ok, "rescue_ok"}};
  for (const auto& [which, name] : names)
    if (auto* button = box.button(which)) button->setObjectName(QLatin1String(name));
}

void tell(QMessageBox::Icon icon, const QString& words) {
  QMessageBox box(icon, QString(), words, QMessageBox::Ok);
  name_buttons(box);
  box.exec();
}

bool ask(const QString& words) {
  QMessageBox box(QMessageBox::Question, QString(), words, QMessageBox::Yes | QMessageBox::No);
  box.setDefaultButton(QMessageBox::Yes);
  box.setEscapeButton(QMessageBox::No);
  name_buttons(box);
  return box.exec() == QMessageBox::Yes;
}

}  // namespace

void ask_about_emergency_files(const std::string& database) {
  const auto files = storage::emergency_files(database);
  if (files.empty()) return;
  QString words = say(QT_TRANSLATE_NOOP(
      "Rescue", "The database was taken away while these sessions were recorded. They are kept:"));
  for (const storage::EmergencyFile& file : files)
    words += QStringLiteral("\n%1, %2")
                 .arg(QString::fromStdString(file.patient_code),
                      QString::fromStdString(file.started_utc));
  words += QStringLiteral("\n\n");
  const QString by_command = words + command_words(database);
  if (storage::is_protected_database(database)) return tell(QMessageBox::Information, by_command);
  if (!ask(words + say(QT_TRANSLATE_NOOP("Rescue", "Take them into the database now?")))) return;
  for (const storage::EmergencyFile& file : files) {
    // A deleted file that was protected is so again.
    const auto there = storage::put_back(database, file);
    if (there && storage::is_protected_database(database))
      return tell(QMessageBox::Information, by_command);
    if (const QString problem = take_back(database, file); !problem.isEmpty())
      tell(QMessageBox::Warning, problem);
  }
}

}  // namespace isograsp::gui
