// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SCENE_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SCENE_H

#include "io/shape.h"

#include <string>

// Scenes of several objects, each with its place: glTF, GLB, 3MF, DAE (Collada) and FBX, by assimp where the build has
// it. They become one shape.

namespace Shape_io {
namespace internal {

bool can_read_scenes();

// ".gltf" and so on, in small letters.
bool is_scene_extension(const std::string& extension);

// `folder` is where the other files lie that this one names, or empty: then it must do without them.
void read_scene(const std::string& bytes, const std::string& extension, const std::string& folder,
                Shape& shape);

// The two that show in their first bytes.
void read_glb(const std::string& bytes, Shape& shape);
void read_3mf(const std::string& bytes, Shape& shape);

} // namespace internal
} // namespace Shape_io

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_IO_READ_SCENE_H
