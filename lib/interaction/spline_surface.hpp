/// Rough surfaces through heights on a grid.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "interaction/closest_point_search.hpp"
#include "interaction/spline_axis.hpp"

namespace ixos {

/// The bicubic spline through heights on a grid (M = 2), or the cubic spline through a row of them (M = 1), with two
/// continuous derivatives: a surface of GraphObstacle. The bounds of heights, slopes and second derivatives are those
/// of the control values of each piece in Bezier's form, of which the spline's are means.
template <std::size_t M>
class SplineSurface {
 public:
  static constexpr std::size_t variables = M;

  /// `heights[i + n j]` belongs to sample i of the first axis, which has n, and j of the second.
  SplineSurface(const std::array<SplineAxis, M>& axes, const std::vector<double>& heights) : axes_(axes) {
    const std::size_t n = axes_[0].samples(), rows = heights.size() / n;
    std::vector<std::vector<double>> lines(rows);
    for (std::size_t j = 0; j < rows; ++j) {
      const auto first = heights.begin() + static_cast<std::ptrdiff_t>(j * n);
      lines[j] = axes_[0].coefficients_of({first, first + static_cast<std::ptrdiff_t>(n)});
    }
    stride_ = axes_[0].coefficients();
    if constexpr (M == 2) {
      coefficients_.resize(stride_ * axes_[1].coefficients());
      std::vector<double> column(rows);
      for (std::size_t i = 0; i < stride_; ++i) {
        for (std::size_t j = 0; j < rows; ++j) column[j] = lines[j][i];
        const std::vector<double> c = axes_[1].coefficients_of(column);
        for (std::size_t j = 0; j < c.size(); ++j) coefficients_[i + stride_ * j] = c[j];
      }
    } else {
      coefficients_ = lines.front();
    }
    set_bounds();
  }

  /// Evaluates the surface. It keeps the coefficients of the last pieces: the places of a search are close together.
  class Reader {
   public:
    explicit Reader(const SplineSurface& surface) : surface_(surface) { first_ = -1.0; }

    Height<M> at(const GraphPoint<M>& place) {
      const SplineAxis::Weights x = surface_.axes_[0].at(place[0]);
      const double along = surface_.axes_[0].per_distance();
      Height<M> height;
      if constexpr (M == 1) {
        load(x.piece);
        height.value = product(x.value, rows_[0]);
        height.slope[0] = along * product(x.slope, rows_[0]);
        height.bend[0][0] = (along * along) * product(x.bend, rows_[0]);
      } else {
        const SplineAxis::Weights y = surface_.axes_[1].at(place[1]);
        const double across = surface_.axes_[1].per_distance();
        load(x.piece + static_cast<double>(surface_.stride_) * y.piece);
        std::array<Pack, 4> value, slope, bend;  // of the four rows
        for (std::size_t j = 0; j < 4; ++j) {
          value[j] = product(x.value, rows_[j]);
          slope[j] = product(x.slope, rows_[j]);
          bend[j] = product(x.bend, rows_[j]);
        }
        height.value = product(y.value, value);
        height.slope = {Pack(along * product(y.value, slope)), Pack(across * product(y.slope, value))};
        height.bend[0][0] = (along * along) * product(y.value, bend);
        height.bend[0][1] = height.bend[1][0] = (along * across) * product(y.slope, slope);
        height.bend[1][1] = (across * across) * product(y.bend, value);
      }
      return height;
    }

   private:
    /// Gets the coefficients of the pieces whose first ones are these.
    void load(const Pack& first) {
      if (everywhere(first == first_)) return;
      first_ = first;
      const double* coefficients = surface_.coefficients_.data();
      std::array<std::size_t, Pack::size()> from;
      for (std::size_t l = 0; l < Pack::size(); ++l) from[l] = static_cast<std::size_t>(double(first[l]));
      for (std::size_t j = 0; j < rows_.size(); ++j)
        for (std::size_t k = 0; k < 4; ++k)
          rows_[j][k] = Pack([&](auto lane) { return coefficients[from[lane] + j * surface_.stride_ + k]; });
    }

    const SplineSurface& surface_;
    Pack first_;
    std::array<std::array<Pack, 4>, M == 2 ? 4 : 1> rows_;
  };
  Reader reader() const { return Reader(*this); }
  Height<M> at(const GraphPoint<M>& place) const { return reader().at(place); }

