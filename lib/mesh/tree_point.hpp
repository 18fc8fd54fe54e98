/// Points of the search trees of Boost.Geometry.
#pragma once
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/point.hpp>

#include "base/vec.hpp"

namespace ixos {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;

inline TreePoint tree_point(const Vec<3>& x) { return {x[0], x[1], x[2]}; }

}  // namespace ixos
