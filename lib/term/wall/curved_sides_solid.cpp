#include "term/wall/curved_sides_of.hpp"

namespace ixos {

template std::unique_ptr<CurvedWallSides<3>> make_curved_sides(const LocalMesh&, const SideGroup&, const Pattern&, int);

}  // namespace ixos
