// SPDX-License-Identifier: GPL-3.0-or-later
// The convex hull of primitive wrenches, by Qhull.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include <libqhull_r/libqhull_r.h>

#include "grasp_model/grasp.hpp"

namespace isograsp {

Result<double> epsilon_quality(const Eigen::MatrixXd& wrenches) {
  const Eigen::Index dimensions = wrenches.rows();
  if (!wrenches.allFinite()) return refused("not a finite wrench"_text, "leave it out"_text);
  if (wrenches.cols() <= dimensions) return 0.0;
  const Eigen::MatrixXd about_mean = wrenches.colwise() - wrenches.rowwise().mean();
  if (criteria(about_mean).rank < static_cast<int>(dimensions)) return 0.0;  // a flat hull

  Eigen::MatrixXd points = wrenches;  // Qhull may write into its input
  char* printed = nullptr;
  std::size_t length = 0;
  std::FILE* errors = open_memstream(&printed, &length);
  char command[] = "qhull Pp";
  qhT hull;
  qh_zero(&hull, errors);
  const int status =
      qh_new_qhull(&hull, static_cast<int>(dimensions), static_cast<int>(points.cols()),
                   points.data(), False, command, nullptr, errors);
  double least = std::numeric_limits<double>::infinity();
  if (status == qh_ERRnone)
    for (const facetT* facet = hull.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next)
      least = std::min(least, -facet->offset);
  qh_freeqhull(&hull, !qh_ALL);
  int pieces = 0;
  int bytes = 0;
  qh_memfreeshort(&hull, &pieces, &bytes);
  std::fclose(errors);
  const std::string message(printed, length);
  std::free(printed);
  if (status != qh_ERRnone)
    return failed(
        "no convex hull of these wrenches: %1"_text(message.substr(0, message.find('\n'))),
        "leave out wrenches that almost coincide"_text);
  return std::max(0.0, least);
}

}  // namespace isograsp
