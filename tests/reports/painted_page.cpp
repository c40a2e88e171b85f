// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reports/painted_page.hpp"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <cmath>
#include <numeric>

#include "reports/paper/pdf_page.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::test {

namespace {

class Notes : public QPaintEngine {
 public:
  explicit Notes(PaintedPage& page) : QPaintEngine(AllFeatures), page_(page) {}

  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState& now) override {
    if (now.state().testFlag(DirtyTransform)) transform_ = now.transform();
    if (now.state().testFlag(DirtyPen)) pen_ = now.pen();
  }
  [[nodiscard]] Type type() const override { return User; }
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawImage(const QRectF&, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {}

  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    const QString text = item.text().trimmed();
    if (text.isEmpty()) return;
    const double em = item.font().pixelSize();
    constexpr double kCapital = 0.73;  // of the size of DejaVu Sans
    constexpr double kBelow = 0.05;
    const double width = QFontMetricsF(item.font()).horizontalAdvance(text);
    const QRectF box(at.x(), at.y() - kCapital * em, width, (kCapital + kBelow) * em);
    constexpr double kLevel = 1e-6;
    const bool slanted = std::abs(transform_.m11()) > kLevel && std::abs(transform_.m12()) > kLevel;
    page_.texts.push_back({text, on_page(box), slanted});
  }
  void drawLines(const QLineF* lines, int count) override {
    for (int i = 0; i < count; ++i) add(lines[i]);
  }
  void drawPolygon(const QPointF* points, int count, PolygonDrawMode) override {
    for (int i = 1; i < count; ++i) add({points[i - 1], points[i]});
  }
  void drawPath(const QPainterPath& path) override {
    for (const QPolygonF& part : path.toSubpathPolygons())
      for (int i = 1; i < part.size(); ++i) add({part[i - 1], part[i]});
  }

 private:
  [[nodiscard]] QRectF on_page(const QRectF& box) const {
    const QRectF mapped = transform_.mapRect(box);
    return {mapped.topLeft() / reports::pdf::kUnit, mapped.size() / reports::pdf::kUnit};
  }
  void add(const QLineF& line) {
    if (pen_.style() == Qt::NoPen) return;
    const QLineF mapped = transform_.map(line);
    page_.lines.emplace_back(mapped.p1() / reports::pdf::kUnit, mapped.p2() / reports::pdf::kUnit);
  }

  PaintedPage& page_;
  QTransform transform_;
  QPen pen_;
};

/// A sheet of A4 that keeps notes of what is painted on it.
class Sheet : public QPaintDevice {
 public:
  explicit Sheet(PaintedPage& page) : notes_(page) {}
  [[nodiscard]] QPaintEngine* paintEngine() const override { return &notes_; }

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmWidth: return static_cast<int>(reports::pdf::kPageWidth * reports::pdf::kUnit);
      case PdmHeight: return static_cast<int>(reports::pdf::kPageHeight * reports::pdf::kUnit);
      case PdmDpiX:
      case PdmDpiY:
      case PdmPhysicalDpiX:
      case PdmPhysicalDpiY: return reports::pdf::kResolution;
      case PdmDevicePixelRatio: return 1;
      case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
      case PdmWidthMM: return 210;
      case PdmHeightMM: return 297;
      default: return 0;
    }
  }

 private:
  mutable Notes notes_;
};

}  // namespace

PaintedPage painted(const reports::ReportPages& pages, int page) {
  PaintedPage result;
  Sheet sheet(result);
  QCPPainter painter(&sheet);
  for (int step = 0; step < pages.steps(page); ++step) pages.paint(painter, page, step);
  painter.end();
  return result;
}

std::vector<QString> overprinted(const PaintedPage& page) {
  constexpr double kTouch = 0.4;  // points: letters may come as near
  std::vector<QString> pairs;
  for (std::size_t i = 0; i < page.texts.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const auto& [text, box, slanted] = page.texts[i];
      const auto& other = page.texts[k];
      if (slanted || other.slanted) continue;
      const QRectF common = box.intersected(other.box);
      if (common.width() > kTouch && common.height() > kTouch)
        pairs.push_back("'" + text + "' lies on '" + other.text + "' at " +
                        QString::number(common.x()) + ", " + QString::number(common.y()));
    }
  return pairs;
}

std::vector<int> all_pages(const reports::ReportPages& pages) {
  std::vector<int> numbers(static_cast<std::size_t>(pages.pages()));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

}  // namespace isograsp::test
