// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_SURVIVES_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_SURVIVES_H

#include <functional>

namespace Scenes {

// Does the work in a process of its own, to see whether it comes to its end within so many seconds of computing, or
// crashes, or goes on. What it throws, too, is an end. Nothing of it is left. Where no process can be made it is
// taken to survive.
bool survives(const std::function<void()>& work, unsigned int seconds);

} // namespace Scenes

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_SURVIVES_H
