# Instruction sets by names that mean something on every processor, so that presets and packages name no others.
set(IXOS_ARCH "native" CACHE STRING
    "Instruction set: native (this machine's), baseline (every processor's of its kind), recent (most of today's), or a \
value of the compiler's -march")
set(IXOS_FASTER_ARCHS "" CACHE STRING
    "Further builds of the library, of which the loader takes the best one: all, recent (one level), or \
a list of levels (x86-64-v3;...)")

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(_baseline x86-64)
  set(_recent x86-64-v3)
  set(_all x86-64-v3 x86-64-v4)
else()  # the compiler's default; the loader knows no levels
  set(_baseline)
  set(_recent)
  set(_all)
endif()

# The builds read these two. Empty: no -march.
set(IXOS_MARCH ${IXOS_ARCH})
if(IXOS_ARCH MATCHES "^(baseline|recent)$")
  set(IXOS_MARCH ${_${IXOS_ARCH}})
endif()
set(IXOS_FASTER_MARCHS ${IXOS_FASTER_ARCHS})
if(IXOS_FASTER_ARCHS MATCHES "^(recent|all)$")
  set(IXOS_FASTER_MARCHS ${_${IXOS_FASTER_ARCHS}})
endif()
