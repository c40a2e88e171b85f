// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/trial_view.hpp"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QShortcut>
#include <QSignalBlocker>
#include <cmath>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/patient_screen/patient_window.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "hand/columns.hpp"

namespace isograsp::gui {

namespace {
constexpr int kFrame_ms = 33;       // of the replay on the screen
constexpr double kSlider_Hz = 1e3;  // steps of the slider
constexpr int kAbout_px = 284;
constexpr int kAboutBelow_px = 180;  // with large letters

QString phase_words(tasks::Phase phase) {
  switch (phase) {
    case tasks::Phase::lead_in: return QObject::tr("lead-in, not scored");
    case tasks::Phase::active: return QObject::tr("scored");
    case tasks::Phase::transport: return QObject::tr("transport");
    case tasks::Phase::hold: return QObject::tr("holding");
    case tasks::Phase::paused: return QObject::tr("paused");
    case tasks::Phase::done: return QObject::tr("done");
  }
  return {};
}
}  // namespace

TrialView::TrialView(QWidget* parent) : Card(tr("Trial"), parent) {
  set_ = new ChoiceBox;
  set_->setObjectName("trial_curves");
  describe(*set_, tr("What is drawn"), tr("What is drawn over time: arrow keys choose (Ctrl+G)"));
  auto* head = new QHBoxLayout;
  head->setSpacing(10);
  column_->removeWidget(title_);
  subtitle_ = new QLabel;
  subtitle_->setProperty("role", "quiet");
  head->addWidget(title_);
  head->addWidget(subtitle_, 1);
  head->addWidget(set_);
  warning_ = new QLabel;
  warning_->setObjectName("trial_warning");
  warning_->setWordWrap(true);
  body_ = new QWidget;
  auto* columns = new QBoxLayout(side_by_side(), body_);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(10);
  columns->addWidget(make_pictures(), 1);
  columns->addWidget(make_about());
  column_->addLayout(head);
  column_->addWidget(warning_);
  column_->addWidget(body_, 1);
  column_->addWidget(make_controls());
  timer_.setInterval(kFrame_ms);
  timer_.setTimerType(Qt::PreciseTimer);
  connect_all();
  show_problem(tr("Choose a trial at the left and open it with Enter."));
}

QWidget* TrialView::make_pictures() {
  auto* pictures = new QWidget;
  auto* column = new QVBoxLayout(pictures);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  object_ = new QStackedWidget;
  take_rest(*object_, 120);
  flat_ = new ObjectPathView;
  describe(*flat_, tr("Path of the object"),
           tr("Path, object and target (dashed); filled dots are fingers that touch"));
  object_->addWidget(flat_);
  page_ = new PagePicture;
  page_->setObjectName("trial_two_hands");
  describe(*page_, tr("Picture of both hands"),
           tr("What the patient saw: the force of each hand and what was asked (Space)"));
  object_->addWidget(page_);
  why_flat_ = new QLabel(tr("Drawn flat: this display has no OpenGL for the 3D picture."));
  why_flat_->setProperty("role", "quiet");
  plot_ = new TrialPlot;
  plot_->setObjectName("trial_plot");
  take_rest(*plot_, 130);
  describe(*plot_, tr("Signals of the trial"),
           tr("Left and right arrow keys step by a sample (with Shift by ten), up and down zoom, "
              "Space plays; the mouse moves the cursor, a double click shows all (F6)"));
  reading_ = new QLabel;
  reading_->setObjectName("trial_reading");
  reading_->setTextFormat(Qt::RichText);
  reading_->setWordWrap(true);
  arm_ = new ArmViews;
  arm_->setObjectName("trial_arm");
  take_rest(*arm_, 120);
  auto* beside = new QHBoxLayout;
  beside->setSpacing(6);
  beside->addWidget(object_, 2);
  beside->addWidget(arm_, 3);
  column->addLayout(beside, 9);
  column->addWidget(why_flat_);
  column->addWidget(plot_, 10);
  column->addWidget(reading_);
  return pictures;
}

QWidget* TrialView::make_about() {
  auto* about = new QWidget;
  if (side_by_side() == QBoxLayout::LeftToRight) about->setFixedWidth(scaled(kAbout_px));
  grasp_ = new GraspView("replay_", GraspView::Form::narrow);
  side_ = new QStackedWidget;
  if (side_by_side() != QBoxLayout::LeftToRight) side_->setMinimumHeight(scaled(kAboutBelow_px));
  auto* column = new QVBoxLayout(about);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  column->addWidget(grasp_);
  column->addWidget(side_, 1);
  about_ = new TrialAbout;
  channels_ = new QListWidget;
  channels_->setObjectName("trial_channels");
  describe(*channels_, tr("Recorded channels"),
           tr("Every recorded channel: arrow keys and Space choose what is drawn"));
  side_->addWidget(about_);
  side_->addWidget(channels_);
  return about;
}

QWidget* TrialView::make_controls() {
  auto* controls = new QWidget;
  auto* row = new QHBoxLayout(controls);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(10);
  play_ = new QPushButton(tr("Play"));
  play_->setObjectName("trial_play");
  play_->setMinimumWidth(scaled(88));
  describe(*play_, tr("Play or pause"), tr("Play or pause the replay (Space)"));
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("trial_slider");
  slider_->setSingleStep(static_cast<int>(0.1 * kSlider_Hz));
  slider_->setPageStep(static_cast<int>(kSlider_Hz));
  describe(*slider_, tr("Time in the trial"),
           tr("Time in the trial: arrow keys 0.1 s, page keys 1 s, Home and End; Space plays"));
  time_ = new QLabel;
  time_->setObjectName("trial_time");
  time_->setMinimumWidth(scaled(118));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  speed_ = new ChoiceBox;
  speed_->setObjectName("trial_speed");
  for (const double speed : Playback::kSpeeds) speed_->addItem(tr("%L1 ×").arg(speed), speed);
  speed_->setCurrentIndex(2);
  describe(*speed_, tr("Speed of the replay"), tr("Speed of the replay (keys + and −)"));
  row->addWidget(play_);
  row->addWidget(slider_, 1);
  row->addWidget(time_);
  row->addWidget(speed_);
  return controls;
}

void TrialView::connect_all() {
  connect(&timer_, &QTimer::timeout, this, &TrialView::advance);
  connect(play_, &QPushButton::clicked, this, &TrialView::toggle);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) {
    if (trial_ != nullptr) seek(trial_->replay.begin_s() + value / kSlider_Hz);
  });
  connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          &TrialView::choose_speed);
  connect(plot_, &TrialPlot::sought, this, &TrialView::seek);
  connect(plot_, &TrialPlot::stepped, this, [this](int frames) {
    playback_.pause();
    if (trial_ != nullptr) seek(playback_.t_s() + frames * trial_->replay.period_s());
  });
  connect(set_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &TrialView::draw_curves);
  connect(channels_, &QListWidget::itemChanged, this, &TrialView::draw_curves);
  connect(about_, &TrialAbout::sought, this, &TrialView::seek);
  connect(new QShortcut(QKeySequence(QStringLiteral("Ctrl+G")), this), &QShortcut::activated, set_,
          [this] { set_->setFocus(); });
}

