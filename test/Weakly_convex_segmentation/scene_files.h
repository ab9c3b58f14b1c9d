// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_SCENE_FILES_H
#define TEST_SCENE_FILES_H

#include "io/shape.h"
#include "pcd_files.h"

#include <boost/crc.hpp>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Files of every format of scenes, all of one tetrahedron, and what gzip makes of a file.

namespace Scene_files {

inline const std::vector<Shape_io::Point> corners = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline const std::vector<std::vector<std::size_t>> faces = {
    {0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

inline std::string base64(const std::string& bytes)
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      result += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63];
  }
  return result;
}

inline std::string gltf_buffer()
{
  std::string buffer;
  for (const Shape_io::Point& p : corners)
    for (int i = 0; i < 3; ++i) Pcd_files::append(buffer, static_cast<float>(p[i]));
  for (const auto& face : faces)
    for (const std::size_t corner : face)
      Pcd_files::append(buffer, static_cast<std::uint16_t>(corner));
  return buffer;
}

inline std::string embedded()
{
  return ",\"uri\":\"data:application/octet-stream;base64," + base64(gltf_buffer()) + '"';
}

inline std::string gltf(const std::string& uri, const std::string& nodes = "[{\"mesh\":0}]",
                        const std::string& primitive = "\"indices\":1")
{
  return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":" +
         nodes + ",\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}," + primitive +
         "}]}],\"buffers\":[{\"byteLength\":72" + uri +
         "}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,\"byteLength\":48},{\"buffer\":0,"
         "\"byteOffset\":48,\"byteLength\":24}],\"accessors\":[{\"bufferView\":0,\"componentType\":"
         "5126,\"count\":4,\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[2,1,1]},{\"bufferView\":1,"
         "\"componentType\":5123,\"count\":12,\"type\":\"SCALAR\"}]}";
}

