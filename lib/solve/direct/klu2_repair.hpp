/// Repair of a miscompiled solver in the distribution's Trilinos 13.2.
#pragma once
#include <string>

namespace ixos {

/// Amesos2's KLU2, as Debian ships it, solves wrongly on two or more ranks: g++ 12.2 miscompiles its triangular solve.
/// klu2_repair.cpp instantiates the class anew, compiled with -fno-ivopts; its weak symbols come first in the link
/// order and replace the distribution's everywhere in the process, MueLu's coarse solver included, which comes with
/// ixos_solvers: that library names libixos before those of Trilinos. Calling this function keeps that object in the
/// link. Does nothing with later versions of Trilinos.
void anchor_klu2_repair();

/// Returns the file name of the library whose KLU2 this process uses: libixos if the repair is in force. Returns an
/// empty text if this version of Trilinos needs no repair.
std::string klu2_library();

}  // namespace ixos
