// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/language.hpp"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>

// Without a namespace, as Qt asks: the linker would leave out what nobody in the library names.
static void take_in_translations() {
  Q_INIT_RESOURCE(translations);
}

namespace isograsp::gui {

namespace {

const Language* find(const QString& code) {
  const auto* const found =
      std::find_if(kLanguages.begin(), kLanguages.end(),
                   [&](const Language& language) { return code == QLatin1String(language.code); });
  return found == kLanguages.end() ? nullptr : found;
}

/// Where the desktop speaks it too, with the forms of its country.
QLocale forms_of(const QString& code) {
  const QLocale desktop(QLocale::system().name());
  QLocale forms(code);
  if (desktop.language() == forms.language()) forms = desktop;
  forms.setNumberOptions(QLocale::OmitGroupSeparator);  // a gap in 1 234 looks like two numbers
  return forms;
}

void install(const QString& file, const QString& folder) {
  // A child of the application: it goes with it, and the next speak() finds it.
  auto* translator = new QTranslator(QCoreApplication::instance());
  translator->setObjectName(QStringLiteral("spoken"));
  // Qt's own texts are a package of their own: without it a file dialog stays English.
  if (translator->load(file, folder))
    QCoreApplication::installTranslator(translator);
  else
    delete translator;
}

std::string now = "en";

}  // namespace

std::string desktop_language() {
  for (const QString& tag : QLocale::system().uiLanguages())
    if (const auto* language = find(QLocale(tag).name().section('_', 0, 0))) return language->code;
  return "en";
}

void speak(const std::string& code) {
  take_in_translations();
  const auto* const known = find(QString::fromStdString(code));
  now = known == nullptr ? desktop_language() : known->code;
  const auto language = QString::fromStdString(now);
  auto* application = QCoreApplication::instance();
  for (auto* before : application->findChildren<QTranslator*>(QStringLiteral("spoken"),
                                                              Qt::FindDirectChildrenOnly)) {
    QCoreApplication::removeTranslator(before);
    delete before;
  }
  QLocale::setDefault(forms_of(language));
  install(QStringLiteral("qtbase_") + language,
          QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install(QStringLiteral("isograsp_") + language, QStringLiteral(":/translations"));
}

const std::vector<TextPattern>& patterns_below() {
  static const auto kPatterns = [] {
    take_in_translations();
    QFile file(QStringLiteral(":/translations/patterns.txt"));
    std::vector<TextPattern> patterns;
    if (file.open(QIODevice::ReadOnly))
      for (const auto& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n')))
        if (!line.isEmpty()) patterns.emplace_back(line);
    std::stable_sort(patterns.begin(), patterns.end(),
                     [](const auto& a, const auto& b) { return a.length() > b.length(); });
    return patterns;
  }();
  return kPatterns;
}

std::string spoken() {
  return now;
}

}  // namespace isograsp::gui
