#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "interaction/catalogue.hpp"
#include "interaction/graph_obstacle.hpp"
#include "interaction/spline_surface.hpp"
#include "io/height_grid.hpp"
#include "parameters/validation.hpp"

namespace ixos {
namespace {

enum class Level { File, Mean, Top };

struct Parameters : FrameParameters {
  std::string file = required;
  std::vector<double> spacing;
  double height_unit = 1, metre = 0;
  bool periodic = false;
  Level level = Level::File;
  GapMeasure measure = GapMeasure::Distance;
};

/// Reads the file. Returns spacings and heights in L0.
HeightGrid read_grid(const SceneNode& node, const Parameters& p) {
  HeightGrid grid = at(node.path_of("File"), [&] { return read_height_grid(p.file); });
  if (grid.in_metres) {
    if (!p.spacing.empty()) node.refuse("Spacing", "must be empty: the file states the distances itself");
    if (p.height_unit != 1) node.refuse("Height Unit", "must be 1: the file states its units itself");
    if (!(p.metre > 0)) node.refuse("Metre", "is missing: the file states lengths in SI units");
  } else {
    const auto spacing = node.numbers("Spacing", 2, {});
    if (spacing.empty()) node.refuse("Spacing", "is missing: the file has no distances");
    if (!(spacing[0] > 0 && spacing[1] > 0)) node.refuse("Spacing", "must be two positive numbers");
    grid.column_spacing = spacing[0];
    grid.row_spacing = spacing[1];
  }
  const double unit = grid.in_metres ? p.metre : p.height_unit, length = grid.in_metres ? p.metre : 1.0;
  grid.column_spacing *= length;
  grid.row_spacing *= length;
  for (double& height : grid.heights) height *= unit;
  double zero = 0;
  if (p.level == Level::Top) zero = *std::max_element(grid.heights.begin(), grid.heights.end());
  if (p.level == Level::Mean)
    zero = std::accumulate(grid.heights.begin(), grid.heights.end(), 0.0) / static_cast<double>(grid.heights.size());
  for (double& height : grid.heights) height -= zero;
  return grid;
}

std::shared_ptr<const Obstacle> make(const Options<Parameters>& options, const SceneNode& node, std::size_t dimension) {
  const Parameters p = options.read(node);
  const Frame frame = read_frame(node, dimension);
  const HeightGrid grid = read_grid(node, p);
  const auto refuse_size = [&](const std::string& why) {
    node.refuse("File", fmt::format("{} has {} rows of {} heights; {}", p.file, grid.rows, grid.columns, why));
  };
  if (grid.columns < 4) refuse_size("a row needs at least 4");
  const SplineAxis along(grid.columns, grid.column_spacing, p.periodic);
  if (grid.rows == 1)
    return std::make_shared<GraphObstacle<SplineSurface<1>>>(SplineSurface<1>({along}, grid.heights), frame, p.measure);
  if (dimension == 2) refuse_size("in two dimensions it must have one row");
  if (grid.rows < 4) refuse_size("it needs 1 row, or at least 4");
  const SplineAxis across(grid.rows, grid.row_spacing, p.periodic);
  return std::make_shared<GraphObstacle<SplineSurface<2>>>(SplineSurface<2>({along, across}, grid.heights), frame,
                                                           p.measure);
}

}  // namespace

ObstacleEntry height_field_obstacle() {
  Options<Parameters> options;
  options
      .add("File", &Parameters::file,
           "Path of the file with the heights, relative to the scene's folder or to the working folder: a Gwyddion "
           "Simple "
           "Field (.gsf), netCDF in a classic format, or a text with the numbers of a row in each line. A file of one "
           "row is a profile, the same along the second axis.")
      .add("Spacing", &Parameters::spacing,
           "For a text: distances of two numbers in a line, and of two lines [L0]. Other files state them.",
           greater_than(0))
      .add("Height Unit", &Parameters::height_unit,
           "For a text: unit of the heights [L0], for example \"1 nm\". Other files state it.", greater_than(0))
      .add("Metre", &Parameters::metre,
           "For a file in SI units: the length of a metre [L0], \"1 m\". With 0, a scene takes it from its Units.",
           at_least(0))
      .add("Periodic", &Parameters::periodic,
           "Whether the field repeats. Otherwise it ends at its outer heights, and no surface may be beyond.")
      .choose("Level", &Parameters::level, {{"File", Level::File}, {"Mean", Level::Mean}, {"Top", Level::Top}},
              "Height of the file that is at the Point: zero, the mean, or the highest one.");
  add_frame(options,
            "Place of the middle of the field, at the height that Level chooses [L0]. If empty, it is the origin.",
            "Direction of the rows in three dimensions [-]. If empty, it is the first axis.");
  add_gap_measure(options);
  return {"Height Field", "A rigid rough wall, a bicubic spline through heights from a file.", "de Boor 1978",
          options.list(),
          [options](const SceneNode& node, std::size_t dimension) { return make(options, node, dimension); }};
}

}  // namespace ixos
