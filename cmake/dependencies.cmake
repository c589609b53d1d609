# SPDX-License-Identifier: MIT
# Targets for the third-party sources that dependencies.json pins: hyrax::lua, sol2, json, log,
# doctest, cli, minizip. All presets, mingw's included, see only the staged copies, never /usr/include.
# Include after project() and after compiler.cmake, whose sanitizer flags Lua must get, too.

set(HYRAX_THIRD_PARTY "${CMAKE_CURRENT_LIST_DIR}/../build/third_party" CACHE PATH
    "Where third-party sources are staged; shared by all presets")
get_filename_component(HYRAX_THIRD_PARTY "${HYRAX_THIRD_PARTY}" ABSOLUTE)

find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)

# A folder of the user's wins: cache variable here, environment variable in the script.
set(given)
foreach(name IN ITEMS lua sol2 nlohmann_json spdlog fmt doctest cli11 zlib)
    string(TOUPPER "HYRAX_${name}_DIR" variable)
    set(${variable} "" CACHE PATH "Folder with the sources of ${name} (empty: see dependencies.json)")
    mark_as_advanced(${variable})
    if(${variable})
        list(APPEND given --dir "${name}=${${variable}}")
    endif()
endforeach()

set(pins "${CMAKE_CURRENT_LIST_DIR}/dependencies.json")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${pins}")
# Checks hashes in 0.2 s and touches no network when everything is staged.
execute_process(
    COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_LIST_DIR}/fetch_dependencies.py"
            --quiet --stage "${HYRAX_THIRD_PARTY}" ${given}
    RESULT_VARIABLE fetch_result)
if(NOT fetch_result EQUAL 0)
    message(FATAL_ERROR "Third-party sources are missing (see above). `./dev build` installs what it needs.")
endif()

# A target for headers alone: hyrax::<alias> over build/third_party/<folder>/include.
function(hyrax_header_library alias folder)
    add_library(hyrax_dep_${alias} INTERFACE)
    add_library(hyrax::${alias} ALIAS hyrax_dep_${alias})
    target_include_directories(hyrax_dep_${alias} SYSTEM INTERFACE "${HYRAX_THIRD_PARTY}/${folder}/include")
endfunction()

hyrax_header_library(json nlohmann_json)
hyrax_header_library(doctest doctest)
hyrax_header_library(cli cli11)
hyrax_header_library(sol2 sol2)
hyrax_header_library(log spdlog)

# Lua is compiled as C++ everywhere: only so does its error, an exception then, run the destructors
# of the C++ frames it passes.
set(lua_folder "${HYRAX_THIRD_PARTY}/lua/src")
set(lua_units
    lapi lauxlib lbaselib lcode lcorolib lctype ldblib ldebug ldo ldump lfunc lgc linit liolib llex
    lmathlib lmem loadlib lobject lopcodes loslib lparser lstate lstring lstrlib ltable ltablib ltm
    lundump lutf8lib lvm lzio)
list(TRANSFORM lua_units PREPEND "${lua_folder}/")
list(TRANSFORM lua_units APPEND ".c" OUTPUT_VARIABLE lua_sources)
add_library(hyrax_lua STATIC ${lua_sources})
add_library(hyrax::lua ALIAS hyrax_lua)
set_source_files_properties(${lua_sources} PROPERTIES LANGUAGE CXX)
target_include_directories(hyrax_lua SYSTEM PUBLIC "${lua_folder}")
target_compile_features(hyrax_lua PRIVATE cxx_std_17)
# LUA_USE_LINUX stays undefined: no dlopen, no popen, no readline. On Windows Lua decides for itself
# (LUA_USE_WINDOWS); LUA_USE_C89 would shut LoadLibrary out, but makes lua_Integer a 32-bit long.
if(MINGW)
    # msvcrt's printf would write 1e+100 and nan in its own way.
    target_compile_definitions(hyrax_lua PRIVATE __USE_MINGW_ANSI_STDIO=1)
endif()
if(MSVC)
    target_compile_options(hyrax_lua PRIVATE /TP /W0) # untried
else()
    target_compile_options(hyrax_lua PRIVATE -w -ffp-contract=off -fstack-protector-strong)
    # Scripts have limits of processor time, which a debug build must not meet any earlier.
    target_compile_options(hyrax_lua PRIVATE $<$<CONFIG:Debug>:-O2>)
    # os.tmpname fails: it would use tmpnam, against which the linker warns, and no script may call it.
    target_compile_options(hyrax_lua PRIVATE -DLUA_TMPNAMBUFSIZE=1 "-Dlua_tmpnam(b,e)=((e)=1)")
    # `pairs` walks in the order of hashes: with a seed of its own, every run would take another
    # order. Colliding keys made on purpose cost their script its own time limit.
    target_compile_options(hyrax_lua PRIVATE "-Dluai_makeseed(L)=0x68797261u")
endif()

# What opens zip files: of zlib the half that inflates, and the reader that comes with it. Its names
# get a prefix, so that libpng on Linux goes on with the system's zlib.
set(zlib_folder "${HYRAX_THIRD_PARTY}/zlib/src")
set(zlib_units adler32 crc32 inffast inflate inftrees zutil contrib/minizip/ioapi contrib/minizip/unzip)
list(TRANSFORM zlib_units PREPEND "${zlib_folder}/")
list(TRANSFORM zlib_units APPEND ".c" OUTPUT_VARIABLE zlib_sources)
add_library(hyrax_minizip STATIC ${zlib_sources})
add_library(hyrax::minizip ALIAS hyrax_minizip)
target_include_directories(hyrax_minizip SYSTEM PUBLIC "${zlib_folder}" "${zlib_folder}/contrib")
target_compile_definitions(hyrax_minizip PUBLIC Z_PREFIX)
if(MSVC)
    target_compile_options(hyrax_minizip PRIVATE /W0) # untried
else()
    target_compile_options(hyrax_minizip PRIVATE -w -fstack-protector-strong)
endif()

target_compile_definitions(hyrax_dep_sol2 INTERFACE
    SOL_ALL_SAFETIES_ON=1 SOL_USING_CXX_LUA=1 SOL_PRINT_ERRORS=0)
target_link_libraries(hyrax_dep_sol2 INTERFACE hyrax::lua)

find_package(Threads REQUIRED)
target_include_directories(hyrax_dep_log SYSTEM INTERFACE "${HYRAX_THIRD_PARTY}/fmt/include")
target_compile_definitions(hyrax_dep_log INTERFACE SPDLOG_FMT_EXTERNAL FMT_HEADER_ONLY)
target_link_libraries(hyrax_dep_log INTERFACE Threads::Threads)
if(WIN32)
    # File names are std::filesystem::path::native() on both systems.
    target_compile_definitions(hyrax_dep_log INTERFACE SPDLOG_WCHAR_FILENAMES)
endif()
