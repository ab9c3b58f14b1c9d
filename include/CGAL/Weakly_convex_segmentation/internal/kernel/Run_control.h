// Copyright (c) 2026  The Weakly_convex_segmentation authors.
//
// This file is part of Weakly_convex_segmentation, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Weakly_convex_segmentation authors

#ifndef CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_RUN_CONTROL_H
#define CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_RUN_CONTROL_H

// Progress, cancellation and events of a run.

#include <CGAL/Weakly_convex_segmentation/Visitor.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/Function_ref.h>
#include <CGAL/Weakly_convex_segmentation/internal/kernel/stage_shares.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>

namespace CGAL {
namespace Weakly_convex_segmentation {
namespace internal {

/// How a run talks to its caller.
struct Run_control
{
  using Clock = std::chrono::steady_clock;

  bool parallel = false;
  Visitor* visitor = nullptr;
  std::function<bool(double)> callback; ///< progress in [0, 1]; false cancels

  // the last question; of the thread that asks only
  mutable double asked_share = 0.;
  mutable Clock::time_point asked_time = Clock::time_point();
  mutable std::thread::id asking_thread = {};
  mutable std::size_t skipped = 0;
  mutable Stage_shares shares = stage_shares(0, true); // of the input at hand

  void progress(const double share) const
  {
    if (!callback) return;
    asked_share = share;
    asked_time = Clock::now();
    // other threads may read it meanwhile, see check_sometimes()
    if (asking_thread != std::this_thread::get_id()) asking_thread = std::this_thread::get_id();
    if (!callback(share)) throw Canceled();
  }

  /// asks again, between the steps of a stage, if a tenth of a second has passed since.
  void check() const
  {
    constexpr std::chrono::milliseconds interval(100);
    if (callback && Clock::now() - asked_time > interval) progress(asked_share);
  }

  bool asks_on_this_thread() const
  {
    return callback && std::this_thread::get_id() == asking_thread;
  }

  /// check() on any thread: only the thread that has asked before asks again.
  void check_on_any_thread() const
  {
    if (asks_on_this_thread()) check();
  }

  /// the same for what happens millions of times
  void check_sometimes() const
  {
    if (asks_on_this_thread() && ++skipped % 1024 == 0) check();
  }

  /// the input is prepared, and the stages begin.
  void begin_stages(const std::size_t number_of_points, const bool has_given_normals) const
  {
    shares = stage_shares(number_of_points, has_given_normals);
    progress(shares[0]);
  }

  /// runs one stage between its events; `work` returns the number of things made.
  void stage(const Stage stage, const Function_ref<std::size_t()> work) const
  {
    if (visitor != nullptr) visitor->stage_begins(stage);
    const std::size_t size = work();
    if (visitor != nullptr) visitor->stage_ends(stage, size);
    progress(shares[static_cast<std::size_t>(stage) + 1]);
  }
};

/// Passes merges on to another visitor, and asks the callback meanwhile.
class Asking_visitor : public Visitor
{
  const Run_control& m_control;

public:
  explicit Asking_visitor(const Run_control& control) : m_control(control) {}
  void merged(const int first, const int second, const double cost) override
  {
    if (m_control.visitor != nullptr) m_control.visitor->merged(first, second, cost);
    m_control.check();
  }
};

} // namespace internal
} // namespace Weakly_convex_segmentation
} // namespace CGAL

#endif // CGAL_WEAKLY_CONVEX_SEGMENTATION_INTERNAL_KERNEL_RUN_CONTROL_H
