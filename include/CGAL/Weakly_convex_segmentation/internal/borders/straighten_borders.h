// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_STRAIGHTEN_BORDERS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_STRAIGHTEN_BORDERS_H

// On a mesh, borders are paths of edges. The cuts before this see points, and leave paths that zigzag; here these
// become short and straight in the true edges, and go to the creases near them. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/Parameters.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/border_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/borders/seam_cuts.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Run_control.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The energy of the borders of labels of the faces: their length, less in concave creases, what they bend, and the
/// area that has another label than at first.
class Border_energy
{
public:
  /// `area_cost`: of an area, as a length
  Border_energy(const Border_mesh& border, const std::vector<int>& of_faces, const double area_cost)
    : labels(of_faces), m_border(border), m_first(of_faces), m_area_cost(area_cost),
      m_seen_edges(border.edges.size(), 0), m_seen_vertices(border.vertices.size(), 0)
  {
    double sum = 0.;
    for (const Border_edge& e : border.edges) sum += e.length;
    m_mean = border.edges.empty() ? 0. : sum / static_cast<double>(border.edges.size());
  }

  std::vector<int> labels; ///< of the faces of the border mesh

  double mean_length() const { return m_mean; }

  bool is_border(const Index edge) const
  {
    const Border_edge& e = m_border.edges[edge];
    return labels[e.faces[0]] != labels[e.faces[1]];
  }

  /// returns the part of the energy that depends on the labels of some faces.
  double around(const std::vector<Index>& faces)
  {
    ++m_round;
    double sum = 0.;
    for (const Index f : faces)
    {
      if (labels[f] != m_first[f]) sum += m_area_cost * m_border.areas[f];
      for (const Index e : m_border.edges_of_face[f])
        if (is_new(m_seen_edges[e]) && is_border(e)) sum += m_border.edges[e].cost;
    }
    for (const Index f : faces)
      for (const Index v : m_border.vertices_of_face[f])
        if (is_new(m_seen_vertices[v])) sum += bend(v);
    return sum;
  }

private:
  bool is_new(std::size_t& seen) const
  {
    const bool result = seen != m_round;
    seen = m_round;
    return result;
  }

  /// returns the cost of how the border turns at a vertex: the square of the angle, times the length of the
  /// border there. Where a segment touches itself, it is that of a border that turns back.
  double bend(const Index v) const
  {
    constexpr double pi = 3.14159265358979323846;
    std::array<Index, 2> border_edges = {0, 0};
    std::size_t degree = 0;
    for (const Index e : m_border.edges_of_vertex[v])
    {
      if (!is_border(e)) continue;
      if (degree < 2) border_edges[degree] = e;
      ++degree;
    }
    if (degree > 3) return pi * pi * m_mean;
    if (degree != 2) return 0.; // ends at the edge of the mesh, or three segments meet
    const Border_edge &e = m_border.edges[border_edges[0]], &f = m_border.edges[border_edges[1]];
    const Vector3 to = m_border.vertices[v] - m_border.vertices[e.other_end(v)];
    const Vector3 from = m_border.vertices[f.other_end(v)] - m_border.vertices[v];
    const double turn = angle(normalized(to), normalized(from));
    return 0.5 * (e.length + f.length) * turn * turn;
  }

  const Border_mesh& m_border;
  std::vector<int> m_first;
  double m_area_cost, m_mean;
  std::size_t m_round = 0;
  std::vector<std::size_t> m_seen_edges, m_seen_vertices; ///< when they were counted last
};

/// Lowers the energy by one small move after the other, the best at a vertex: a face near it, all of one label
/// around it, or also all of that label around the next vertex of the border change to another label. Single
/// faces alone would be stuck where a whole row has to change.
class Border_straightening
{
public:
  /// `sizes`: the number of faces of each label in the whole mesh, of which none is to vanish
  Border_straightening(const Border_mesh& border, Border_energy& energy,
                       std::vector<std::size_t> sizes)
    : m_border(border), m_energy(energy), m_sizes(std::move(sizes))
  {}

  void run(const Run_control& control)
  {
    std::vector<char> is_waiting(m_border.vertices.size(), 0);
    std::vector<Index> waiting;
    const auto wait = [&](const Index v)
    {
      if (is_waiting[v] == 0) waiting.push_back(v);
      is_waiting[v] = 1;
    };
    for (Index v = 0; v < m_border.vertices.size(); ++v)
      for (const Index e : m_border.edges_of_vertex[v])
        if (m_energy.is_border(e)) wait(v);
    for (std::size_t i = 0; i < waiting.size(); ++i)
    {
      control.check_sometimes();
      const Index v = waiting[i];
      is_waiting[v] = 0;
      if (!improve(v)) continue;
      for (const Index f : m_best.faces)
        for (const Index w : m_border.vertices_of_face[f]) wait(w);
    }
  }

private:
  struct Move
  {
    std::vector<Index> faces;
    int label = 0;
    double gain = 0.;
  };

