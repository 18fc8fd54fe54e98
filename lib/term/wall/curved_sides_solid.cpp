#include "term/wall/point_matrices.hpp"

namespace ixos {

template std::unique_ptr<CurvedWallSides<3>> make_curved_sides(const LocalMesh&, const SideGroup&, const Pattern&, int);

}  // namespace ixos
