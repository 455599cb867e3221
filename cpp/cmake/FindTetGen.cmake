# TetGen 1.5 or 1.6, which installs neither a CMake nor a pkg-config file.
# Defines TetGen_FOUND, TetGen_VERSION and the target TetGen::TetGen.
find_path(TetGen_INCLUDE_DIR tetgen.h)
find_library(TetGen_LIBRARY NAMES tet tetgen)

# 1.5 and 1.6 differ in their option struct; the header names its version only in a comment.
if(TetGen_INCLUDE_DIR)
    file(STRINGS "${TetGen_INCLUDE_DIR}/tetgen.h" TetGen_VERSION_LINE REGEX "Version [0-9]+\\.[0-9]+" LIMIT_COUNT 1)
    string(REGEX MATCH "[0-9]+\\.[0-9]+" TetGen_VERSION "${TetGen_VERSION_LINE}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR
                                  VERSION_VAR TetGen_VERSION)
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)

if(TetGen_FOUND AND NOT TARGET TetGen::TetGen)
    add_library(TetGen::TetGen UNKNOWN IMPORTED)
    set_target_properties(TetGen::TetGen PROPERTIES
        IMPORTED_LOCATION "${TetGen_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${TetGen_INCLUDE_DIR}"
        INTERFACE_COMPILE_DEFINITIONS TETLIBRARY)
endif()
