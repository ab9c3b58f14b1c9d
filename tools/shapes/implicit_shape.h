// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_SHAPE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_SHAPE_H

#include "shapes/implicit_primitives.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

// A solid as the union of named parts, each of them the union of primitives.

namespace Shape_generator {

// Position and radius on the axis of a limb.
struct Station
{
  Point position;
  double radius;
};

class Implicit_shape
{
public:
  // Parts melt into each other over the length `blend`; `sharp` keeps edges and corners.
  explicit Implicit_shape(double blend = 0, bool sharp = false) : m_blend(blend), m_sharp(sharp) {}

  std::size_t add_part(const std::string& name);

  template <class Primitive_type, class... Arguments>
  void add(std::size_t part, const Arguments&... arguments)
  {
    const auto primitive = std::make_shared<const Primitive_type>(arguments...);
    m_parts[part].primitives.push_back(primitive);
    const Box box = primitive->box();
    for (Box* target : {&m_box, &m_parts[part].box})
    {
      target->extend(box.lower, 0);
      target->extend(box.upper, 0);
    }
  }

  void add_ball(std::size_t part, const Point& center, double radius);

  // A tube along a smooth curve through the stations.
  void add_limb(std::size_t part, const std::vector<Station>& stations,
                const Point& spread = {0, 0, 0});

  double distance(const Point& p) const;

  Point gradient(const Point& p) const;

  // Moves p to the surface along the gradient, but at most by max_step per iteration.
  Point project(Point p, double max_step) const;

  // The part that p is nearest to; of parts at the same distance the first one.
  int nearest_part(const Point& p) const;

  std::vector<std::string> part_names() const;

  const Box& box() const { return m_box; }
  bool is_sharp() const { return m_sharp; }

private:
  struct Part
  {
    std::string name;
    std::vector<std::shared_ptr<const Primitive>> primitives;
    Box box;

    double distance(const Point& p) const
    {
      double result = std::numeric_limits<double>::infinity();
      for (const std::shared_ptr<const Primitive>& primitive : primitives)
        result = (std::min)(result, primitive->distance(p));
      return result;
    }
  };

  double smooth_minimum(double a, double b) const;

  // Catmull-Rom interpolation between the stations i and i+1.
  static Station between(const std::vector<Station>& stations, std::size_t i, double t);

  std::vector<Part> m_parts;
  Box m_box;
  double m_blend;
  bool m_sharp;
};

} // namespace Shape_generator

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SHAPES_IMPLICIT_SHAPE_H
