#include "mesh/free_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/eigenpairs.hpp"
#include "base/vector3.hpp"
#include "mesh/bounds.hpp"

namespace ixos {
namespace {

using Point = std::array<double, 3>;

/// Six numbers, or a symmetric matrix of them. Fewer modes use the first ones; the other rows are zero.
using Six = std::array<double, 6>;
using Matrix = Small<double, 6>;

/// The modes of a space: which translations, and about which axes rotations.
struct Modes {
  std::vector<std::size_t> translations, rotations;
  std::size_t size() const { return translations.size() + rotations.size(); }
};

Modes modes_of(MotionSpace space) {
  if (space == MotionSpace::Revolved) return {{1}, {}};
  if (space == MotionSpace::Plane) return {{0, 1}, {2}};
  return {{0, 1, 2}, {0, 1, 2}};
}

/// The centre of the box around the places, and half its diagonal.
struct Box {
  Point centre{};
  double size = 0;
};

Box box_around(const std::vector<Point>& places) {
  Box box;
  if (places.empty()) return box;
  Bounds bounds;
  for (const Point& x : places) bounds.add(x);
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    box.centre[i] = (bounds.lower[i] + bounds.upper[i]) / 2;
    square += bounds.extent(i) * bounds.extent(i) / 4;
  }
  box.size = std::sqrt(square);
  return box;
}

/// Returns the displacements along the restraint that the modes of size 1 cause.
Six row_of(const Restraint& restraint, const Modes& modes, const Box& box) {
  Point arm{};
  for (std::size_t i = 0; i < 3; ++i) arm[i] = (restraint.place[i] - box.centre[i]) / (box.size > 0 ? box.size : 1);
  const Point moment = cross(arm, restraint.direction);
  Six row{};
  std::size_t m = 0;
  for (const std::size_t axis : modes.translations) row[m++] = restraint.direction[axis];
  for (const std::size_t axis : modes.rotations) row[m++] = moment[axis];
  return row;
}

/// Returns an orthonormal basis of the modes that no row hinders.
std::vector<Six> free_modes(const std::vector<Restraint>& restraints, const Modes& modes, const Box& box) {
  constexpr double least = 1e-12;  // square of 1e-6
  Matrix gram{};
  for (const Restraint& restraint : restraints) {
    const Six row = row_of(restraint, modes, box);
    for (std::size_t i = 0; i < modes.size(); ++i)
      for (std::size_t j = 0; j < modes.size(); ++j) gram[i][j] += row[i] * row[j];
  }
  const auto pairs = eigenpairs<double, 6>(gram);
  const double largest = *std::max_element(pairs.value.begin(), pairs.value.end());
  std::vector<Six> result;
  for (std::size_t i = 0; i < modes.size(); ++i)
    if (pairs.value[i] <= least * largest) result.push_back(pairs.vector[i]);
  return result;
}

/// Returns the vector of length 1 whose first component that is not small is positive.
Point unit(Point v) {
  const double length = std::sqrt(dot(v, v));
  for (double& x : v) x = std::abs(x) < 1e-9 * length ? 0.0 : x / length;
  const auto first = std::find_if(v.begin(), v.end(), [](double x) { return x != 0; });
  if (first != v.end() && *first < 0)
    for (double& x : v) x = x == 0 ? 0.0 : -x;
  return v;
}

std::string vector_in_words(const Point& v, MotionSpace space) {
  const auto clean = [](double x) { return std::abs(x) < 1e-12 ? 0.0 : x; };
  return space == MotionSpace::Plane ? fmt::format("({:.4g}, {:.4g})", clean(v[0]), clean(v[1]))
                                     : fmt::format("({:.4g}, {:.4g}, {:.4g})", clean(v[0]), clean(v[1]), clean(v[2]));
}

std::string translations_in_words(const FreeMotions& motions) {
  const auto& all = motions.translations;
  if (motions.space == MotionSpace::Revolved) return "the translation along the axis";
  if (all.size() == (motions.space == MotionSpace::Plane ? 2U : 3U)) return "any translation";
  if (all.size() == 2) return "translations normal to " + vector_in_words(unit(cross(all[0], all[1])), motions.space);
  return "the translation along " + vector_in_words(all[0], motions.space);
}

std::string rotations_in_words(const FreeMotions& motions) {
  const auto& all = motions.rotations;
  const bool about_a_point = motions.translations.empty();
  if (motions.space == MotionSpace::Plane)
    return about_a_point ? "the rotation about " + vector_in_words(all[0].point, motions.space) : "the rotation";
  if (all.size() == 3) return "any rotation";
  if (all.size() == 2)
    return "rotations about axes normal to " +
           vector_in_words(unit(cross(all[0].direction, all[1].direction)), motions.space);
  return "the rotation about the axis along " + vector_in_words(all[0].direction, motions.space) +
         (about_a_point ? " through " + vector_in_words(all[0].point, motions.space) : "");
}

}  // namespace

FreeMotions free_motions(const std::vector<Point>& places, const std::vector<Restraint>& restraints,
                         MotionSpace space) {
  const Modes modes = modes_of(space);
  const Box box = box_around(places);
  const std::vector<Six> basis = free_modes(restraints, modes, box);
  // Free modes without a rotation are translations.
  Matrix gram{};
  for (std::size_t i = 0; i < basis.size(); ++i)
    for (std::size_t j = 0; j < basis.size(); ++j)
      for (std::size_t m = modes.translations.size(); m < modes.size(); ++m) gram[i][j] += basis[i][m] * basis[j][m];
  const auto pairs = eigenpairs<double, 6>(gram);
  FreeMotions result;
  result.space = space;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    Point translation{}, turn{};
    for (std::size_t i = 0; i < basis.size(); ++i) {
      std::size_t m = 0;
      for (const std::size_t axis : modes.translations) translation[axis] += pairs.vector[k][i] * basis[i][m++];
      for (const std::size_t axis : modes.rotations) turn[axis] += pairs.vector[k][i] * basis[i][m++];
    }
    constexpr double least = 1e-14;  // square of the share of a rotation that is rounding alone
    if (pairs.value[k] <= least) {
      result.translations.push_back(unit(translation));
      continue;
    }
    Point point = cross(turn, translation);
    for (std::size_t i = 0; i < 3; ++i) point[i] = box.centre[i] + point[i] * box.size / dot(turn, turn);
    result.rotations.push_back({unit(turn), point});
  }
  return result;
}

std::string in_words(const FreeMotions& motions) {
  std::string words;
  if (!motions.translations.empty()) words = translations_in_words(motions);
  if (!motions.rotations.empty()) words += (words.empty() ? "" : " and ") + rotations_in_words(motions);
  return words;
}

}  // namespace ixos
