/// A strip whose mesh follows the front while it is peeled off a wall.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "run/restart_fixture.hpp"
#include "study/common/history_table.hpp"

namespace ixos::test {

inline std::string adapt(int levels, const std::string& more = "") {
  return list("Adapt", count("Levels", levels) + count("Interval", 4) + number("Budget", 1) + more);
}

/// A strip that is peeled off a wall at its right edge. `material`, `wall`: further parameters of these.
inline std::string strip(const std::string& scheme, const std::string& mesh, double step, double end,
                         const std::string& output = "", const std::string& element = "Q1C1",
                         const std::string& material = "", const std::string& wall = "") {
  return list("Mesh",
              word("Type", "Box") + list("Box", numbers("Lengths", {12, 0.5}) + counts("Divisions", {12, 1})) + mesh) +
         list("Materials", list("Rubber", number("Density", 0.01) + material)) +
         list("Interactions",
              list("Wall", word("Side Set", "bottom") + numbers("Point", {0, -0.6368}) + number("Gamma L", 1) +
                               number("Gamma W", 10) + word("Contact Element", element) + wall)) +
         list("Histories", list("Up", word("Type", "Ramp") + list("Ramp", number("Value", 2) + number("Length", 4)))) +
         list("Boundary Conditions",
              list("Pull", word("Node Set", "right") + word("Components", "y") + word("History", "Up")) +
                  list("Guide", word("Node Set", "right") + word("Components", "x"))) +
         list("Output", output + texts("Reactions", "{right}") + list("Probes", list("P", numbers("Point", {6, 0})))) +
         list("Time Integrator", word("Type", scheme) + steps(step, end));
}

inline const std::string branches =
    list("Maxwell Branches", numbers("Relaxation Times", {0.05, 2}) + numbers("Moduli", {0.4, 0.2}));
inline const std::string friction = list("Friction", word("Type", "Extended Amontons") + number("Coefficient", 0.3));

/// Expects that the balance with what was dissipated and what changes of the mesh added is closed.
inline void expect_closed(const HistoryTable& rows, double largest) {
  const std::vector<double>&total = rows.column("total_energy"), &work = rows.column("external_work"),
        &adapted = rows.column("adapted_energy"), &lost = rows.column("dissipated_energy");
  for (std::size_t k = 0; k < rows.rows(); ++k) {
    EXPECT_NEAR(total[k] + lost[k] - work[k] - adapted[k], total[0], 1e-11 * largest) << k;
    if (k > 0) {
      EXPECT_GE(lost[k], lost[k - 1] - 1e-13 * largest) << k;
    }
  }
}

/// The sum of the squared differences of two columns of as many rows.
inline double squared_distance(const std::vector<double>& one, const std::vector<double>& other) {
  double sum = 0;
  for (std::size_t k = 0; k < one.size(); ++k) sum += (one[k] - other[k]) * (one[k] - other[k]);
  return sum;
}

/// Expects that a run has the force of a run on a mesh that is fine everywhere within 3 %, and that squared errors are
/// `times` smaller than those of a coarse mesh.
inline void expect_force_of_fine_mesh(const HistoryTable& fine, const HistoryTable& coarse, const HistoryTable& follows,
                                      double times) {
  const std::string force = "reaction_right_y";
  const std::vector<double> exact = fine.column(force), nothing(exact.size(), 0.0);
  const double error = squared_distance(exact, follows.column(force));
  EXPECT_LT(std::sqrt(error / squared_distance(exact, nothing)), 0.03);
  EXPECT_GT(squared_distance(exact, coarse.column(force)), times * error);
}

}  // namespace ixos::test
