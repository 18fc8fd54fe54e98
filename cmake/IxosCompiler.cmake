# Compiler launcher, linker, warnings, instruction set and sanitizers, as one interface target: ixos_options.
find_program(IXOS_CCACHE ccache)
if(IXOS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # The first two let it serve sources with a precompiled header: see ccache(1), "Precompiled headers". The third serves a
  # clean root with another language of messages.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,locale ${IXOS_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${IXOS_CCACHE})
endif()

# -g1 keeps line numbers for profiles and back traces and costs nearly nothing to compile.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g1 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -fno-omit-frame-pointer")

# Each version of a compiler warns of other things: those of Debian 12 must find nothing.
set(_reference OFF)
if("${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^(GNU 12|Clang 14)[.]")
  set(_reference ON)
endif()
option(IXOS_WARNINGS_AS_ERRORS "Treat warnings in our own code as errors" ${_reference})

add_library(ixos_options INTERFACE)
target_compile_options(ixos_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-psabi)
if(IXOS_WARNINGS_AS_ERRORS)
  target_compile_options(ixos_options INTERFACE -Werror)
endif()
# A target's property IXOS_MARCH goes before the variable of that name.
set(_march $<TARGET_PROPERTY:IXOS_MARCH>)
target_compile_options(ixos_options INTERFACE
  $<$<BOOL:${_march}>:-march=${_march}>
  $<$<AND:$<NOT:$<BOOL:${_march}>>,$<BOOL:${IXOS_MARCH}>>:-march=${IXOS_MARCH}>)
# Null and misaligned accesses fault by themselves, and sizes of objects are ASan's: half the time to compile.
set(IXOS_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-sanitize=null,alignment,object-size)
if(IXOS_SANITIZE)
  list(TRANSFORM IXOS_SANITIZERS REPLACE address,undefined ${IXOS_SANITIZE})
  target_compile_options(ixos_options INTERFACE ${IXOS_SANITIZERS})
  target_link_options(ixos_options INTERFACE ${IXOS_SANITIZERS})
endif()

# ixos_sanitize(target): a target under sanitizers in a build without. Another target has the same sources, so that tools
# which read the commands of a build are not told of this one.
function(ixos_sanitize target)
  target_compile_options(${target} PRIVATE ${IXOS_SANITIZERS})
  target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  target_link_options(${target} PRIVATE ${IXOS_SANITIZERS})
  set_target_properties(${target} PROPERTIES EXPORT_COMPILE_COMMANDS OFF)
endfunction()

find_program(IXOS_LLD ld.lld)
if(IXOS_LLD)
  target_link_options(ixos_options INTERFACE -fuse-ld=lld)
endif()

# ixos_precompile(target [headers...] | target REUSE_FROM other): g++ reads once, for all sources of the target, the headers
# of other projects that most of them include: a source includes them all the same, because other compilers, clang-tidy
# and structure.headers do without.
function(ixos_precompile target)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    return()
  endif()
  target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
  if("${ARGV1}" STREQUAL REUSE_FROM)
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    target_precompile_headers(${target} PRIVATE
      <algorithm> <array> <cmath> <experimental/simd> <functional> <limits> <map> <memory> <optional> <set> <stdexcept> <string>
      <utility> <vector> <fmt/format.h> <Teuchos_Array.hpp> <Teuchos_Comm.hpp> <Teuchos_ParameterList.hpp> ${ARGN})
  endif()
endfunction()
