// The stage of partitioned.cpp, a mass on a spring, and its solver.
#pragma once
#include <array>
#include <ixos/checkpoint.hpp>
#include <ixos/model.hpp>

constexpr int body_steps = 2;   ///< in a coupling step
constexpr int stage_steps = 8;  ///< likewise

/// The forces on the block's top at the ends of the body's steps, the coupling step's start first.
using Forces = std::array<double, body_steps + 1>;

/// The foreign solver: m y'' = -k (y - rest) - force by the trapezoidal rule. Each rank computes it alike.
struct Stage {
  double mass = 4, stiffness = 2, rest = -0.5;
  ixos::TimeValue motion;
  double force = 0;  ///< on the block's top

  void advance(double dt, const Forces& forces) {
    const double h = dt / stage_steps;
    for (int step = 1; step <= stage_steps; ++step) {
      const auto [y, v, a] = motion;
      const double load = -at(forces, static_cast<double>(step) / stage_steps) + stiffness * rest;
      const double known = y + h * v + h * h / 4 * a;
      motion.acceleration = (load - stiffness * known) / (mass + stiffness * h * h / 4);
      motion.value = known + h * h / 4 * motion.acceleration;
      motion.rate = v + h / 2 * (a + motion.acceleration);
    }
    force = forces.back();
  }
  double energy() const {
    const double way = motion.value - rest;
    return mass / 2 * motion.rate * motion.rate + stiffness / 2 * way * way;
  }
  void transfer(ixos::Record& record) {
    record.number("place", motion.value);
    record.number("velocity", motion.rate);
    record.number("acceleration", motion.acceleration);
    record.number("force", force);
  }

 private:
  /// The parabola through the three forces, tau from 0 to 1.
  static double at(const Forces& f, double tau) {
    return f[0] * (1 - tau) * (1 - 2 * tau) + f[1] * 4 * tau * (1 - tau) + f[2] * tau * (2 * tau - 1);
  }
};
