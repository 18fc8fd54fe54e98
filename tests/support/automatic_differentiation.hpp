/// Forward automatic differentiation as a scalar type of the kernels: the oracle for every tangent.
#pragma once
#include <Sacado.hpp>
#include <cmath>

#include "base/pack.hpp"

// Found by argument-dependent lookup from the kernels.
namespace Sacado::Fad::Exp {

template <class Storage>
GeneralFad<Storage> log1p(const GeneralFad<Storage>& x) {
  GeneralFad<Storage> result(x);
  result.val() = std::log1p(x.val());
  for (int i = 0; i < x.size(); ++i) result.fastAccessDx(i) = x.fastAccessDx(i) / (1 + x.val());
  return result;
}

/// The smaller of two by value, with its derivatives.
template <class Storage>
GeneralFad<Storage> smaller(const GeneralFad<Storage>& a, const GeneralFad<Storage>& b) {
  return a.val() < b.val() ? a : b;
}

template <class Storage>
double least(const GeneralFad<Storage>& x) {
  return x.val();
}

}  // namespace Sacado::Fad::Exp

namespace ixos::test {

/// A number with N derivatives.
template <int N>
using Dual = Sacado::Fad::Exp::GeneralFad<Sacado::Fad::Exp::StaticFixedStorage<double, N>>;

/// The i-th of N independent variables, with this value.
template <int N>
Dual<N> variable(int i, double value) {
  return Dual<N>(N, i, value);
}

}  // namespace ixos::test
