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

}  // namespace ixos
