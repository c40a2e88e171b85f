// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/device_page.hpp"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "gui/look/card.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

constexpr int kRow_px = 26;

/// What each sensor counted since it was connected.
struct Counter {
  const char* title;
  std::uint64_t SensorCounters::*count;
};
constexpr std::array<Counter, 9> kCounters{
    {{QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Good samples"), &SensorCounters::good},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Lost"), &SensorCounters::lost},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Half samples"), &SensorCounters::torn},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Meaningless"), &SensorCounters::invalid},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Standing still"), &SensorCounters::stale},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "At the end of the range"),
      &SensorCounters::saturated},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Overloaded"), &SensorCounters::overload},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Called wrong by the sensor"),
      &SensorCounters::status_errors},
     {QT_TRANSLATE_NOOP("isograsp::gui::DevicePage", "Set up again"), &SensorCounters::restarts}}};

QString words_of(const Counter& counter) {
  return DevicePage::tr(counter.title);
}

QString details_of(const DeviceInfo& info, bool is_seen) {
  QStringList lines{translated(info.description)};
  lines += DevicePage::tr("%1 samples per second, delay %L2 ms")
               .arg(1.0 / info.sample_period_s, 0, 'f', 0)
               .arg(info.delay_s * 1e3, 0, 'f', 1);
  if (is_seen) return lines.join(QLatin1Char('\n'));
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const auto& serial = info.serial_numbers[f];
    lines += DevicePage::tr("%1: serial number %2, up to %3 N, one count is %L4 N")
                 .arg(finger_title(kFingers[f]))
                 .arg(serial.empty() ? DevicePage::tr("not told") : QString::fromStdString(serial))
                 .arg(info.range[f][2], 0, 'f', 0)
                 .arg(info.units_per_count[f][2], 0, 'g', 3);
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

DevicePage::DevicePage(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  auto* columns = new QBoxLayout(side_by_side(), this);
  columns->setContentsMargins(12, 12, 12, 12);
  columns->setSpacing(12);
  auto* left = new QVBoxLayout;
  left->setSpacing(12);
  left->addWidget(make_state());
  left->addWidget(make_sensors(), 1);
  auto* right = new QVBoxLayout;
  right->setSpacing(12);
  right->addWidget(make_check(), 3);
  right->addWidget(make_faults(), 1);
  columns->addLayout(left, 1);
  columns->addLayout(right, 1);
  connect(&presenter_.flow(), &SessionFlow::changed, this, &DevicePage::refresh);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &DevicePage::look);
  refresh();
}

QWidget* DevicePage::make_state() {
  auto* card = new Card({});
  state_card_ = card;
  light_ = new StateLight(22);
  words_ = new QLabel;
  words_->setObjectName("device_state");
  words_->setWordWrap(true);
  auto* state = new QHBoxLayout;
  state->setSpacing(8);
  state->addWidget(light_, 0, Qt::AlignTop);
  state->addWidget(words_, 1);
  details_ = new QLabel;
  details_->setObjectName("device_details");
  details_->setProperty("role", "quiet");
  details_->setWordWrap(true);
  card->column().addLayout(state);
  card->column().addWidget(details_);
  return card;
}

QWidget* DevicePage::make_check() {
  auto* card = new Card(tr("Guided check"));
  check_card_ = card;
  instruction_ = new QLabel;
  instruction_->setObjectName("check_instruction");
  instruction_->setProperty("role", "large");
  instruction_->setWordWrap(true);
  picture_ = new SupportPicture;
  side_ = new ChoiceBox;
  side_->setObjectName("check_side");
  side_->addItem(tr("Platform of the left hand"));
  side_->addItem(tr("Platform of the right hand"));
  describe(*side_, tr("Platform to be checked"),
           tr("Which of the two platforms (Tab, arrow keys)"));
  connect(side_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    check_ = {};  // what was found is of the other one
    results_->clear();
    refresh_check();
  });
  begin_ = new QPushButton;
  begin_->setObjectName("check_begin");
  results_ = new QListWidget;
  results_->setObjectName("check_results");
  results_->setWordWrap(true);
  take_rest(*results_, 3 * kRow_px);
  describe(*results_, tr("What the check found"), tr("One line for every press (Tab, arrow keys)"));
  card->column().addWidget(side_);
  card->column().addWidget(instruction_);
  card->column().addWidget(picture_, 2);
  card->column().addWidget(begin_);
  card->column().addWidget(results_, 1);
  connect(begin_, &QPushButton::clicked, this, &DevicePage::toggle_check);
  return card;
}