  /// appends the faces of a label around a vertex that may change and are not there yet.
  void add_around(const Index v, const int label, std::vector<Index>& faces) const
  {
    for (const Index f : m_border.faces_of_vertex[v])
      if (m_energy.labels[f] == label && m_border.may_change[f] != 0 &&
          std::find(faces.begin(), faces.end(), f) == faces.end())
        faces.push_back(f);
  }

  void set_labels(const std::vector<Index>& faces, const int label)
  {
    for (const Index f : faces) m_energy.labels[f] = label;
  }

  /// keeps the move of some faces of one label if it gains most.
  void consider(const std::vector<Index>& faces, const int label)
  {
    const int own = m_energy.labels[faces.front()];
    if (m_sizes[own] <= faces.size()) return;
    const double before = m_energy.around(faces);
    set_labels(faces, label);
    const double gain = before - m_energy.around(faces);
    set_labels(faces, own);
    const double least = 1e-6 * m_energy.mean_length(); // what rounding may feign
    if (gain > m_best.gain + least) m_best = {faces, label, gain};
  }

  /// considers all moves of faces of one label around a vertex to another label.
  void consider_moves(const Index v, const int own, const int label)
  {
    m_around.clear();
    add_around(v, own, m_around);
    if (m_around.empty()) return;
    consider(m_around, label);
    if (m_around.size() > 1)
      for (const Index f : m_around) consider({f}, label);
    for (const Index e : m_border.edges_of_vertex[v])
    {
      if (!m_energy.is_border(e)) continue;
      m_more = m_around;
      add_around(m_border.edges[e].other_end(v), own, m_more);
      if (m_more.size() > m_around.size()) consider(m_more, label);
    }
  }

  /// makes the best move at a vertex; returns whether there was one.
  bool improve(const Index v)
  {
    std::vector<int> labels;
    for (const Index f : m_border.faces_of_vertex[v])
      if (std::find(labels.begin(), labels.end(), m_energy.labels[f]) == labels.end())
        labels.push_back(m_energy.labels[f]);
    m_best = {};
    for (const int own : labels)
      for (const int label : labels)
        if (own != label) consider_moves(v, own, label);
    if (m_best.faces.empty()) return false;
    m_sizes[m_energy.labels[m_best.faces.front()]] -= m_best.faces.size();
    m_sizes[m_best.label] += m_best.faces.size();
    set_labels(m_best.faces, m_best.label);
    return true;
  }

  const Border_mesh& m_border;
  Border_energy& m_energy;
  std::vector<std::size_t> m_sizes;
  std::vector<Index> m_around, m_more;
  Move m_best;
};

/// straightens the borders between labels of the faces of a mesh; labels are numbered from 0.
///
/// Faces move that are up to three edges from a border, and none but these and the next is looked at. To move a
/// border by the band's width costs half of its length. Complexity: linear in the faces, but for a sort of those near
/// borders.
inline void straighten_borders(const Mesh_faces& mesh, const Oriented_points& points,
                               const Border_parameters& parameters, const Run_control& control,
                               std::vector<int>& labels)
{
  constexpr int steps = 4;
  constexpr double move_weight = 0.5;
  if (mesh.first_corner.size() != labels.size() + 1) return;
  Border_mesh border = faces_near_borders(mesh, labels, points.placement, steps);
  if (border.faces.empty()) return;
  control.check();
  measure_faces(points, border);
  for (Border_edge& e : border.edges)
    e.cost = e.length * static_cast<float>(border_cost(e.concavity));

  std::vector<int> own;
  for (const Index f : border.faces) own.push_back(labels[f]);
  std::vector<std::size_t> sizes;
  for (const int label : labels)
  {
    if (static_cast<std::size_t>(label) >= sizes.size())
      sizes.resize(static_cast<std::size_t>(label) + 1);
    ++sizes[label];
  }
  Border_energy energy(border, own, move_weight / parameters.band_width);
  Border_straightening(border, energy, std::move(sizes)).run(control);
  for (std::size_t i = 0; i < border.faces.size(); ++i) labels[border.faces[i]] = energy.labels[i];
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_STRAIGHTEN_BORDERS_H
