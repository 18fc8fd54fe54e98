#include "interaction/obstacle.hpp"
#include "interaction/catalogue.hpp"

namespace ixos {
namespace {

/// The space between two parallel planes is free: y from 0 to the height.
class Slit final : public Obstacle {
 public:
  explicit Slit(double height) : height_(height) {}

  ObstacleGap at(const PackPoint& x) const override {
    const auto lower = x[1] < height_ / 2;
    ObstacleGap found;
    found.gap = select(lower, x[1], Pack(height_ - x[1]));                        // signed distance
    found.normal = {Pack(0.0), select(lower, Pack(1.0), Pack(-1.0)), Pack(0.0)};  // its gradient
    return found;  // bend, its second derivatives, is zero
  }

 private:
  double height_;
};

struct Parameters {
  double height = 0;
};

}  // namespace

ObstacleEntry slit_obstacle() {
  Options<Parameters> options;
  options.require("Height", &Parameters::height, "Height of the slit [L0].", greater_than(0));
  return {"Slit", "A slit between two planes.", "", options.list(),
          [options](const SceneNode& node, std::size_t /*dimension*/) -> std::shared_ptr<const Obstacle> {
            return std::make_shared<Slit>(options.read(node).height);
          }};
}

}  // namespace ixos
