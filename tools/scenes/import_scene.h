// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_IMPORT_SCENE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_IMPORT_SCENE_H

#include "io/shape.h"

#include <string>

namespace Scenes {

// Reads the bytes by assimp as a file of that extension, and puts the objects of its scene into one shape, each in its
// place. The files that it names are looked for in the folder; empty: there are none.
// Throws std::runtime_error with cause and remedy.
void import_scene(const std::string& bytes, const std::string& extension, const std::string& folder,
                  Shape_io::Shape& shape);

} // namespace Scenes

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_SCENES_IMPORT_SCENE_H
