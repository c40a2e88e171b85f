// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/device_pages/add_device.hpp"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <utility>

#include "device/config/device_config.hpp"
#include "device/config/family_facts.hpp"
#include "gui/look/choice_box.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace fs = std::filesystem;

namespace {

constexpr int kFieldWide_px = 340;

/// "Robotous RFT on can0: thumb 1234, index 1235, middle 1236."
QString words_of(const session::DeviceAnswer& answer) {
  QStringList parts;
  for (const auto& sensor : answer.sensors)
    if (!sensor.serial_number.empty()) parts << qt(sensor.name + " " + sensor.serial_number);
  const QString what = translated(answer.description);
  const QString who =
      parts.isEmpty() ? what : AddDeviceDialog::tr("%1: %2").arg(what, parts.join(", "));
  if (answer.frames == 0)
    return AddDeviceDialog::tr(
               "%1 answers. Its camera is looked at in a session only, once a lawful basis is on "
               "record.")
        .arg(who);
  if (answer.good())
    return AddDeviceDialog::tr("%1. Works: %2 times a second, nothing missing.")
        .arg(who, translated_number(answer.rate_Hz, 0));
  if (answer.with_gap == answer.frames)
    return AddDeviceDialog::tr("%1 answers, but sends nothing whole: look at cables and power.")
        .arg(who);
  return AddDeviceDialog::tr("%1 answers, but parts are missing in %2 of %3 looks.")
      .arg(who)
      .arg(answer.with_gap)
      .arg(answer.frames);
}

}  // namespace

AddDeviceDialog::AddDeviceDialog(const std::string& library, QStringList taken,
                                 std::span<const session::ApparatusRow> apparatuses,
                                 QWidget* parent)
    : QDialog(parent),
      library_(library),
      taken_(std::move(taken)),
      apparatuses_(apparatuses),
      here_(look_around()) {
  setWindowTitle(tr("Add a device"));
  make_fields();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addLayout(form_);
  make_acts();
  for (QWidget* widget : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(result_)})
    column->addWidget(widget);
  auto* buttons = new QDialogButtonBox;
  add_ = buttons->addButton(tr("Add the device"), QDialogButtonBox::AcceptRole);
  add_->setObjectName("device_add");
  mark_main(*add_, true);
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  offer();
}

AddDeviceDialog::~AddDeviceDialog() {
  asking_.request_stop();
}

void AddDeviceDialog::make_fields() {
  const auto choice = [](const char* name, const QString& title, const QString& tip) {
    auto* box = new ChoiceBox;
    box->setObjectName(QLatin1String(name));
    box->setMinimumWidth(scaled(kFieldWide_px));
    describe(*box, title, tip);
    return box;
  };
  kind_ = choice("device_kind", tr("What it is"), tr("How the device is reached (arrow keys)"));
  for (const DeviceKind kind : kDeviceKinds) kind_->addItem(gui::words_of(kind));
  family_ = choice("device_family", tr("Maker"), tr("Whose sensors they are (arrow keys)"));
  where_ =
      choice("device_where", tr("Where"), tr("Choose or type; empty: Find looks for it (Tab)"));
  where_->setEditable(true);
  setup_ = choice("device_setup", tr("Set-up"),
                  tr("The file that says how the sensors are mounted and set (arrow keys)"));
  rig_ = choice("device_rig", tr("Rig"), tr("What the markers are stuck to (arrow keys)"));
  for (const auto& name : rigs_in(library_)) rig_->addItem(qt(name));
  rig_->setCurrentIndex(std::max(0, rig_->findText("kurillo15")));  // that of the assessment
  name_ = new QLineEdit;
  name_->setObjectName("device_name");
  name_->setPlaceholderText(tr("Room 2"));
  describe(*name_, tr("Name"), tr("What people here call it (Tab)"));
  find_ = new QPushButton(tr("&Find"));
  find_->setObjectName("device_find");
  describe(*find_, tr("Find what answers"),
           tr("Asks every place where such a device could be (Alt+F)"));
  auto* place = new QHBoxLayout;
  place->setSpacing(8);
  place->addWidget(where_, 1);
  place->addWidget(find_);
  form_ = new QFormLayout;
  form_->setVerticalSpacing(8);
  form_->addRow(tr("What"), kind_);
  form_->addRow(tr("Maker"), family_);
  form_->addRow(tr("Where"), place);
  form_->addRow(tr("Set-up"), setup_);
  form_->addRow(tr("Rig"), rig_);
  form_->addRow(tr("Name"), name_);
  connect(kind_, QOverload<int>::of(&QComboBox::activated), this, &AddDeviceDialog::offer);
  connect(family_, QOverload<int>::of(&QComboBox::activated), this, &AddDeviceDialog::refresh);
  connect(where_, &QComboBox::editTextChanged, this, &AddDeviceDialog::refresh);
  connect(name_, &QLineEdit::textChanged, this, &AddDeviceDialog::refresh);
  connect(find_, &QPushButton::clicked, this, [this] { ask(candidates(draft(), here_)); });
}

