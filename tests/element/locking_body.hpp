/// One element of each kernel, for the tests of the remedies for locking.
#pragma once
#include <type_traits>

#include "element/cell_means.hpp"
#include "element/elastic_kernel.hpp"
#include "element/element_nodes.hpp"
#include "element/enhanced_kernel.hpp"
#include "element/projected_dilatation_kernel.hpp"
#include "material/linear_elastic.hpp"
#include "material/neo_hooke.hpp"

namespace ixos::test {

/// Returns the mean over the reference volume of value(H), an array of numbers, of what the law sees in an element.
template <class Kernel, class Geometry, class Nodal, class Value>
auto mean_of(const typename Kernel::Law& law, const Geometry& geometry, const Nodal& u, const Value& value) {
  std::vector<Small<double, Kernel::G>> h;
  Kernel::seen(law, geometry, u, h);
  std::vector<double> weights;
  for (const auto& point : geometry.points) weights.push_back(point.weight);
  return mean_over(h.size(), weights.data(), [&](std::size_t q) { return value(h[q]); });
}

/// One element of a kernel, over any scalar type.
template <class ElementType, class KernelType>
struct Body : ElementNodes<ElementType> {
  using Element = ElementType;
  using Kernel = KernelType;
  using Law = typename Kernel::Law;
  using Standard = ElasticKernel<Element, Law>;
  using Nodes = ElementNodes<Element>;
  template <class T>
  using Nodal = typename Nodes::template Nodal<T>;
  template <class T>
  using Matrix = Small<T, Nodes::N * Nodes::D>;

  static const typename Kernel::Table& table() {
    static const typename Kernel::Table values;
    return values;
  }

  template <class T>
  T energy(const Nodal<T>& u) const {
    return Kernel::energy(law, Kernel::geometry(table(), Nodes::template constant<T>(x)), u);
  }

  /// Of a segment from `from` with velocity `velocity`.
  template <class K = Kernel, class T>
  Nodal<T> force(const Nodal<T>& u, const Rule& rule = end_rule()) const {
    const Nodal<T> start = Nodes::template constant<T>(from), rate = Nodes::template constant<T>(velocity);
    Nodal<T> f{};
    K::add_force(law, K::geometry(table(), Nodes::template constant<T>(x)), {&start, &rate, &u}, rule, f);
    return f;
  }

  template <class K = Kernel, class T>
  Matrix<T> tangent(const Nodal<T>& u, const Rule& rule = end_rule()) const {
    const Nodal<T> start = Nodes::template constant<T>(from), rate = Nodes::template constant<T>(velocity);
    Matrix<T> k{};
    K::add_tangent(law, K::geometry(table(), Nodes::template constant<T>(x)), {&start, &rate, &u}, rule, k);
    return k;
  }

  double least_jacobian(const Nodal<double>& u, const Rule& rule = end_rule()) const {
    Nodal<double> f{};
    return Kernel::add_force(law, Kernel::geometry(table(), x), {&from, &velocity, &u}, rule, f);
  }

  static Law law_of(const Lame& lame) {
    if constexpr (std::is_constructible_v<Law, NeoHooke>)
      return Law(NeoHooke{lame});
    else
      return Law{lame};
  }

  Law law = law_of(lame_constants(1.0, 0.3));
  Nodal<double> x = Nodes::distorted(0.0), from = Nodes::wave(0.06, 1.0), velocity = Nodes::wave(0.06, 2.0);
  Nodal<double> to = Nodes::wave(0.1, 3.0);
};

template <class Element, class Law>
using Mean = Body<Element, DilatationKernel<Element, Law>>;
template <class Element, class Law>
using Modes = Body<Element, EnhancedKernel<Element, Law>>;
template <class Element, class Law>
using Plain = Body<Element, ElasticKernel<Element, Law>>;

}  // namespace ixos::test
