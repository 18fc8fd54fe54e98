/// Answers of ixos that need no scene.
#pragma once

namespace ixos {

/// Prints the time integrators: properties, citation and parameters.
void print_schemes();

/// Prints version and build.
void print_version();

}  // namespace ixos
