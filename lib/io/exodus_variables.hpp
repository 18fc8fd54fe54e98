/// Variables over time in an Exodus file. Included by lib/io only.
#pragma once
#include <string>

#include "io/exodus_definition.hpp"
#include "io/field_file.hpp"

namespace ixos {

/// Defines the variables. Exodus refuses variables on nodes or cells if a file has none of them: a rank may own no
/// cells. Throws FileError.
void define_variables(const ExodusHandle& file, const FieldNames& names, bool has_cells);

struct ExodusSize {
  long long nodes;
  long long cells;
};

/// Throws InputError unless the existing file has that format, size and names, and at least the frames and bytes to
/// keep.
void require_frames(const std::string& path, ExodusFormat format, const ExodusSize& size, const FieldNames& names,
                    const FieldLength& keep);

/// Returns the length of a file, 0 if it does not exist.
double bytes_of(const std::string& path);

}  // namespace ixos