// One triangle twice, with texture coordinates, normals, colors and a material each.
inline std::string textured_gltf()
{
  std::string buffer;
  for (const float f : {0.f, 0.f, 0.f, 1.f, 0.f,  0.f,   0.f, 1.f, 0.f,  // points
                        0.f, 0.f, 1.f, 0.f, 0.5f, 0.25f,                 // texture coordinates
                        0.f, 0.f, 1.f, 0.f, 0.f,  1.f,   0.f, 0.f, 1.f,  // normals
                        1.f, 0.f, 0.f, 0.f, 1.f,  0.f,   0.f, 0.f, 1.f}) // colors
    Pcd_files::append(buffer, f);
  std::string views, accessors;
  const std::vector<std::pair<int, std::string>> tables = {
      {0, "VEC3"}, {36, "VEC2"}, {60, "VEC3"}, {96, "VEC3"}};
  for (std::size_t i = 0; i < tables.size(); ++i)
  {
    const auto& [offset, type] = tables[i];
    const std::string comma = i > 0 ? "," : "", size = type == "VEC2" ? "24" : "36";
    views += comma + "{\"buffer\":0,\"byteOffset\":" + std::to_string(offset) +
             ",\"byteLength\":" + size + "}";
    accessors += comma + "{\"bufferView\":" + std::to_string(i) +
                 ",\"componentType\":5126,\"count\":3,\"type\":\"" + type + "\"}";
  }
  const std::string primitive = "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"NORMAL\":2,"
                                "\"COLOR_0\":3},\"material\":";
  return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{"
         "\"mesh\":0}],\"materials\":[{\"name\":\"wood\"},{\"name\":\"steel\"}],\"meshes\":[{"
         "\"primitives\":[" +
         primitive + "1}," + primitive +
         "0}]}],\"buffers\":[{\"byteLength\":132,\"uri\":\"data:application/octet-stream;base64," +
         base64(buffer) + "\"}],\"bufferViews\":[" + views + "],\"accessors\":[" + accessors + "]}";
}

inline std::string glb()
{
  std::string json = gltf("");
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string buffer = gltf_buffer();
  std::string result = "glTF";
  Pcd_files::append(result, std::uint32_t(2));
  Pcd_files::append(result, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
  Pcd_files::append(result, static_cast<std::uint32_t>(json.size()));
  result += "JSON" + json;
  Pcd_files::append(result, static_cast<std::uint32_t>(buffer.size()));
  return result + std::string("BIN\0", 4) + buffer;
}

inline std::uint32_t crc(const std::string& bytes)
{
  boost::crc_32_type result;
  result.process_bytes(bytes.data(), bytes.size());
  return result.checksum();
}

// A zip archive of files that are not compressed.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files)
{
  const auto entry = [](const std::string& name, const std::string& content)
  {
    std::string fields("\x14\0\0\0\0\0\0\0\0\0", 10); // stored as it is, no time
    Pcd_files::append(fields, crc(content));
    Pcd_files::append(fields, static_cast<std::uint32_t>(content.size()));
    Pcd_files::append(fields, static_cast<std::uint32_t>(content.size()));
    Pcd_files::append(fields, static_cast<std::uint16_t>(name.size()));
    return fields + std::string(2, '\0');
  };
  std::string result, directory;
  for (const auto& [name, content] : files)
  {
    directory += std::string("PK\1\2\x14\0", 6) + entry(name, content) + std::string(10, '\0');
    Pcd_files::append(directory, static_cast<std::uint32_t>(result.size()));
    directory += name;
    result += "PK\3\4" + entry(name, content) + name + content;
  }
  std::string end("PK\5\6\0\0\0\0", 8);
  for (int i = 0; i < 2; ++i) Pcd_files::append(end, static_cast<std::uint16_t>(files.size()));
  Pcd_files::append(end, static_cast<std::uint32_t>(directory.size()));
  Pcd_files::append(end, static_cast<std::uint32_t>(result.size()));
  return result + directory + end + std::string(2, '\0');
}

inline std::string object_3mf(const int id, const std::string& content)
{
  return "<object id=\"" + std::to_string(id) + "\" type=\"model\">" + content + "</object>";
}

inline std::string mesh_3mf()
{
  std::ostringstream out;
  out << "<mesh><vertices>";
  for (const Shape_io::Point& p : corners)
    out << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>";
  out << "</vertices><triangles>";
  for (const auto& f : faces)
    out << "<triangle v1=\"" << f[0] << "\" v2=\"" << f[1] << "\" v3=\"" << f[2] << "\"/>";
  out << "</triangles></mesh>";
  return out.str();
}

inline std::string file_3mf(const std::string& resources, const std::string& items,
                            const std::string& other = "3D/other.txt")
{
  const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>";
  const std::string schema = "http://schemas.microsoft.com/3dmanufacturing/";
  return zip(
      {{"_rels/.rels",
        xml +
            "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/"
            "relationships\"><Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" Type=\"" +
            schema + "2013/01/3dmodel\"/></Relationships>"},
       {"3D/3dmodel.model", xml + "<model unit=\"millimeter\" xmlns=\"" + schema +
                                "core/2015/02\"><resources>" + resources + "</resources><build>" +
                                items + "</build></model>"},
       {other, "x"}});
}

inline std::string dae(const std::string& asset, const std::string& place = "")
{
  std::ostringstream points, indices;
  for (const Shape_io::Point& p : corners) points << p << ' ';
  for (const auto& face : faces)
    for (const std::size_t corner : face) indices << corner << ' ';
  std::string params;
  for (const std::string axis : {"X", "Y", "Z"})
    params += "<param name=\"" + axis + "\" type=\"float\"/>";
  return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\"><asset>" +
         asset +
         "</asset><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array "
         "id=\"pa\" count=\"12\">" +
         points.str() +
         "</float_array><technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\">" +
         params +
         "</accessor></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" "
         "source=\"#p\"/></vertices><triangles count=\"4\"><input semantic=\"VERTEX\" "
         "source=\"#v\" "
         "offset=\"0\"/><p>" +
         indices.str() +
         "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
         "<visual_scene id=\"s\"><node id=\"n\">" +
         place +
         "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes><scene>"
         "<instance_visual_scene url=\"#s\"/></scene></COLLADA>";
}

inline std::string fbx()
{
  return "; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: "
         "7300\n}\n"
         "Objects:  {\n Geometry: 1, \"Geometry::g\", \"Mesh\" {\n  Vertices: *12 {\n   a: "
         "0,0,0,2,0,0,0,1,0,0,0,1\n  }\n  PolygonVertexIndex: *12 {\n   a: "
         "0,2,-2,0,1,-4,0,3,-3,1,2,-4\n  }\n }\n Model: 2, \"Model::m\", \"Mesh\" {\n }\n}\n"
         "Connections:  {\n C: \"OO\",2,0\n C: \"OO\",1,2\n}\n";
}

// Compressed as it is, in one stored block.
inline std::string gzip(const std::string& bytes)
{
  std::string result("\x1f\x8b\x08\0\0\0\0\0\0\xff\1", 11);
  Pcd_files::append(result, static_cast<std::uint16_t>(bytes.size()));
  Pcd_files::append(result, static_cast<std::uint16_t>(~bytes.size()));
  result += bytes;
  Pcd_files::append(result, crc(bytes));
  Pcd_files::append(result, static_cast<std::uint32_t>(bytes.size()));
  return result;
}

} // namespace Scene_files

#endif // TEST_SCENE_FILES_H
