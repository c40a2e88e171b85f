// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/device_panel.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "gui/choice_box.hpp"
#include "gui/device_list.hpp"
#include "gui/look.hpp"

namespace isograsp {

DevicePanel::DevicePanel(SessionPresenter& presenter, QWidget* parent)
    : Card({}, parent), presenter_(presenter) {
  title_->setText(tr("&Device"));
  devices_ = new ChoiceBox;
  devices_->setObjectName("devices");
  devices_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  describe(*devices_, tr("Device"),
           tr("What is present now, simulated patients, recordings (Alt+D)"));
  title_->setBuddy(devices_);
  connect_ = new QPushButton;
  connect_->setObjectName("connect");
  light_ = new StateLight(22);
  words_ = new QLabel;
  words_->setObjectName("device_words");
  words_->setWordWrap(true);
  auto* state = new QHBoxLayout;
  state->setSpacing(8);
  state->addWidget(light_, 0, Qt::AlignTop);
  state->addWidget(words_, 1);

  zero_ = new QPushButton(tr("Device is empty: set &zero"));
  zero_->setObjectName("zero");
  describe(*zero_, tr("Set the zero of the empty device"),
           tr("With no hand in the device: one quiet second becomes zero (Alt+Z)"));
  confirm_ = new QFrame;
  confirm_->setProperty("confirm", true);
  auto* question = new QLabel(tr("No hand, nothing touches the supports?"));
  question->setWordWrap(true);
  confirmed_ = new QPushButton(tr("Yes, empt&y"));
  confirmed_->setObjectName("zero_confirmed");
  describe(*confirmed_, tr("Yes, the device is empty"), tr("Set the zero now (Alt+Y)"));
  not_yet_ = new QPushButton(tr("&No"));
  not_yet_->setObjectName("zero_not_yet");
  describe(*not_yet_, tr("No, not yet"), tr("Keep the present zero (Alt+N)"));
  auto* answers = new QHBoxLayout;
  answers->addWidget(confirmed_, 1);
  answers->addWidget(not_yet_);
  auto* asking = new QVBoxLayout(confirm_);
  asking->setContentsMargins(8, 6, 8, 8);
  asking->addWidget(question);
  asking->addLayout(answers);
  confirm_->hide();
  changed_ = new QPushButton(tr("Empty; was serviced: ta&ke it"));
  changed_->setObjectName("zero_changed");
  describe(*changed_, tr("The device was serviced or remounted: accept its new zero"),
           tr("The empty device reads something else than at its last zero because it was serviced "
              "or remounted; this is stored with the zero (Alt+K)"));
  changed_->hide();
  strapped_ = new QPushButton(tr("Hand is &in and strapped"));
  strapped_->setObjectName("strapped");
  describe(*strapped_, tr("The hand is in and strapped"),
           tr("From now a minute to settle, then the resting force can be measured (Alt+I)"));
  progress_ = new QProgressBar;
  progress_->setObjectName("device_progress");
  auto place = progress_->sizePolicy();
  place.setRetainSizeWhenHidden(true);  // the window must not jump when the bar comes and goes
  progress_->setSizePolicy(place);
  describe(*progress_, tr("Progress of the device"),
           tr("Connecting, setting the zero, or saving the session"));
  progress_->hide();

  column_->addWidget(devices_);
  column_->addWidget(connect_);
  column_->addLayout(state);
  column_->addWidget(zero_);
  column_->addWidget(confirm_);
  column_->addWidget(changed_);
  column_->addWidget(strapped_);
  column_->addWidget(progress_);

  fill(presenter_.device_uri());
  connect(devices_, QOverload<int>::of(&QComboBox::activated), this, &DevicePanel::choose);
  connect(connect_, &QPushButton::clicked, this, [this] {
    const auto& view = presenter_.view();
    if (view.may_connect)
      presenter_.connect_device();
    else if (view.may_cancel_connecting)
      presenter_.cancel_connecting();
    else
      presenter_.disconnect_device();
  });
  connect(zero_, &QPushButton::clicked, this, [this] {
    zero_->hide();
    confirm_->show();
    confirmed_->setFocus();
  });
  connect(confirmed_, &QPushButton::clicked, this, [this] {
    confirm_->hide();
    zero_->show();
    presenter_.set_zero();
  });
  connect(changed_, &QPushButton::clicked, this, [this] { presenter_.set_zero(true); });
  connect(strapped_, &QPushButton::clicked, &presenter_, &SessionPresenter::mark_strapped);
  connect(not_yet_, &QPushButton::clicked, this, [this] {
    confirm_->hide();
    zero_->show();
  });
  connect(&presenter_, &SessionPresenter::changed, this, &DevicePanel::refresh);
  connect(&presenter_, &SessionPresenter::frame, this, &DevicePanel::refresh_progress);
  refresh();
}

void DevicePanel::fill(const std::string& preset) {
  const QSignalBlocker quiet(devices_);
  devices_->clear();
  if (preset.empty()) devices_->addItem(tr("Choose a device"), QString());
  for (const auto& choice : list_devices(preset))
    devices_->addItem(QString::fromStdString(choice.words), QString::fromStdString(choice.uri));
  devices_->setCurrentIndex(0);
}

void DevicePanel::choose(int index) {
  const auto uri = devices_->itemData(index).toString().toStdString();
  const bool placeholder = presenter_.device_uri().empty() && index == 0;
  if (placeholder) return;
  if (uri.empty())
    choose_recording();
  else
    presenter_.choose_device(uri);
}

void DevicePanel::choose_recording() {
  auto* dialog = new QFileDialog(this, tr("Open a recording"), QString(),
                                 tr("Finger forces (*.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const auto uri = recording_uri(path.toStdString());
    presenter_.choose_device(uri);
    fill(uri);
  });
  connect(dialog, &QFileDialog::rejected, this, [this] { fill(presenter_.device_uri()); });
  dialog->open();
}

void DevicePanel::refresh() {
  const auto& view = presenter_.view();
  devices_->setEnabled(view.may_change_device);
  if (view.may_cancel_connecting) {
    connect_->setText(tr("&Cancel"));
    describe(*connect_, tr("Cancel connecting"), tr("Do not connect to this device (Alt+C)"));
  } else if (presenter_.session_open()) {
    connect_->setText(tr("Dis&connect"));
    describe(*connect_, tr("Disconnect"), tr("End the session and disconnect (Alt+C)"));
  } else {
    connect_->setText(tr("&Connect"));
    describe(*connect_, tr("Connect"),
             tr("Begin the session: needs patient, hand and device (Alt+C)"));
  }
  connect_->setEnabled(view.may_connect || view.may_cancel_connecting || view.may_disconnect);
  mark_next(*connect_, view.may_connect);
  light_->show_mood(view.device_mood);
  words_->setText(QString::fromStdString(view.device_words));
  zero_->setEnabled(view.may_zero);
  mark_next(*zero_, view.next() == Step::zero);
  mark_next(*confirmed_, true);
  changed_->setVisible(view.may_accept_changed);
  strapped_->setEnabled(view.may_strap);
  if (!view.may_zero && confirm_->isVisible()) {
    confirm_->hide();
    zero_->show();
  }
}

void DevicePanel::refresh_progress() {
  const bool zeroing = presenter_.snapshot().stage == Stage::zeroing;
  const bool waiting = presenter_.busy() && !presenter_.session_open();
  progress_->setVisible(zeroing || waiting);
  if (waiting) {
    progress_->setRange(0, 0);  // nobody knows how long a device takes: the bar only moves
  } else if (zeroing) {
    progress_->setRange(0, 100);
    progress_->setValue(static_cast<int>(100.0 * presenter_.snapshot().zero_progress));
  }
}

}  // namespace isograsp
