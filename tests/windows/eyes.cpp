// SPDX-License-Identifier: GPL-3.0-or-later
// Eyes on the windows of a program that knows nothing of them: a plugin that Qt loads where
// QT_QPA_GENERIC_PLUGINS names it. It tells where widgets are and what stands on them; who asks
// moves a real mouse and presses real keys. One question a line on the descriptor that
// ISOGRASP_EYES names, one answer a line.
//   widget NAME     rectangle and state of the visible widget that is called so
//   item NAME TEXT  … of the first item that contains the text, in a list, a table or an open
//   choice
//   windows         how many windows are visible
//   seen            the texts of all visible labels, one line
//   points RRGGBB   how many points of that colour the patient's window has
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QColor>
#include <QComboBox>
#include <QGenericPlugin>
#include <QLabel>
#include <QPixmap>
#include <QScreen>
#include <QScrollArea>
#include <QSocketNotifier>
#include <QString>
#include <QWindow>
#include <cstdlib>

#include <unistd.h>

namespace isograsp::test {

class Eyes final : public QObject {
 public:
  explicit Eyes(int descriptor)
      : descriptor_(descriptor), asked_(descriptor, QSocketNotifier::Read) {
    QObject::connect(&asked_, &QSocketNotifier::activated, this, [this] { read(); });
  }

 private:
  void read() {
    char buffer[4096];
    const auto count = ::read(descriptor_, buffer, sizeof buffer);
    if (count <= 0) return asked_.setEnabled(false);
    text_.append(buffer, static_cast<int>(count));
    for (int end = text_.indexOf('\n'); end >= 0; end = text_.indexOf('\n')) {
      const auto answer = answer_to(QString::fromUtf8(text_.left(end))).toUtf8() + '\n';
      text_.remove(0, end + 1);
      if (::write(descriptor_, answer.constData(), static_cast<std::size_t>(answer.size())) < 0)
        return asked_.setEnabled(false);
    }
  }

  [[nodiscard]] static QString answer_to(const QString& question) {
    const auto verb = question.section(' ', 0, 0);
    const auto name = question.section(' ', 1, 1);
    if (verb == "widget") return widget(name);
    if (verb == "item") return item(name, question.section(' ', 2));
    if (verb == "windows") return QString::number(windows());
    if (verb == "seen") return seen();
    if (verb == "points") return QString::number(points(QColor("#" + name)));
    return QStringLiteral("unknown question");
  }

  /// A dialog before what stands behind it.
  [[nodiscard]] static QList<QWidget*> tops() {
    auto all = QApplication::topLevelWidgets();
    if (auto* modal = QApplication::activeModalWidget()) {
      all.removeAll(modal);
      all.prepend(modal);
    }
    return all;
  }
  [[nodiscard]] static int windows() {
    int count = 0;
    for (const auto* top : tops()) count += top->isVisible() && top->isWindow();
    return count;
  }
  [[nodiscard]] static QWidget* find(const QString& name) {
    QWidget* hidden = nullptr;
    for (auto* top : tops()) {
      if (!top->isVisible()) continue;
      for (auto* found : top->findChildren<QWidget*>(name)) {
        if (found->isVisible()) return found;
        hidden = found;
      }
    }
    return hidden;
  }

  [[nodiscard]] static QString line(const QWidget& widget, const QRect& part, bool enabled,
                                    const QString& text) {
    const QPoint corner = widget.mapToGlobal(part.topLeft());
    return QStringLiteral("%1 %2 %3 %4 %5 %6 %7")
        .arg(corner.x())
        .arg(corner.y())
        .arg(part.width())
        .arg(part.height())
        .arg(widget.isVisible() ? 1 : 0)
        .arg(enabled && is_in_front(widget) ? 1 : 0)
        .arg(QString(text).replace('\n', ' '));
  }
  /// A window that the manager has not placed yet would be missed by the mouse.
  [[nodiscard]] static bool is_in_front(const QWidget& widget) {
    const auto* window = widget.window();
    return window->isActiveWindow() || window->windowType() == Qt::Popup;
  }
  [[nodiscard]] static QString words_on(const QWidget& widget) {
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
    if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) return choice->currentText();
    return {};
  }

  /// What has been scrolled away is scrolled back, as a hand would do that looks for it.
  [[nodiscard]] static QString widget(const QString& name) {
    auto* found = find(name);
    if (found == nullptr) return QStringLiteral("absent");
    for (auto* above = found->parentWidget(); above != nullptr; above = above->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(found);
    return line(*found, found->rect(), found->isEnabled(), words_on(*found));
  }
  [[nodiscard]] static QString item(const QString& name, const QString& text) {
    auto* found = find(name);
    auto* view = qobject_cast<QAbstractItemView*>(found);
    if (auto* choice = qobject_cast<QComboBox*>(found)) view = choice->view();
    if (view == nullptr) return QStringLiteral("absent");
    const auto* model = view->model();
    for (int row = 0; row < model->rowCount(); ++row) {
      const auto index = model->index(row, 0);
      if (!index.data().toString().contains(text)) continue;
      view->scrollTo(index);
      return line(*view->viewport(), view->visualRect(index),
                  (index.flags() & Qt::ItemIsEnabled) != 0, index.data().toString());
    }
    return QStringLiteral("absent");
  }
  [[nodiscard]] static QString seen() {
    QStringList words;
    for (const auto* top : tops())
      if (top->isVisible())
        for (const auto* label : top->findChildren<QLabel*>())
          if (label->isVisible() && !label->text().isEmpty()) words += label->text();
    return words.join(QStringLiteral(" | ")).replace('\n', ' ');
  }

  /// Of the window that no widget makes: the patient's, as the X server shows it.
  [[nodiscard]] static int points(const QColor& colour) {
    int count = 0;
    for (auto* window : QGuiApplication::topLevelWindows()) {
      if (!window->isVisible() || !window->inherits("QPaintDeviceWindow")) continue;
      const auto picture = window->screen()->grabWindow(window->winId()).toImage();
      for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) count += picture.pixelColor(x, y) == colour;
    }
    return count;
  }

  int descriptor_;
  QSocketNotifier asked_;
  QByteArray text_;
};

class EyesPlugin final : public QGenericPlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID QGenericPluginFactoryInterface_iid FILE "eyes.json")

 public:
  QObject* create(const QString&, const QString&) override {
    const char* descriptor = std::getenv("ISOGRASP_EYES");
    return descriptor == nullptr ? nullptr : new Eyes(std::atoi(descriptor));
  }
};

}  // namespace isograsp::test

#include "eyes.moc"
