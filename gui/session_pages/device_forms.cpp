// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/device_forms.hpp"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/arm_pages/cameras_dialog.hpp"
#include "gui/arm_pages/first_visit_offer.hpp"
#include "gui/device_pages/add_device.hpp"
#include "gui/device_pages/device_list.hpp"
#include "gui/force_pages/platforms_form.hpp"
#include "gui/hand_pages/basis_view.hpp"
#include "gui/hand_pages/size_offer.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr int kDeviceFormRow_px = 26;
constexpr int kMostDeviceRows = 7;

QProgressBar* make_progress(const QString& name, const QString& what) {
  auto* progress = new QProgressBar;
  progress->setObjectName(name);
  describe(*progress, what, what);
  progress->hide();
  return progress;
}

}  // namespace

ConnectForm::ConnectForm(SessionPresenter& presenter, SettingsFile& settings, Staff& staff,
                         QWidget* parent)
    : QWidget(parent), presenter_(presenter), settings_(settings) {
  devices_ = new QListWidget;
  devices_->setObjectName("devices");
  devices_->setTextElideMode(Qt::ElideMiddle);
  describe(*devices_, tr("Device or cameras"),
           tr("What is present now, simulated patients, recordings (Alt+4, then arrow keys)"));
  forget_ = new QPushButton(tr("Forget this device"));
  forget_->setObjectName("device_forget");
  describe(*forget_, tr("Forget this device"),
           tr("Takes what was added here out of the list (Tab, then space)"));
  connect(forget_, &QPushButton::clicked, this, &ConnectForm::forget_device);
  connect_ = new QPushButton;
  connect_->setObjectName("connect");
  progress_ = make_progress("connect_progress", tr("Connecting, or saving the session"));
  progress_->setRange(0, 0);  // nobody knows how long a device takes: the bar only moves
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  column->addWidget(devices_);
  column->addWidget(forget_);
  column->addWidget(new PlatformsForm(presenter_, settings_));
  column->addWidget(new FirstVisitOffer(presenter_));
  column->addWidget(new SizeOffer(presenter_));
  column->addWidget(new BasisView(presenter_, staff));
  column->addWidget(connect_);
  column->addWidget(progress_);
  fill(presenter_.state().choices.device_uri);
  connect(devices_, &QListWidget::currentRowChanged, this, &ConnectForm::choose);
  connect(connect_, &QPushButton::clicked, this, [this] {
    const auto& view = presenter_.flow().view();
    if (view.may_connect)
      presenter_.connecting().connect_device();
    else if (view.may_cancel_connecting)
      presenter_.connecting().cancel();
    else
      presenter_.connecting().disconnect_device();
  });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ConnectForm::refresh);
  refresh();
}

void ConnectForm::fill(const std::string& preset) {
  const QSignalBlocker quiet(devices_);
  devices_->clear();
  for (const auto& choice : list_devices(preset, settings_.now().devices)) {
    auto* item = new QListWidgetItem(QString::fromStdString(choice.words), devices_);
    item->setData(Qt::UserRole, QString::fromStdString(choice.uri));
    item->setToolTip(item->text());
    item->setSizeHint({0, scaled(kDeviceFormRow_px)});
  }
  // Nothing is chosen beforehand unless somebody did.
  devices_->setCurrentRow(preset.empty() ? -1 : 0);
  devices_->setFixedHeight(
      scaled(kDeviceFormRow_px) * std::clamp(devices_->count(), 2, kMostDeviceRows) + 6);
}

void ConnectForm::choose(int row) {
  if (row < 0) return;
  const auto uri = devices_->item(row)->data(Qt::UserRole).toString().toStdString();
  if (uri == kAskRecording)
    choose_recording();
  else if (uri == kAskCameras)
    choose_cameras();
  else if (uri == kAddDevice)
    add_device();
  else
    presenter_.choices().choose_device(uri);
}

void ConnectForm::choose_cameras() {
  auto* dialog = new CamerasDialog(presenter_.state().config.library, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    const auto uri = dialog->uri();
    presenter_.choices().choose_device(uri);
    fill(uri);
  });
  connect(dialog, &QDialog::rejected, this,
          [this] { fill(presenter_.state().choices.device_uri); });
  dialog->open();
}

void ConnectForm::add_device() {
  QStringList taken;
  for (const NamedDevice& device : settings_.now().devices)
    taken << QString::fromStdString(device.name);
  const GuiConfig& config = presenter_.state().config;
  auto* dialog = new AddDeviceDialog(config.library, taken, config.apparatuses, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] {
    const NamedDevice device = dialog->device();
    Settings settings = settings_.now();
    std::erase_if(settings.devices, [&](const NamedDevice& one) { return one.uri == device.uri; });
    settings.devices.push_back(device);
    settings_.change(settings);
    presenter_.choices().choose_device(device.uri);
    fill(device.uri);
  });
  connect(dialog, &QDialog::rejected, this,
          [this] { fill(presenter_.state().choices.device_uri); });
  dialog->open();
}

