/// An interaction of two surfaces in two passes.
#pragma once
#include <memory>

#include "term/interaction.hpp"

namespace ixos {

/// Returns the sum of two interactions of the same surfaces, of which either is once the secondary and once the primary
/// one. `reacts`: each has half of the law's energy, so that the sum has it once, and takes the reaction. Otherwise
/// each acts on its own secondary surface with the whole law (Sauer and De Lorenzis 2013): the forces have no
/// potential; the energy is the mean of both. The report is that of the first one's secondary surface.
std::unique_ptr<Interaction> two_passes(std::unique_ptr<Interaction> first, std::unique_ptr<Interaction> second,
                                        bool reacts);

}  // namespace ixos