CurveSet TrialView::set() const {
  return static_cast<CurveSet>(set_->currentData().toInt());
}

void TrialView::show_loading(const QString& what) {
  show_problem(tr("Loading %1 …").arg(what));
}

void TrialView::show_problem(const QString& words) {
  playback_ = {};
  timer_.stop();
  trial_.reset();
  title_->setText(tr("Trial"));
  subtitle_->clear();
  warning_->setText(words);
  warning_->setVisible(true);
  warning_->setAlignment(Qt::AlignTop);
  for (auto* widget :
       {body_, static_cast<QWidget*>(play_), static_cast<QWidget*>(slider_),
        static_cast<QWidget*>(speed_), static_cast<QWidget*>(time_), static_cast<QWidget*>(set_)})
    widget->hide();
}

void TrialView::show_trial(std::shared_ptr<const LoadedTrial> trial) {
  const double speed = playback_.speed();
  trial_ = std::move(trial);
  const auto& record = trial_->opened.trial;
  const auto& replay = trial_->replay;
  playback_ = Playback(replay.begin_s(), replay.end_s());
  playback_.set_speed(speed);
  choose_speed(speed_->currentIndex());
  title_->setText(tr("Trial %1: %2").arg(record.number).arg(translated(record.task_name)));
  const auto mark = source_mark(trial_->opened.session);
  subtitle_->setText(mark.isEmpty() ? standing_words(record)
                                    : tr("%1 · %2").arg(standing_words(record), mark));
  const auto damage = QString::fromStdString(trial_->opened.damage);
  const auto problem = !damage.isEmpty()                ? damage
                       : !trial_->why_nothing.isEmpty() ? trial_->why_nothing
                                                        : trial_->why_no_picture;
  warning_->setText(tr("⚠ %1").arg(problem));
  warning_->setVisible(!problem.isEmpty());
  const bool any = replay.rows() > 0;
  body_->show();
  for (auto* widget :
       {static_cast<QWidget*>(play_), static_cast<QWidget*>(slider_), static_cast<QWidget*>(speed_),
        static_cast<QWidget*>(time_), static_cast<QWidget*>(set_)}) {
    widget->show();
    widget->setEnabled(any);
  }
  plot_->setVisible(any);
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(
        0, static_cast<int>(std::ceil(kSlider_Hz * (replay.end_s() - replay.begin_s()))));
    slider_->setValue(0);
  }
  {
    const QSignalBlocker quiet(set_);
    const auto before = set_->currentData();
    set_->clear();
    for (const CurveSet set : sets_of(replay)) set_->addItem(words_of(set), static_cast<int>(set));
    set_->setCurrentIndex(std::max(0, set_->findData(before)));
  }
  about_->show_trial(*trial_);
  fill_channels();
  show_object();
  draw_curves();
  if (any) plot_->show_whole();
  seek(replay.begin_s());
}

