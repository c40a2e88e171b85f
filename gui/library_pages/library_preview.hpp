// SPDX-License-Identifier: GPL-3.0-or-later
// What a task, scene, protocol or file of postures will be, told from its text before anybody runs
// it: facts in words, the target over time, the object from above, the steps with their durations.
// Knows no widget.
#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <optional>
#include <vector>

#include "grasp_model/patch/contact_patch.hpp"
#include "gui/library/library_files.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::gui {

struct LibraryPreview {
  struct Fact {
    QString label;
    QString words;  ///< may be of several lines
  };
  /// A target over time.
  struct Curve {
    QString axis;  ///< "% of the maximum", "N"
    double period_s = 0.0;
    std::vector<double> values;  ///< NaN: nothing is asked
    std::vector<bool> hidden;    ///< … or it is, and the patient does not see it
  };
  /// The object in the plane of x and y [m].
  struct Sketch {
    struct Touch {
      QPointF place;
      QPointF inward;   ///< unit vector, or shorter where the normal leaves the plane
      QString letters;  ///< whose it is
      std::optional<Finger> finger = std::nullopt;  ///< nothing: a whole hand
    };
    struct Target {
      QPointF place;
      double angle_rad = 0.0;
      bool start = false;  ///< where an object appears
    };
    QPolygonF outline;  ///< about its centre of mass
    std::vector<Touch> touches;
    std::vector<Target> targets;
  };
  /// What a pad covers of the object, as the pad looks at it: x along the tangent, from its contact
  /// point [m].
  struct Patch {
    QString title;
    QString words;               ///< area, middle, limits and rays, a line each
    QPolygonF object;            ///< its outline
    QPolygonF pad;               ///< as far as it reaches
    QPolygonF outline;           ///< of the patch, one corner for each ray
    std::vector<RayStop> stops;  ///< why each of these rays ended
    QPointF centroid;
  };
  struct Step {
    QString words;
    tasks::Duration duration;  ///< by which this step makes the protocol longer
  };

  QString title;
  std::vector<Fact> facts;
  std::optional<Curve> curve;
  std::optional<Sketch> sketch;
  std::vector<Patch> patches;
  std::vector<Step> steps;
};

/// Of a text that LibraryFiles::check() takes; empty for any other. Measures what a scene costs, so
/// it takes some milliseconds; any thread.
[[nodiscard]] LibraryPreview preview_of(LibraryKind kind, const std::string& text,
                                        const std::string& path, const std::string& shipped);

/// "45 s", "3 min 20 s".
[[nodiscard]] QString time_words(double duration_s);

}  // namespace isograsp::gui
