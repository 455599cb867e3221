# Settings that every target of the project shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

# All of the project's sources are compiled with these; third-party headers are SYSTEM and stay silent.
function(nmgs_target_settings target)
    if(MSVC)
        target_compile_options(${target} PRIVATE /W4 $<$<BOOL:${NMGS_WERROR}>:/WX>)
    else()
        # No contraction to fused multiply-add: the same input gives the same bytes on every machine.
        # GCC 12 sees overlaps in std::string's operator+ that are not there (its bug 105329); GCC 16
        # members of structs that are not initialized, in LEMON's headers and of our own, that are.
        target_compile_options(${target} PRIVATE -Wall -Wextra -ffp-contract=off
                                                 $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
                                                 $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,16>>:-Wno-maybe-uninitialized>
                                                 $<$<BOOL:${NMGS_WERROR}>:-Werror>)
        if(NMGS_SANITIZE)
            target_compile_options(${target} PRIVATE -fsanitize=address,undefined
                                                     -fno-sanitize-recover=all -fno-omit-frame-pointer)
            target_link_options(${target} PRIVATE -fsanitize=address,undefined)
        endif()
    endif()
endfunction()
