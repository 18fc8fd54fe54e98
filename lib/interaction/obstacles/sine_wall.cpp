#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "interaction/catalogue.hpp"
#include "interaction/graph_obstacle.hpp"

namespace ixos {
namespace {

/// h = sum_i A_i cos(k_i a_i). Crests and troughs are planes of symmetry, so the projection of a point is in the half
/// wave of the point: on the other side of such a plane, its mirror image is nearer.
template <std::size_t M>
class Waves {
 public:
  static constexpr std::size_t variables = M;

  Waves(const std::array<double, M>& amplitude, const std::array<double, M>& number)
      : amplitude_(amplitude), number_(number) {}

  const Waves& reader() const { return *this; }
  Height<M> at(const GraphPoint<M>& a) const {
    Height<M> height{};
    height.value = 0.0;
    for (std::size_t i = 0; i < M; ++i) {
      const double k = number_[i];
      const Pack phase = k * a[i], wave = amplitude_[i] * std::experimental::cos(phase);
      height.value += wave;
      height.slope[i] = -amplitude_[i] * k * std::experimental::sin(phase);
      height.bend[i][i] = -k * k * wave;
    }
    return height;
  }

  GraphPoint<M> kept(GraphPoint<M> a, const GraphPoint<M>& x) const {
    for (std::size_t i = 0; i < M; ++i) {
      const double half = M_PI / number_[i];
      const Pack lower = half * std::experimental::floor(x[i] / half);
      a[i] = std::experimental::max(smaller(a[i], Pack(lower + half)), lower);
    }
    return a;
  }

  double highest() const { return std::accumulate(amplitude_.begin(), amplitude_.end(), 0.0); }
  double steepest() const {
    double square = 0;
    for (std::size_t i = 0; i < M; ++i) square += std::pow(amplitude_[i] * number_[i], 2);
    return std::sqrt(square);
  }
  double sharpest() const {
    double largest = 0;
    for (std::size_t i = 0; i < M; ++i) largest = std::max(largest, amplitude_[i] * number_[i] * number_[i]);
    return largest;
  }
  double deepest() const { return sharpest(); }
  double bend_length() const { return 1 / *std::max_element(number_.begin(), number_.end()); }
  Pack to_edge(const GraphPoint<M>& /*a*/) const { return std::numeric_limits<double>::infinity(); }

 private:
  std::array<double, M> amplitude_, number_;
};

struct Parameters : FrameParameters {
  double amplitude = 0, period = 0, second_amplitude = 0, second_period = 1;
  GapMeasure measure = GapMeasure::Distance;
};

std::shared_ptr<const Obstacle> make(const Options<Parameters>& options, const SceneNode& node, std::size_t dimension) {
  const Parameters p = options.read(node);
  const Frame frame = read_frame(node, dimension);
  const double k = 2 * M_PI / p.period;
  if (p.second_amplitude == 0)
    return std::make_shared<GraphObstacle<Waves<1>>>(Waves<1>({p.amplitude}, {k}), frame, p.measure);
  if (dimension == 2) node.refuse("Second Amplitude", "must be 0 in two dimensions");
  return std::make_shared<GraphObstacle<Waves<2>>>(
      Waves<2>({p.amplitude, p.second_amplitude}, {k, 2 * M_PI / p.second_period}), frame, p.measure);
}

}  // namespace

ObstacleEntry sine_wall_obstacle() {
  Options<Parameters> options;
  add_frame(options, "A point on the mean plane of the wall, below a crest [L0]. If empty, it is the origin.",
            "Direction of the wave in three dimensions [-]. If empty, it is the first axis.");
  options.require("Amplitude", &Parameters::amplitude, "Height of a crest over the mean plane [L0].", greater_than(0))
      .require("Period", &Parameters::period, "Distance from crest to crest [L0].", greater_than(0))
      .add("Second Amplitude", &Parameters::second_amplitude,
           "Height of a second wave [L0], across the first one, which is added to it in three dimensions. 0: none.",
           at_least(0))
      .add("Second Period", &Parameters::second_period, "Distance from crest to crest of the second wave [L0].",
           greater_than(0));
  add_gap_measure(options);
  return {"Sine Wall", "A rigid wall with waves, z = A cos(2 pi x/period).", "", options.list(),
          [options](const SceneNode& node, std::size_t dimension) { return make(options, node, dimension); }};
}

}  // namespace ixos
