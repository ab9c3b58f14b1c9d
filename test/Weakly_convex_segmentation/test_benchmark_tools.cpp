// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the benchmark is made of: methods in processes of their own, pictures, and the programs and the
// runner on a small benchmark that is made here.

#include <boost/test/unit_test.hpp>

#include "common/run_in_child_process.h"
#include "scratch_folder.h"
#include "shapes/shape_generator.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <sys/wait.h>

BOOST_AUTO_TEST_SUITE(test_benchmark_tools)

namespace {

using Run_in_child_process::Labeling;
using Json = nlohmann::json;

std::string program(const std::string& name)
{
  const char* const bin_dir = std::getenv("WCS_BIN_DIR");
  BOOST_REQUIRE_MESSAGE(bin_dir, "set WCS_BIN_DIR to the folder of the programs");
  return std::string(bin_dir) + "/" + name;
}

int exit_code(const Scratch_folder& folder, const std::string& command)
{
  const int status = std::system(
      ("cd '" + folder.path().string() + "' && " + command + " > out.txt 2> err.txt < /dev/null")
          .c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// writes a shape as model `number` of a benchmark, with its true parts and one part as two people's
void write_model(const Scratch_folder& folder, const int number, const std::string& shape)
{
  const auto mesh = Shape_generator::make_mesh(shape, 4000);
  const std::string n = std::to_string(number);
  for (const std::string& f : {std::string("off"), "seg/Benchmark/" + n})
    std::filesystem::create_directories(folder.path() / "data" / f);
  std::ostringstream off, truth, one;
  off << "OFF\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const auto& p : mesh.points) off << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& f : mesh.faces) off << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
  for (const int l : mesh.labels)
  {
    truth << l << '\n';
    one << "0\n";
  }
  folder.write("data/off/" + n + ".off", off.str());
  folder.write("data/seg/Benchmark/" + n + "/" + n + "_0.seg", truth.str());
  folder.write("data/seg/Benchmark/" + n + "/" + n + "_1.seg", one.str());
}

/// the command that runs the runner, or nothing if it can't be run here
std::string runner()
{
  const char* const source_dir = std::getenv("WCS_SOURCE_DIR");
  if (source_dir == nullptr || std::system("python3 --version > /dev/null 2>&1") != 0) return "";
  return "python3 '" + std::string(source_dir) +
         "/benchmark/Weakly_convex_segmentation/run_benchmark.py' --jobs 2 --bin '" + program("") +
         "' ";
}

} // namespace

BOOST_AUTO_TEST_CASE(a_method_in_a_child_gives_labels)
{
  const auto outcome = Run_in_child_process::run(
      [] {
        return std::vector<Labeling>{{"a", {1, 2, 3}, 0.5}, {"b", {}, 0.}};
      },
      10);
  BOOST_TEST(outcome.failure == "");
  BOOST_REQUIRE(outcome.labelings.size() == 2u);
  BOOST_TEST(outcome.labelings[0].method == "a");
  BOOST_TEST(outcome.labelings[0].labels == (std::vector<int>{1, 2, 3}));
  BOOST_TEST(outcome.labelings[0].cpu_seconds == 0.5);
  BOOST_TEST(outcome.labelings[1].labels.empty());
  BOOST_TEST(outcome.peak_megabytes > 0.);
}

BOOST_AUTO_TEST_CASE(memory_of_a_child_is_measured)
{
  const auto peak = [](const std::size_t megabytes)
  {
    return Run_in_child_process::run(
               [&]
               {
                 const std::vector<int> memory(megabytes << 18, 1);
                 return std::vector<Labeling>{{"a", {memory.back()}, 0.}};
               },
               60)
        .peak_megabytes;
  };
  const double difference = peak(200) - peak(1);
  BOOST_TEST(difference > 150.);
  BOOST_TEST(difference < 250.);
}

BOOST_AUTO_TEST_CASE(what_happens_to_a_child_is_told)
{
  using Labelings = std::vector<Labeling>;
  const auto failure = [](const std::function<Labelings()>& method)
  {
    const auto outcome = Run_in_child_process::run(method, 1);
    BOOST_TEST(outcome.labelings.empty());
    return outcome.failure;
  };
  BOOST_TEST(failure([]() -> Labelings { throw std::runtime_error("no luck"); }) == "no luck");
  BOOST_TEST(failure([]() -> Labelings { ::_exit(0); }) == "it ended before it was done");
  BOOST_TEST(failure(
                 []() -> Labelings
                 {
                   ::raise(SIGKILL);
                   return {};
                 }) == "ended by signal 9");
  BOOST_TEST(failure(
                 []() -> Labelings
                 {
                   ::sleep(20);
                   return {};
                 }) == "stopped after 1 s");
}

BOOST_AUTO_TEST_CASE(one_model_is_scored_by_all_methods)
{
  const Scratch_folder folder;
  write_model(folder, 1, "dumbbell");
  BOOST_TEST(exit_code(folder, program("benchmark_shape") +
                                   " data 1 --json 1.json --pictures pictures --labels labels "
                                   "--methods default,lines_of_sight_told,one_segment,people") ==
             0);
  BOOST_TEST(folder.has("pictures/1_ours.png"));
  BOOST_TEST(folder.has("pictures/1_person.png"));
  BOOST_TEST(folder.has("labels/1_patches.seg"));
  const Json json = Json::parse(folder.read("1.json"));
  BOOST_TEST(json["category"] == "Human");
  const Json& methods = json["methods"];
  BOOST_TEST(methods.size() == 6u);
  BOOST_TEST(methods["people"]["segments"] == 2.);
  BOOST_TEST(methods["one_segment"]["segments"] == 1.);
  BOOST_TEST(methods["one_segment"]["cut_discrepancy"].is_null());
  BOOST_TEST(methods["default"]["segments"] == methods["lines_of_sight_told"]["segments"]);
  // one person gave the true parts, the other one: their error, and half of it for either's side
  const double people = methods["people"]["rand_error"];
  BOOST_TEST(double(methods["one_segment"]["rand_error"]) == people / 2.,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(double(methods["default"]["rand_error"]) < people);
  BOOST_TEST(double(methods["default"]["convexity_rank"]) >
             double(methods["one_segment"]["convexity_rank"]));
  BOOST_TEST(double(methods["default"]["cpu_seconds"]) >=
             double(methods["patches"]["cpu_seconds"]));
  BOOST_TEST(double(methods["default"]["peak_megabytes"]) > 1.);

  BOOST_TEST(exit_code(folder, program("benchmark_shape") + " data 3 --json 3.json") == 1);
  BOOST_TEST(!folder.has("3.json"));
  BOOST_TEST(folder.read("err.txt").find("3.off") != std::string::npos);
  BOOST_TEST(exit_code(folder, program("benchmark_shape") + " data 1 --methods magic") == 1);
}

BOOST_AUTO_TEST_CASE(the_runner_goes_on_and_tells_of_failures)
{
  if (runner().empty())
  {
    BOOST_TEST_MESSAGE("skipped: it takes Python 3 and WCS_SOURCE_DIR, the project's folder");
    return;
  }
  const Scratch_folder folder;
  write_model(folder, 1, "two_spheres");
  write_model(folder, 21, "dumbbell");
  const std::string run = runner() + "scores data out --methods default,one_segment,people";
  BOOST_TEST(exit_code(folder, run) == 0);
  const std::string table = folder.read("out/scores.csv");
  BOOST_TEST(std::count(table.begin(), table.end(), '\n') == 1 + 2 * 5);
  BOOST_TEST(Json::parse(folder.read("out/scores.json"))["models"].size() == 2u);

  BOOST_TEST(exit_code(folder, run) == 0); // all done
  BOOST_TEST(folder.read("out.txt").find("2 of 2 shapes are done already") != std::string::npos);
  BOOST_TEST(folder.read("out/scores.csv") == table);

  // one method more: joined with the others
  BOOST_TEST(exit_code(folder, runner() + "scores data out --methods lines_of_sight") == 0);
  const std::string joined = folder.read("out/scores.csv");
  BOOST_TEST(std::count(joined.begin(), joined.end(), '\n') == 1 + 2 * 6);
  std::filesystem::remove(folder.path() / "out/scores/21_lines_of_sight.json");

  std::filesystem::remove(folder.path() / "out/scores/21_default_one_segment_people.json");
  folder.write("data/off/21.off", "OFF\n3 1 0\n");
  BOOST_TEST(exit_code(folder, run) == 1);
  BOOST_TEST(folder.read("out.txt").find("1 of 2 shapes") != std::string::npos);
  const Json merged = Json::parse(folder.read("out/scores.json"));
  BOOST_TEST(merged["models"].size() == 1u);
  BOOST_TEST(merged["failures"].contains("model 21"));

  folder.write("shapes.off", "");
  std::filesystem::create_directories(folder.path() / "shapes/more");
  std::filesystem::copy_file(folder.path() / "data/off/1.off", folder.path() / "shapes/more/a.off");
  folder.write("shapes/broken.ply", "ply\nnonsense\n");
  BOOST_TEST(exit_code(folder, runner() + "corpus shapes corpus") == 1);
  const Json corpus = Json::parse(folder.read("corpus/corpus.json"));
  BOOST_REQUIRE(corpus["shapes"].size() == 1u);
  BOOST_TEST(corpus["shapes"][0]["number_of_segments"] == 2);
  BOOST_TEST(corpus["failures"].contains("broken.ply"));
  BOOST_TEST(folder.has("corpus/pictures/more_a.off.png"));
  BOOST_TEST(exit_code(folder, runner() + "merge corpus") == 0);
}

BOOST_AUTO_TEST_CASE(scans_are_scored_by_all_methods_and_what_is_measured_is_kept)
{
  const Scratch_folder folder;
  write_model(folder, 1, "dumbbell");
  const std::string run = program("benchmark_scans") + " data --ids 1 --csv scans.csv --resume";
  BOOST_TEST(exit_code(folder, run + " --methods default") == 0);
  const std::string table = folder.read("scans.csv");
  const auto rows = [](const std::string& text, const std::string& method)
  {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find('"' + method + '"', at)) != std::string::npos; ++at)
      ++count;
    return count;
  };
  BOOST_TEST(rows(table, "default") >=
             14u); // 5 numbers of views, with and without noise; 4 of holes
  BOOST_TEST(rows(table, "one segment") == rows(table, "default"));

  // nothing is measured twice
  BOOST_TEST(exit_code(folder, run + " --methods default") == 0);
  BOOST_TEST(folder.read("scans.csv") == table);
  BOOST_TEST(exit_code(folder, program("benchmark_scans") +
                                   " data --ids 1 --csv sdf.csv --only removed --methods sdf") ==
             0);
  BOOST_TEST(rows(folder.read("sdf.csv"), "sdf") == 4u);

  // some of the clouds, with a column of labels for each method
  BOOST_TEST(exit_code(folder, program("benchmark_scans") +
                                   " data --ids 1 --only '1 view' --without noise --clouds clouds"
                                   " --csv few.csv --methods paper,default") == 0);
  BOOST_TEST(rows(folder.read("few.csv"), "paper") == 1u);
  BOOST_TEST(rows(folder.read("few.csv"), "paper, complete mesh") == 1u);
  std::istringstream cloud(folder.read("clouds/1_1_view.xyz"));
  std::string line;
  std::getline(cloud, line);
  BOOST_TEST(std::count(line.begin(), line.end(), ' ') == 8);

  BOOST_TEST(exit_code(folder, run + " --methods magic") == 1);
  const std::string error = folder.read("err.txt");
  BOOST_TEST(error.find("magic") != std::string::npos);
  BOOST_TEST(std::count(error.begin(), error.end(), '\n') == 1);
}

BOOST_AUTO_TEST_CASE(made_scans_have_true_parts_and_no_background)
{
  const Scratch_folder folder;
  BOOST_TEST(exit_code(folder, program("make_scans") + " made room airplane") == 0);
  const auto rows = [&](const std::string& name)
  {
    std::istringstream in(folder.read("made/" + name + ".ply"));
    for (std::string line; std::getline(in, line) && line != "end_header";)
    {}
    std::set<int> views, labels;
    for (double x = 0.; in >> x;)
    {
      for (int i = 0; i < 5; ++i) in >> x; // the other coordinates, the normal
      int view = 0, label = 0;
      in >> view >> label;
      views.insert(view);
      labels.insert(label);
    }
    return std::pair(views, labels);
  };
  BOOST_TEST(rows("room").first == (std::set<int>{0, 1, 2}));
  BOOST_TEST(rows("room").second == (std::set<int>{0, 1, 2, 3, 4, 5, 6, 7}));
  BOOST_TEST(rows("airplane").first == std::set<int>{0});
  BOOST_TEST(exit_code(folder, program("make_scans") + " made no_such_scan") == 1);
  BOOST_TEST(exit_code(folder, program("make_scans")) == 1);
}

BOOST_AUTO_TEST_CASE(labelings_of_a_shape_are_drawn_from_one_side)
{
  const Scratch_folder folder;
  write_model(folder, 1, "dumbbell");
  const std::string labels = " data/seg/Benchmark/1/1_";
  const std::string run = program("draw_labels") + " data/off/1.off" + labels + "0.seg a.png";
  BOOST_TEST(exit_code(folder, run + labels + "1.seg b.png" + labels + "0.seg c.png") == 0);
  BOOST_TEST(folder.read("a.png") == folder.read("c.png"));
  BOOST_TEST(folder.read("a.png") != folder.read("b.png"));
  // width and height
  BOOST_TEST(folder.read("a.png").substr(16, 8) == folder.read("b.png").substr(16, 8));
  BOOST_TEST(exit_code(folder, run + labels + "1.seg") == 1); // without a picture to make
}

BOOST_AUTO_TEST_CASE(the_stages_of_a_mesh_are_traced)
{
  const Scratch_folder folder;
  const std::string run = program("trace_stages") + " dumbbell trace.json";
  BOOST_TEST(exit_code(folder, run + " number_of_patches=30") == 0);
  const Json trace = Json::parse(folder.read("trace.json"));
  const std::size_t faces = trace["faces"].size();
  const auto count = [&](const char* const level)
  {
    const auto labels = trace["labels"][level].get<std::vector<int>>();
    BOOST_TEST(labels.size() == faces);
    return *std::max_element(labels.begin(), labels.end()) + 1;
  };
  // about as many as are wanted: clusters that do not hang together are split, and so are those that segments cut
  BOOST_TEST(
      exit_code(folder, program("trace_stages") + " dumbbell more.json number_of_patches=90") == 0);
  const Json more = Json::parse(folder.read("more.json"));
  BOOST_TEST(2 * trace["visibility"].size() < more["visibility"].size());
  BOOST_TEST(count("components") <= count("patches"));
  BOOST_TEST(count("segments") <= count("components"));
  BOOST_TEST(count("merged") == count("segments"));

  const std::size_t patches = trace["visibility"].size();
  BOOST_TEST(patches == trace["visibility"][0].size());
  BOOST_TEST(trace["visibility"][0][1] == trace["visibility"][1][0]);
  const Json& lines = trace["lines"];
  BOOST_TEST(lines["faces"].size() == 2 * patches);
  for (std::size_t i = 0; i < 2 * patches; ++i)
  {
    const auto& row = lines["seen"][i].get_ref<const std::string&>();
    BOOST_TEST(row.size() == 2 * patches);
    BOOST_TEST(row[i] == '1');
  }
  for (const Json& sample : trace["diameters"]) BOOST_TEST(sample[0] < faces);

  BOOST_TEST(exit_code(folder, run + " no_such_knob=1") == 1);
  BOOST_TEST(exit_code(folder, program("trace_stages") + " no_such_shape no.json") == 1);
  BOOST_TEST(!folder.has("no.json"));
}

BOOST_AUTO_TEST_CASE(parts_are_measured_without_people)
{
  const Scratch_folder folder;
  write_model(folder, 1, "figure");
  std::filesystem::create_directories(folder.path() / "mine");
  std::filesystem::copy_file(folder.path() / "data/seg/Benchmark/1/1_0.seg",
                             folder.path() / "mine/1.seg");
  const std::string parts = program("benchmark_parts");
  BOOST_TEST(exit_code(folder, parts + " data mine=mine --people --csv parts.csv") == 0);
  const std::string csv = folder.read("parts.csv");
  BOOST_TEST(std::count(csv.begin(), csv.end(), '\n') == 4); // a header, two people and mine
  BOOST_TEST(csv.find("\n1,mine,1,") != std::string::npos);
  BOOST_TEST(exit_code(folder, parts + " --mesh data/off/1.off=mine/1.seg --quiet") == 0);
  for (const std::string& wrong :
       {std::string(" data"), std::string(" data mine"), std::string(" data mine=none"),
        std::string(""), std::string(" data mine=mine --ids 270")})
  {
    BOOST_TEST(exit_code(folder, parts + wrong) == 1);
    const std::string error = folder.read("err.txt");
    BOOST_TEST(std::count(error.begin(), error.end(), '\n') == 1);
  }
}

BOOST_AUTO_TEST_CASE(merges_of_all_variants_of_a_shape_are_samples_for_the_fit)
{
  const Scratch_folder folder;
  write_model(folder, 1, "figure");
  const std::string fit = program("fit_merge_cost");
  BOOST_REQUIRE(exit_code(folder, fit + " names") == 0);
  const std::string names = folder.read("out.txt");
  const auto features = static_cast<std::size_t>(std::count(names.begin(), names.end(), '\n'));
  const auto samples = [&](const std::string& variant, const int seed)
  {
    const std::string call = fit + " samples data " + variant + " out.bin seed=";
    BOOST_REQUIRE(exit_code(folder, call + std::to_string(seed)) == 0);
    const std::string bytes = folder.read("out.bin");
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
    BOOST_REQUIRE(values.size() % (3 + features) == 0);
    return values;
  };
  const auto least_target = [&](const std::vector<float>& values)
  {
    float least = 1.f;
    for (std::size_t row = 0; row < values.size(); row += 3 + features)
    {
      BOOST_CHECK_EQUAL(values[row], 1.f);  // the model
      const float target = values[row + 2]; // none where a region has no face
      BOOST_CHECK(std::isnan(target) || target <= 1.f);
      if (target < least) least = target;
    }
    return least;
  };
  std::set<std::string> different;
  for (const char* const variant : {"mesh", "points", "half", "surface", "one_view", "two_views",
                                    "four_views", "noisy_scan", "stretched", "noisy_mesh"})
    BOOST_TEST_CONTEXT(variant)
    {
      const auto values = samples(variant, 0);
      different.insert(folder.read("out.bin"));
      const float least = least_target(values); // one of the two people has it in one part
      BOOST_CHECK(least >= 0.499f && least < 0.6f);
    }
  BOOST_CHECK_GE(different.size(), 9u); // centroids of even faces are neighbors as in the mesh
  std::size_t of_hulls = 0;
  for (int seed = 0; seed < 8; ++seed)
  {
    const auto values = samples("hull", seed);
    BOOST_CHECK_EQUAL(least_target(values), 1.f);
    of_hulls += values.size();
  }
  BOOST_CHECK_GT(of_hulls, 0u);
  BOOST_TEST(exit_code(folder, fit + " samples data no_such_variant out.bin") == 1);
}

BOOST_AUTO_TEST_SUITE_END()
