// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_BASELINES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_BASELINES_H

#include <CGAL/Weakly_convex_segmentation/internal/points/neighbor_graph.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/cpc_segmentation.h>
#include <pcl/segmentation/lccp_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

// The two segmentations by convexity of the Point Cloud Library: locally convex connected patches
// (LCCP, Stein et al. 2014) and constrained planar cuts (CPC, Schoeler et al. 2015), with the settings
// that were best on the odd-numbered meshes of the Princeton Segmentation Benchmark.

namespace Pcl_baselines {

using Coordinates = std::array<double, 3>;
using Point = pcl::PointXYZRGBA; // a type that the library is compiled for; colors are not used

/// Lengths are relative to the diagonal of the bounding box.
struct Options
{
  double voxel, seed;
  double tolerance; ///< degrees of concavity that still connect
  bool check_smoothness;
  std::uint32_t k_factor;
};
constexpr Options lccp_options = {0.01, 0.02, 0., true, 1};
constexpr Options cpc_options = {0.01, 0.03, 20., false, 0};

/// The cloud at unit size and its supervoxels.
struct Supervoxels
{
  double voxel, seed;
  pcl::PointCloud<Point>::Ptr cloud;
  pcl::PointCloud<pcl::PointXYZL>::Ptr labels; ///< the supervoxel of each point, 0 for none
  std::map<std::uint32_t, pcl::Supervoxel<Point>::Ptr> clusters;
  std::multimap<std::uint32_t, std::uint32_t> adjacency;
};

inline double bounding_box_diagonal(const std::vector<Coordinates>& points)
{
  double sum = 0.;
  for (int c = 0; c < 3; ++c)
  {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [c](const Coordinates& a, const Coordinates& b)
                                                 { return a[c] < b[c]; });
    sum += ((*high)[c] - (*low)[c]) * ((*high)[c] - (*low)[c]);
  }
  return std::sqrt(sum);
}

/// \param smallest_voxel in units of the points: 1.5 times their spacing, so that voxels are not empty
inline Supervoxels make_supervoxels(const std::vector<Coordinates>& points,
                                    const std::vector<Coordinates>& normals,
                                    const double smallest_voxel, const Options& options)
{
  const double diagonal = points.empty() ? 0. : bounding_box_diagonal(points);
  if (!(diagonal > 0.) || points.size() != normals.size())
    throw std::invalid_argument("PCL needs points that are not all the same, each with a normal");
  Supervoxels result;
  result.voxel = (std::max)(options.voxel, smallest_voxel / diagonal);
  result.seed = (std::max)(options.seed, 2. * result.voxel);
  result.cloud.reset(new pcl::PointCloud<Point>);
  const pcl::PointCloud<pcl::Normal>::Ptr directions(new pcl::PointCloud<pcl::Normal>);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    Point p;
    p.x = static_cast<float>((points[i][0] - points[0][0]) / diagonal);
    p.y = static_cast<float>((points[i][1] - points[0][1]) / diagonal);
    p.z = static_cast<float>((points[i][2] - points[0][2]) / diagonal);
    p.rgba = 0;
    result.cloud->push_back(p);
    const auto& v = normals[i];
    const double l = (std::max)(std::hypot(v[0], v[1], v[2]), 1e-300);
    directions->push_back(pcl::Normal(static_cast<float>(v[0] / l), static_cast<float>(v[1] / l),
                                      static_cast<float>(v[2] / l)));
  }
  pcl::SupervoxelClustering<Point> clustering(static_cast<float>(result.voxel),
                                              static_cast<float>(result.seed));
  clustering.setUseSingleCameraTransform(false);
  clustering.setInputCloud(result.cloud);
  clustering.setNormalCloud(directions);
  clustering.setColorImportance(0.f);
  clustering.setSpatialImportance(1.f);
  clustering.setNormalImportance(4.f);
  clustering.extract(result.clusters);
  if (result.clusters.empty()) throw std::runtime_error("PCL found no supervoxels");
  clustering.getSupervoxelAdjacency(result.adjacency);
  result.labels = clustering.getLabeledCloud();
  return result;
}

/// returns the segment of each point; those in no supervoxel have that of the nearest point.
template <typename Segmentation>
std::vector<int> labels_of_points(Segmentation& segmentation, const Supervoxels& supervoxels)
{
  namespace internal = CGAL::Weakly_convex_segmentation::internal;
  const auto position = [&](const std::size_t i)
  {
    const Point& p = (*supervoxels.cloud)[i];
    return internal::Vector3{p.x, p.y, p.z};
  };
  std::vector<std::size_t> labeled;
  std::vector<internal::Vector3> positions;
  std::vector<char> has_label(supervoxels.labels->size(), 0);
  for (std::size_t i = 0; i < has_label.size(); ++i)
    if ((*supervoxels.labels)[i].label != 0)
    {
      has_label[i] = 1;
      labeled.push_back(i);
      positions.push_back(position(i));
    }
  pcl::PointCloud<pcl::PointXYZL> relabeled = *supervoxels.labels;
  segmentation.relabelCloud(relabeled);
  std::vector<int> result(has_label.size(), 0);
  for (const std::size_t i : labeled) result[i] = static_cast<int>(relabeled[i].label);
  if (labeled.empty()) return result;
  const internal::Kd_tree tree(positions);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (has_label[i] == 0)
      tree.nearest(position(i), 1,
                   [&](const internal::Index nearest, float)
                   { result[i] = static_cast<int>(relabeled[labeled[nearest]].label); });
  return result;
}

template <typename Segmentation>
void set_options(Segmentation& segmentation, const Supervoxels& supervoxels, const Options& options)
{
  segmentation.setConcavityToleranceThreshold(static_cast<float>(options.tolerance));
  segmentation.setSanityCheck(false);
  segmentation.setSmoothnessCheck(options.check_smoothness, static_cast<float>(supervoxels.voxel),
                                  static_cast<float>(supervoxels.seed), 0.1f);
  segmentation.setKFactor(options.k_factor);
  segmentation.setMinSegmentSize(3);
  segmentation.setInputSupervoxels(supervoxels.clusters, supervoxels.adjacency);
}

/// returns a label a point by locally convex connected patches.
inline std::vector<int> segment_by_lccp(const std::vector<Coordinates>& points,
                                        const std::vector<Coordinates>& normals,
                                        const double smallest_voxel,
                                        const Options& options = lccp_options)
{
  const Supervoxels supervoxels = make_supervoxels(points, normals, smallest_voxel, options);
  pcl::LCCPSegmentation<Point> segmentation;
  set_options(segmentation, supervoxels, options);
  segmentation.segment();
  return labels_of_points(segmentation, supervoxels);
}

/// returns a label a point by constrained planar cuts.
inline std::vector<int> segment_by_cpc(const std::vector<Coordinates>& points,
                                       const std::vector<Coordinates>& normals,
                                       const double smallest_voxel,
                                       const Options& options = cpc_options)
{
  const Supervoxels supervoxels = make_supervoxels(points, normals, smallest_voxel, options);
  pcl::CPCSegmentation<Point> segmentation;
  set_options(segmentation, supervoxels, options);
  segmentation.setCutting(25, 0, 0.06f, true, true, false);
  segmentation.setRANSACIterations(1000);
  segmentation.segment();
  return labels_of_points(segmentation, supervoxels);
}

} // namespace Pcl_baselines

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_BENCHMARK_BASELINES_PCL_BASELINES_H
