/// Whether the variables of an Exodus file are as long as its header says. Included by lib/io only.
#pragma once
#include <exodusII.h>

#include <cstdint>

#include "io/exodus_handle.hpp"

namespace ixos {

/// libexodus reads as many numbers as a variable has into an array of as many as its object's header has. Throws
/// InputError, with the path and the name, if the dimensions of a variable for ids, coordinates, sets or maps are not
/// those of its object. `most`: no more objects of a kind are looked at.
void check_exodus_shapes(const ExodusHandle& file, const ex_init_params& header, int64_t most);

/// Throws the same if the table of a block's cells and nodes does not have the block's dimensions. Checks as many
/// blocks as `blocks` says. Called once their types are accepted: blocks of polyhedra have other tables.
void check_exodus_cells(const ExodusHandle& file, int64_t blocks);

}  // namespace ixos