  const GraphPoint<M>& kept(const GraphPoint<M>& place, const GraphPoint<M>& /*x*/) const { return place; }
  double highest() const { return highest_; }
  double steepest() const { return steepest_; }
  double sharpest() const { return sharpest_; }
  double deepest() const { return deepest_; }
  /// The second derivatives are linear along each piece.
  double bend_length() const {
    double length = axes_[0].distance();
    for (const SplineAxis& axis : axes_) length = std::min(length, axis.distance());
    return length;
  }
  Pack to_edge(const GraphPoint<M>& place) const {
    Pack result = axes_[0].to_end(place[0]);
    if constexpr (M == 2) result = smaller(result, axes_[1].to_end(place[1]));
    return result;
  }

 private:
  static Pack product(const std::array<Pack, 4>& a, const std::array<Pack, 4>& b) {
    return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
  }

  /// The largest heights, slopes and second derivatives of the control values of one piece.
  struct Bounds {
    std::array<double, 2> slope{}, over{}, under{};  ///< |h_i|, h_ii and -h_ii
    double mixed = 0;                                ///< |h_12|
    double height = -std::numeric_limits<double>::infinity();
  };

  void set_bounds() {
    const std::size_t rows = M == 2 ? axes_[M - 1].pieces() : 1;
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < axes_[0].pieces(); ++i) {
        const Bounds b = bounds(i + stride_ * j);
        const double difference = 0.5 * (b.over[0] - b.over[1]);
        highest_ = std::max(highest_, b.height);
        steepest_ = std::max(steepest_, std::hypot(b.slope[0], b.slope[1]));
        deepest_ = std::max(deepest_, 0.5 * (b.over[0] + b.over[1]) + std::hypot(difference, b.mixed));
        sharpest_ = std::max({sharpest_, deepest_, std::max(b.under[0], b.under[1]) + b.mixed});
      }
  }

  /// Returns the control values of a piece in Bezier's form from those of its four B-splines.
  static std::array<double, 4> control(const std::array<double, 4>& c) {
    return {(c[0] + 4 * c[1] + c[2]) / 6, (2 * c[1] + c[2]) / 3, (c[1] + 2 * c[2]) / 3, (c[1] + 4 * c[2] + c[3]) / 6};
  }

  /// Returns the bounds of the piece whose first coefficient is that.
  Bounds bounds(std::size_t first) const {
    constexpr std::size_t rows = M == 2 ? 4 : 1;
    std::array<std::array<double, 4>, rows> c;
    for (std::size_t j = 0; j < rows; ++j) {
      const double* own = &coefficients_[first + stride_ * j];
      c[j] = control({own[0], own[1], own[2], own[3]});
    }
    if constexpr (M == 2)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::array<double, 4> column = control({c[0][i], c[1][i], c[2][i], c[3][i]});
        for (std::size_t j = 0; j < 4; ++j) c[j][i] = column[j];
      }
    Bounds result;
    const auto note = [&](std::size_t axis, double slope) {
      result.slope[axis] = std::max(result.slope[axis], 3 * std::abs(slope) / axes_[axis].distance());
    };
    const auto note_bend = [&](std::size_t axis, double bend) {
      const double value = 6 * bend / std::pow(axes_[axis].distance(), 2);
      result.over[axis] = std::max(result.over[axis], value);
      result.under[axis] = std::max(result.under[axis], -value);
    };
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        result.height = std::max(result.height, c[j][i]);
        if (i < 3) note(0, c[j][i + 1] - c[j][i]);
        if (i < 2) note_bend(0, c[j][i + 2] - 2 * c[j][i + 1] + c[j][i]);
        if constexpr (M == 2) {
          if (j < 3) note(1, c[j + 1][i] - c[j][i]);
          if (j < 2) note_bend(1, c[j + 2][i] - 2 * c[j + 1][i] + c[j][i]);
          if (i < 3 && j < 3) {
            const double mixed = (c[j + 1][i + 1] - c[j + 1][i]) - (c[j][i + 1] - c[j][i]);
            result.mixed = std::max(result.mixed, 9 * std::abs(mixed) / (axes_[0].distance() * axes_[1].distance()));
          }
        }
      }
    return result;
  }

  std::array<SplineAxis, M> axes_;
  std::vector<double> coefficients_;
  std::size_t stride_ = 0;  ///< coefficients of a row
  double highest_ = -std::numeric_limits<double>::infinity(), steepest_ = 0, sharpest_ = 0, deepest_ = 0;
};

}  // namespace ixos
