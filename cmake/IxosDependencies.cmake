# Everything Ixos links against. Trilinos is one interface target, ixos_trilinos.
find_package(MPI REQUIRED COMPONENTS C CXX)
find_package(Trilinos 13.2 REQUIRED COMPONENTS MueLu NOX Stratimikos Thyra ThyraTpetraAdapters Belos Ifpack2 Amesos2
                                               Tpetra Kokkos Sacado Teuchos)
find_package(BLAS REQUIRED)
find_package(LAPACK REQUIRED)
find_package(CLI11 REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(EXPAT REQUIRED)
find_library(IXOS_METIS metis REQUIRED)
find_library(IXOS_MUPARSER muparser REQUIRED)
find_library(IXOS_EXODUS exoIIv2c REQUIRED)
# The netCDF that libexodus itself holds; a second one beside it would take its calls.
find_library(IXOS_NETCDF NAMES netcdf_mpi libnetcdf_mpi.so.19 REQUIRED)
find_path(IXOS_EXODUS_INCLUDE exodusII.h REQUIRED)
find_library(IXOS_XXHASH xxhash REQUIRED)
# Headers only, in a system directory.
find_path(IXOS_BOOST_INCLUDE boost/multiprecision/cpp_int.hpp REQUIRED)
find_path(IXOS_BOOST_GRAPH_INCLUDE boost/graph/cuthill_mckee_ordering.hpp REQUIRED)
# The one that Exodus is built with: two HDF5 libraries in one program clash.
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 REQUIRED COMPONENTS C HL)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "Ixos needs the parallel HDF5 (libhdf5-openmpi-dev)")
endif()
option(IXOS_CHOLMOD "Link CHOLMOD, whose supernodal part is under the GPL (docs/licences.md)" ON)
if(IXOS_CHOLMOD)
  find_library(IXOS_CHOLMOD_LIBRARY cholmod REQUIRED)
endif()
find_library(IXOS_KLU klu REQUIRED)
find_library(IXOS_DMUMPS dmumps REQUIRED)
find_library(IXOS_SMUMPS smumps REQUIRED)
set(IXOS_MUMPS ${IXOS_DMUMPS} ${IXOS_SMUMPS})
find_path(IXOS_SUITESPARSE_INCLUDE klu.h PATH_SUFFIXES suitesparse REQUIRED)

add_library(ixos_trilinos INTERFACE)
# The distribution's imported targets carry no include directories: they are added here, as SYSTEM.
target_include_directories(ixos_trilinos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS})
# The targets of these packages drag libraries that nothing here uses (PT-Scotch, Epetra, MUMPS): link the files of the
# others, not the targets.
set(_unused trilinos_zoltan trilinos_zoltan2 trilinos_isorropia trilinos_noxepetra trilinos_noxlapack
            trilinos_locaepetra trilinos_localapack trilinos_ModeLaplace)
foreach(_library IN LISTS Trilinos_LIBRARIES)
  if(TARGET ${_library} AND NOT _library IN_LIST _unused)
    target_link_libraries(ixos_trilinos INTERFACE $<TARGET_FILE:${_library}>)
  endif()
endforeach()
target_link_options(ixos_trilinos INTERFACE LINKER:--as-needed)
target_link_libraries(ixos_trilinos INTERFACE MPI::MPI_CXX LAPACK::LAPACK BLAS::BLAS)
