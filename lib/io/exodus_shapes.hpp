/// Whether the variables of an Exodus file are as long as its header says. Included by lib/io only.
#pragma once
#include <exodusII.h>

#include <cstdint>
#include <string>

namespace ixos {

/// libexodus reads as many numbers as a variable has into an array of as many as its object's header has. Throws
/// InputError, with the path and the name, if the dimensions of a variable for ids, coordinates, sets or maps are not
/// those of its object. `most`: no more objects of a kind are looked at.
void check_exodus_shapes(int file, const std::string& path, const ex_init_params& header, int64_t most);

/// The same for the nodes of the cells in the first `blocks` blocks, whose types have been accepted.
void check_exodus_cells(int file, const std::string& path, int64_t blocks);

}  // namespace ixos
