// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/look.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QFont>
#include <QKeySequence>
#include <QPalette>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleFactory>
#include <QVariant>
#include <QWidget>
#include <utility>

namespace isograsp::gui {

namespace {

const char* const kStyleSheet = R"(
QMainWindow, QWidget#page { background: %BACKGROUND%; }
QFrame[card="true"] { background: %CARD%; border: 1px solid %RULE%; border-radius: 8px; }
QFrame#fault_card { background: %CARD%; border: 1px solid %FAULT%; border-radius: 8px;
  margin: 8px 16px 0px 16px; }
QFrame#header { background: %CARD%; border: none; }
QFrame#next_bar { background: %CARD%; border: none; border-top: 1px solid %GRID%;
  border-bottom: 1px solid %RULE%; }
QLabel { background: transparent; color: %TEXT%; }
QLabel[role="title"] { font-weight: bold; color: %TEXT%; }
QLabel[role="quiet"] { color: %QUIET%; }
QLabel[role="large"] { font-size: %LARGE%pt; }
QLabel[role="number"] { font-size: %NUMBER%pt; font-weight: bold; color: %ACCENT%; }
QLabel[role="problem"] { color: %FAULT%; }
QLabel#wordmark { font-weight: bold; font-size: %TITLE%pt; color: %ACCENT%; }
QLabel#sentence { font-size: %LARGE%pt; }
QLabel#simulated { background: %TEXT%; color: %CARD%; font-weight: bold; border-radius: 4px;
  padding: 5px 10px; }
QFrame#navigation { background: %CARD%; border: none; border-right: 1px solid %RULE%; }
QPushButton[tight="true"] { padding: 6px 2px; }
QPushButton[tab="true"] { background: transparent; border: none; border-radius: 6px;
  text-align: left; padding: 6px 10px; color: %TEXT%; }
QPushButton[tab="true"]:hover { background: %HOVER%; }
QPushButton[tab="true"]:checked { background: %CHOSEN%; border: none; color: #0A2E52;
  font-weight: bold; }
QPushButton[tab="true"]:focus { border: 2px solid %ACCENT%; }
QLabel#message { background: #FFF6E0; border: 1px solid #E0B252; border-radius: 6px;
  padding: 5px 10px; }
QFrame[section] { background: %CARD%; border: 1px solid %RULE%; border-radius: 8px; }
QFrame[section="next"] { border: 2px solid %ACCENT%; }
QPushButton[flat_head="true"] { background: transparent; border: none; border-radius: 7px;
  text-align: left; padding: 4px; }
QPushButton[flat_head="true"]:hover { background: %HOVER%; }
QPushButton[flat_head="true"]:focus { border: 2px solid %ACCENT%; }
QLabel[section] { border: none; background: transparent; }
QLabel[section="done"] { color: %READY%; font-weight: bold; }
QLabel[section="next"] { color: %ACCENT%; font-weight: bold; }
QLabel[section="open"] { color: %QUIET%; }
QListWidget[plain="true"] { border: none; }
QListWidget#patient_list, QListWidget#patient_list[next="choose"] { background: transparent;
  border: 1px solid transparent; }
QListWidget#patient_list::item { padding: 0px; }
QListWidget#patient_list:focus { border: 1px solid %ACCENT%; border-radius: 8px; }
QToolButton[score="true"] { background: %CARD%; color: %TEXT%; border: 1px solid %EDGE%;
  border-radius: 4px; padding: 3px 0; min-height: %LINE%px; }
QToolButton[score="true"]:hover { border-color: %ACCENT%; background: %HOVER%; }
QToolButton[score="true"]:checked { background: %ACCENT%; color: %CARD%; font-weight: bold; }
QToolButton[score="true"]:focus { border: 2px solid %ACCENT%; }
QTabWidget::pane { border: none; }
QTabBar { background: transparent; }
QTabBar::tab { background: transparent; color: %QUIET%; padding: 9px 16px 7px 16px; border: none;
  border-bottom: 2px solid transparent; margin-left: 8px; }
QTabBar::tab:selected { color: %ACCENT%; border-bottom: 2px solid %ACCENT%; }
QTabBar::tab:hover { color: %TEXT%; }
QTabBar::tab:focus { color: %ACCENT%; background: %CHOSEN%; }
QFrame[due="true"] { border: 2px solid %ACCENT%; }
QPushButton { background: %CARD%; color: %TEXT%; border: 1px solid %EDGE%; border-radius: 6px;
  padding: 6px 12px; min-height: %LINE%px; }
QPushButton:hover { border-color: %ACCENT%; background: %HOVER%; }
QPushButton:pressed { background: %CHOSEN%; }
QPushButton:checked { background: %CHOSEN%; border: 2px solid %ACCENT%; font-weight: bold; }
QPushButton:focus { border: 2px solid %ACCENT%; }
QPushButton:disabled { color: #7B8794; background: %BACKGROUND%; border-color: #DDE3EA; }
QPushButton[next="press"]:enabled, QPushButton[next="choose"]:enabled { color: %ACCENT%;
  border: 2px solid %ACCENT%; padding: 5px 11px; font-weight: bold; }
QPushButton#next_thing:enabled, QPushButton[main="yes"]:enabled { background: %ACCENT%;
  color: %CARD%; border-color: %ACCENT%; font-weight: bold; }
