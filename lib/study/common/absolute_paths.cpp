#include "study/common/absolute_paths.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "parameters/parameter_entries.hpp"

namespace ixos {

void make_paths_absolute(Teuchos::ParameterList& scene, const std::string& file) {
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& [name, entry] : entries(scene)) {
    if (entry.isList())
      make_paths_absolute(scene.sublist(name), file);
    else if (name == "File" && entry.isType<std::string>())
      found.emplace_back(name, scene.get<std::string>(name));
  }
  for (const auto& [name, value] : found) {
    const std::filesystem::path beside = std::filesystem::path(file).parent_path() / value;
    if (!value.empty() && std::filesystem::exists(beside))
      scene.set(name, std::filesystem::absolute(beside).lexically_normal().string());
  }
}

}  // namespace ixos
