# Installs the library, its headers, the driver and a package that find_package(Ixos) finds.
include(CMakePackageConfigHelpers)
install(TARGETS ixos ixos_trilinos EXPORT IxosTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS ixos_driver ixos_study RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY lib/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ixos FILES_MATCHING PATTERN "*.hpp"
        # Its layout follows the instruction set that the library was built for.
        PATTERN "element_batches.hpp" EXCLUDE)
install(DIRECTORY drivers/plot DESTINATION ${CMAKE_INSTALL_DATADIR}/ixos USE_SOURCE_PERMISSIONS
        PATTERN "__pycache__" EXCLUDE PATTERN "completion.bash" EXCLUDE)
# A script in its folder, called by a name on the path.
install(CODE "file(CREATE_LINK ../${CMAKE_INSTALL_DATADIR}/ixos/plot/overview.py
  \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/ixos-plot\" SYMBOLIC)")
install(DIRECTORY xml DESTINATION ${CMAKE_INSTALL_DATADIR}/ixos)
install(DIRECTORY docs/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/ixos PATTERN "__pycache__" EXCLUDE)
install(EXPORT IxosTargets NAMESPACE Ixos:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Ixos)
configure_package_config_file(cmake/IxosConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/IxosConfig.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Ixos)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/IxosConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/IxosConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/IxosConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Ixos)
