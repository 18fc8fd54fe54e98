// The products of all elements at their points.
#include "element/cell_product.hpp"

namespace ixos {

#define IXOS_PRODUCT(D, T)                                                                                          \
  template void SpatialProduct<D>::multiply(std::size_t, const NarrowPack*, Small<T, D>*, std::array<T, D>*) const; \
  template void ModuliProduct<D>::multiply(std::size_t, const NarrowPack*, Small<T, D>*, std::array<T, D>*) const;
IXOS_PRODUCT(2, Pack)
IXOS_PRODUCT(3, Pack)
IXOS_PRODUCT(2, NarrowPack)
IXOS_PRODUCT(3, NarrowPack)
#undef IXOS_PRODUCT

}  // namespace ixos
