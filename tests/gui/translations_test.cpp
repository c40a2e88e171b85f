// SPDX-License-Identifier: GPL-3.0-or-later
// The languages: their files are complete, numbers and dates follow them on the screen and nowhere
// else, and what the layers below say is known in each.
#include <QFile>
#include <QFontMetricsF>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <map>

#include "core/csv.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/picture/patient_picture.hpp"
#include "gui/record_pages/profile_cards.hpp"
#include "gui/rules/flow.hpp"
#include "gui/words/cue_words.hpp"
#include "gui/words/profile_words.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "session/platform/zeroing.hpp"
#include "spoken.hpp"
#include "tests/support/every.hpp"
#include "tests/support/every_language.hpp"

namespace isograsp::gui::test::translations_test {
namespace {

struct Message {
  QString context;
  QString source;
  QStringList words;  ///< one; of a plural one for each number
  bool finished = true;
};

std::vector<Message> messages_of(const char* language) {
  QFile file(QStringLiteral(ISOGRASP_SOURCE_DIR "/gui/translations/isograsp_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
  std::vector<Message> messages;
  QString context;
  QXmlStreamReader xml(&file);
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    const auto name = xml.name();
    if (name == "name") {
      context = xml.readElementText();
    } else if (name == "message") {
      messages.push_back({context, {}, {}});
    } else if (name == "source") {
      messages.back().source = xml.readElementText();
    } else if (name == "translation") {
      messages.back().finished = !xml.attributes().hasAttribute("type");
      QString text;
      while (xml.readNext() != QXmlStreamReader::EndElement)
        if (xml.isStartElement())
          messages.back().words << xml.readElementText();
        else
          text += xml.text();
      if (messages.back().words.isEmpty()) messages.back().words << text;
    }
  }
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
  return messages;
}

/// "%1", "%L2", "%n" in order.
QStringList placeholders(const QString& text) {
  static const QRegularExpression kPlace("%(L?\\d|n)");
  QStringList found;
  for (auto all = kPlace.globalMatch(text); all.hasNext();) found << all.next().captured();
  found.sort();
  found.removeDuplicates();
  return found;
}

QString edge(const QString& text, const char* where) {
  return QRegularExpression(where).match(text).captured();
}

class EachLanguage : public QtTest, public ::testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(, EachLanguage, ::testing::ValuesIn(test::translated_languages()),
                         test::code_of_language);

TEST_P(EachLanguage, SaysEveryTextAndKeepsItsPlaceholdersMnemonicAndEdges) {
  const auto messages = messages_of(GetParam());
  ASSERT_GE(messages.size(), 1000U) << "the windows have more texts than that";
  for (const auto& message : every(messages))
    for (const auto& words : every(message.words)) {
      const auto where = message.context.toStdString() + ": " + message.source.toStdString();
      EXPECT_TRUE(message.finished && !words.isEmpty())
          << where << " (scripts/translations --missing)";
      EXPECT_EQ(placeholders(words), placeholders(message.source)) << where;
      EXPECT_EQ(edge(words, "^\\s*"), edge(message.source, "^\\s*")) << where;
      EXPECT_EQ(edge(words, "\\s*$"), edge(message.source, "\\s*$")) << where;
      EXPECT_EQ(QKeySequence::mnemonic(words).isEmpty(),
                QKeySequence::mnemonic(message.source).isEmpty())
          << where << " = " << words.toStdString();
    }
}

TEST_P(EachLanguage, HasNoEnglishLeftInTheSentencesOfASession) {
  const auto sentence = [](const FlowFacts& facts) { return decide(facts).sentence; };
  FlowFacts facts;
  facts.database_open = facts.patient_chosen = facts.hand_chosen = facts.screened = true;
  facts.device_chosen = facts.anything_arrived = true;
  facts.connection = Connection::open;
  facts.zero_refusal = session::words_of(
      session::ZeroRefusal{session::ZeroRefusal::Why::drift, Finger::index, 0.5, 0.3});
  const auto english = sentence(facts);
  const Spoken spoken(GetParam());
  const auto translated = QString::fromStdString(sentence(facts));
  EXPECT_NE(translated.toStdString(), english);
  EXPECT_TRUE(translated.contains("0,5 N/s")) << translated.toStdString();
  for (const char* word : {"zero", "sensor ", "Take", "hand out", "limit "})
    EXPECT_FALSE(translated.contains(word)) << translated.toStdString();
}

TEST_P(EachLanguage, WritesNumbersAndDatesOnTheScreenAndTakesThemBack) {
  const Spoken spoken(GetParam());
  const bool german = gui::spoken() == "de";
  const QString date = german ? "05.03.2026" : "05/03/2026";
  EXPECT_EQ(short_number(1.5), "1,50");
  Measure measure;
  measure.value = 1.25;
  measure.unit = "N";
  EXPECT_EQ(measure_value(measure), "1,25 N");
  EXPECT_EQ(translated_date("2026-03-05"), date);
  const Date today{std::chrono::year{2026}, std::chrono::month{6}, std::chrono::day{1}};
  for (const QString& typed : {date, QString("2026-03-05"), QString("5.3.2026")})
    EXPECT_EQ(iso_text(typed_date(typed, today, Ahead::refused).value.value_or(today)),
              "2026-03-05")
        << typed.toStdString();
  EXPECT_EQ(typed_score("31,5", *storage::clinical_scale("NHPT")).value, 31.5);
  EXPECT_EQ(score_words({0, "2026-03-05", "NHPT", 31.5, ""}), "31,5 s");
}

TEST_P(EachLanguage, ChangesNothingThatIsStored) {
  const Spoken spoken(GetParam());
  EXPECT_EQ(format_number(1.5), "1.5");
  PersonCard person;
  storage::PatientProfile known;
  known.onset_date = "2026-03-05";
  person.show_profile(known);
  EXPECT_EQ(person.findChild<QLineEdit*>("onset")->text(), translated_date("2026-03-05"));
  EXPECT_EQ(person.profile().onset_date, "2026-03-05");
  ScoreCard scores;
  std::optional<storage::ClinicalScore> added;
  QObject::connect(&scores, &ScoreCard::added,
                   [&](const storage::ClinicalScore& score) { added = score; });
  scores.findChild<QLineEdit*>("score_date")->setText(translated_date("2026-03-05"));
  scores.findChild<QLineEdit*>("score_value")->setText("31,5");
  scores.findChild<QPushButton*>("score_add")->click();
  ASSERT_TRUE(added.has_value());
  EXPECT_EQ(added->on_date, "2026-03-05");
  EXPECT_EQ(added->value, 31.5);
  EXPECT_EQ(local_date("not a time"), "not a time");
}

TEST_P(EachLanguage, HeadlinesOfThePatientStayLarge) {
  // Drawn as large as the English ones where they fit, and never so small that they cannot be read
  // from the bed.
  constexpr double kLeastShare = 0.5;  // of the size that a short headline has
  const QRectF screen(0, 0, 1280, 720);
  const double room =
      0.88 * screen.width();  // as gui/patient_screen/patient_canvas.cpp leaves for it
  const Spoken spoken(GetParam());
  const auto check = [&](const CueWords& words) {
    const auto measure = [&](const std::string& text, double share, bool bold) {
      const QFontMetricsF font(ink::font_of(screen, share, bold));
      return room / font.horizontalAdvance(QString::fromStdString(text));
    };
    EXPECT_GE(measure(words.headline, 0.115, true), kLeastShare) << words.headline;
    EXPECT_GE(measure(words.detail, 0.05, false), 1.0) << words.detail;
  };
  for (const Hand hand : {Hand::right, Hand::left})
    for (std::size_t d = 0; d < kDigitsCount; ++d)
      for (std::size_t way = 0; way < kDirectionCount; ++way)
        for (const Cue cue : {Cue::hand_out, Cue::relax, Cue::squeeze, Cue::press, Cue::follow,
                              Cue::reproduce, Cue::let_go, Cue::move})
          check(words_of(cue, {static_cast<Digits>(d), static_cast<Direction>(way)}, hand));
}

TEST_P(EachLanguage, SpeaksToThePatient) {
  PatientFacts facts;
  const auto english = picture_for(facts).headline;
  const Spoken spoken(GetParam());
  EXPECT_NE(picture_for(facts).headline, english);
  EXPECT_EQ(picture_for(facts).headline, gui::spoken() == "de" ? "Willkommen" : "Bienvenue");
}

TEST_F(QtTest, EnglishHasItsPluralsAndNothingElse) {
  for (const auto& message : every(messages_of("en"))) {
    EXPECT_EQ(message.words.size(), 2) << message.source.toStdString();
    for (const auto& words : every(message.words))
      EXPECT_TRUE(message.finished && !words.isEmpty());
  }
}

TEST_F(QtTest, AnUnknownLanguageIsThatOfTheDesktopAndEnglishComesBack) {
  const auto english = status_words(storage::TrialStatus::completed);
  {
    const Spoken spoken("de");
    EXPECT_NE(status_words(storage::TrialStatus::completed), english);
    speak("tlh");
    EXPECT_EQ(gui::spoken(), languages::desktop_language());
    speak("en");
    EXPECT_EQ(status_words(storage::TrialStatus::completed), english);
    EXPECT_EQ(translated_date("2026-03-05"), "2026-03-05")
        << "countries order day and month otherwise";
  }
  EXPECT_EQ(status_words(storage::TrialStatus::completed), english);
}

TEST_F(QtTest, WhatIsStoredInEnglishIsSaidAsAWholeOrWithItsValues) {
  const Spoken spoken("de");
  EXPECT_EQ(translated("Stopped by the therapist."), "Vom Therapeuten beendet.");
  EXPECT_EQ(translated("Wrist of 3.5 N"), "Wrist of 3.5 N") << "what is not known stays as it is";
  Measure measure;
  measure.reason = "not reached within 2.5 s";
  EXPECT_EQ(measure_remark(measure), "innerhalb von 2,5 s nicht erreicht");
  measure.reason = "there was no grip";
  EXPECT_EQ(measure_remark(measure), "es gab keinen Griff");
}

}  // namespace
}  // namespace isograsp::gui::test::translations_test
