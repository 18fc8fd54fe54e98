# Copies the headers of lib as they are installed:
#   cmake -D FROM=lib -D TO=folder -P IxosHeaders.cmake
# lib/ixos/model.hpp becomes <ixos/model.hpp>; lib/mesh/mesh.hpp becomes <ixos/internal/mesh/mesh.hpp>. Includes of
# "mesh/mesh.hpp" become "ixos/internal/mesh/mesh.hpp": a program may have headers of the same names. Only the stable
# headers are copied, and what they include.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${TO})
file(GLOB headers RELATIVE ${FROM} ${FROM}/ixos/*.hpp)
set(copied ${headers})
while(headers)
  list(POP_FRONT headers header)
  # Their layout follows the instruction set that the library was built for.
  if(header MATCHES "element_batches.hpp$|point_data.hpp$")
    message(FATAL_ERROR "A stable header includes ${header}, which depends on the width of a pack")
  endif()
  file(READ ${FROM}/${header} text)
  string(REGEX MATCHALL "\n#include \"[^\"]+\"" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "\n#include \"([^\"]+)\"" "\\1" include "${include}")
    if(NOT include IN_LIST copied)
      list(APPEND copied ${include})
      list(APPEND headers ${include})
    endif()
  endforeach()
  string(REGEX REPLACE "(^|\n)#include \"" "\\1#include \"ixos/internal/" text "${text}")
  if(header MATCHES "^ixos/")
    file(WRITE ${TO}/${header} "${text}")
  else()
    file(WRITE ${TO}/ixos/internal/${header} "${text}")
  endif()
endwhile()
