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

namespace isograsp::gui {

namespace {

const char* const kStyleSheet = R"(
QMainWindow, QWidget#page { background: #F3F5F8; }
QFrame[card="true"] { background: #FFFFFF; border: 1px solid #D5DBE3; border-radius: 8px; }
QFrame#header { background: #FFFFFF; border: none; border-bottom: 1px solid #D5DBE3; }
QLabel { background: transparent; color: #1B2733; }
QLabel[role="title"] { font-weight: bold; color: #1B2733; }
QLabel[role="quiet"] { color: #52606D; }
QLabel[role="large"] { font-size: %LARGE%pt; }
QLabel[role="problem"] { color: #B3261E; }
QLabel#wordmark { font-weight: bold; font-size: %TITLE%pt; color: #0B5CAD; }
QLabel#sentence { font-size: %LARGE%pt; }
QLabel#simulated { background: #1B2733; color: #FFFFFF; font-weight: bold; border-radius: 4px;
  padding: 5px 10px; }
QFrame#navigation { background: #FFFFFF; border: none; border-right: 1px solid #D5DBE3; }
QPushButton[tight="true"] { padding: 6px 2px; }
QPushButton[tab="true"] { background: transparent; border: none; border-radius: 6px;
  text-align: left; padding: 6px 10px; color: #1B2733; }
QPushButton[tab="true"]:hover { background: #F4F9FE; }
QPushButton[tab="true"]:checked { background: #E1EEFA; border: none; color: #0A2E52;
  font-weight: bold; }
QPushButton[tab="true"]:focus { border: 2px solid #0B5CAD; }
QLabel#message { background: #FFF6E0; border: 1px solid #E0B252; border-radius: 6px;
  padding: 5px 10px; }
QFrame[section] { background: #FFFFFF; border: 1px solid #D5DBE3; border-radius: 8px; }
QFrame[section="next"] { border: 2px solid #0B5CAD; }
QPushButton[flat_head="true"] { background: transparent; border: none; border-radius: 7px;
  text-align: left; padding: 4px; }
QPushButton[flat_head="true"]:hover { background: #F4F9FE; }
QPushButton[flat_head="true"]:focus { border: 2px solid #0B5CAD; }
QLabel[section] { border: none; background: transparent; }
QLabel[section="done"] { color: #1B7F4B; font-weight: bold; }
QLabel[section="next"] { color: #0B5CAD; font-weight: bold; }
QLabel[section="open"] { color: #52606D; }
QListWidget[plain="true"] { border: none; }
QToolButton[score="true"] { background: #FFFFFF; color: #1B2733; border: 1px solid #A9B4C0;
  border-radius: 4px; padding: 3px 0; min-height: %LINE%px; }
QToolButton[score="true"]:hover { border-color: #0B5CAD; background: #F4F9FE; }
QToolButton[score="true"]:checked { background: #0B5CAD; color: #FFFFFF; font-weight: bold; }
QToolButton[score="true"]:focus { border: 2px solid #0B5CAD; }
QTabWidget::pane { border: none; }
QTabBar { background: transparent; }
QTabBar::tab { background: transparent; color: #52606D; padding: 9px 16px 7px 16px; border: none;
  border-bottom: 2px solid transparent; margin-left: 8px; }
QTabBar::tab:selected { color: #0B5CAD; border-bottom: 2px solid #0B5CAD; }
QTabBar::tab:hover { color: #1B2733; }
QTabBar::tab:focus { color: #0B5CAD; background: #E1EEFA; }
QFrame[due="true"] { border: 2px solid #0B5CAD; }
QPushButton { background: #FFFFFF; color: #1B2733; border: 1px solid #A9B4C0; border-radius: 6px;
  padding: 6px 12px; min-height: %LINE%px; }
QPushButton:hover { border-color: #0B5CAD; background: #F4F9FE; }
QPushButton:pressed { background: #E1EEFA; }
QPushButton:checked { background: #E1EEFA; border: 2px solid #0B5CAD; font-weight: bold; }
QPushButton:focus { border: 2px solid #0B5CAD; }
QPushButton:disabled { color: #7B8794; background: #F3F5F8; border-color: #DDE3EA; }
QPushButton[next="true"]:enabled { background: #0B5CAD; color: #FFFFFF; border-color: #0B5CAD;
  font-weight: bold; }
QPushButton[next="true"]:enabled:hover { background: #094C90; }
QPushButton[next="true"]:enabled:focus { border: 2px solid #062F59; }
QPushButton#stop:enabled { color: #B3261E; border-color: #B3261E; font-weight: bold; }
QPushButton#stop:enabled:hover { background: #FCEEED; }
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QPlainTextEdit { background: #FFFFFF; border: 1px solid #A9B4C0;
  border-radius: 6px; padding: 5px 8px; min-height: %LINE%px; selection-background-color: #0B5CAD; }
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus { border: 2px solid #0B5CAD; padding: 4px 7px; }
QPlainTextEdit { padding: 3px 4px; }
QPlainTextEdit:focus { border: 2px solid #0B5CAD; padding: 2px 3px; }
QComboBox:disabled, QLineEdit:disabled, QPlainTextEdit:disabled { color: #7B8794; background: #F3F5F8;
  border-color: #DDE3EA; }
QComboBox::drop-down { border: none; width: %ARROW%px; }
QComboBox QAbstractItemView { background: #FFFFFF; color: #1B2733; border: 1px solid #A9B4C0;
  selection-background-color: #E1EEFA; selection-color: #1B2733; }
QListWidget, QTableWidget { background: #FFFFFF; color: #1B2733; border: 1px solid #E3E8EE;
  border-radius: 6px; outline: none; gridline-color: #EBEFF3; }
QListWidget:focus, QTableWidget:focus { border: 1px solid #0B5CAD; }
QListWidget[next="true"] { border: 2px solid #0B5CAD; }
QListWidget::item { padding: 2px 8px; border-radius: 4px; }
QListWidget::item:hover { background: #F4F9FE; }
QListWidget::item:selected { background: #E1EEFA; color: #0A2E52; font-weight: bold; }
QListWidget:disabled { color: #7B8794; }
QListWidget::item:selected:disabled { background: #EBEFF3; color: #3E4C59; }
QTableWidget::item { padding: 3px 6px; border: none; }
QTableWidget::item:selected { background: #E1EEFA; color: #1B2733; }
QHeaderView::section { background: #FFFFFF; color: #52606D; border: none;
  border-bottom: 1px solid #D5DBE3; padding: 4px 6px; font-weight: normal; }
QProgressBar { background: #E6EAEF; border: none; border-radius: 5px; max-height: %BAR%px;
  min-height: %BAR%px; color: transparent; }
QProgressBar::chunk { background: #0B5CAD; border-radius: 5px; }
QCheckBox { color: #1B2733; spacing: 8px; padding: 2px; border: 1px solid transparent;
  border-radius: 4px; }
QCheckBox:focus { border-color: #0B5CAD; }
QFrame[confirm="true"] { background: #FFF6E0; border: 1px solid #E0B252; border-radius: 6px; }
QToolTip { background: #1B2733; color: #FFFFFF; border: none; padding: 5px; }
QScrollBar:vertical { background: transparent; width: %BAR%px; margin: 0; }
QScrollBar::handle:vertical { background: #C3CCD6; border-radius: 4px; min-height: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
)";

constexpr double kText_pt = 9.5;
constexpr double kLarge_pt = 13.0;
constexpr double kTitle_pt = 15.0;
constexpr int kLine_px = 18;  // of a button or a field
constexpr int kArrow_px = 22;
constexpr int kBar_px = 10;
constexpr int kMostSideBySide_percent = 130;
int letters_percent = 100;

/// Signs grow with the letters beside them: what is ticked is to be seen as well as read.
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
  application.setStyleSheet(QString(kStyleSheet)
                                .replace("%LINE%", QString::number(scaled(kLine_px)))
                                .replace("%ARROW%", QString::number(scaled(kArrow_px)))
                                .replace("%BAR%", QString::number(scaled(kBar_px)))
                                .replace("%LARGE%", QString::number(kLarge_pt * larger))
                                .replace("%TITLE%", QString::number(kTitle_pt * larger)));
}

int scaled(int usual_px) noexcept {
  return usual_px * letters_percent / 100;
}

QBoxLayout::Direction side_by_side() noexcept {
  return letters_percent <= kMostSideBySide_percent ? QBoxLayout::LeftToRight
                                                    : QBoxLayout::TopToBottom;
}

void mark_next(QWidget& widget, bool next) {
  if (widget.property("next").toBool() == next) return;
  widget.setProperty("next", next);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
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