void ConnectForm::forget_device() {
  Settings settings = settings_.now();
  std::erase_if(settings.devices, [this](const NamedDevice& one) {
    return one.uri == presenter_.state().choices.device_uri;
  });
  settings_.change(settings);
  presenter_.choices().choose_device({});
  fill({});
}

void ConnectForm::choose_recording() {
  auto* dialog = new QFileDialog(this, tr("Open a recording"), QString(),
                                 tr("Finger forces (*.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
    const auto uri = recording_uri(path.toStdString());
    presenter_.choices().choose_device(uri);
    fill(uri);
  });
  connect(dialog, &QFileDialog::rejected, this,
          [this] { fill(presenter_.state().choices.device_uri); });
  dialog->open();
}

void ConnectForm::refresh() {
  const auto& view = presenter_.flow().view();
  devices_->setEnabled(view.may_change_device);
  devices_->setVisible(!presenter_.state().session_open() && !measures_both(presenter_.state()));
  const auto& added = settings_.now().devices;
  show_part(*forget_, devices_->isVisibleTo(this) && view.may_change_device &&
                          std::any_of(added.begin(), added.end(), [this](const NamedDevice& one) {
                            return one.uri == presenter_.state().choices.device_uri;
                          }));
  if (presenter_.state().choices.device_uri.empty() && devices_->currentRow() >= 0 &&
      measures_both(presenter_.state())) {
    const QSignalBlocker quiet(devices_);  // was chosen for one hand
    devices_->setCurrentRow(-1);
  }
  if (view.may_cancel_connecting) {
    connect_->setText(tr("&Cancel"));
    describe(*connect_, tr("Cancel connecting"), tr("Do not connect (Alt+C)"));
  } else if (presenter_.state().session_open()) {
    connect_->setText(tr("Dis&connect"));
    describe(*connect_, tr("Disconnect"), tr("End the session and disconnect (Alt+C)"));
  } else {
    connect_->setText(tr("&Connect"));
    describe(*connect_, tr("Connect"),
             tr("Begin the session, once the steps above are done (Alt+C)"));
  }
  connect_->setEnabled(view.may_connect || view.may_cancel_connecting || view.may_disconnect);
  mark_choice(*devices_, view.press == NextPress::device);
  mark_next(*connect_, view.press == NextPress::connect);
  progress_->setVisible(presenter_.state().busy() && !presenter_.state().session_open());
}

ZeroForm::ZeroForm(SessionPresenter& presenter, QWidget* parent)
    : QWidget(parent), presenter_(presenter) {
  zero_ = new QPushButton;
  zero_->setObjectName("zero");
  empty_ = new QLabel;
  empty_->setProperty("role", "quiet");
  empty_->setWordWrap(true);
  changed_ = new QPushButton(tr("Empty; was serviced: ta&ke it"));
  changed_->setObjectName("zero_changed");
  describe(*changed_, tr("The device was serviced or remounted: accept its new zero"),
           tr("The empty device reads something else than at its last zero because it was serviced "
              "or remounted; this is stored with the zero (Alt+K)"));
  changed_->hide();
  progress_ = make_progress("zero_progress", tr("Measuring the empty device"));
  progress_->setRange(0, 100);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  for (QWidget* widget : {static_cast<QWidget*>(empty_), static_cast<QWidget*>(zero_),
                          static_cast<QWidget*>(changed_), static_cast<QWidget*>(progress_)})
    column->addWidget(widget);
  connect(zero_, &QPushButton::clicked, this, [this] { presenter_.preparing().set_zero(); });
  connect(changed_, &QPushButton::clicked, this, [this] { presenter_.preparing().set_zero(true); });
  connect(&presenter_.flow(), &SessionFlow::changed, this, &ZeroForm::refresh);
  connect(&presenter_.flow(), &SessionFlow::frame, this, &ZeroForm::refresh_progress);
  refresh();
}

void ZeroForm::refresh() {
  const auto& view = presenter_.flow().view();
  show_part(*this, !view.start_posture && !view.hand_entry);
  if (view.both_hands) {
    zero_->setText(tr("Both are empty: set &zeros"));
    describe(*zero_, tr("Set the zeros of both empty platforms"),
             tr("With no hand in either: one quiet second becomes zero, of both at once (Alt+Z)"));
    empty_->setText(tr("No hand in either, nothing touches the supports."));
  } else {
    zero_->setText(tr("Device is empty: set &zero"));
    describe(*zero_, tr("Set the zero of the empty device"),
             tr("With no hand in the device: one quiet second becomes zero (Alt+Z)"));
    empty_->setText(tr("No hand, nothing touches the supports."));
  }
  zero_->setEnabled(view.may_zero);
  mark_next(*zero_, view.press == NextPress::zero);
  changed_->setVisible(view.may_accept_changed);
}

void ZeroForm::refresh_progress() {
  const auto& now = presenter_.state().snapshot();
  progress_->setVisible(now.stage == session::Stage::zeroing);
  progress_->setValue(static_cast<int>(100.0 * now.zero_progress));
}

}  // namespace isograsp::gui
