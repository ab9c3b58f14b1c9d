// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scenes/import_scene.h"

#include "io/text_lines.h"
#include "scenes/flatten_scene.h"
#include "scenes/survives.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace Scenes {

namespace {

// A name in a glTF file may have %20 for a blank.
std::string decoded(const std::string& name)
{
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    unsigned char code = 0;
    const char* const digits = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2)
    {
      result += static_cast<char>(code);
      i += 2;
    }
    else
      result += name[i];
  }
  return result;
}

// The file itself is in memory, as it may have come through a pipe or compressed; the others lie in its folder.
class Scene_files : public Assimp::DefaultIOSystem
{
public:
  Scene_files(const std::string& bytes, const std::string& name, const bool has_others)
    : m_bytes(bytes), m_name(name), m_has_others(has_others)
  {}

  bool Exists(const char* const name) const override
  {
    return name == m_name || !path_of(name).empty();
  }

  Assimp::IOStream* Open(const char* const name, const char* const mode) override
  {
    if (name == m_name)
      return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(m_bytes.data()),
                                        m_bytes.size());
    const std::string path = path_of(name);
    return path.empty() ? nullptr : DefaultIOSystem::Open(path.c_str(), mode);
  }

private:
  // Empty: there is no such file.
  std::string path_of(const std::string& name) const
  {
    std::error_code error;
    for (const std::string& path : {name, decoded(name)})
      if (m_has_others && std::filesystem::is_regular_file(path, error)) return path;
    return "";
  }

  const std::string& m_bytes;
  std::string m_name;
  bool m_has_others;
};

// assimp would try all its formats on what is not of its extension.
void keep_only(Assimp::Importer& importer, const std::string& extension)
{
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;)
  {
    std::istringstream names(importer.GetImporterInfo(i)->mFileExtensions);
    bool is_of_extension = false;
    for (std::string name; names >> name;)
      is_of_extension = is_of_extension || '.' + name == extension;
    if (!is_of_extension) importer.UnregisterLoader(importer.GetImporter(i));
  }
}

[[noreturn]] void refuse(const Assimp::Importer& importer)
{
  if (const std::exception_ptr cause = importer.GetException()) try
    {
      std::rethrow_exception(cause);
    }
    catch (const std::bad_alloc&)
    {
      throw;
    }
    catch (...) // in GetErrorString(), too
    {}
  constexpr std::size_t most = 200;
  const std::string cause = Shape_io::internal::shown(importer.GetErrorString(), most);
  throw std::runtime_error("it is not sound (" + (cause.empty() ? "no cause is known" : cause) +
                           "); check it and the files that it names, or export the shape again");
}

// The parts of a 3MF file that have objects: the names are in the directory at its end. assimp reads the first only.
std::size_t number_of_3mf_models(const std::string& bytes)
{
  constexpr std::size_t size_of_entry = 46, place_of_length = 28;
  std::size_t number = 0;
  for (std::size_t i = bytes.find("PK\1\2"); i != std::string::npos;
       i = bytes.find("PK\1\2", i + 4))
  {
    if (i + size_of_entry > bytes.size()) break;
    const auto byte = [&](const std::size_t k)
    { return std::size_t(static_cast<unsigned char>(bytes[i + place_of_length + k])); };
    const std::string name = bytes.substr(i + size_of_entry, byte(0) + 256 * byte(1));
    if (name.size() > 6 && name.compare(name.size() - 6, 6, ".model") == 0) ++number;
  }
  return number;
}

// assimp turns the lengths of DAE files into meters.
void note_unit(const std::string& bytes, Shape_io::Shape& shape)
{
  const std::size_t unit = bytes.find("<unit");
  const std::string tag =
      unit == std::string::npos ? "" : bytes.substr(unit, bytes.find('>', unit) - unit);
  const std::size_t meter = tag.find("meter=");
  if (meter == std::string::npos) return;
  const std::string text = tag.substr(meter + 7);
  double number = 1.;
  if (Shape_io::internal::is_number(text.substr(0, text.find_first_of("\"'")), number) &&
      number != 1.)
    shape.notes.push_back("the lengths are in meters; the file has units of " +
                          Shape_io::internal::shown(text.substr(0, text.find_first_of("\"'"))) +
                          " m");
}

const aiScene* imported(Assimp::Importer& importer, const std::string& bytes,
                        const std::string& extension, const std::string& folder)
{
  const std::string name = (folder.empty() ? "" : folder + '/') + "shape" + extension;
  keep_only(importer, extension);
  // the coordinates are to be those of the file: DAE tells which axis is up, and assimp would turn it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetIOHandler(new Scene_files(bytes, name, !folder.empty())); // the importer deletes it
  return importer.ReadFile(name, 0);
}

} // namespace

void import_scene(const std::string& bytes, const std::string& extension, const std::string& folder,
                  Shape_io::Shape& shape)
{
  if (extension == ".3mf" && number_of_3mf_models(bytes) > 1)
    throw std::runtime_error(
        "its objects are in several models (the production extension of 3MF), which are "
        "not read; export it without that, or as STL, PLY or OBJ");
  // damaged files bring assimp to crash, such as a 3MF object that is a component of itself, or into endless loops;
  // sound ones take less than a second a megabyte
  const auto import_only = [&]
  {
    Assimp::Importer importer;
    imported(importer, bytes, extension, folder);
  };
  const auto megabytes = static_cast<unsigned int>(bytes.size() >> 20);
  if (!survives(import_only, 10 + 5 * megabytes))
    throw std::runtime_error(
        "it is not sound (assimp crashes on it, or does not come to an end); check it or export "
        "the shape again");
  Assimp::Importer importer;
  const aiScene* const scene = imported(importer, bytes, extension, folder);
  if (!scene || !scene->mRootNode) refuse(importer);
  flatten_scene(*scene, shape);
  if (extension == ".dae") note_unit(bytes, shape);
}

} // namespace Scenes
