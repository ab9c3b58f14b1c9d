// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FUNCTION_REF_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FUNCTION_REF_H

// Function objects as arguments of functions that are no templates.

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

template <typename Signature>
class Function_ref;

/// Refers to a function object of any type, which has to live as long: who takes one instead of a
/// template parameter is compiled once.
template <typename Result, typename... Arguments>
class Function_ref<Result(Arguments...)>
{
  const void* m_function;
  Result (*m_call)(const void*, Arguments...);

public:
  template <typename Function>
  Function_ref(const Function& function) // not explicit: calls look as with a template parameter
    : m_function(&function), m_call([](const void* f, Arguments... arguments) -> Result
                                    { return (*static_cast<const Function*>(f))(arguments...); })
  {}
  Result operator()(Arguments... arguments) const { return m_call(m_function, arguments...); }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_FUNCTION_REF_H
