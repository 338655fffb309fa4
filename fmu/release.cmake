# The toolchain of fmu/release.sh: clang of the PyPI package `ziglang`, which brings the headers and libraries of its
# targets along. fmu/release.sh sets DRAPE_PLATFORM, DRAPE_ZIG and DRAPE_TOOLS; the last holds the compiler's commands.
set(CMAKE_SYSTEM_PROCESSOR x86_64)
if(DRAPE_PLATFORM STREQUAL win64)
  set(CMAKE_SYSTEM_NAME Windows)
  set(DRAPE_TARGET x86_64-windows-gnu)
else()
  set(CMAKE_SYSTEM_NAME Linux)
  set(DRAPE_TARGET x86_64-linux-gnu.2.28)
endif()
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES DRAPE_PLATFORM DRAPE_ZIG DRAPE_TOOLS)

set(CMAKE_C_COMPILER ${DRAPE_TOOLS}/cc)
set(CMAKE_CXX_COMPILER ${DRAPE_TOOLS}/c++)
set(CMAKE_AR ${DRAPE_TOOLS}/ar CACHE FILEPATH "")
set(CMAKE_RANLIB ${DRAPE_TOOLS}/ranlib CACHE FILEPATH "")
set(CMAKE_RC_COMPILER ${DRAPE_TOOLS}/rc CACHE FILEPATH "")
set(CMAKE_C_COMPILER_TARGET ${DRAPE_TARGET})
set(CMAKE_CXX_COMPILER_TARGET ${DRAPE_TARGET})
# Its checks compile only: a program for them would need the C++ runtime built in one way more.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
# What CMake does not say by itself to a compiler for another machine.
set(CMAKE_C_FLAGS_INIT "-target ${DRAPE_TARGET}")
set(CMAKE_CXX_FLAGS_INIT "-target ${DRAPE_TARGET}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
