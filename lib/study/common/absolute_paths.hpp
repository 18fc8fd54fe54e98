/// Scenes that stand elsewhere than their files.
#pragma once
#include <Teuchos_ParameterList.hpp>
#include <string>

namespace ixos {

/// Makes the paths of files beside the scene, which was read from `file`, absolute.
void make_paths_absolute(Teuchos::ParameterList& scene, const std::string& file);

}  // namespace ixos
