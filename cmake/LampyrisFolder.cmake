# One folder, one target: lampyris_folder(NAME ROOM engine|modules SOURCES … FOLDERS … LIBRARIES …)
#   FOLDERS    folders of ours behind the arrow in the house's list; linked PUBLIC
#   LIBRARIES  outside libraries, PRIVATE;  PUBLIC_LIBRARIES  those that a header needs
find_program(LAMPYRIS_CCACHE ccache)
if(LAMPYRIS_CCACHE)
    # Paths below the source folder count as relative: a second clone finds what the first one built.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${LAMPYRIS_CCACHE})
endif()
find_package(Threads REQUIRED)

if(LAMPYRIS_SANITIZE)
    add_compile_options(-fsanitize=${LAMPYRIS_SANITIZE} -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${LAMPYRIS_SANITIZE})
endif()

add_library(lampyris_options INTERFACE)
target_compile_options(lampyris_options INTERFACE -Wall -Wextra -Wpedantic -Werror)
if(LAMPYRIS_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(lampyris_options INTERFACE -Wno-maybe-uninitialized) # GCC: false alarms beside sanitizers
endif()

function(lampyris_folder NAME)
    cmake_parse_arguments(ARG "" "ROOM" "SOURCES;FOLDERS;LIBRARIES;PUBLIC_LIBRARIES" ${ARGN})
    set(target lampyris_${NAME})
    if(ARG_SOURCES)
        add_library(${target} STATIC ${ARG_SOURCES})
        set(visibility PUBLIC)
        target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:lampyris_options> ${ARG_LIBRARIES})
    else()
        add_library(${target} INTERFACE)
        set(visibility INTERFACE)
    endif()
    add_library(lampyris::${NAME} ALIAS ${target})
    target_include_directories(${target} ${visibility}
        $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/${ARG_ROOM}> $<INSTALL_INTERFACE:${LAMPYRIS_HEADERS}>)
    target_compile_features(${target} ${visibility} cxx_std_20)
    foreach(folder ${ARG_FOLDERS})
        target_link_libraries(${target} ${visibility} lampyris::${folder})
    endforeach()
    if(ARG_PUBLIC_LIBRARIES)
        target_link_libraries(${target} ${visibility} ${ARG_PUBLIC_LIBRARIES})
    endif()
    if(NOT ARG_ROOM STREQUAL sandbox)
        lampyris_install_folder(${NAME} ${CMAKE_CURRENT_SOURCE_DIR})
    endif()
endfunction()
