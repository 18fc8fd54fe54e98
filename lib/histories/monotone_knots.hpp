/// The limiter of tables that stay between the values of neighbouring times.
#pragma once
#include <vector>

#include "histories/time_function.hpp"

namespace ixos {

/// Limits the rates and accelerations of the knots so that the quintic Hermite polynomial of each interval is monotone,
/// or constant if both ends have the same value. Then no value leaves the range of its neighbours, and a table that
/// rests rests exactly. The curve stays twice continuously differentiable. Knots that satisfy the conditions keep their
/// numbers to the last bit: those of all parabolas that are monotone on each interval, and those of smooth data away
/// from extrema.
///
/// The conditions are that the Bernstein coefficients of each polynomial are monotone. Compare Dougherty, Edelman and
/// Hyman, Math. Comp. 52 (1989) 471-494. With the length h, the change D > 0 of the value, the rates d and the
/// accelerations s of the ends 0 and 1, they are
///   d0, d1 >= 0,  s0 >= -4 d0/h,  s1 <= 4 d1/h,  h^2 (s0 - s1) <= 20 D - 8 h (d0 + d1).
/// The rates are limited first, to h (d0 + d1) <= 5/2 D. Then s0 = s1 = 0 satisfies all conditions, so that both
/// intervals of a knot leave it some acceleration. `times` are those of the knots and increase.
void make_monotone(const std::vector<double>& times, std::vector<TimeValue>& knots);

}  // namespace ixos