QWidget* DevicePage::make_sensors() {
  auto* card = new Card(tr("What the sensors counted"));
  counted_card_ = card;
  sensors_ = new QTableWidget(static_cast<int>(kCounters.size()), 1 + kFingerCount);
  sensors_->setObjectName("sensor_counters");
  QStringList heads{tr("Samples")};
  for (const Finger finger : kFingers) heads += finger_title(finger);
  sensors_->setHorizontalHeaderLabels(heads);
  sensors_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  sensors_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  sensors_->horizontalHeaderItem(0)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  sensors_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
  sensors_->verticalHeader()->hide();
  sensors_->verticalHeader()->setDefaultSectionSize(scaled(kRow_px));
  sensors_->setShowGrid(false);
  sensors_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  sensors_->setSelectionBehavior(QAbstractItemView::SelectRows);
  sensors_->setTabKeyNavigation(false);
  take_rest(*sensors_, 4 * kRow_px);
  describe(*sensors_, tr("Samples of each sensor"),
           tr("Counted since the device was connected (Tab, arrow keys)"));
  for (std::size_t row = 0; row < kCounters.size(); ++row)
    for (int column = 0; column <= static_cast<int>(kFingerCount); ++column) {
      auto* item = new QTableWidgetItem(column == 0 ? words_of(kCounters[row]) : QString());
      item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
      sensors_->setItem(static_cast<int>(row), column, item);
    }
  cameras_ = new QLabel;
  cameras_->setObjectName("camera_counters");
  cameras_->setWordWrap(true);
  cameras_->hide();
  card->column().addWidget(sensors_, 1);
  card->column().addWidget(cameras_);
  card->column().addStretch(0);
  return card;
}

QWidget* DevicePage::make_faults() {
  auto* card = new Card(tr("Faults in this session"));
  no_faults_ = new QLabel;
  no_faults_->setProperty("role", "quiet");
  faults_ = new QListWidget;
  faults_->setObjectName("device_faults");
  faults_->setWordWrap(true);
  take_rest(*faults_, 2 * kRow_px);
  describe(*faults_, tr("Faults in this session"), tr("The newest first (Tab, arrow keys)"));
  card->column().addWidget(no_faults_);
  card->column().addWidget(faults_, 1);
  card->column().addStretch(0);
  return card;
}

std::optional<Hand> DevicePage::checked_side() const {
  if (!measures_both(presenter_.state())) return std::nullopt;
  return side_->currentIndex() == 0 ? Hand::left : Hand::right;
}

void DevicePage::toggle_check() {
  const bool running =
      check_.state() == GuidedCheck::State::empty || check_.state() == GuidedCheck::State::pressing;
  if (running)
    check_.stop();
  else if (const auto* info = presenter_.state().device())
    check_.begin(
        info->frame_period_s,
        checked_side().value_or(presenter_.state().choices.today.hand.value_or(Hand::right)),
        presenter_.state().snapshot().frames);
  refresh_check();
}

void DevicePage::look() {
  if (!presenter_.flow().view().may_check) check_.stop();
  const auto& open = presenter_.state().open;
  const auto checked = checked_side();
  const bool changed = checked && open && open->both ? check_.look(side_of(*open->both, *checked))
                                                     : check_.look(presenter_.state().snapshot());
  if (changed) {
    if (check_.state() == GuidedCheck::State::over) {
      const std::string side = checked ? " (" + std::string(name_of(*checked)) + ")" : "";
      presenter_.remarks().note("Guided check" + side + ": " + english(check_.outcome()));
    }
    refresh_check();
  }
  // Twice a second is enough for counters.
  constexpr int kEvery = 30;
  if (++polls_ % kEvery == 0 && isVisible()) refresh_sensors();
}