void TrialView::take_focus() {
  if (play_->isVisible() && play_->isEnabled()) play_->setFocus();
}

void TrialView::fill_channels() {
  const QSignalBlocker quiet(channels_);
  channels_->clear();
  for (const auto& name : trial_->replay.signals().names()) {
    if (name == columns::t_s) continue;
    auto* item = new QListWidgetItem(QString::fromStdString(name), channels_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(name == columns::actual_force_N ? Qt::Checked : Qt::Unchecked);
  }
}

void TrialView::show_object() {
  const ArmReplay* arm = trial_->arm.get();
  arm_->setVisible(arm != nullptr);
  if (arm == nullptr) arm_->show_nothing();
  const HandReplay* tracked = trial_->tracked.get();
  grasp_->setVisible(tracked != nullptr && tracked->has_object());
  if (trial_->two_hands != nullptr && trial_->task != nullptr) {
    object_->setVisible(true);
    why_flat_->hide();
    object_->setCurrentWidget(page_);
    return;
  }
  const bool object = arm != nullptr ? arm->has_object() : trial_->replay.has_object();
  static const bool kOpenGl = why_no_opengl().empty();
  const bool drawn = arm != nullptr || tracked != nullptr || trial_->scene != nullptr;
  const bool solid = object && kOpenGl && trial_->task != nullptr && drawn;
  object_->setVisible(object && (solid || arm == nullptr));  // three views are flat already
  why_flat_->setVisible(object && !kOpenGl);
  if (!object) return;
  if (solid && window_ == nullptr) {
    window_ = new ReplayWindow;
    connect(window_, &ReplayWindow::key_pressed, this, [this](int key) { (void)act_on(key); });
    container_ = QWidget::createWindowContainer(window_);
    container_->setObjectName("trial_object");
    describe(*container_, tr("Object"),
             tr("The object as the patient saw it, and its path (Space)"));
    object_->addWidget(container_);
  }
  object_->setCurrentWidget(solid ? container_ : flat_);
  if (solid)
    window_->show_trial(trial_);
  else if (arm == nullptr)
    flat_->show_trial(trial_);
}

void TrialView::draw_curves() {
  if (trial_ == nullptr) return;
  const bool choosing = set() == CurveSet::chosen;
  side_->setCurrentIndex(choosing ? 1 : 0);
  std::vector<std::string> chosen;
  for (int row = 0; choosing && row < channels_->count(); ++row)
    if (channels_->item(row)->checkState() == Qt::Checked)
      chosen.push_back(channels_->item(row)->text().toStdString());
  curves_ = curves_of(trial_->replay, set(), chosen);
  plot_->show_trial(trial_->replay, curves_, trial_->opened.marks);
  show_time();
}

void TrialView::toggle() {
  if (trial_ == nullptr || trial_->replay.rows() == 0) return;
  playback_.toggle();
  if (playback_.playing()) {
    since_.start();
    timer_.start();
  }
  show_time();
}

void TrialView::seek(double t_s) {
  if (trial_ == nullptr) return;
  playback_.seek(t_s);
  show_time();
}

void TrialView::advance() {
  constexpr double kNanosecond_s = 1e-9;
  const double passed_s = kNanosecond_s * static_cast<double>(since_.nsecsElapsed());
  since_.start();
  playback_.advance(passed_s);
  show_time();
}

void TrialView::show_time() {
  if (!playback_.playing()) timer_.stop();
  play_->setText(playback_.playing() ? tr("Pause") : tr("Play"));
  const auto& replay = trial_->replay;
  if (replay.rows() == 0) return;
  const double t_s = playback_.t_s();
  {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(kSlider_Hz * (t_s - replay.begin_s()))));
  }
  time_->setText(tr("%1 of %2 s").arg(seconds_text(t_s), seconds_text(replay.end_s())));
  plot_->set_cursor(t_s);
  const auto state = replay.at(t_s);
  if (trial_->arm) arm_->show_arm(trial_->arm->at(replay, state), trial_->arm->space());
  if (trial_->tracked) grasp_->show_grasp(grasp_live(trial_->tracked->at(replay, state)));
  if (!trial_->arm && object_->isVisible() && object_->currentWidget() == flat_)
    flat_->show_state(state);
  if (object_->currentWidget() == page_ && trial_->two_hands != nullptr)
    page_->show_picture(picture_at(*trial_, state));
  if (window_ != nullptr && object_->currentWidget() == container_) window_->show_state(state);
  QStringList parts{phase_words(state.phase)};
  for (const auto& curve : curves_)
    parts << tr("<span style=\"color:%1\">%2</span>&nbsp;%3&nbsp;%4")
                 .arg(curve.colour.name(), curve.target ? tr("┅") : tr("━"),
                      curve.name.toHtmlEscaped(), reading(replay, curve, t_s));
  if ((trial_->arm || replay.has_object()) && state.target_index >= 0)
    parts << tr("targets reached %1").arg(state.targets_reached);
  reading_->setText(parts.join(QStringLiteral(" &nbsp; ")));
}

void TrialView::choose_speed(int index) {
  if (index >= 0) playback_.set_speed(speed_->itemData(index).toDouble());
}

bool TrialView::act_on(int key) {
  if (trial_ == nullptr) return false;
  const int last = speed_->count() - 1;
  switch (key) {
    case Qt::Key_Space: toggle(); return true;
    case Qt::Key_Plus:
      speed_->setCurrentIndex(std::min(last, speed_->currentIndex() + 1));
      return true;
    case Qt::Key_Minus:
      speed_->setCurrentIndex(std::max(0, speed_->currentIndex() - 1));
      return true;
    default: return false;
  }
}

void TrialView::keyPressEvent(QKeyEvent* event) {
  if (!act_on(event->key())) Card::keyPressEvent(event);
}

void TrialView::hideEvent(QHideEvent* event) {
  Card::hideEvent(event);
  playback_.pause();
  if (trial_ != nullptr) show_time();
}

}  // namespace isograsp::gui
