# What `cmake --install` puts under a prefix: the program, its licence, for each folder of engine/ and modules/ a
# static library and its headers, and what find_package(lampyris) and pkg-config read. All of it may be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(LAMPYRIS_HEADERS ${CMAKE_INSTALL_INCLUDEDIR}/lampyris)  # where "photon_gi/renderer.h" is found
set(LAMPYRIS_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/lampyris)

# The target lampyris_NAME as lampyris::NAME, and the headers of FOLDER.
function(lampyris_install_folder NAME FOLDER)
    set_target_properties(lampyris_${NAME} PROPERTIES EXPORT_NAME ${NAME})
    install(TARGETS lampyris_${NAME} EXPORT lampyris)
    install(DIRECTORY ${FOLDER} DESTINATION ${LAMPYRIS_HEADERS} FILES_MATCHING PATTERN "*.h")
    get_target_property(type lampyris_${NAME} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
        set_property(GLOBAL APPEND PROPERTY LAMPYRIS_ARCHIVES ${NAME})
    endif()
endfunction()

# Called once, after all folders.
function(lampyris_install_package)
    install(EXPORT lampyris NAMESPACE lampyris:: FILE lampyris-targets.cmake DESTINATION ${LAMPYRIS_PACKAGE})
    configure_package_config_file(${CMAKE_SOURCE_DIR}/cmake/lampyris-config.cmake.in
        ${CMAKE_BINARY_DIR}/package/lampyris-config.cmake INSTALL_DESTINATION ${LAMPYRIS_PACKAGE})
    write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/lampyris-config-version.cmake
        COMPATIBILITY SameMinorVersion) # until 1.0 a minor version may break what was
    install(FILES ${CMAKE_BINARY_DIR}/package/lampyris-config.cmake
                  ${CMAKE_BINARY_DIR}/package/lampyris-config-version.cmake
                  ${CMAKE_SOURCE_DIR}/cmake/LampyrisLibraries.cmake DESTINATION ${LAMPYRIS_PACKAGE})

    # pkg-config: an archive stands before those that it needs, which were added earlier.
    get_property(archives GLOBAL PROPERTY LAMPYRIS_ARCHIVES)
    list(REVERSE archives)
    list(TRANSFORM archives PREPEND -llampyris_)
    list(JOIN archives " " LAMPYRIS_ARCHIVES)
    get_target_property(definitions lampyris_math INTERFACE_COMPILE_DEFINITIONS)
    list(TRANSFORM definitions PREPEND -D)
    list(JOIN definitions " " LAMPYRIS_DEFINITIONS)
    set(LAMPYRIS_REQUIRES "fmt glm nlohmann_json")
    set(LAMPYRIS_REQUIRES_PRIVATE "spdlog stb tinygltf")
    if(LAMPYRIS_VULKAN)
        string(APPEND LAMPYRIS_REQUIRES " vulkan")
        string(APPEND LAMPYRIS_REQUIRES_PRIVATE " glfw3 x11 imgui glslang spirv spirv-cross-c-shared")
        set(LAMPYRIS_LIBS_PRIVATE "-lglslang-default-resource-limits")
    endif()
    file(RELATIVE_PATH LAMPYRIS_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
    string(REGEX REPLACE "/$" "" LAMPYRIS_UP ${LAMPYRIS_UP})
    configure_file(${CMAKE_SOURCE_DIR}/cmake/lampyris.pc.in ${CMAKE_BINARY_DIR}/package/lampyris.pc @ONLY)
    install(FILES ${CMAKE_BINARY_DIR}/package/lampyris.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

    if(LAMPYRIS_VULKAN)
        install(TARGETS lampyris)
    endif()
    install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
