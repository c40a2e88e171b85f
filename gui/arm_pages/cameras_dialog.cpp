// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/arm_pages/cameras_dialog.hpp"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <vector>

#include "gui/device_pages/device_address.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {

constexpr std::array<const char*, 3> kSchemes{"qtm://", "natnet://", "replay://"};
constexpr int kRecording = 2;

}  // namespace

CamerasDialog::CamerasDialog(const std::string& library, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Cameras"));
  source_ = new ChoiceBox;
  source_->setObjectName("cameras_source");
  source_->addItem(tr("Qualisys Track Manager"));
  source_->addItem(tr("OptiTrack Motive"));
  source_->addItem(tr("A recording of markers"));
  describe(*source_, tr("System of the cameras"), tr("Whose pictures are read (arrow keys)"));
  where_title_ = new QLabel;
  where_ = new QLineEdit;
  where_->setObjectName("cameras_where");
  where_->setMinimumWidth(scaled(260));
  browse_ = new QPushButton(tr("Choose …"));
  browse_->setObjectName("cameras_browse");
  describe(*browse_, tr("Choose the recording"), tr("C3D, TRC, Qualisys table or CSV (Tab)"));
  rig_ = new ChoiceBox;
  rig_->setObjectName("cameras_rig");
  for (const auto& name : rigs_in(library)) rig_->addItem(QString::fromStdString(name));
  rig_->setCurrentIndex(std::max(0, rig_->findText("kurillo15")));  // that of the assessment
  describe(*rig_, tr("Rig"), tr("What the markers are stuck to; docs/markers.md (arrow keys)"));
  auto* place = new QHBoxLayout;
  place->addWidget(where_, 1);
  place->addWidget(browse_);
  auto* form = new QFormLayout;
  form->addRow(tr("System"), source_);
  form->addRow(where_title_, place);
  form->addRow(tr("Rig"), rig_);
  auto* buttons = new QDialogButtonBox;
  accept_ = buttons->addButton(tr("Use these cameras"), QDialogButtonBox::AcceptRole);
  accept_->setObjectName("cameras_accept");
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(source_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    where_->clear();
    refresh();
  });
  connect(where_, &QLineEdit::textChanged, this, &CamerasDialog::refresh);
  connect(browse_, &QPushButton::clicked, this, &CamerasDialog::choose_file);
  refresh();
}

std::string CamerasDialog::uri() const {
  const auto where = where_->text().trimmed().toStdString();
  const auto rig = rig_->currentText().toStdString();
  if (where.empty() || rig.empty() || source_->currentIndex() < 0) return {};
  return kSchemes[static_cast<std::size_t>(source_->currentIndex())] + escaped_for_uri(where) +
         "?rig=" + escaped_for_uri(rig);
}

void CamerasDialog::choose_file() {
  auto* dialog = new QFileDialog(this, tr("Open a recording of markers"), QString(),
                                 tr("Markers (*.c3d *.trc *.tsv *.csv);;All files (*)"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, where_, &QLineEdit::setText);
  dialog->open();
}

void CamerasDialog::refresh() {
  const bool recording = source_->currentIndex() == kRecording;
  where_title_->setText(recording ? tr("File") : tr("Address"));
  where_->setPlaceholderText(recording ? QString() : QStringLiteral("192.168.0.7"));
  describe(*where_, recording ? tr("File of the recording") : tr("Address of their computer"),
           recording ? tr("Where the recording is (Tab)")
                     : tr("Name or number in the network; with :PORT if it is another one (Tab)"));
  browse_->setVisible(recording);
  accept_->setEnabled(!uri().empty());
}

}  // namespace isograsp::gui
