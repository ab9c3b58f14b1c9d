// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_DRAW_PARTS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_DRAW_PARTS_H

#include "draw/picture.h"
#include "io/shape.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

// Pictures of parts, many a second and without a display: a viewer needs one, and takes longer to start than this to
// draw a hundred.

namespace Draw_parts {

using Point = std::array<double, 3>;

/// Triangles, or points with normals where there are no triangles.
struct Scene
{
  std::vector<Point> points;
  std::vector<Point> normals; ///< of the points, if there are no faces
  std::vector<std::array<std::size_t, 3>> faces;
  std::vector<std::size_t>
      sources; ///< the element that a face is a piece of; empty: the face itself
};

/// the scene, with polygons cut into triangles; without what has a negative label.
Scene make_scene(const Shape_io::Shape& shape, const std::vector<int>& labels);

/// What is seen: the nearest element of each sample, none where there is nothing.
struct View
{
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  int width = 0, height = 0;
  std::vector<std::size_t> element;
  std::vector<float> shade;
  std::vector<float> depth;
};

/// Axes of the picture in space: to the right, upwards, and towards the eye.
using Camera = Eigen::Matrix3d;

/// number of samples along a side of a pixel
constexpr int samples = 3;

/// looks at the scene from far away, at a square of so many pixels.
View look(const Scene& scene, const Camera& camera, int size);

/// returns the one of several slanted views of the principal axes that shows most of the parts. The
/// longest axis goes to the right, or upwards if it is that of y.
Camera best_camera(const Scene& scene, const std::vector<int>& labels);

/// the same from all around, for a shape that stands upright
Camera best_upright_camera(const Scene& scene, const std::vector<int>& labels, const Point& up);

/// the picture of a view; lines between parts are dark, and so are outlines.
Picture make_picture(const View& view, const std::vector<int>& labels,
                     const std::vector<Color>& color_of_label);

} // namespace Draw_parts

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_DRAW_DRAW_PARTS_H
