// SPDX-License-Identifier: GPL-3.0-or-later
// The flat pictures of the patient's screen: what is said about them covers nothing that is to be
// read.
#include "gui/patient_screen/patient_canvas.hpp"

#include "qt_test.hpp"

namespace isograsp::gui::test::patient_canvas_test {
namespace {

using Page = PatientPicture::Page;

QImage painted(const PatientPicture& picture, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  const QRectF area(QPointF(0, 0), QSizeF(size));
  if (picture.page == Page::object)
    paint_banner(painter, area, picture);
  else
    paint_page(painter, area, picture);
  return image;
}

QRect difference(const QImage& a, const QImage& b) {
  QRect all;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      if (a.pixel(x, y) != b.pixel(x, y)) all |= QRect(x, y, 1, 1);
  return all;
}

class MarkOfASimulation : public QtTest {};

TEST_F(MarkOfASimulation, CoversNoWord) {
  const QString headline = "Press with the thumb and with both fingers, as hard as you can";
  for (const QSize size : {QSize(1280, 720), QSize(640, 720), QSize(960, 1080)})
    for (const bool urgent : {false, true})
      for (const Page page : {Page::effort, Page::tracking, Page::directions, Page::object})
        for (int letters = 10; letters <= headline.size(); letters += 4) {
          PatientPicture picture;
          picture.page = page;
          picture.urgent = urgent;
          const QImage unmarked = painted(picture, size);
          picture.simulated = true;
          const QImage silent = painted(picture, size);
          const QRect mark = difference(unmarked, silent).adjusted(-3, -3, 3, 3);
          ASSERT_FALSE(mark.isEmpty());
          picture.headline = headline.left(letters).toStdString();
          picture.detail = "Next: thumb and both fingers, as hard as you can, then let go";
          const QImage said = painted(picture, size);
          // The mark lies above the words: what it covers shows at its edge.
          EXPECT_TRUE(difference(silent.copy(mark), said.copy(mark)).isEmpty())
              << size.width() << " px wide, page " << static_cast<int>(page) << ", " << letters
              << " letters";
        }
}

}  // namespace
}  // namespace isograsp::gui::test::patient_canvas_test
