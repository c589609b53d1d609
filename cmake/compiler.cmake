# SPDX-License-Identifier: MIT
# hyrax_defaults(target): the language, the warnings and the hardening that all our targets share.
# Sanitizers and ccache are the only settings for whole directories. Include after project().

set(HYRAX_SANITIZE "" CACHE STRING "Sanitizers: \"address,undefined\", \"thread\" or empty")
set_property(CACHE HYRAX_SANITIZE PROPERTY STRINGS "" "address,undefined" "thread")

# Third parties get the sanitizers too: a container that only one side watches raises false alarms.
if(HYRAX_SANITIZE)
    add_compile_options(-fsanitize=${HYRAX_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${HYRAX_SANITIZE})
endif()

find_program(HYRAX_CCACHE ccache)
mark_as_advanced(HYRAX_CCACHE)
if(HYRAX_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_C_COMPILER_LAUNCHER "${HYRAX_CCACHE}")
    set(CMAKE_CXX_COMPILER_LAUNCHER "${HYRAX_CCACHE}")
endif()

# Without -Wnull-dereference: GCC 12 raises it falsely in fmt.
set(hyrax_gcc_warnings
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast -Wdouble-promotion
    -Wnon-virtual-dtor -Woverloaded-virtual -Wformat=2 -Wuseless-cast -Wduplicated-cond -Wlogical-op)
# Those of the above that clang has.
set(hyrax_clang_warnings
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wold-style-cast -Wdouble-promotion
    -Wnon-virtual-dtor -Woverloaded-virtual -Wformat=2)

function(hyrax_defaults target)
    # For those who include its headers as well, so that each header can be compiled alone.
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
        target_compile_features(${target} PRIVATE cxx_std_23)
    else()
        target_compile_features(${target} PUBLIC cxx_std_23)
    endif()
    set_target_properties(${target} PROPERTIES
        CXX_STANDARD 23
        CXX_STANDARD_REQUIRED ON
        CXX_EXTENSIONS OFF
        COMPILE_WARNING_AS_ERROR ON)

    if(MSVC) # untried
        target_compile_options(${target} PRIVATE /W4 /permissive- /utf-8 /fp:precise /Zc:__cplusplus)
    else()
        # A fused multiply-add rounds once where the document rounds twice: numbers would differ
        # between processors.
        target_compile_options(${target} PRIVATE -ffp-contract=off -fstack-protector-strong)
        target_compile_options(${target} PRIVATE
            "$<$<CXX_COMPILER_ID:GNU>:${hyrax_gcc_warnings}>"
            "$<$<CXX_COMPILER_ID:Clang>:${hyrax_clang_warnings}>")
        # With sanitizers GCC 12 takes the inside of a variant in a variant for uninitialised.
        if(HYRAX_SANITIZE)
            target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>")
        endif()
        # The macro needs optimisation, and the sanitizers bring better checks of their own.
        if(NOT HYRAX_SANITIZE)
            target_compile_options(${target} PRIVATE
                "$<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>")
        endif()
    endif()

    if(WIN32)
        target_compile_definitions(${target} PRIVATE
            UNICODE _UNICODE NOMINMAX WIN32_LEAN_AND_MEAN _WIN32_WINNT=0x0A00 WINVER=0x0A00)
    endif()
    if(MINGW)
        # The stack protector brings -lssp, which fortified code needs as well. Static: only system DLLs are imported. No time stamp: the same source gives the same file.
        # ld would otherwise claim Windows 5.2.
        target_link_options(${target} PRIVATE
            -static -fstack-protector-strong -Wl,--gc-sections -Wl,--tsaware -Wl,--no-insert-timestamp
            -Wl,--major-subsystem-version,10 -Wl,--minor-subsystem-version,0)
    endif()
endfunction()

# For code that is many templates and little work: a third smaller, and what 100 flying pets cost
# stays the same. The warning is false, as with sanitizers.
function(hyrax_prefer_small target)
    if(MINGW)
        target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-Os;-Wno-maybe-uninitialized>")
    endif()
endfunction()
