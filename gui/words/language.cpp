// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/words/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <algorithm>

#include "gui/words/texts.hpp"

// Without a namespace, as Qt asks: the linker would leave out what nobody in the library names.
static void take_in_translations() {
  Q_INIT_RESOURCE(translations);
}

namespace isograsp::gui {

namespace {

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

/// The words of the language that is spoken, with the numbers and days of the screen.
class OnScreen : public Language {
 public:
  [[nodiscard]] std::string_view words(std::string_view english) const override {
    return languages::language(now).words(english);
  }
  [[nodiscard]] std::string number(std::string_view digits) const override {
    return translated_digits(digits).toStdString();
  }
  [[nodiscard]] std::string day(Date date) const override {
    return translated_date(iso_text(date)).toStdString();
  }
};

}  // namespace

void speak(const std::string& code) {
  take_in_translations();
  now = languages::is_language(code) ? code : languages::desktop_language();
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

const Language& spoken_language() {
  static const OnScreen kScreen;
  return kScreen;
}

std::string spoken() {
  return now;
}

}  // namespace isograsp::gui
