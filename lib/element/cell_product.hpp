/// The tangent of an element (or a pack of elements) applied without forming its matrix.
#pragma once
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "element/moduli_product.hpp"
#include "element/point_gradients.hpp"
#include "element/spatial_product.hpp"

namespace ixos {

/// A product at points of either form. Compiled once a dimension, for all elements.
template <std::size_t D>
class PointProduct {
 public:
  PointProduct() = default;
  template <class Product>
  explicit PointProduct(Product product) : product_(std::move(product)) {}

  bool has_mass() const {
    return std::visit([](const auto& own) { return own.has_mass(); }, product_);
  }
  std::size_t point_size() const {
    return std::visit([](const auto& own) { return own.point_size(); }, product_);
  }
  template <class T, class Kept>
  void multiply(std::size_t size, const Kept* data, Small<T, D>* gradients, std::array<T, D>* values) const {
    std::visit([&](const auto& own) { own.multiply(size, data, gradients, values); }, product_);
  }
  template <class T, class Kept>
  Small<T, D, D * D> diagonal(const Kept* data) const {
    return std::visit([&](const auto& own) { return own.template diagonal<T>(data); }, product_);
  }

 private:
  std::variant<ModuliProduct<D>, SpatialProduct<D>> product_;
};

/// Adds W u to f, from the data of a product at the points. A Product is PointProduct or one of its forms.
template <class Element, class Product, class T, class Kept>
void add_product(const ShapeTable<Element>& table, const Product& product, const Kept* data,
                 const Small<T, Element::nodes, Element::dimension>& u, PointScratch<Element::dimension, T>& scratch,
                 Small<T, Element::nodes, Element::dimension>& f) {
  const auto run = [&](auto has_mass) {
    constexpr bool with = decltype(has_mass)::value;
    auto* const gradients = scratch.gradients.data();
    auto* const values = with ? scratch.values.data() : nullptr;
    PointGradients<Element>::template evaluate<with>(table, u, gradients, values);
    if constexpr (with) scratch.complete_values();
    product.multiply(table.size(), data, gradients, values);
    PointGradients<Element>::template integrate<with>(table, gradients, values, f);
  };
  if (product.has_mass())
    run(std::true_type{});
  else
    run(std::false_type{});
}

/// Adds the diagonal of K to d, without that of the mass.
template <class Element, class Product, class T, class Kept>
void add_diagonal(const ShapeTable<Element>& table, const Product& product, const Kept* data,
                  Small<T, Element::nodes, Element::dimension>& diagonal) {
  constexpr std::size_t D = Element::dimension;
  for (std::size_t q = 0; q < table.size(); ++q, data += product.point_size()) {
    const Small<T, D, D* D> b = product.template diagonal<T>(data);
    for (std::size_t a = 0; a < diagonal.size(); ++a) {
      const auto& dn = table.gradient[q][a];
      for (std::size_t i = 0; i < D; ++i)
        for (std::size_t d = 0; d < D; ++d)
          for (std::size_t e = 0; e < D; ++e) diagonal[a][i] += (dn[d] * dn[e]) * b[i][d * D + e];
    }
  }
}

extern template void SpatialProduct<2>::multiply(std::size_t, const NarrowPack*, Small<Pack, 2>*,
                                                 std::array<Pack, 2>*) const;
extern template void SpatialProduct<3>::multiply(std::size_t, const NarrowPack*, Small<Pack, 3>*,
                                                 std::array<Pack, 3>*) const;
extern template void SpatialProduct<2>::multiply(std::size_t, const NarrowPack*, Small<NarrowPack, 2>*,
                                                 std::array<NarrowPack, 2>*) const;
extern template void SpatialProduct<3>::multiply(std::size_t, const NarrowPack*, Small<NarrowPack, 3>*,
                                                 std::array<NarrowPack, 3>*) const;
extern template void ModuliProduct<2>::multiply(std::size_t, const NarrowPack*, Small<Pack, 2>*,
                                                std::array<Pack, 2>*) const;
extern template void ModuliProduct<3>::multiply(std::size_t, const NarrowPack*, Small<Pack, 3>*,
                                                std::array<Pack, 3>*) const;
extern template void ModuliProduct<2>::multiply(std::size_t, const NarrowPack*, Small<NarrowPack, 2>*,
                                                std::array<NarrowPack, 2>*) const;
extern template void ModuliProduct<3>::multiply(std::size_t, const NarrowPack*, Small<NarrowPack, 3>*,
                                                std::array<NarrowPack, 3>*) const;

}  // namespace ixos
