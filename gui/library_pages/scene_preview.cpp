// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/library_pages/scene_preview.hpp"

#include <QCoreApplication>
#include <QRectF>
#include <algorithm>
#include <cmath>

#include "bimanual/read_hands.hpp"
#include "grasp_model/grasp.hpp"
#include "grasp_model/plan_words.hpp"
#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "session/platform/plan_cost.hpp"

namespace isograsp::gui {

namespace {

struct SceneTexts {
  Q_DECLARE_TR_FUNCTIONS(ScenePreview)
};

constexpr int kCorners = 48;  ///< of what is round
constexpr double kPerMillimetre = 1e3;

QPointF on_circle(double radius, int k) {
  return radius * QPointF(std::cos(2.0 * M_PI * k / kCorners), std::sin(2.0 * M_PI * k / kCorners));
}

QPolygonF outline_of(const Scene& scene) {
  const double across = scene.size_m.x();
  if (scene.shape == Shape::box) {
    const QSizeF size(across, scene.size_m.y());
    return QPolygonF(QRectF(QPointF(-size.width() / 2.0, -size.height() / 2.0), size));
  }
  QPolygonF circle;
  for (int k = 0; k <= kCorners; ++k) circle << on_circle(0.5 * across, k);
  return circle;
}

void add_touch(const Contact& contact, const QString& letters, std::optional<Finger> finger,
               LibraryPreview::Sketch& sketch) {
  sketch.touches.push_back({{contact.p_OC.x(), contact.p_OC.y()},
                            {contact.R_OC(0, 2), contact.R_OC(1, 2)},
                            letters,
                            finger});
}

/// Points whose hull is the object, object axes.
std::vector<Vec3> corners_of(const Scene& object) {
  std::vector<Vec3> corners;
  if (object.shape == Shape::box) {
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        for (const double z : {-0.5, 0.5})
          corners.push_back(object.size_m.cwiseProduct(Vec3(x, y, z)));
    return corners;
  }
  for (int k = 0; k < kCorners; ++k) {
    const QPointF p = on_circle(0.5 * object.size_m.x(), k);
    for (const double end : {-0.5, 0.5})
      corners.emplace_back(p.x(), p.y(), end * object.size_m.y());
  }
  return corners;
}

double turn_of(const QPointF& a, const QPointF& b, const QPointF& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

QPolygonF hull_of(std::vector<QPointF> points) {
  std::sort(points.begin(), points.end(), [](const QPointF& a, const QPointF& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  QPolygonF hull;
  for (int way = 0; way < 2; ++way) {  // below, then above
    const int begin = hull.size();
    for (const QPointF& p : points) {
      while (hull.size() >= begin + 2 && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0.0)
        hull.removeLast();
      hull << p;
    }
    hull.removeLast();  // it begins the other half
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The object as the contact looks at it along its normal: x and y of the contact, from its point.
QPolygonF seen_from(const PatchFrame& frame, const Scene& object) {
  std::vector<QPointF> points;
  if (object.shape == Shape::sphere) {
    const QPointF middle(-frame.p.dot(frame.x), -frame.p.dot(frame.y));
    for (int k = 0; k < kCorners; ++k)
      points.push_back(middle + on_circle(0.5 * object.size_m.x(), k));
  } else {
    for (const Vec3& corner : corners_of(object))
      points.emplace_back((corner - frame.p).dot(frame.x), (corner - frame.p).dot(frame.y));
  }
  return hull_of(std::move(points));
}

QString words_of(const std::array<std::size_t, kRayStopNames.size()>& stopped) {
  const std::array<QString, kRayStopNames.size()> phrases{
      SceneTexts::tr("%1 reach the end of the pad"), SceneTexts::tr("%1 stop at an edge"),
      SceneTexts::tr("%1 stop where friction no longer holds"),
      SceneTexts::tr("%1 stop where the surface ends")};
  QStringList words;
  for (std::size_t i = 0; i < stopped.size(); ++i)
    if (stopped[i] > 0) words << phrases[i].arg(stopped[i]);
  return words.join(QStringLiteral(", "));
}

QString millimetres(double length_m) {
  constexpr double kShown_m = 5e-6;  // less is 0.00, whatever its sign
  return short_number(std::abs(length_m) < kShown_m ? 0.0 : kPerMillimetre * length_m);
}

QString words_of(const ContactPatch& patch, const Pad& pad) {
  const double whole_m2 = M_PI * pad.semi_x_m * pad.semi_y_m;
  const QStringList lines{
      SceneTexts::tr("covers %1 of the %2 mm² of the pad")
          .arg(short_number(kPerMillimetre * kPerMillimetre * patch.area_m2),
               short_number(kPerMillimetre * kPerMillimetre * whole_m2)),
      SceneTexts::tr("middle: %1 mm along the tangent, %2 mm across it")
          .arg(millimetres(patch.centroid_m.x()), millimetres(patch.centroid_m.y())),
      SceneTexts::tr("torsion: at most %1 N mm for each newton of pressure, %2 as a pure torque")
          .arg(millimetres(patch.torsion_m), millimetres(patch.pure_torsion_limit_m)),
      SceneTexts::tr("of %1 rays: %2").arg(pad.rays).arg(words_of(patch.stopped))};
  return lines.join(QLatin1Char('\n'));
}

/// Of each contact that is a pad, what it covers and why no more of it.
void add_patch(const Contact& contact, const Scene& object, const QString& title,
               LibraryPreview& preview) {
  if (!contact.pad) return;
  preview.patches.push_back(patch_of(contact, object, title));
  preview.facts.push_back({SceneTexts::tr("Pad: %1").arg(title), preview.patches.back().words});
}

/// The sets of fingers that hold the object against any push, in words.
QString closed_by(const Scene& scene) {
  const auto rows = rows_of(scene);
  QStringList sets;
  for (unsigned mask = 1; mask < 1U << scene.contacts.size(); ++mask) {
    std::vector<Contact> contacts;
    QStringList fingers;
    for (std::size_t i = 0; i < scene.contacts.size(); ++i)
      if ((mask >> i & 1U) != 0) {
        contacts.push_back(scene.contacts[i]);
        fingers << qt(name_of(scene.contacts[i].finger));
      }
    if (force_closure(contacts, rows)) sets << fingers.join(QStringLiteral(" + "));
  }
  return sets.isEmpty() ? SceneTexts::tr("no set of fingers") : sets.join(QStringLiteral("; "));
}

LibraryPreview::Fact mass_of(const Scene& scene) {
  return {SceneTexts::tr("Mass"), SceneTexts::tr("%1 kg").arg(short_number(scene.mass_kg))};
}

/// `contacts`: those of one hand are in the plan.
void add_plan(const Plan& plan, bool contacts, std::vector<LibraryPreview::Fact>& facts) {
  const auto word = [contacts](const std::string& name) -> QString {
    if (name == "translation") return SceneTexts::tr("Moves");
    if (name == "rotation") return SceneTexts::tr("Turns");
    if (name == "wrench_frame") return SceneTexts::tr("Forces act in");
    if (name == "limits") return SceneTexts::tr("Limits of travel");
    if (!contacts) return {};
    if (name == "contacts") return SceneTexts::tr("Contacts");
    if (name == "grasp_rule") return SceneTexts::tr("Grasp rule");
    return {};
  };
  for (const auto& [name, text] : isograsp::words_of(plan))
    if (const auto label = word(name); !label.isEmpty())
      facts.push_back({label, QString::fromStdString(text)});
}

LibraryPreview of_one_hand(const Scene& scene, const Plan& plan) {
  LibraryPreview preview;
  preview.title = QString::fromStdString(scene.name);
  preview.sketch = sketch_of(scene);
  preview.facts.push_back(mass_of(scene));
  for (const Contact& contact : scene.contacts)
    add_patch(contact, scene, finger_title(contact.finger), preview);
  preview.facts.push_back({SceneTexts::tr("Held firmly by"), closed_by(scene)});
  add_plan(plan, true, preview.facts);
  preview.facts.push_back(
      {SceneTexts::tr("Cost"), SceneTexts::tr("%1 ns per frame, measured here")
                                   .arg(session::cost_ns_per_frame(plan), 0, 'f', 0)});
  return preview;
}

QString words_of(bimanual::Coupling coupling) {
  switch (coupling) {
    case bimanual::Coupling::none: return SceneTexts::tr("press without an object");
    case bimanual::Coupling::force: return SceneTexts::tr("press the object with their forces");
    case bimanual::Coupling::proxy: break;
  }
  return SceneTexts::tr("are points that forces move");
}

void add_contacts(const bimanual::HandsScene& scene, LibraryPreview& preview) {
  const std::array<QString, bimanual::kSides> hands{SceneTexts::tr("left hand"),
                                                    SceneTexts::tr("right hand")};
  const std::array<QString, bimanual::kSides> letters{SceneTexts::tr("L", "left hand"),
                                                      SceneTexts::tr("R", "right hand")};
  for (std::size_t side = 0; side < bimanual::kSides; ++side) {
    const bimanual::HandContacts& hand = scene.contacts[side];
    for (const Contact& contact : hand.contacts) {
      const QString finger = hand.whole ? QString() : finger_title(contact.finger);
      const QString title =
          hand.whole ? hands[side] : SceneTexts::tr("%1, %2").arg(hands[side], finger);
      add_touch(contact, letters[side] + finger.left(1),
                hand.whole ? std::nullopt : std::optional(contact.finger), *preview.sketch);
      add_patch(contact, scene.object, title, preview);
    }
  }
}

LibraryPreview of_two_hands(const bimanual::HandsScene& scene) {
  LibraryPreview preview;
  preview.title = QString::fromStdString(scene.object.name);
  preview.facts.push_back({SceneTexts::tr("Two hands"), words_of(scene.coupling)});
  if (scene.coupling == bimanual::Coupling::none) return preview;
  const auto plan = Plan::compile(scene.object, kLibraryHold_s);
  if (!plan) return {};
  preview.sketch = LibraryPreview::Sketch{outline_of(scene.object), {}, {}};
  preview.facts.push_back(mass_of(scene.object));
  add_contacts(scene, preview);
  add_plan(*plan, false, preview.facts);
  return preview;
}

}  // namespace

LibraryPreview::Sketch sketch_of(const Scene& scene) {
  LibraryPreview::Sketch sketch;
  sketch.outline = outline_of(scene);
  for (const Contact& contact : scene.contacts)
    add_touch(contact, finger_title(contact.finger).left(1), contact.finger, sketch);
  return sketch;
}

LibraryPreview::Patch patch_of(const Contact& contact, const Scene& object, const QString& title) {
  const Pad& pad = *contact.pad;
  const PatchFrame frame = frame_of(contact);
  LibraryPreview::Patch drawn;
  drawn.title = title;
  drawn.object = seen_from(frame, object);
  const auto rays = surface_of_solid(object.shape, object.size_m)->rays(frame, pad);
  if (!rays) return drawn;  // told when the scene was read
  for (int k = 0; k < pad.rays; ++k) {
    const PadReach reach = reach_of_ray(pad, k);
    drawn.pad << reach.limit_m * QPointF(std::cos(reach.angle_rad), std::sin(reach.angle_rad));
  }
  const ContactPatch patch = isograsp::patch_of(*rays, pad);
  for (const Vec2& p : patch.outline_m) drawn.outline << QPointF(p.x(), p.y());
  for (const PatchRay& ray : *rays) drawn.stops.push_back(ray.stop);
  drawn.centroid = {patch.centroid_m.x(), patch.centroid_m.y()};
  drawn.words = words_of(patch, pad);
  return drawn;
}

LibraryPreview preview_of_scene(const std::string& text, const std::string& path) {
  if (bimanual::has_hands(text)) {
    const auto scene = bimanual::parse_hands_scene(text, path);
    return scene ? of_two_hands(*scene) : LibraryPreview{};
  }
  const auto scene = parse_scene(text, path);
  if (!scene) return {};
  const auto plan = Plan::compile(*scene, kLibraryHold_s);
  return plan ? of_one_hand(*scene, *plan) : LibraryPreview{};
}

}  // namespace isograsp::gui
