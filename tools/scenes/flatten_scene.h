// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_FLATTEN_SCENE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_FLATTEN_SCENE_H

#include "io/shape.h"

struct aiScene;

namespace Scenes {

// All meshes of a scene in the places that its nodes give them; a mesh that several nodes have is there several
// times. Where there are no faces, the points of all nodes. Notes tell what is left out.
void flatten_scene(const aiScene& scene, Shape_io::Shape& shape);

} // namespace Scenes

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_FLATTEN_SCENE_H
