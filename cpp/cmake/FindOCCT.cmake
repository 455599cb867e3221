# OpenCASCADE 7.6 to 7.9 by its libraries: OpenCASCADE's own CMake package asks for
# development packages (TBB, fontconfig) that nothing here uses.
# Defines OCCT_FOUND, OCCT_VERSION and the target OCCT::OCCT.
find_path(OCCT_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade occt)

if(OCCT_INCLUDE_DIR)
    foreach(part MAJOR MINOR MAINTENANCE)
        file(STRINGS "${OCCT_INCLUDE_DIR}/Standard_Version.hxx" line
             REGEX "#define[ \t]+OCC_VERSION_${part}[ \t]+[0-9]+")
        string(REGEX MATCH "[0-9]+$" OCCT_${part} "${line}")
    endforeach()
    set(OCCT_VERSION "${OCCT_MAJOR}.${OCCT_MINOR}.${OCCT_MAINTENANCE}")
endif()

set(OCCT_LIBRARIES "")
set(OCCT_MISSING "")
foreach(name TKernel TKMath TKG2d TKG3d TKGeomBase TKBRep TKGeomAlgo TKTopAlgo TKPrim TKBO TKShHealing TKMesh TKBool TKOffset TKFillet TKBin TKBinL TKCDF TKLCAF)
    find_library(OCCT_${name}_LIBRARY ${name})
    mark_as_advanced(OCCT_${name}_LIBRARY)
    if(OCCT_${name}_LIBRARY)
        list(APPEND OCCT_LIBRARIES "${OCCT_${name}_LIBRARY}")
    elseif(NOT name MATCHES "TKBin|TKBinL|TKCDF|TKLCAF")
        list(APPEND OCCT_MISSING ${name})
    endif()
endforeach()

include(FindPackageHandleStandardArgs)
if(OCCT_MISSING)
    set(OCCT_FAILURE "missing libraries: ${OCCT_MISSING}")
    set(OCCT_COMPLETE FALSE)
else()
    set(OCCT_COMPLETE TRUE)
endif()
find_package_handle_standard_args(OCCT REQUIRED_VARS OCCT_INCLUDE_DIR OCCT_COMPLETE
                                  VERSION_VAR OCCT_VERSION REASON_FAILURE_MESSAGE "${OCCT_FAILURE}")

if(OCCT_FOUND AND NOT TARGET OCCT::OCCT)
    add_library(OCCT::OCCT INTERFACE IMPORTED)
    set_target_properties(OCCT::OCCT PROPERTIES
        INTERFACE_INCLUDE_DIRECTORIES "${OCCT_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES "${OCCT_LIBRARIES}")
endif()