QPushButton#next_thing { font-size: %LARGE%pt; padding: 6px 20px; }
QPushButton#next_thing, QPushButton#stop { min-height: %TOUCH%px; }
QPushButton#next_thing:enabled:hover, QPushButton[main="yes"]:enabled:hover { background: #094C90; }
QPushButton#next_thing:enabled:focus, QPushButton[main="yes"]:enabled:focus {
  border: 2px solid #062F59; }
QPushButton#stop:enabled { color: %FAULT%; border-color: %FAULT%; font-weight: bold; }
QPushButton#stop:enabled:hover { background: #FCEEED; }
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QPlainTextEdit { background: %CARD%; border: 1px solid %EDGE%;
  border-radius: 6px; padding: 5px 8px; min-height: %LINE%px; selection-background-color: %ACCENT%; }
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border: 2px solid %ACCENT%; padding: 4px 7px; }
QPlainTextEdit { padding: 3px 4px; }
QPlainTextEdit:focus { border: 2px solid %ACCENT%; padding: 2px 3px; }
QComboBox:disabled, QLineEdit:disabled, QPlainTextEdit:disabled { color: #7B8794; background: %BACKGROUND%;
  border-color: #DDE3EA; }
QComboBox::drop-down { border: none; width: %ARROW%px; }
QComboBox QAbstractItemView { background: %CARD%; color: %TEXT%; border: 1px solid %EDGE%;
  selection-background-color: %CHOSEN%; selection-color: %TEXT%; }
QListWidget, QTableWidget { background: %CARD%; color: %TEXT%; border: 1px solid %DESK%;
  border-radius: 6px; outline: none; gridline-color: %GRID%; }
QListWidget:focus, QTableWidget:focus { border: 1px solid %ACCENT%; }
QListWidget[next="choose"] { border: 2px solid %ACCENT%; }
QListWidget::item { padding: 2px 8px; border-radius: 4px; }
QListWidget::item:hover { background: %HOVER%; }
QListWidget::item:selected { background: %CHOSEN%; color: #0A2E52; font-weight: bold; }
QListWidget:disabled { color: #7B8794; }
QListWidget::item:selected:disabled { background: %GRID%; color: #3E4C59; }
QTableWidget::item { padding: 3px 6px; border: none; }
QTableWidget::item:selected { background: %CHOSEN%; color: %TEXT%; }
QHeaderView::section { background: %CARD%; color: %QUIET%; border: none;
  border-bottom: 1px solid %RULE%; padding: 4px 6px; font-weight: normal; }
QProgressBar { background: %TRACK%; border: none; border-radius: 5px; max-height: %BAR%px;
  min-height: %BAR%px; color: transparent; }
QProgressBar::chunk { background: %ACCENT%; border-radius: 5px; }
QCheckBox { color: %TEXT%; spacing: 8px; padding: 2px; border: 1px solid transparent;
  border-radius: 4px; }
QCheckBox:focus { border-color: %ACCENT%; }
QFrame[confirm="true"] { background: #FFF6E0; border: 1px solid #E0B252; border-radius: 6px; }
QToolTip { background: %TEXT%; color: %CARD%; border: none; padding: 5px; }
QScrollBar:vertical { background: transparent; width: %BAR%px; margin: 0; }
QScrollBar::handle:vertical { background: #C3CCD6; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
)";

/// The colours of look.hpp by their names in the style sheet.
QString coloured(QString sheet) {
  const std::pair<const char*, QColor> colours[] = {
      {"%CARD%", look::kCard},       {"%BACKGROUND%", look::kBackground},
      {"%RULE%", look::kLine},       {"%EDGE%", look::kEdge},
      {"%GRID%", look::kGrid},       {"%TRACK%", look::kTrack},
      {"%DESK%", look::kDesk},       {"%HOVER%", look::kHover},
      {"%CHOSEN%", look::kChosen},   {"%TEXT%", look::kText},
      {"%QUIET%", look::kQuietText}, {"%ACCENT%", look::kAccent},
      {"%READY%", look::kReady},     {"%FAULT%", look::kFault}};
  for (const auto& [name, colour] : colours) sheet.replace(QLatin1String(name), colour.name());
  return sheet;
}

constexpr double kText_pt = 9.5;
constexpr double kLarge_pt = 13.0;
constexpr double kTitle_pt = 15.0;
constexpr double kNumber_pt = 26.0;
constexpr int kLine_px = 18;       // of a button or a field
constexpr int kTouch_px = 44;      // what a finger hits without looking
constexpr int kBarAround_px = 14;  // of it: padding and border of the bar's buttons
constexpr int kArrow_px = 22;
constexpr int kBar_px = 10;
constexpr int kChoices_px = 264;
constexpr int kMostSideBySide_percent = 130;
int letters_percent = 100;

/// Check marks grow with the letters beside them, so that both can be seen equally well.
class GrowingSigns final : public QProxyStyle {
 public:
  GrowingSigns() : QProxyStyle(QStyleFactory::create("Fusion")) {}
  int pixelMetric(PixelMetric metric, const QStyleOption* option,
                  const QWidget* widget) const override {
    const int usual_px = QProxyStyle::pixelMetric(metric, option, widget);
    switch (metric) {
      case PM_IndicatorWidth:
      case PM_IndicatorHeight:
      case PM_ExclusiveIndicatorWidth:
      case PM_ExclusiveIndicatorHeight:
      case PM_SliderLength:
      case PM_SliderThickness:
      case PM_SliderControlThickness:
      case PM_SmallIconSize:
      case PM_ButtonIconSize: return scaled(usual_px);
      default: return usual_px;
    }
  }
};

void dress_as(QWidget& widget, const char* role, const char* value) {
  if (widget.property(role).toString() == QLatin1String(value)) return;
  widget.setProperty(role, value);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

}  // namespace

QString finger_title(Finger finger) {
  switch (finger) {
    case Finger::thumb: return QObject::tr("Thumb");
    case Finger::index: return QObject::tr("Index");
    case Finger::middle: return QObject::tr("Middle");
  }
  return {};
}

void dress(QApplication& application, int font_percent) {
  letters_percent = font_percent;
  const double larger = font_percent / 100.0;
  application.setStyle(new GrowingSigns);
  QFont font("DejaVu Sans");
  font.setPointSizeF(kText_pt * larger);
  application.setFont(font);
  QPalette palette;
  palette.setColor(QPalette::Window, look::kBackground);
  palette.setColor(QPalette::WindowText, look::kText);
  palette.setColor(QPalette::Base, look::kCard);
  palette.setColor(QPalette::Text, look::kText);
  palette.setColor(QPalette::Button, look::kCard);
  palette.setColor(QPalette::ButtonText, look::kText);
  palette.setColor(QPalette::Highlight, look::kAccent);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::PlaceholderText, look::kQuietText);
  application.setPalette(palette);
  application.setStyleSheet(coloured(kStyleSheet)
                                .replace("%TOUCH%", QString::number(kTouch_px - kBarAround_px))
                                .replace("%LINE%", QString::number(scaled(kLine_px)))
                                .replace("%ARROW%", QString::number(scaled(kArrow_px)))
                                .replace("%BAR%", QString::number(scaled(kBar_px)))
                                .replace("%LARGE%", QString::number(kLarge_pt * larger))
                                .replace("%NUMBER%", QString::number(kNumber_pt * larger))
                                .replace("%TITLE%", QString::number(kTitle_pt * larger)));
}

int scaled(int usual_px) noexcept {
  return usual_px * letters_percent / 100;
}

QBoxLayout::Direction side_by_side() noexcept {
  return letters_percent <= kMostSideBySide_percent ? QBoxLayout::LeftToRight
                                                    : QBoxLayout::TopToBottom;
}

void lay_out_choices(QWidget& page, QWidget& choices, QWidget& body) {
  auto* row = new QBoxLayout(side_by_side(), &page);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  if (row->direction() == QBoxLayout::LeftToRight) choices.setFixedWidth(scaled(kChoices_px));
  row->addWidget(&choices);
  row->addWidget(&body, 1);
}

void show_part(QWidget& part, bool shown) {
  // What stands nowhere yet would become a window.
  if (part.parentWidget() != nullptr || !shown) part.setVisible(shown);
}

void mark_next(QWidget& button, bool next) {
  dress_as(button, "next", next ? "press" : "");
}

void mark_choice(QWidget& answer, bool next) {
  dress_as(answer, "next", next ? "choose" : "");
}

bool is_choice(const QWidget& marked) {
  return marked.property("next").toString() == QLatin1String("choose");
}

void may_fold(QWidget& part) {
  part.setProperty("folds", true);
}

QWidget* marked_next(QWidget& page) {
  const auto can_be_used = [&page](const QWidget& widget) {
    for (const QWidget* part = &widget; part != &page; part = part->parentWidget())
      if (part->isHidden() && !part->property("folds").toBool()) return false;
    return widget.isEnabled();
  };
  for (auto* widget : page.findChildren<QWidget*>())
    if (!widget->property("next").toString().isEmpty() && can_be_used(*widget)) return widget;
  return nullptr;
}

void mark_main(QWidget& button, bool main) {
  dress_as(button, "main", main ? "yes" : "");
}

void take_rest(QWidget& widget, int least_px) {
  widget.setMinimumHeight(scaled(least_px));
  widget.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
}

void describe(QWidget& widget, const QString& name, const QString& tooltip) {
  QString words = tooltip;
  if (const auto* button = qobject_cast<QAbstractButton*>(&widget)) {
    static const QRegularExpression kAltLetter(QStringLiteral("Alt\\+[A-Z]\\b"));
    const auto key = QKeySequence::mnemonic(button->text());
    if (!key.isEmpty()) words.replace(kAltLetter, key.toString(QKeySequence::PortableText));
  }
  widget.setAccessibleName(name);
  widget.setToolTip(words);
  widget.setAccessibleDescription(words);
}

}  // namespace isograsp::gui
