#include "units/result_units.hpp"

namespace ixos {

std::vector<ResultUnit> result_units(const UnitSystem& units, int dimension) {
  const bool plane = dimension == 2;
  std::vector<ResultUnit> all{{"length", "L0", "m"},
                              {"time", "T0", "s"},
                              {"stress", "E0", "Pa"},
                              {"velocity", "L0/T0", "m/s"},
                              {"acceleration", "L0/T0^2", "m/s^2"},
                              {"force", plane ? "E0 L0" : "E0 L0^2", plane ? "N/m" : "N"},
                              {"energy", plane ? "E0 L0^2" : "E0 L0^3", plane ? "J/m" : "J"},
                              {"linear_momentum", plane ? "E0 L0 T0" : "E0 L0^2 T0", plane ? "N s/m" : "N s"},
                              {"angular_momentum", plane ? "E0 L0^2 T0" : "E0 L0^3 T0", plane ? "N s" : "N m s"},
                              {"contact_measure", plane ? "L0" : "L0^2", plane ? "m" : "m^2"},
                              {"moment", plane ? "E0 L0^2" : "E0 L0^3", plane ? "N" : "N m"}};
  for (ResultUnit& unit : all) unit.scale = units.si(unit.expression);
  return all;
}

}  // namespace ixos
