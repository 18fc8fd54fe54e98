# Copies the headers of lib as they are installed:
#   cmake -D FROM=lib -D TO=folder -P IxosHeaders.cmake
# lib/ixos/model.hpp becomes <ixos/model.hpp>; lib/mesh/mesh.hpp becomes <ixos/internal/mesh/mesh.hpp>. Includes of
# "mesh/mesh.hpp" become "ixos/internal/mesh/mesh.hpp": a program may have headers of the same names.
file(REMOVE_RECURSE ${TO})
file(GLOB_RECURSE headers RELATIVE ${FROM} ${FROM}/*.hpp)
# Its layout follows the instruction set that the library was built for.
list(FILTER headers EXCLUDE REGEX "element_batches.hpp$")
foreach(header IN LISTS headers)
  file(READ ${FROM}/${header} text)
  string(REGEX REPLACE "(^|\n)#include \"" "\\1#include \"ixos/internal/" text "${text}")
  if(header MATCHES "^ixos/")
    file(WRITE ${TO}/${header} "${text}")
  else()
    file(WRITE ${TO}/ixos/internal/${header} "${text}")
  endif()
endforeach()
