/// Units of results.
#pragma once
#include <string>
#include <vector>

#include "units/unit_system.hpp"

namespace ixos {

/// The unit of one kind of result.
struct ResultUnit {
  std::string quantity;    ///< "force"
  std::string expression;  ///< in units of the scene, see UnitSystem::unit(): "E0 L0^2"
  std::string si;          ///< the SI unit: "N"
  double scale = 0;        ///< how many SI units it is
};

/// Returns the units of all results of a run in 2 or 3 dimensions. In 2 dimensions forces, moments, energies and
/// momenta are per depth. Throws InputError for one that is beyond the range of numbers.
std::vector<ResultUnit> result_units(const UnitSystem& units, int dimension);

}  // namespace ixos
