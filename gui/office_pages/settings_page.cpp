// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/office_pages/settings_page.hpp"

#include <QFormLayout>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QScreen>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/office_pages/records_card.hpp"

namespace isograsp::gui {

namespace {

constexpr double kCm = 100.0;   // in a metre
constexpr double kMs = 1000.0;  // in a second
constexpr int kFontSteps_percent[] = {100, 115, 130, 150, 175, 200};
/// A spin box shows its special words at its least value, one step below the range.
constexpr double kNotSet = -1.0;

QLabel* remark(const QString& words) {
  auto* label = new QLabel(words);
  label->setWordWrap(true);
  label->setProperty("role", "quiet");
  return label;
}

QFormLayout* form_in(Card& card) {
  auto* form = new QFormLayout;
  form->setLabelAlignment(Qt::AlignLeft);
  form->setHorizontalSpacing(18);
  form->setVerticalSpacing(8);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  card.column().addLayout(form);
  return form;
}

template <class Widget>
Widget* field(const char* object_name, const QString& name, const QString& tooltip) {
  auto* made = new Widget;
  made->setObjectName(object_name);
  describe(*made, name, tooltip);
  return made;
}

void add_row(QFormLayout& form, const QString& words, QWidget* field) {
  auto* label = new QLabel(words);
  label->setBuddy(field);
  form.addRow(label, field);
}

}  // namespace

SettingsPage::SettingsPage(SettingsFile& settings, const Staff& staff, QWidget* parent)
    : QWidget(parent), settings_(settings) {
  const bool wide = side_by_side() == QBoxLayout::LeftToRight;
  auto* columns = new QBoxLayout(side_by_side(), this);
  columns->setContentsMargins(12, 12, 12, 12);
  columns->setSpacing(12);
  const auto add_column = [&](std::initializer_list<QWidget*> cards) {
    auto* column = new QVBoxLayout;
    column->setSpacing(12);
    for (auto* card : cards) column->addWidget(card);
    column->addStretch(1);
    columns->addLayout(column, wide ? 1 : 0);
  };
  auto* window = make_window_card();
  auto* screen = make_screen_card();
  add_column({window, make_sound_card()});
  add_column({screen, new RecordsCard(staff)});
  if (!wide) columns->addStretch(1);
  connect(&settings_, &SettingsFile::changed, this, &SettingsPage::refresh);
  connect(qApp, &QGuiApplication::screenAdded, this, &SettingsPage::fill_screens);
  connect(qApp, &QGuiApplication::screenRemoved, this, &SettingsPage::fill_screens);
  fill_screens();
  refresh();
}

QWidget* SettingsPage::make_window_card() {
  auto* card = new Card(tr("This window"));
  auto* form = form_in(*card);
  language_ = field<ChoiceBox>("settings_language", tr("Language"),
                               tr("Of both windows; takes effect at once (Alt+L)"));
  language_->addItem(tr("As the desktop"), QString(languages::kDesktopLanguage));
  for (const auto& language : languages::kLanguages)
    language_->addItem(QString(language.name), QString(language.code));
  add_row(*form, tr("&Language"), language_);
  operator_ = field<QLineEdit>(
      "settings_operator", tr("Operator"),
      tr("Who works here; stored with sessions, zeros and resting forces. In a protected database "
         "it is whoever logs in (Alt+O)"));
  add_row(*form, tr("&Operator"), operator_);
  letters_ = field<ChoiceBox>("settings_letters", tr("Size of letters"),
                              tr("Of this window; the patient's are always large (Alt+S)"));
  for (const int percent : kFontSteps_percent)
    letters_->addItem(tr("%1 %").arg(QLocale().toString(percent)), percent);
  add_row(*form, tr("&Size of letters"), letters_);
  forces_ = field<ChoiceBox>(
      "settings_forces", tr("Live forces"),
      tr("How the live grip is shown; newtons are what is stored and reported (Alt+R)"));
  forces_->addItem(tr("in newtons"), false);
  forces_->addItem(tr("in newtons and in % of today's maximum"), true);
  add_row(*form, tr("Live fo&rces"), forces_);
  card->column().addWidget(remark(tr("The hand is no setting: it is asked for in every session.")));
  const auto chosen = QOverload<int>::of(&QComboBox::activated);
  connect(language_, chosen, this, [this] {
    change([&](Settings& s) { s.language = language_->currentData().toString().toStdString(); });
  });
  connect(operator_, &QLineEdit::editingFinished, this, [this] {
    change([&](Settings& s) { s.operator_name = operator_->text().trimmed().toStdString(); });
  });
  connect(letters_, chosen, this, [this] {
    change([&](Settings& s) { s.font_percent = letters_->currentData().toInt(); });
  });
  connect(forces_, chosen, this, [this] {
    change([&](Settings& s) { s.share_of_maximum = forces_->currentData().toBool(); });
  });
  return card;
}

QWidget* SettingsPage::make_screen_card() {
  auto* card = new Card(tr("The patient's screen"));
  auto* form = form_in(*card);
  screen_ = field<ChoiceBox>("settings_screen", tr("Display"),
                             tr("Where the patient's screen is shown (Alt+D)"));
  add_row(*form, tr("&Display"), screen_);
  distance_cm_ = field<QSpinBox>(
      "settings_distance", tr("Distance of the eyes"),
      tr("From the patient's eyes to the screen; with the height of the picture it makes visual "
         "angles true (Alt+E)"));
  distance_cm_->setRange(static_cast<int>(std::lround(limits::kNearest_m * kCm)),
                         static_cast<int>(std::lround(limits::kFarthest_m * kCm)));
  distance_cm_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  distance_cm_->setKeyboardTracking(false);
  distance_cm_->setSuffix(tr(" cm"));
  add_row(*form, tr("Distance of the &eyes"), distance_cm_);
  height_cm_ = field<QDoubleSpinBox>(
      "settings_height", tr("Height of the picture"),
      tr("Measured with a ruler on the patient's display, edge to edge (Alt+H)"));
  height_cm_->setDecimals(1);
  height_cm_->setRange(kNotSet, limits::kHighestScreen_m * kCm);
  height_cm_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  height_cm_->setKeyboardTracking(false);
  height_cm_->setSuffix(tr(" cm"));
  add_row(*form, tr("&Height of the picture"), height_cm_);
  delay_ms_ = field<QDoubleSpinBox>(
      "settings_delay", tr("Delay of the display"),
      tr("From the program to the light, measured with a photodiode or a camera; stored with every "
         "session (Alt+Y)"));
  delay_ms_->setDecimals(1);
  delay_ms_->setRange(kNotSet, limits::kLongestDelay_s * kMs);
  delay_ms_->setSpecialValueText(tr("not measured"));
  delay_ms_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  delay_ms_->setKeyboardTracking(false);
  delay_ms_->setSuffix(tr(" ms"));
  add_row(*form, tr("Dela&y of the display"), delay_ms_);
  card->column().addWidget(
      remark(tr("Which half of the screen a patient sees, less motion, sounds and voice are chosen "
                "for each patient, in the first step of a session.")));
  connect(screen_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    change(
        [&](Settings& s) { s.patient_screen = screen_->currentData().toString().toStdString(); });
  });
  connect(distance_cm_, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int cm) { change([&](Settings& s) { s.viewing_distance_m = cm / kCm; }); });
  connect(height_cm_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double cm) {
            change([&](Settings& s) {
              s.screen_height_m.reset();
              if (cm / kCm >= limits::kLowestScreen_m) s.screen_height_m = cm / kCm;
            });
          });
  connect(delay_ms_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double ms) {
    change([&](Settings& s) {
      s.display_delay_s.reset();
      if (ms >= 0.0) s.display_delay_s = ms / kMs;
    });
  });
  return card;
}

