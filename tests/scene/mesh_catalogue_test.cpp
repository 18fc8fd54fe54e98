#include "scene/read/mesh_parts.hpp"
#include "scene/read/parameters.hpp"
#include "scene/read/scene_mesh.hpp"
#include "support/catalogue_walk.hpp"
#include "test_folders.hpp"

namespace ixos {
namespace {

TEST(MeshCatalogueTest, EveryEntryIsWhole) {
  const std::string folder = std::string(IXOS_TEST_DIRECTORY) + "/../meshes/";
  Teuchos::ParameterList texts;
  texts.set("File", "the mesh");
  test::walk(meshes(), texts,
             {"Exodus/File", "Exodus/Dimension", "Gmsh/File", "Gmsh/Dimension", "Given/Dimension", "Parts/Merge",
              "Array/Merge"},
             [&](Teuchos::ParameterList list, const MeshEntry& entry) -> std::vector<double> {
               if (entry.parameters.isParameter("File"))
                 list.sublist(entry.name).set("File", folder + (entry.name == "Gmsh" ? "pillar.msh" : "ball.e"));
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

TEST(MeshCatalogueTest, StatedDimensionsAreThoseOfTheMeshes) {
  Teuchos::ParameterList list = scene_parameters().sublist("Mesh");
  for (const MeshEntry& entry : meshes().entries()) {
    list.set(meshes().choice(), entry.name);
    if (has_parts(entry.name))
      EXPECT_EQ(entry.dimension, 0);  // its parts state theirs
    else if (entry.dimension == 0)
      EXPECT_TRUE(list.sublist(entry.name).isType<int>("Dimension")) << entry.name;
    else
      EXPECT_EQ(meshes().make(SceneNode(list, "Mesh")).dimension, entry.dimension) << entry.name;
  }
}

}  // namespace
}  // namespace ixos
