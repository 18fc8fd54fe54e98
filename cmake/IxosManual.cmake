# Manual pages and bash completion: made by the build from the programs' own tables of options, and installed.
# The pages need help2man, and the page of ixos-plot needs matplotlib. The build leaves out what it cannot make.
find_program(IXOS_HELP2MAN help2man)
set(_manual ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${_manual}/man1 ${_manual}/completions)
# A build machine may have no remote shell, which MPI would miss.
set(_run ${CMAKE_COMMAND} -E env LC_ALL=C.UTF-8 OMPI_MCA_plm_rsh_agent=/bin/false
         PYTHONDONTWRITEBYTECODE=1 ASAN_OPTIONS=detect_leaks=0)

# ixos_manual_page(program path sentence [dependency])
function(ixos_manual_page program path sentence)
  set(page ${_manual}/man1/${program}.1)
  set(more ${PROJECT_SOURCE_DIR}/docs/man/${program}.h2m)
  add_custom_command(OUTPUT ${page}
    COMMAND ${_run} ${IXOS_HELP2MAN} --no-info --name=${sentence} --version-string=${PROJECT_VERSION}
            --source=Ixos --include=${more} --output=${page} ${path}
    DEPENDS ${more} ${ARGN} VERBATIM)
  set_property(GLOBAL APPEND PROPERTY IXOS_MANUAL ${page})
  install(FILES ${page} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL)
endfunction()

# ixos_completion(program target)
function(ixos_completion program target)
  set(script ${_manual}/completions/${program})
  add_custom_command(OUTPUT ${script} COMMAND ${_run} $<TARGET_FILE:${target}> --completion > ${script}
    DEPENDS ${target} VERBATIM)
  set_property(GLOBAL APPEND PROPERTY IXOS_MANUAL ${script})
  install(FILES ${script} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions OPTIONAL)
endfunction()

ixos_completion(ixos ixos_driver)
ixos_completion(ixos-study ixos_study)
install(FILES ${PROJECT_SOURCE_DIR}/drivers/plot/completion.bash RENAME ixos-plot
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
if(IXOS_HELP2MAN)
  ixos_manual_page(ixos $<TARGET_FILE:ixos_driver> "simulate dynamic adhesion" ixos_driver)
  ixos_manual_page(ixos-study $<TARGET_FILE:ixos_study> "measure what accuracy costs" ixos_study)
  execute_process(COMMAND ${_run} ${PROJECT_SOURCE_DIR}/drivers/plot/overview.py --help RESULT_VARIABLE _plot
                  OUTPUT_QUIET ERROR_QUIET)
  if(_plot EQUAL 0)
    ixos_manual_page(ixos-plot ${PROJECT_BINARY_DIR}/drivers/ixos-plot "draw the results of a run"
                     ${PROJECT_SOURCE_DIR}/drivers/plot/overview.py ${PROJECT_SOURCE_DIR}/drivers/plot/options.py)
  else()
    message(STATUS "No manual page of ixos-plot: it needs python3-matplotlib")
  endif()
else()
  message(STATUS "No manual pages: they need help2man")
endif()
get_property(_made GLOBAL PROPERTY IXOS_MANUAL)
add_custom_target(manual ALL DEPENDS ${_made})

# The documents as a site, on demand: cmake --build build/release --target site. Installed if it was made.
add_custom_target(site COMMAND ${PROJECT_SOURCE_DIR}/docs/site.sh ${PROJECT_BINARY_DIR}/site VERBATIM)
install(DIRECTORY ${PROJECT_BINARY_DIR}/site/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/html OPTIONAL
        PATTERN ".buildinfo" EXCLUDE)
