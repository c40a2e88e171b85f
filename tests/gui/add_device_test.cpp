// SPDX-License-Identifier: GPL-3.0-or-later
// A device is added by hand: no address is typed as a URI or shown as one; what is found and
// checked is asked over real sockets of this computer.
#include "gui/device_pages/add_device.hpp"

#include <QLineEdit>
#include <filesystem>

#include "device/config/net_ft_sensor.hpp"
#include "device/config/uri.hpp"
#include "gui/device_pages/device_list.hpp"
#include "operator.hpp"
#include "tests/device/net_ft_boxes.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::add_device_test {
namespace {

using isograsp::test::Boxes;
using isograsp::test::every;
using isograsp::test::must;
using isograsp::test::TemporaryFolder;

const std::string kLibrary = ISOGRASP_SOURCE_DIR "/library";

TEST(DeviceAddress, WhatIsFilledInBecomesAnAddressThatTheProgramKnows) {
  EXPECT_EQ(uri_of({DeviceKind::can, "rft", "can0", "", ""}), "can://can0?protocol=rft");
  EXPECT_EQ(uri_of({DeviceKind::network, "net-ft", "192.168.1.1", "", ""}),
            "udp://192.168.1.1,192.168.1.2,192.168.1.3?protocol=net-ft")
      << "the first of three in a row";
  EXPECT_EQ(uri_of({DeviceKind::network, "net-ft", "10.0.0.4, 10.0.0.9,10.0.0.2", "", ""}),
            "udp://10.0.0.4,10.0.0.9,10.0.0.2?protocol=net-ft");
  EXPECT_EQ(uri_of({DeviceKind::qualisys, "", "cameras", "", "kurillo15"}),
            "qtm://cameras?rig=kurillo15");
  EXPECT_EQ(uri_of({DeviceKind::leap, "", "127.0.0.1", "", ""}), "leap://127.0.0.1");
  const auto uri =
      must(Uri::parse(uri_of({DeviceKind::can, "rft", "can0", "/a b/100%&.toml", ""})));
  EXPECT_EQ(uri.parameters.at("config"), "/a b/100%&.toml");
}

TEST(DeviceAddress, WhatIsNotCompleteHasNone) {
  const std::vector<DeviceDraft> drafts{
      {DeviceKind::can, "rft", "", "", ""},
      {DeviceKind::can, "", "can0", "", ""},
      {DeviceKind::can, "rft", "can0,can1", "", ""},
      {DeviceKind::network, "net-ft", "192.168.1.254", "", ""},
      {DeviceKind::network, "net-ft", "boxes", "", ""},
      {DeviceKind::serial, "rft", "/dev/ttyUSB0,/dev/ttyUSB1", "", ""},
      {DeviceKind::motive, "", "127.0.0.1", "", ""},
      {DeviceKind::leap, "", "a,b", "", ""}};
  for (const auto& draft : every(drafts)) EXPECT_EQ(uri_of(draft), "") << draft.where;
}

TEST(DeviceAddress, EveryKindIsOfferedWithWordsAndForcesWithTheirFamilies) {
  for (const DeviceKind kind : every(kDeviceKinds)) {
    EXPECT_FALSE(words_of(kind).isEmpty());
    EXPECT_EQ(families_of(kind).empty(), !is_force(kind));
  }
}

TEST(DeviceAddress, FindAsksEveryInterfaceAndFamilyAndThePlaceThatWasGivenAlone) {
  const Surroundings here{{"can0", "can1"}, {"/dev/a", "/dev/b", "/dev/c", "/dev/d"}};
  const auto families = families_of(DeviceKind::can).size();
  ASSERT_GE(families, 2U);
  EXPECT_EQ(candidates({DeviceKind::can, "rft", "", "", ""}, here).size(), 2 * families);
  EXPECT_EQ(candidates({DeviceKind::can, "rft", "can1", "", ""}, here).size(), families);
  const auto lines = candidates({DeviceKind::serial, "rft", "", "", ""}, here);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].where, "/dev/a,/dev/b,/dev/c");
  EXPECT_TRUE(candidates({DeviceKind::network, "net-ft", "", "", ""}, here).empty())
      << "a network is not searched";
  EXPECT_TRUE(candidates({DeviceKind::serial, "rft", "", "", ""}, {}).empty());
  const auto service = candidates({DeviceKind::leap, "", "", "", ""}, here);
  ASSERT_EQ(service.size(), 1U);
  EXPECT_EQ(service[0].where, "127.0.0.1");
}