QWidget* SettingsPage::make_sound_card() {
  auto* card = new Card(tr("Sound"));
  auto* form = form_in(*card);
  volume_ = field<QSlider>("settings_volume", tr("Loudness"),
                           tr("Of tones and voice (Alt+U, then arrow keys)"));
  volume_->setOrientation(Qt::Horizontal);
  volume_->setRange(0, 100);
  volume_->setPageStep(10);
  add_row(*form, tr("Lo&udness"), volume_);
  try_sound_ = field<QPushButton>("settings_try_sound", tr("Try the sound"),
                                  tr("Plays the tone of success (Alt+T)"));
  try_sound_->setText(tr("&Try the sound"));
  try_voice_ = field<QPushButton>("settings_try_voice", tr("Try the voice"),
                                  tr("Speaks an instruction (Alt+V)"));
  try_voice_->setText(tr("Try the &voice"));
  auto* tries = new QHBoxLayout;
  tries->addWidget(try_sound_);
  tries->addWidget(try_voice_);
  tries->addStretch(1);
  card->column().addLayout(tries);
  sound_words_ = remark({});
  sound_words_->setObjectName("settings_sound_words");
  sound_words_->hide();
  card->column().addWidget(sound_words_);
  connect(volume_, &QSlider::valueChanged, this,
          [this](int percent) { change([&](Settings& s) { s.volume_percent = percent; }); });
  const auto answer = [this](const QString& why_not) {
    sound_words_->setText(why_not);
    sound_words_->setVisible(!why_not.isEmpty());
  };
  connect(try_sound_, &QPushButton::clicked, this, [this, answer] {
    speaker_.set_volume(settings_.now().volume_percent);
    answer(speaker_.play(Tone::success));
  });
  connect(try_voice_, &QPushButton::clicked, this, [this, answer] {
    speaker_.set_volume(settings_.now().volume_percent);
    answer(speaker_.speak(tr("Squeeze with thumb and fingers")));
  });
  return card;
}

