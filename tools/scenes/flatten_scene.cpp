// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/flatten_scene.h"

#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Scenes {

namespace {

using Shape_io::Point;
using Shape_io::Property;
using Shape_io::Shape;
using Shape_io::Vector;

// An affine map, in double precision so that nested ones lose nothing more.
class Transform
{
public:
  explicit Transform(const aiMatrix4x4& m)
    : m_rows{{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}}
  {}

  // Of what is in `inner` first.
  Transform operator*(const Transform& inner) const
  {
    Transform result = *this;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j)
      {
        result.m_rows[i][j] = j == 3 ? m_rows[i][3] : 0.;
        for (std::size_t k = 0; k < 3; ++k)
          result.m_rows[i][j] += m_rows[i][k] * inner.m_rows[k][j];
      }
    return result;
  }

  Point point(const aiVector3D& p) const
  {
    const auto coordinate = [&](const std::size_t i)
    {
      const auto& row = m_rows[i];
      return row[0] * double(p.x) + row[1] * double(p.y) + row[2] * double(p.z) + row[3];
    };
    return Point(coordinate(0), coordinate(1), coordinate(2));
  }

  // Of length 1, unless there is none.
  Vector normal(const aiVector3D& n) const
  {
    const double sign = is_mirror() ? -1. : 1.;
    const Vector sum = sign * (double(n.x) * cofactors(0) + double(n.y) * cofactors(1) +
                               double(n.z) * cofactors(2));
    const double length = std::sqrt(sum.squared_length());
    return length > 0. && std::isfinite(length) ? sum / length : Vector(n.x, n.y, n.z);
  }

  bool is_mirror() const { return column(0) * cofactors(0) < 0.; }

  bool is_move() const
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (m_rows[i][j] != (i == j ? 1. : 0.)) return false;
    return true;
  }

private:
  Vector column(const std::size_t j) const
  {
    return Vector(m_rows[0][j], m_rows[1][j], m_rows[2][j]);
  }

  Vector cofactors(const std::size_t j) const
  {
    return CGAL::cross_product(column((j + 1) % 3), column((j + 2) % 3));
  }

  std::array<std::array<double, 4>, 3> m_rows;
};

struct Instance
{
  const aiMesh* mesh;
  Transform transform;
  std::string name;
};

// Names go into lines of text.
std::string one_line(const aiString& name)
{
  std::string result = name.C_Str();
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  result.erase(0, (std::min)(result.find_first_not_of(' '), result.size()));
  result.erase(result.find_last_not_of(" \\") + 1);
  return result;
}

std::vector<Instance> instances_of(const aiScene& scene)
{
  std::vector<Instance> result;
  std::vector<std::pair<const aiNode*, Transform>> open = {
      {scene.mRootNode, Transform(scene.mRootNode->mTransformation)}};
  while (!open.empty())
  {
    const auto [node, transform] = open.back();
    open.pop_back();
    for (unsigned int i = 0; i < node->mNumMeshes; ++i)
    {
      if (node->mMeshes[i] >= scene.mNumMeshes || !scene.mMeshes[node->mMeshes[i]]) continue;
      const aiMesh* const mesh = scene.mMeshes[node->mMeshes[i]];
      const std::string name = one_line(node->mName);
      result.push_back({mesh, transform, name.empty() ? one_line(mesh->mName) : name});
    }
    for (unsigned int i = node->mNumChildren; i-- > 0;) // the first is to be next
      if (node->mChildren[i])
        open.emplace_back(node->mChildren[i],
                          transform * Transform(node->mChildren[i]->mTransformation));
  }
  return result;
}

bool has_polygons(const aiMesh& mesh)
{
  return std::any_of(mesh.mFaces, mesh.mFaces + mesh.mNumFaces,
                     [](const aiFace& face) { return face.mNumIndices > 2; });
}

