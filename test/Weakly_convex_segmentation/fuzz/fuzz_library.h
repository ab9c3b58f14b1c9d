// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_FUZZ_LIBRARY_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_FUZZ_LIBRARY_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/weakly_convex_segmentation.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// What bytes say about a shape, and the one thing that fuzzers and the bounded replay do with it.

namespace Fuzz_library {

namespace WCS = CGAL::Weakly_convex_segmentation;
using Kernel = CGAL::Simple_cartesian<double>;
using Element = std::pair<Kernel::Point_3, Kernel::Vector_3>;

/// Takes numbers off the front of the bytes; zeros when there are no more.
class Byte_source
{
  const std::uint8_t* m_data;
  std::size_t m_size;

public:
  Byte_source(const std::uint8_t* data, const std::size_t size) : m_data(data), m_size(size) {}
  bool is_empty() const { return m_size == 0; }
  std::uint8_t byte()
  {
    if (m_size == 0) return 0;
    --m_size;
    return *m_data++;
  }
  /// small whole numbers, so that points coincide, or with `any` any double
  double number(const bool any)
  {
    if (!any) return static_cast<double>(static_cast<std::int8_t>(byte())) / 16.;
    std::uint8_t bytes[sizeof(double)];
    for (std::uint8_t& b : bytes) b = byte();
    double value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }
};

struct No_map
{
  using key_type = Element;
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  template <typename Key>
  friend void put(const No_map&, const Key&, int)
  {}
};

/// ends the process if not every element has a label, or labels have gaps
inline void require_labels(const WCS::Result& result, const std::size_t count)
{
  const std::set<int> labels(result.labels.begin(), result.labels.end());
  if (result.labels.size() != count || labels.empty() || *labels.begin() != 0 ||
      static_cast<std::size_t>(*labels.rbegin()) + 1 != labels.size() ||
      labels.size() != result.number_of_segments())
    std::abort();
}

inline void run_soup(Byte_source& source, const bool any, const WCS::Parameters& parameters)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  const std::size_t count = source.byte();
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = source.number(any), y = source.number(any);
    points.emplace_back(x, y, source.number(any));
  }
  while (!source.is_empty() && polygons.size() < 300)
  {
    std::vector<std::size_t> polygon(3 + source.byte() % 3u);
    for (std::size_t& v : polygon) v = source.byte();
    polygons.push_back(polygon);
  }
  require_labels(CGAL::weakly_convex_segmentation_of_soup(points, polygons, parameters),
                 polygons.size());
}

inline void run_cloud(Byte_source& source, const bool any, const bool has_normals,
                      const WCS::Parameters& parameters)
{
  std::vector<Element> elements;
  while (!source.is_empty() && elements.size() < 300)
  {
    const double x = source.number(any), y = source.number(any), z = source.number(any);
    Kernel::Vector_3 normal(0., 0., 0.);
    if (has_normals)
    {
      const double u = source.number(any), v = source.number(any);
      normal = Kernel::Vector_3(u, v, source.number(any));
    }
    elements.push_back({Kernel::Point_3(x, y, z), normal});
  }
  const auto points = CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Element>());
  const WCS::Result result =
      has_normals ? CGAL::weakly_convex_segmentation(
                        elements, No_map(), parameters,
                        points.normal_map(CGAL::Second_of_pair_property_map<Element>()))
                  : CGAL::weakly_convex_segmentation(elements, No_map(), parameters, points);
  require_labels(result, elements.size());
}

/// segments what the bytes say: an answer or an `std::invalid_argument`, and nothing else.
/// \returns whether there was an answer
inline bool run(const std::uint8_t* data, const std::size_t size)
{
  Byte_source source(data, size);
  const unsigned int kind = source.byte();
  const bool any = (kind & 4u) != 0;
  WCS::Parameters parameters = (kind & 8u) != 0    ? WCS::Parameters::paper()
                               : (kind & 16u) != 0 ? WCS::Parameters::training_free()
                                                   : WCS::Parameters();
  parameters.number_of_patches = 10; // small shapes, many of them
  parameters.number_of_representatives = 300;
  try
  {
    if ((kind & 1u) != 0)
      run_soup(source, any, parameters);
    else
      run_cloud(source, any, (kind & 2u) != 0, parameters);
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  return true;
}

} // namespace Fuzz_library

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TEST_FUZZ_LIBRARY_H
