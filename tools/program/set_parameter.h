// Copyright (c) 2026  The Weakly_convex_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SET_PARAMETER_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SET_PARAMETER_H

// The parameters of the method by name, for command lines: from the one table in Parameters.h.

#include "program/command_line.h"

#include <CGAL/Weakly_convex_segmentation/Parameters.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace Named_parameters {

using Parameters = CGAL::Weakly_convex_segmentation::Parameters;

/// A parameter that is one number, a rule or switch by its number, or an element of a vector, `name[i]`.
struct Knob
{
  std::string name;
  double low, high;
  bool is_whole; ///< a count, rule or switch
};

/// calls `f(knob, number)` for all knobs, with a reference to the member or element.
template <typename Parameters_, typename Function>
void for_each_knob(Parameters_& parameters, const Function& f)
{
  const auto visit = [&f](const char* name, auto& member, const double low, const double high)
  {
    using Member = std::decay_t<decltype(member)>;
    if constexpr (std::is_same<Member, std::vector<double>>::value)
      for (std::size_t i = 0; i < member.size(); ++i)
        f(Knob{std::string(name) + "[" + std::to_string(i) + "]", low, high, false}, member[i]);
    else
      f(Knob{name, low, high, !std::is_floating_point<Member>::value}, member);
  };
  CGAL::Weakly_convex_segmentation::internal::for_each_parameter(parameters, visit);
}

/// returns all knobs, in the order of the stages.
inline std::vector<Knob> knobs(const Parameters& parameters = {})
{
  std::vector<Knob> result;
  for_each_knob(parameters, [&](const Knob& knob, const auto&) { result.push_back(knob); });
  return result;
}

/// returns the value of a knob.
/// \throws std::invalid_argument if there is no such knob
inline double get(const Parameters& parameters, const std::string& name)
{
  const double* found = nullptr;
  double value = 0.;
  for_each_knob(parameters,
                [&](const Knob& knob, const auto& member)
                {
                  if (knob.name != name) return;
                  value = static_cast<double>(member);
                  found = &value;
                });
  if (found == nullptr) throw std::invalid_argument("there is no parameter '" + name + "'");
  return value;
}

/// sets a knob, and returns whether there is one of that name.
inline bool set(Parameters& parameters, const std::string& name, const double value)
{
  bool is_known = false;
  for_each_knob(parameters,
                [&](const Knob& knob, auto& member)
                {
                  if (knob.name != name) return;
                  using Member = std::decay_t<decltype(member)>;
                  if constexpr (std::is_enum<Member>::value)
                    member = static_cast<Member>(static_cast<int>(value));
                  else if constexpr (std::is_same<Member, bool>::value)
                    member = value != 0.;
                  else
                    member = static_cast<Member>(value);
                  is_known = true;
                });
  return is_known;
}

/// returns the numbers of a list that is separated by commas.
/// \throws std::invalid_argument if one is no number
inline std::vector<double> read_numbers(const std::string& list)
{
  std::vector<double> numbers;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');)
  {
    std::size_t used = 0;
    try
    {
      numbers.push_back(std::stod(word, &used));
    }
    catch (const std::exception&)
    {
      used = 0;
    }
    if (used == 0 || used != word.size())
      throw std::invalid_argument("'" + word + "' is no number");
  }
  if (numbers.empty()) throw std::invalid_argument("there is no number");
  return numbers;
}

/// sets a parameter from `name=value`, a vector from `name=value,value,...`.
/// \throws std::invalid_argument if there is no such parameter or a value is no number
inline void set_parameter(Parameters& parameters, const std::string& assignment)
{
  const std::size_t equals = assignment.find('=');
  const std::string name = assignment.substr(0, equals);
  std::vector<double> values;
  try
  {
    if (equals != std::string::npos) values = read_numbers(assignment.substr(equals + 1));
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument("'" + assignment + "': " + error.what());
  }
  bool is_known = values.size() == 1 && set(parameters, name, values.front());
  const auto visit = [&](const char* member_name, auto& member, double, double)
  {
    if constexpr (std::is_same<std::decay_t<decltype(member)>, std::vector<double>>::value)
      if (!values.empty() && name == member_name)
      {
        member = values;
        is_known = true;
      }
  };
  CGAL::Weakly_convex_segmentation::internal::for_each_parameter(parameters, visit);
  if (is_known) return;
  std::vector<std::string> names;
  for (const Knob& knob : knobs()) names.push_back(knob.name);
  throw std::invalid_argument("'" + assignment +
                              "' does not set a parameter; give NAME=VALUE, or NAME=VALUE,VALUE "
                              "for a vector, with a name from Parameters.h" +
                              Command_line::suggestion(name, names));
}

} // namespace Named_parameters

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_TOOLS_PROGRAM_SET_PARAMETER_H