// The points of a mesh that are told apart. Formats with an index a kind of value for each corner, DAE and FBX, come
// with a point of its own for each corner: those that are equal in all become one again.
std::vector<std::size_t> different_points(const aiMesh& mesh, std::vector<unsigned int>& chosen)
{
  std::size_t corners = 0;
  for (unsigned int i = 0; i < mesh.mNumFaces; ++i) corners += mesh.mFaces[i].mNumIndices;
  const bool is_soup = has_polygons(mesh) && corners == mesh.mNumVertices;
  std::vector<std::size_t> result;
  std::map<std::array<float, 10>, std::size_t> numbers;
  for (unsigned int i = 0; i < mesh.mNumVertices; ++i)
  {
    std::array<float, 10> key = {mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z};
    for (unsigned int k = 0; k < 3 && mesh.mNormals; ++k) key[3 + k] = mesh.mNormals[i][k];
    for (unsigned int k = 0; k < 4 && mesh.mColors[0]; ++k) key[6 + k] = mesh.mColors[0][i][k];
    const bool is_number =
        std::none_of(key.begin(), key.end(), [](const float f) { return std::isnan(f); });
    const auto place = is_soup && is_number ? numbers.emplace(key, chosen.size())
                                            : std::make_pair(numbers.end(), true);
    result.push_back(place.second ? chosen.size() : place.first->second);
    if (place.second) chosen.push_back(i);
  }
  return result;
}

// Puts instances into a shape, one after the other.
class Shape_of_instances
{
public:
  Shape_of_instances(Shape& shape, const std::vector<Instance>& instances) : m_shape(shape)
  {
    const auto all = [&](const auto& has)
    {
      return std::all_of(instances.begin(), instances.end(),
                         [&](const Instance& instance) { return has(*instance.mesh); });
    };
    m_has_normals = all([](const aiMesh& mesh) { return mesh.HasNormals(); });
    m_has_colors = all([](const aiMesh& mesh) { return mesh.HasVertexColors(0); });
    for (const char* name : {"red", "green", "blue", "alpha"})
      m_colors.push_back({name, "float", {}});
  }

  void add(const Instance& instance, const std::size_t number)
  {
    const aiMesh& mesh = *instance.mesh;
    const std::size_t first = m_shape.points.size();
    std::vector<unsigned int> chosen;
    const std::vector<std::size_t> place = different_points(mesh, chosen);
    for (const unsigned int i : chosen) add_point(instance, i);
    for (unsigned int i = 0; i < mesh.mNumFaces; ++i)
    {
      if (mesh.mFaces[i].mNumIndices < 3)
      {
        ++m_number_of_others;
        continue;
      }
      add_face(mesh, mesh.mFaces[i], instance.transform.is_mirror(), place, first);
      m_objects.values.push_back(static_cast<double>(number));
      m_materials.values.push_back(static_cast<double>(mesh.mMaterialIndex));
    }
  }

  void finish(const aiScene& scene, const std::vector<Instance>& instances)
  {
    if (m_has_colors)
    {
      // where the file has none assimp has 1 or, of glTF, 0
      const auto& alpha = m_colors.back().values;
      const std::size_t number = alpha.size();
      if (std::size_t(std::count(alpha.begin(), alpha.end(), 1.)) == number ||
          std::size_t(std::count(alpha.begin(), alpha.end(), 0.)) == number)
        m_colors.pop_back();
      m_shape.point_properties = std::move(m_colors);
    }
    if (!m_shape.is_mesh()) return;
    if (m_number_of_others > 0)
      m_shape.notes.push_back(std::to_string(m_number_of_others) +
                              " points and lines that are no faces are left out");
    if (!m_texture.values.empty()) m_shape.face_properties.push_back(std::move(m_texture));
    add_materials(scene);
    if (instances.size() < 2) return;
    m_shape.face_properties.push_back(std::move(m_objects));
    m_shape.face_words.push_back({"object", {}});
    for (std::size_t i = 0; i < instances.size(); ++i)
      m_shape.face_words.back().words.push_back(
          instances[i].name.empty() ? "object_" + std::to_string(i) : instances[i].name);
  }

private:
  void add_point(const Instance& instance, const unsigned int i)
  {
    const aiMesh& mesh = *instance.mesh;
    m_shape.points.push_back(instance.transform.point(mesh.mVertices[i]));
    if (m_has_normals)
    {
      const aiVector3D& n = mesh.mNormals[i];
      m_shape.normals.push_back(instance.transform.is_move() ? Vector(n.x, n.y, n.z)
                                                             : instance.transform.normal(n));
    }
    if (!m_has_colors) return;
    for (unsigned int k = 0; k < 4; ++k)
      m_colors[k].values.push_back(static_cast<double>(mesh.mColors[0][i][k]));
  }

