#include "scene/read/obstacle_files.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

#include "base/digest.hpp"
#include "interaction/catalogue.hpp"
#include "io/disk_file.hpp"
#include "parameters/parameter_entries.hpp"
#include "scene/read/scene_units.hpp"

namespace ixos {

std::string path_beside(const std::string& scene_folder, const std::string& file) {
  const auto beside = std::filesystem::path(scene_folder) / file;
  return std::filesystem::absolute(std::filesystem::exists(beside) ? beside : std::filesystem::path(file))
      .lexically_normal()
      .string();
}

Teuchos::ParameterList with_obstacle_files(const Teuchos::ParameterList& scene, const std::string& scene_folder) {
  Teuchos::ParameterList result(scene);
  if (!result.isSublist("Interactions")) return result;
  Teuchos::ParameterList& interactions = result.sublist("Interactions");
  for (const auto& [name, entry] : entries(scene.sublist("Interactions"))) {
    if (!interactions.isSublist(name)) continue;
    for (const ObstacleEntry& obstacle : obstacles().entries()) {
      if (!obstacle.parameters.isParameter("File") || !interactions.sublist(name).isSublist(obstacle.name)) continue;
      Teuchos::ParameterList& own = interactions.sublist(name).sublist(obstacle.name);
      if (own.isType<std::string>("File")) own.set("File", path_beside(scene_folder, own.get<std::string>("File")));
      if (obstacle.parameters.isParameter("Metre") && !own.isParameter("Metre"))
        own.set("Metre", 1 / scene_units(scene).si("L0"));
    }
  }
  return result;
}

std::vector<double> obstacle_file_checksums(const Teuchos::ParameterList& scene) {
  std::vector<double> numbers;
  if (!scene.isSublist("Interactions")) return numbers;
  const Teuchos::ParameterList& interactions = scene.sublist("Interactions");
  for (const auto& [name, entry] : entries(interactions)) {
    const Teuchos::ParameterList& own = interactions.sublist(name);
    const auto obstacle = own.get<std::string>("Obstacle");
    if (!own.isSublist(obstacle) || !own.sublist(obstacle).isType<std::string>("File")) continue;
    const auto file = own.sublist(obstacle).get<std::string>("File");
    if (!is_file(file)) continue;
    const std::string bytes = read_whole_file(file);
    for (const std::uint64_t word : checksum(bytes.data(), bytes.size()))
      for (const std::uint64_t half : {word >> 32U, word & 0xffffffffU}) numbers.push_back(static_cast<double>(half));
  }
  return numbers;
}

}  // namespace ixos
