#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FITTED_COST_TABLE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_FITTED_COST_TABLE_H
#include <CGAL/Weakly_convex_segmentation/internal/Boosted_trees.h>
namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {
inline const Boosted_trees& fitted_trees()
{
  static constexpr std::uint16_t roots[] = {0};
  static constexpr Tree_node nodes[] = {{-1, 0, 0.f}};
  static constexpr Boosted_trees trees = {nodes, roots, 1, 0.};
  return trees;
}
} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL
#endif
