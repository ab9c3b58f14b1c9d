// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SOFT_LABELS_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SOFT_LABELS_H

// How much of each label there is at a vertex of a mesh, smoothed along the surface: where two labels are equally much
// there is a smooth border, which does not follow the edges. The paper has nothing like it.

#include <CGAL/Weakly_convex_segmentation/internal/borders/welded_mesh.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Compressed_rows.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Vector3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// The shares of labels at one vertex, ascending by label.
using Shares = std::vector<std::pair<int, double>>;

inline double share_of(const Shares& shares, const int label)
{
  for (const auto& [other, share] : shares)
    if (other == label) return share;
  return 0.;
}

/// returns the label that there is most of.
inline int main_label(const Shares& shares)
{
  return std::max_element(shares.begin(), shares.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/// adds to the share of a label.
inline void add_share(const int label, const double share, Shares& shares)
{
  auto at = std::lower_bound(shares.begin(), shares.end(), label,
                             [](const auto& entry, const int l) { return entry.first < l; });
  if (at == shares.end() || at->first != label) at = shares.insert(at, {label, 0.});
  at->second += share;
}

struct Soft_labels
{
  std::vector<Shares> shares; ///< one a vertex, each of sum 1; empty at a vertex without faces
  std::vector<char>
      is_held; ///< whether borders go through a vertex as they did: all labels have equal shares
};

/// fills the shares of labels in the angles of the faces at each vertex.
inline void share_by_angles(const Welded_mesh& mesh, const std::vector<int>& labels,
                            Soft_labels& soft)
{
  constexpr double least = 1e-6; // radians: of a face without area
  for (Index f = 0; f < mesh.faces.size(); ++f)
  {
    const std::vector<Double3> corners = corners_of(mesh, f);
    for (std::size_t i = 0, n = corners.size(); i < n; ++i)
    {
      const Double3 next = corners[(i + 1) % n] - corners[i];
      const Double3 last = corners[(i + n - 1) % n] - corners[i];
      add_share(labels[f], (std::max)(angle_between(next, last), least),
                soft.shares[mesh.faces[f].first[i]]);
    }
  }
  for (Shares& shares : soft.shares)
  {
    double sum = 0.;
    for (const auto& entry : shares) sum += entry.second;
    for (auto& entry : shares) entry.second /= sum;
  }
}

/// The angles between the faces at the edges of a mesh, in radians.
class Edge_angles
{
public:
  explicit Edge_angles(const Welded_mesh& mesh) : m_mesh(mesh)
  {
    for (Index f = 0; f < mesh.faces.size(); ++f)
      m_normals.push_back(twice_area(corners_of(mesh, f)));
    m_sums.resize(m_normals.size());
    m_counts.resize(m_normals.size());
    for (std::size_t e = 0; e < mesh.at_edges.size(); ++e)
      for (const auto& side : mesh.at_edges[e])
      {
        m_sums[side.face] += at(e);
        ++m_counts[side.face];
      }
  }

  /// whether an edge stands out: it is sharp, and much sharper than others of its faces, which noise and coarse
  /// meshes have too.
  bool is_crease(const std::size_t edge) const
  {
    constexpr double sharp = radians(30.), times_others = 2.;
    const double own = at(edge);
    double others = 0., count = 0.;
    for (const auto& side : m_mesh.at_edges[edge])
    {
      others += m_sums[side.face] - own;
      count += static_cast<double>(m_counts[side.face] - 1);
    }
    return own > sharp && own * count > times_others * others;
  }

private:
  /// 0 where there are not two faces.
  double at(const std::size_t edge) const
  {
    const auto sides = m_mesh.at_edges[edge];
    if (sides.size() != 2) return 0.;
    const auto& [a, b] = std::make_pair(sides.first[0], sides.first[1]);
    const double turned = a.along == b.along ? -1. : 1.;
    return angle_between(m_normals[a.face], turned * m_normals[b.face]);
  }

  const Welded_mesh& m_mesh;
  std::vector<Double3> m_normals; ///< of any length
  std::vector<double> m_sums;     ///< of the angles at the edges of each face
  std::vector<std::size_t> m_counts;
};

/// holds the borders in creases, and those where more than two faces meet.
inline void hold_creases(const Welded_mesh& mesh, const std::vector<int>& labels, Soft_labels& soft)
{
  const Edge_angles angles(mesh);
  for (std::size_t e = 0; e < mesh.at_edges.size(); ++e)
  {
    const auto sides = mesh.at_edges[e];
    bool is_border = false;
    for (const auto& side : sides)
      is_border = is_border || labels[side.face] != labels[sides.first->face];
    if (is_border && (sides.size() > 2 || angles.is_crease(e)))
      soft.is_held[sides.first->low] = soft.is_held[sides.first->high] = 1;
  }
}

/// The vertices near borders, with the edges between them and all others.
struct Border_surroundings
{
  std::vector<Index> vertices;
  Compressed_rows<std::pair<Index, double>> neighbors; ///< with 1 / length, ascending
};

/// returns the vertices within `rings` edges of one with several labels.
inline Border_surroundings border_surroundings(const Welded_mesh& mesh, const Soft_labels& soft,
                                               const int rings)
{
  std::vector<char> is_near(mesh.vertices.size(), 0);
  for (std::size_t v = 0; v < is_near.size(); ++v) is_near[v] = soft.shares[v].size() > 1 ? 1 : 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<char> before = is_near;
    for (std::size_t e = 0; e < mesh.at_edges.size(); ++e)
    {
      const std::size_t a = mesh.at_edges[e].first->low, b = mesh.at_edges[e].first->high;
      if (before[a] != before[b]) is_near[a] = is_near[b] = 1;
    }
  }
  std::map<Index, std::map<Index, double>> neighbors;
  for (std::size_t e = 0; e < mesh.at_edges.size(); ++e)
  {
    const auto a = static_cast<Index>(mesh.at_edges[e].first->low);
    const auto b = static_cast<Index>(mesh.at_edges[e].first->high);
    const double weight = 1. / length(mesh.vertices[b] - mesh.vertices[a]);
    if (is_near[a] != 0) neighbors[a][b] = weight;
    if (is_near[b] != 0) neighbors[b][a] = weight;
  }
  Border_surroundings result;
  for (const auto& [v, row] : neighbors)
  {
    result.vertices.push_back(v);
    result.neighbors.entries.insert(result.neighbors.entries.end(), row.begin(), row.end());
    result.neighbors.end_row();
  }
  return result;
}

/// smooths the shares where they are not held: a vertex goes half of the way to the mean of its neighbors.
inline void diffuse(const Border_surroundings& near, const int rounds, Soft_labels& soft)
{
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<Shares> smooth;
    for (std::size_t i = 0; i < near.vertices.size(); ++i)
    {
      double sum = 0.;
      for (const auto& neighbor : near.neighbors[i]) sum += neighbor.second;
      Shares mean = soft.shares[near.vertices[i]];
      for (auto& entry : mean) entry.second *= 0.5;
      for (const auto& [other, weight] : near.neighbors[i])
        for (const auto& [label, share] : soft.shares[other])
          add_share(label, 0.5 * weight / sum * share, mean);
      smooth.push_back(std::move(mean));
    }
    for (std::size_t i = 0; i < near.vertices.size(); ++i)
      if (soft.is_held[near.vertices[i]] == 0) soft.shares[near.vertices[i]] = std::move(smooth[i]);
  }
}

/// returns the shares of labels, one label a face. The borders of the labels `kept` stay where they are, and those in
/// creases.
///
/// Complexity: O(n log n) for n corners of faces.
inline Soft_labels soft_labels(const Welded_mesh& mesh, const std::vector<int>& labels,
                               const std::set<int>& kept)
{
  constexpr int rings = 4, rounds = 8;
  Soft_labels soft;
  soft.shares.resize(mesh.vertices.size());
  soft.is_held.resize(mesh.vertices.size(), 0);
  share_by_angles(mesh, labels, soft);
  hold_creases(mesh, labels, soft);
  for (std::size_t v = 0; v < soft.shares.size(); ++v)
  {
    Shares& shares = soft.shares[v];
    for (const auto& entry : shares)
      if (kept.count(entry.first) > 0) soft.is_held[v] = 1;
    if (soft.is_held[v] == 0) continue;
    for (auto& entry : shares) entry.second = 1. / static_cast<double>(shares.size());
  }
  diffuse(border_surroundings(mesh, soft, rings), rounds, soft);
  return soft;
}

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_BORDERS_SOFT_LABELS_H