void AddDeviceDialog::make_acts() {
  check_ = new QPushButton(tr("&Check"));
  check_->setObjectName("device_check");
  describe(*check_, tr("Check the device"),
           tr("Opens it, looks at it for a second and lets it go; nothing is recorded (Alt+C)"));
  form_->addRow(QString(), check_);
  progress_ = new QProgressBar;
  progress_->setObjectName("device_progress");
  progress_->setRange(0, 0);
  describe(*progress_, tr("Asking"), tr("Asking"));
  progress_->hide();
  result_ = new QLabel;
  result_->setObjectName("device_result");
  result_->setWordWrap(true);
  result_->setMinimumHeight(3 * fontMetrics().lineSpacing());
  result_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  connect(check_, &QPushButton::clicked, this, [this] { ask({draft()}); });
}

NamedDevice AddDeviceDialog::device() const {
  return {name_->text().trimmed().toStdString(), uri_of(draft())};
}

DeviceDraft AddDeviceDialog::draft() const {
  DeviceDraft draft;
  draft.kind = kDeviceKinds[static_cast<std::size_t>(std::max(0, kind_->currentIndex()))];
  draft.family = family_->currentData().toString().toStdString();
  draft.where = where_->currentText().trimmed().toStdString();
  draft.setup = setup_->currentData().toString().toStdString();
  if (is_cameras(draft.kind)) draft.rig = rig_->currentText().toStdString();
  return draft;
}

/// What there is to choose for that kind; nothing is typed in beforehand.
void AddDeviceDialog::offer() {
  const DeviceKind kind = draft().kind;
  family_->clear();
  for (const auto& family : families_of(kind)) family_->addItem(qt(family.title), qt(family.name));
  where_->clear();
  if (kind == DeviceKind::can)
    for (const auto& interface : here_.can) where_->addItem(qt(interface));
  where_->setEditText({});
  where_->lineEdit()->setPlaceholderText(
      kind == DeviceKind::can       ? QStringLiteral("can0")
      : kind == DeviceKind::network ? tr("192.168.1.1: the first of three in a row, or all three")
      : kind == DeviceKind::serial  ? tr("three ports, with commas")
      : kind == DeviceKind::script  ? QStringLiteral("127.0.0.1:6440")
                                    : QStringLiteral("192.168.0.7"));
  result_->clear();
  refresh();
}

void AddDeviceDialog::show_draft(const DeviceDraft& draft) {
  family_->setCurrentIndex(family_->findData(qt(draft.family)));
  where_->setEditText(qt(draft.where));
  refresh();
}

void AddDeviceDialog::refresh() {
  const DeviceDraft now = draft();
  const auto show_row = [this](QWidget& field, bool shown) {
    field.setVisible(shown);
    form_->labelForField(&field)->setVisible(shown);
  };
  show_row(*family_, family_->count() > 1);
  show_row(*setup_, is_force(now.kind));
  show_row(*rig_, is_cameras(now.kind));
  if (setup_->property("family") != qt(now.family)) {
    setup_->setProperty("family", qt(now.family));
    setup_->clear();
    setup_->addItem(tr("as delivered"), QString());
    for (const auto& file : toml_files_in(library_ + "/devices"))
      if (const auto config = DeviceConfig::read(file);
          config && config->family->name == now.family)
        setup_->addItem(qt(config->name.empty() ? fs::path(file).stem().string() : config->name),
                        qt(file));
  }
  const bool complete = !uri_of(draft()).empty();
  const bool asks = now_.has_value();
  check_->setEnabled(complete && !asks);
  find_->setEnabled(!asks && !candidates(now, here_).empty());
  const QString name = name_->text().trimmed();
  const bool taken = taken_.contains(name, Qt::CaseInsensitive);
  if (taken) result_->setText(tr("Another device has this name."));
  add_->setEnabled(complete && !asks && !name.isEmpty() && !taken);
  progress_->setVisible(asks);
}

void AddDeviceDialog::ask(std::vector<DeviceDraft> drafts) {
  if (now_ || drafts.empty()) return;
  std::reverse(drafts.begin(), drafts.end());
  left_ = std::move(drafts);
  asked_ = left_.size();
  asking_ = {};
  ask_next();
}

void AddDeviceDialog::ask_next() {
  now_ = std::move(left_.back());
  left_.pop_back();
  result_->setText(tr("Asking %1 …").arg(qt(now_->where)));
  refresh();
  worker_.run([uri = uri_of(*now_), library = library_, stop = asking_.get_token(),
               rows = apparatuses_] { return session::ask_device(uri, library, stop, rows); },
              [this](const Result<session::DeviceAnswer>& answer) { take(answer); });
}

void AddDeviceDialog::take(const Result<session::DeviceAnswer>& answer) {
  if (answer) {
    const DeviceDraft found = *now_;
    show_draft(found);
    return end_asking(words_of(*answer));
  }
  if (!left_.empty()) return ask_next();
  end_asking(asked_ > 1 ? tr("Nothing answers. Asked last: %1").arg(translated(answer.error()))
                        : translated(answer.error()));
}

void AddDeviceDialog::end_asking(const QString& words) {
  now_.reset();
  left_.clear();
  refresh();
  result_->setText(words);
}

}  // namespace isograsp::gui
