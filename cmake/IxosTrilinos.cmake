# Trilinos as one interface target, ixos_trilinos. Tried: 13.2 and 16.1.
set(_components MueLu NOX Stratimikos Thyra ThyraTpetraAdapters Belos Ifpack2 Amesos2 Tpetra Sacado Teuchos)
# Without a version: Trilinos' own check accepts one major version only.
find_package(Trilinos REQUIRED COMPONENTS ${_components})
if(Trilinos_VERSION VERSION_LESS 13.2)
  message(FATAL_ERROR "Ixos needs Trilinos 13.2 or later; found ${Trilinos_VERSION}")
endif()
if(Trilinos_VERSION VERSION_GREATER_EQUAL 17)
  message(FATAL_ERROR "Ixos is written in C++17, and Trilinos ${Trilinos_VERSION} needs C++20: use Trilinos 13.2 to 16")
endif()
if(NOT Trilinos_BUILD_SHARED_LIBS)
  message(FATAL_ERROR "Ixos needs shared libraries of Trilinos: with static ones, libixos and libixos_solvers would each "
                      "have a Kokkos of their own")
endif()
find_file(IXOS_TPETRA_CONFIG TpetraCore_config.h HINTS ${Trilinos_INCLUDE_DIRS} REQUIRED)
file(STRINGS ${IXOS_TPETRA_CONFIG} _long REGEX "^#define HAVE_TPETRA_INST_INT_LONG_LONG")
if(NOT _long)
  message(FATAL_ERROR "Ixos needs a Trilinos with global numbers of type long long (Tpetra_INST_INT_LONG_LONG)")
endif()

file(STRINGS ${IXOS_TPETRA_CONFIG} _device REGEX "^#define HAVE_TPETRA_INST_(CUDA|HIP|SYCL)")
if(_device)
  message(FATAL_ERROR "Ixos works on the memory of the processor, and this Trilinos was built for a GPU")
endif()

add_library(ixos_trilinos INTERFACE)
target_link_options(ixos_trilinos INTERFACE LINKER:--as-needed)
# Includes of Trilinos are added here as SYSTEM: imported targets of 13.2 have none.
target_include_directories(ixos_trilinos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS})
if(Trilinos_VERSION VERSION_GREATER_EQUAL 14)
  # Not Trilinos::all_selected_libs: a program that uses Ixos may have asked for other components first.
  list(TRANSFORM _components APPEND ::all_libs OUTPUT_VARIABLE _libraries)
  target_link_libraries(ixos_trilinos INTERFACE ${_libraries})
  set(IXOS_TRILINOS_COMPONENTS COMPONENTS ${_components})  # for IxosConfig.cmake
else()
  set(IXOS_TRILINOS_COMPONENTS)  # all: a program can ask for those of 13.2 once only
  # The targets of these packages drag libraries that nothing here uses (PT-Scotch, Epetra, MUMPS): link the files of the
  # others, not the targets.
  set(_unused trilinos_zoltan trilinos_zoltan2 trilinos_isorropia trilinos_noxepetra trilinos_noxlapack
              trilinos_locaepetra trilinos_localapack trilinos_ModeLaplace)
  foreach(_library IN LISTS Trilinos_LIBRARIES)
    if(TARGET ${_library} AND NOT _library IN_LIST _unused)
      target_link_libraries(ixos_trilinos INTERFACE $<TARGET_FILE:${_library}>)
    endif()
  endforeach()
endif()
target_link_libraries(ixos_trilinos INTERFACE MPI::MPI_CXX LAPACK::LAPACK BLAS::BLAS)
