# Installs the library, its headers, the driver and a package that find_package(Ixos) finds.
include(CMakePackageConfigHelpers)
install(TARGETS ixos ixos_trilinos EXPORT IxosTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS ixos_solvers LIBRARY NAMELINK_SKIP DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS ixos_driver ixos_study RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# docs/embedding.md describes which headers are stable.
set(_headers ${CMAKE_CURRENT_BINARY_DIR}/headers)
install(CODE "execute_process(COMMAND \${CMAKE_COMMAND} -D FROM=${CMAKE_CURRENT_SOURCE_DIR}/lib -D TO=${_headers}
  -P ${CMAKE_CURRENT_SOURCE_DIR}/cmake/IxosHeaders.cmake COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${_headers}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
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
# A program that compiles with one minor version compiles with later ones; the binary interface is that of the SOVERSION.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/IxosConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/IxosConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/IxosConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Ixos)