  // A mirrored face is seen from behind, unless its corners are turned around, too.
  void add_face(const aiMesh& mesh, const aiFace& face, const bool is_mirrored,
                const std::vector<std::size_t>& place, const std::size_t first)
  {
    std::vector<unsigned int> corners(face.mIndices, face.mIndices + face.mNumIndices);
    if (is_mirrored) std::reverse(corners.begin() + 1, corners.end());
    m_shape.polygons.emplace_back();
    for (const unsigned int corner : corners)
    {
      if (corner >= place.size())
        throw std::runtime_error("face " + std::to_string(m_shape.polygons.size() - 1) +
                                 " (counted from 0) has a corner that is none of the points of its "
                                 "mesh; repair it or export the shape again");
      m_shape.polygons.back().push_back(first + place[corner]);
      if (!mesh.HasTextureCoords(0)) continue;
      m_texture.values.push_back(static_cast<double>(mesh.mTextureCoords[0][corner].x));
      m_texture.values.push_back(static_cast<double>(mesh.mTextureCoords[0][corner].y));
    }
    if (2 * corners.size() > 255) m_texture.list_size_type = "int";
    m_texture.first.push_back(m_texture.values.size());
  }

  // Which material a face has, where there are several; of the materials only their names.
  void add_materials(const aiScene& scene)
  {
    const std::set<double> used(m_materials.values.begin(), m_materials.values.end());
    Shape_io::Face_words words = {"material", {}};
    std::map<double, double> numbers;
    bool has_own = scene.mNumTextures > 0;
    for (const double index : used)
    {
      numbers[index] = static_cast<double>(words.words.size());
      aiString name;
      if (index < scene.mNumMaterials)
        scene.mMaterials[static_cast<std::size_t>(index)]->Get(AI_MATKEY_NAME, name);
      has_own = has_own || (name.length > 0 && name != aiString(AI_DEFAULT_MATERIAL_NAME));
      const std::string line = one_line(name);
      words.words.push_back(line.empty() ? "material_" + std::to_string(words.words.size()) : line);
    }
    if (has_own || used.size() > 1)
      m_shape.notes.push_back(
          "of its materials only the names are kept, without colors and textures");
    if (!has_own && used.size() < 2) return;
    for (double& value : m_materials.values) value = numbers[value];
    m_shape.face_properties.push_back(std::move(m_materials));
    m_shape.face_words.push_back(std::move(words));
  }

  Shape& m_shape;
  bool m_has_normals, m_has_colors;
  std::size_t m_number_of_others = 0;
  std::vector<Property> m_colors;
  Property m_texture = {Shape_io::name_of_texture_coordinates, "float", {}, "uchar", {0}};
  Property m_objects = {"object", "int", {}}, m_materials = {"material", "int", {}};
};

void add_notes(const aiScene& scene, const std::vector<Instance>& instances,
               const std::size_t number_left_out, Shape& shape)
{
  const auto any = [&](const auto& has)
  {
    return std::any_of(instances.begin(), instances.end(),
                       [&](const Instance& instance) { return has(*instance.mesh); });
  };
  if (number_left_out > 0)
    shape.notes.push_back(std::to_string(number_left_out) +
                          " objects of points and lines are left out, as there are faces");
  if (shape.normals.empty() && any([](const aiMesh& mesh) { return mesh.HasNormals(); }))
    shape.notes.push_back("the normals are left out, as some objects have none");
  if (shape.point_properties.empty() &&
      any([](const aiMesh& mesh) { return mesh.HasVertexColors(0); }))
    shape.notes.push_back("the colors of points are left out, as some objects have none");
  if (any([](const aiMesh& mesh) { return mesh.HasTextureCoords(1) || mesh.HasVertexColors(1); }))
    shape.notes.push_back("of several sets of texture coordinates or colors the first is kept");
  if (scene.mNumAnimations > 0 ||
      any([](const aiMesh& mesh) { return mesh.HasBones() || mesh.mNumAnimMeshes > 0; }))
    shape.notes.push_back("animations and poses are left out: the shape is the one at rest");
}

} // namespace

void flatten_scene(const aiScene& scene, Shape& shape)
{
  std::vector<Instance> instances = instances_of(scene);
  const std::size_t number_of_all = instances.size();
  const auto is_of_points = [](const Instance& instance) { return !has_polygons(*instance.mesh); };
  if (!std::all_of(instances.begin(), instances.end(), is_of_points))
    instances.erase(std::remove_if(instances.begin(), instances.end(), is_of_points),
                    instances.end());
  Shape_of_instances result(shape, instances);
  for (std::size_t i = 0; i < instances.size(); ++i) result.add(instances[i], i);
  result.finish(scene, instances);
  add_notes(scene, instances, number_of_all - instances.size(), shape);
}

} // namespace Scenes
