// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/file_in_use.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <utility>

#include "gui/look/look.hpp"

namespace isograsp::gui {

FileInUse::FileInUse(const std::string& database, const std::string& holder, QWidget* parent)
    : QDialog(parent) {
  setObjectName("file_in_use");
  setWindowTitle(tr("IsoGrasp"));
  const auto who =
      holder.empty() ? tr("another program") : QString::fromStdString(holder).toHtmlEscaped();
  auto* title = new QLabel(tr("This file is open in another window"));
  title->setProperty("role", "title");
  auto* words = new QLabel(
      tr("%1<br>is open: %2.<br><br>Two windows must not change the same records. Look at them "
         "here, work in the other window, or open another file.")
          .arg(QStringLiteral("<b>%1</b>").arg(QString::fromStdString(database).toHtmlEscaped()),
               who));
  words->setObjectName("file_in_use_words");
  words->setTextFormat(Qt::RichText);
  words->setWordWrap(true);
  words->setMinimumWidth(scaled(440));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 18, 20, 18);
  column->setSpacing(12);
  column->addWidget(title);
  column->addWidget(words);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  const auto add = [&](const QString& text, const char* name, const QString& tip, Choice choice) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    describe(*button, QString(text).remove(QLatin1Char('&')), tip);
    connect(button, &QPushButton::clicked, this, [this, choice] {
      choice_ = choice;
      accept();
    });
    row->addWidget(button);
    return button;
  };
  auto* look = add(tr("&Look only"), "file_look",
                   tr("Courses and reports are shown; nothing is changed (Alt+L)"), Choice::look);
  add(tr("&Open another file …"), "file_another", tr("Choose another database (Alt+O)"),
      Choice::another);
  add(tr("L&eave"), "file_leave", tr("Open nothing (Alt+E, Escape)"), Choice::leave);
  look->setDefault(true);
  mark_main(*look, true);
  column->addLayout(row);
}

std::optional<FileToOpen> file_to_open(const std::string& database) {
  std::string wanted = database;
  for (;;) {
    auto use = storage::WindowLock::take(wanted, storage::this_program());
    // Where that cannot be known, opening says what is wrong.
    if (!use) return FileToOpen{wanted};
    if (use->held()) return FileToOpen{wanted, false, *std::move(use)};
    FileInUse question(wanted, use->holder());
    question.exec();
    switch (question.choice()) {
      case FileInUse::Choice::leave: return std::nullopt;
      case FileInUse::Choice::look: return FileToOpen{wanted, true};
      case FileInUse::Choice::another: break;
    }
    const auto chosen = QFileDialog::getOpenFileName(
        nullptr, FileInUse::tr("Open another file"), QString::fromStdString(wanted),
        FileInUse::tr("Databases (*.db);;All files (*)"));
    if (!chosen.isEmpty()) wanted = chosen.toStdString();
  }
}

}  // namespace isograsp::gui
