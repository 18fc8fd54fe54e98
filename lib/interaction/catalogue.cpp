#include "interaction/catalogue.hpp"

namespace ixos {

#define ENTRY(name) LawEntry name();
#include "interaction/laws.def"
#undef ENTRY
#define ENTRY(name) ObstacleEntry name();
#include "interaction/obstacles.def"
#undef ENTRY

#define ENTRY(name) name(),
const Catalogue<LawEntry>& laws() {
  static const Catalogue<LawEntry> catalogue("Law", "Interaction law.",
                                             {
#include "interaction/laws.def"
                                             });
  return catalogue;
}

const Catalogue<ObstacleEntry>& obstacles() {
  static const Catalogue<ObstacleEntry> catalogue("Obstacle", "Obstacle that the surface interacts with.",
                                                  {
#include "interaction/obstacles.def"
                                                  });
  return catalogue;
}
#undef ENTRY

std::shared_ptr<const GapLaw> make_gap_law(const std::string& name, const Settings& settings) {
  return laws().make_named("interaction law", name, settings);
}

std::shared_ptr<const Obstacle> make_obstacle(const std::string& name, std::size_t dimension,
                                              const Settings& settings) {
  return obstacles().make_named("obstacle", name, settings, dimension);
}

}  // namespace ixos