void DevicePage::refresh() {
  const auto& view = presenter_.flow().view();
  light_->show_mood(view.device_mood);
  words_->setText(QString::fromStdString(view.device_words));
  const auto* info = presenter_.state().device();
  const bool is_arm = presenter_.state().measures_arm();
  const bool is_hand = presenter_.state().measures_hand();
  const bool is_seen = is_arm || is_hand;
  const bool both = measures_both(presenter_.state());
  state_card_->set_title(is_arm    ? tr("Cameras")
                         : is_hand ? tr("Tracker")
                         : both    ? tr("Both platforms")
                                   : tr("Device"));
  side_->setVisible(both);
  details_->setText(info == nullptr ? tr("A device, or cameras, are chosen and connected on the "
                                         "page of the session, once patient and hand are known.")
                                    : details_of(*info, is_seen || both));
  check_card_->setVisible(!is_seen);
  counted_card_->set_title(is_arm    ? tr("What the cameras counted")
                           : is_hand ? tr("What the tracker counted")
                           : both    ? tr("What the sensors counted, left / right")
                                     : tr("What the sensors counted"));
  sensors_->setVisible(!is_seen);
  cameras_->setVisible(is_seen);
  const auto& faults = presenter_.state().traces().faults;
  if (faults_->count() != static_cast<int>(faults.size())) {
    faults_->clear();
    for (auto fault = faults.rbegin(); fault != faults.rend(); ++fault)
      faults_->addItem(tr("%L1 min: %2")
                           .arg(fault->session_time_s / 60.0, 0, 'f', 1)
                           .arg(fault->side
                                    ? (*fault->side == Hand::left ? tr("left platform, %1")
                                                                  : tr("right platform, %1"))
                                          .arg(in_sentence(translated(fault->words)))
                                    : translated(fault->words)));
  }
  faults_->setVisible(faults_->count() > 0);
  no_faults_->setVisible(faults_->count() == 0);
  no_faults_->setText(info == nullptr ? tr("Nothing is connected.") : tr("None so far."));
  refresh_check();
}

void DevicePage::refresh_check() {
  const auto& view = presenter_.flow().view();
  const auto state = check_.state();
  const bool running = state == GuidedCheck::State::empty || state == GuidedCheck::State::pressing;
  const auto hand =
      checked_side().value_or(presenter_.state().choices.today.hand.value_or(Hand::right));
  side_->setEnabled(!running);
  picture_->show_step(
      state == GuidedCheck::State::pressing ? std::optional(check_.step()) : std::nullopt, hand);
  begin_->setText(running ? tr("Stop the chec&k") : tr("Chec&k the supports"));
  describe(*begin_, begin_->text().remove(QLatin1Char('&')),
           tr("You press each empty support as pictured; swapped sensors, wrong signs and turned "
              "axes show (Alt+K)"));
  begin_->setEnabled(running || view.may_check);
  if (running)
    instruction_->setText(translated(check_.instruction()));
  else if (state == GuidedCheck::State::over)
    instruction_->setText(translated(check_.outcome()));
  else
    instruction_->setText(view.may_check
                              ? tr("Take the hand out, then press each empty support as pictured.")
                              : tr("The check needs a connected device and no running trial."));
  const auto results = check_.results();
  results_->setVisible(!results.empty());
  if (results_->count() == static_cast<int>(results.size())) return;
  results_->clear();
  for (const auto& result : results) {
    const bool good = result.verdict == CheckVerdict::good;
    auto* item = new QListWidgetItem(
        (good ? QStringLiteral("✓  ") : QStringLiteral("✗  ")) + translated(result.sentence()),
        results_);
    item->setForeground(good ? look::kReady : look::kFault);
  }
  results_->scrollToBottom();
}

void DevicePage::refresh_sensors() {
  if (const auto& open = presenter_.state().open; open && open->arm) {
    const MarkerCounters& count = open->arm->health.counters;
    return cameras_->setText(
        tr("Pictures of the cameras: %1\nLost: %2\nTwice: %3\nWith other markers: %4\n"
           "Damaged: %5\nConnected again: %6")
            .arg(count.good)
            .arg(count.lost)
            .arg(count.duplicate)
            .arg(count.unlabelled)
            .arg(count.damaged)
            .arg(count.restarts));
  }
  if (const auto& open = presenter_.state().open; open && open->hand) {
    const HandCounters& count = open->hand->health.counters;
    return cameras_->setText(
        tr("Pictures of the tracker: %1\nRows of this hand: %2\nNot seen: %3\nOf the other hand, "
           "not used: %4\nLost: %5\nDamaged: %6\nConnected again: %7")
            .arg(count.frames)
            .arg(count.rows)
            .arg(count.untracked)
            .arg(count.other_side)
            .arg(count.lost)
            .arg(count.malformed)
            .arg(count.restarts));
  }
  const auto& open = presenter_.state().open;
  const auto& health = presenter_.state().snapshot().health;
  for (std::size_t row = 0; row < kCounters.size(); ++row)
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      const auto counted = [&](const DeviceHealth& of) {
        return QString::number(of.sensors[f].*kCounters[row].count);
      };
      QString text;
      if (open && open->both)
        text = tr("%1 / %2", "samples of the left and of the right platform")
                   .arg(counted(open->both->of.left.health), counted(open->both->of.right.health));
      else if (open)
        text = counted(health);
      sensors_->item(static_cast<int>(row), static_cast<int>(f) + 1)->setText(text);
    }
}

}  // namespace isograsp::gui