TEST(DeviceAddress, ThisComputersInterfacesAndPortsAreSeen) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("net/can0"));
  folder.write("net/can0/type", "280\n");
  std::filesystem::create_directories(folder.path("dev"));
  for (const char* name : {"dev/ttyUSB1", "dev/ttyUSB0", "dev/ttyS0"}) folder.write(name, "");
  const auto by_number = look_around(folder.path("net"), folder.path("dev"));
  EXPECT_EQ(by_number.can, std::vector<std::string>{"can0"});
  ASSERT_EQ(by_number.serial_ports.size(), 2U) << "a port of the board is none";
  EXPECT_TRUE(by_number.serial_ports[0].ends_with("ttyUSB0"));
  std::filesystem::create_directories(folder.path("dev/serial/by-id"));
  folder.write("dev/serial/by-id/usb-Robotous-1", "");
  EXPECT_EQ(look_around(folder.path("net"), folder.path("dev")).serial_ports.size(), 1U)
      << "by what is plugged in";
}

class AddDevice : public QtTest {
 protected:
  AddDevice()
      : windows_([&] {
          GuiConfig config{folder_.path("clinic.db"), "", kLibrary, "test"};
          config.settings = folder_.path("isograsp.ini");
          return config;
        }()),
        operator_(windows_) {
    EmulatorOptions options;
    options.config = DeviceConfig::standard(kNetFtFamily);
    boxes_ = std::make_unique<Boxes>(options);
    windows_.therapist().show();
    EXPECT_TRUE(wait_until([&] { return windows_.clinic().is_open(); }));
  }
  [[nodiscard]] QString addresses() const {
    return QString::fromStdString(boxes_->full_address(0) + "," + boxes_->full_address(1) + "," +
                                  boxes_->full_address(2));
  }
  /// The dialog, as it is opened from the list of devices.
  AddDeviceDialog& open() {
    operator_.prepare_person();
    auto& devices = operator_.find<QListWidget>("devices");
    devices.setCurrentRow(devices.count() - 1);
    auto* dialog = windows_.therapist().findChild<AddDeviceDialog*>();
    EXPECT_NE(dialog, nullptr);
    return *dialog;
  }

  TemporaryFolder folder_;
  std::unique_ptr<Boxes> boxes_;
  Windows windows_;
  Operator operator_;
};

TEST_F(AddDevice, IsCheckedNamedChosenAndStillThereAfterwards) {
  auto& dialog = open();
  auto& add = widget_called<QAbstractButton>("device_add", dialog);
  auto& result = widget_called<QLabel>("device_result", dialog);
  auto& kind = widget_called<QComboBox>("device_kind", dialog);
  keep_picture(dialog, "add_device");
  kind.setCurrentIndex(1);
  Q_EMIT kind.activated(1);
  widget_called<QComboBox>("device_where", dialog).setEditText(addresses());
  auto& check = widget_called<QAbstractButton>("device_check", dialog);
  constexpr int kMostLooks = 5;  // one of a busy computer may miss a part
  for (int look = 0; look < kMostLooks && !result.text().contains("times a second"); ++look) {
    QTest::mouseClick(&check, Qt::LeftButton);
    ASSERT_TRUE(wait_until([&] { return check.isEnabled(); }, 20));
  }
  ASSERT_TRUE(result.text().contains("times a second")) << result.text().toStdString();
  EXPECT_FALSE(add.isEnabled()) << "it has no name";
  widget_called<QLineEdit>("device_name", dialog).setText("Room 2");
  keep_picture(dialog, "add_device_checked");
  for (const auto* label : every(dialog.findChildren<QLabel*>()))
    EXPECT_FALSE(label->text().contains("://")) << label->text().toStdString();
  QTest::mouseClick(&add, Qt::LeftButton);
  auto& devices = operator_.find<QListWidget>("devices");
  ASSERT_TRUE(wait_until([&] { return devices.item(0)->text() == "Room 2"; }));
  EXPECT_EQ(devices.currentRow(), 0);
  const auto& uri = windows_.presenter().state().choices.device_uri;
  EXPECT_TRUE(uri.starts_with("udp://127.0.0.1")) << uri;
  const SettingsFile again(QString::fromStdString(folder_.path("isograsp.ini")));
  ASSERT_EQ(again.now().devices.size(), 1U);
  EXPECT_EQ(again.now().devices[0], (NamedDevice{"Room 2", uri}));
  operator_.press("device_forget");
  EXPECT_TRUE(windows_.presenter().state().choices.device_uri.empty());
  EXPECT_NE(devices.item(0)->text(), "Room 2");
}

TEST_F(AddDevice, NothingThatAnswersIsSaidInWordsAndNothingIsAdded) {
  auto& dialog = open();
  auto& result = widget_called<QLabel>("device_result", dialog);
  auto& kind = widget_called<QComboBox>("device_kind", dialog);
  kind.setCurrentIndex(0);
  Q_EMIT kind.activated(0);
  widget_called<QComboBox>("device_where", dialog).setEditText("nothere0");
  QTest::mouseClick(&widget_called<QAbstractButton>("device_find", dialog), Qt::LeftButton);
  ASSERT_TRUE(wait_until([&] { return result.text().startsWith("Nothing answers"); }, 20))
      << result.text().toStdString();
  dialog.reject();
  EXPECT_TRUE(windows_.presenter().state().choices.device_uri.empty());
}

}  // namespace
}  // namespace isograsp::gui::test::add_device_test
