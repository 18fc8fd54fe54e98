#include "interaction/pair_kernel.hpp"

#include "interaction/van_der_waals.hpp"

namespace ixos {

std::vector<GapPower> powers_of(const GapLaw& law) {
  const auto* const own = dynamic_cast<const GapLawOf<VanDerWaals>*>(&law);
  if (own == nullptr) return {};
  return {{own->law().c1(), 9}, {-own->law().c2(), 3}};
}

}  // namespace ixos
