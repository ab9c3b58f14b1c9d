// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read_scene.h"

// Set by CMake where it finds the library, which only the folder scenes/ uses.
#ifdef WCS_HAS_ASSIMP
#include "scenes/import_scene.h"
#endif

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace Shape_io {
namespace internal {

namespace {

constexpr std::pair<const char*, const char*> formats[] = {
    {".gltf", "glTF"}, {".glb", "glTF"}, {".3mf", "3MF"}, {".dae", "DAE"}, {".fbx", "FBX"}};

} // namespace

bool is_scene_extension(const std::string& extension)
{
  return std::any_of(std::begin(formats), std::end(formats),
                     [&](const auto& format) { return extension == format.first; });
}

#ifdef WCS_HAS_ASSIMP

bool can_read_scenes() { return true; }

void read_scene(const std::string& bytes, const std::string& extension, const std::string& folder,
                Shape& shape)
{
  Scenes::import_scene(bytes, extension, folder, shape);
}

#else

bool can_read_scenes() { return false; }

void read_scene(const std::string&, const std::string& extension, const std::string&, Shape&)
{
  const auto* const format = std::find_if(std::begin(formats), std::end(formats),
                                          [&](const auto& f) { return extension == f.first; });
  throw std::runtime_error("this build reads no " + std::string(format->second) +
                           " (it was configured without assimp; Debian: libassimp-dev); build it "
                           "with assimp, or convert the file to PLY or OBJ");
}

#endif

void read_glb(const std::string& bytes, Shape& shape) { read_scene(bytes, ".glb", "", shape); }

void read_3mf(const std::string& bytes, Shape& shape) { read_scene(bytes, ".3mf", "", shape); }

} // namespace internal
} // namespace Shape_io