void SettingsPage::fill_screens() {
  const QSignalBlocker quiet(screen_);
  screen_->clear();
  screen_->addItem(tr("The second one, if there is one"), QString());
  for (const auto* one : QGuiApplication::screens())
    screen_->addItem(
        tr("%1 (%2 × %3)").arg(one->name()).arg(one->size().width()).arg(one->size().height()),
        one->name());
  const auto chosen = QString::fromStdString(settings_.now().patient_screen);
  if (screen_->findData(chosen) < 0)
    screen_->addItem(tr("%1 (not connected now)").arg(chosen), chosen);
  screen_->setCurrentIndex(screen_->findData(chosen));
  const auto screens = QGuiApplication::screens();
  const QScreen* shown = screens.size() > 1 ? screens[1] : screens[0];
  for (const auto* one : screens)
    if (one->name() == chosen) shown = one;
  height_cm_->setSpecialValueText(
      tr("as the display tells: %1 cm")
          .arg(QLocale().toString(shown->physicalSize().height() / 10.0, 'f', 1)));
}

void SettingsPage::change(const std::function<void(Settings&)>& edit) {
  Settings settings = settings_.now();
  edit(settings);
  settings_.change(settings);
}

void SettingsPage::refresh() {
  const Settings& now = settings_.now();
  const QSignalBlocker quiet[] = {QSignalBlocker(distance_cm_), QSignalBlocker(height_cm_),
                                  QSignalBlocker(delay_ms_), QSignalBlocker(volume_)};
  language_->setCurrentIndex(
      std::max(0, language_->findData(QString::fromStdString(now.language))));
  if (letters_->findData(now.font_percent) < 0)
    letters_->addItem(tr("%1 %").arg(QLocale().toString(now.font_percent)), now.font_percent);
  letters_->setCurrentIndex(letters_->findData(now.font_percent));
  operator_->setText(QString::fromStdString(now.operator_name));
  forces_->setCurrentIndex(now.share_of_maximum ? 1 : 0);
  distance_cm_->setValue(static_cast<int>(std::lround(now.viewing_distance_m * kCm)));
  height_cm_->setValue(now.screen_height_m ? *now.screen_height_m * kCm : kNotSet);
  delay_ms_->setValue(now.display_delay_s ? *now.display_delay_s * kMs : kNotSet);
  volume_->setValue(now.volume_percent);
}

}  // namespace isograsp::gui
