#include "term/wall/flat_sides.hpp"

namespace ixos {

template std::unique_ptr<FlatWallSides<3>> make_flat_sides(const LocalMesh&, const SideGroup&, const Pattern&,
                                                           const HalfSpace&, int);

}  // namespace ixos
