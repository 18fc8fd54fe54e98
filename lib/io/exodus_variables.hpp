/// Variables over time in an Exodus file. Included by lib/io only.
#pragma once
#include <string>

#include "io/exodus_definition.hpp"
#include "io/field_file.hpp"

namespace ixos {

/// Exodus refuses variables on nodes or cells where a file has none of: a rank may own no cells. Throws FileError.
void define_variables(const ExodusHandle& file, const FieldNames& names, bool has_cells);

struct ExodusSize {
  long long nodes;
  long long cells;
};

/// Throws InputError unless the file there is of that format, size and names, and has what is to be kept.
void require_frames(const std::string& path, ExodusFormat format, const ExodusSize& size, const FieldNames& names,
                    const FieldLength& keep);

/// The length of a file, 0 where it is not there.
double bytes_of(const std::string& path);

}  // namespace ixos
