#include "scene/scene_mesh.hpp"
#include "support/catalogue_walk.hpp"

namespace ixos {
namespace {

TEST(MeshCatalogueTest, EveryEntryIsWhole) {
  Teuchos::ParameterList texts;
  texts.set("File", std::string(IXOS_TEST_DIRECTORY) + "/../meshes/ball.e");
  test::walk(meshes(), texts, {"Exodus/File", "Exodus/Dimension", "Gmsh/File", "Gmsh/Dimension", "Given/Dimension"},
             [](const Teuchos::ParameterList& list, const MeshEntry&) -> std::vector<double> {
               try {
                 const Mesh mesh = meshes().make(SceneNode(list, "Mesh"));
                 double sum = 0;
                 for (std::size_t k = 0; k < mesh.coordinates.size(); ++k)
                   sum += std::sin(0.1 + double(k)) * mesh.coordinates[k];
                 return {double(mesh.cells()), sum};
               } catch (const InputError&) {
                 return {-1};  // the parameter was read, and the value refused
               }
             });
}

}  // namespace
}  // namespace ixos
