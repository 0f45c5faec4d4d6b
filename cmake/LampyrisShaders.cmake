# lampyris_shaders(TARGET <target> MODULE <name> SHADERS <entry>…)
#   entry  deferred/gbuffer.vert                                       a file under shaders/
#          photon_trace_masked.comp:photons/photon_trace.comp:-DX=1    a variant: name, file, definitions
# Compiles every shader to SPIR-V and embeds it; the target gets "<name>/shaders.h", which declares
# lampyris::<name>::shaders::gbufferVert and the like, with the file and definitions each came from, so that
# engine/shader_reload can make it again. ROOT is where files lie, shaders/ if left out.
if(LAMPYRIS_VULKAN)
    find_program(LAMPYRIS_GLSLANG glslangValidator REQUIRED)
endif()

function(lampyris_shaders)
    cmake_parse_arguments(ARG "" "TARGET;MODULE;ROOT" "SHADERS" ${ARGN})
    if(NOT ARG_ROOT)
        set(ARG_ROOT ${CMAKE_SOURCE_DIR}/shaders)
    endif()
    set(folder ${CMAKE_BINARY_DIR}/generated/${ARG_MODULE})
    set(binaries)
    set(arguments)
    foreach(entry ${ARG_SHADERS})
        string(REGEX REPLACE "^NAME=" "" entry "${entry}")
        string(REPLACE ":" ";" parts "${entry}")
        list(POP_FRONT parts name)
        get_filename_component(name "${name}" NAME)
        set(file ${entry})
        if(parts)
            list(POP_FRONT parts file)
        endif()
        set(binary ${folder}/${name}.spv)
        add_custom_command(OUTPUT ${binary}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
            COMMAND ${LAMPYRIS_GLSLANG} --quiet -V --target-env vulkan1.3 -I${CMAKE_SOURCE_DIR}/shaders
                    ${parts} --depfile ${binary}.d -o ${binary} ${ARG_ROOT}/${file}
            DEPENDS ${ARG_ROOT}/${file} DEPFILE ${binary}.d
            COMMENT "Compiling shader ${ARG_MODULE}/${name}" VERBATIM)
        list(APPEND binaries ${binary})
        list(APPEND arguments ${ARG_MODULE}/${name}=${binary}=${file} ${parts})
    endforeach()
    add_custom_command(OUTPUT ${folder}/shaders.cpp ${folder}/shaders.h
        COMMAND lampyris_shader_embed ${ARG_MODULE} ${folder} ${arguments}
        DEPENDS ${binaries} lampyris_shader_embed
        COMMENT "Embedding shaders of ${ARG_MODULE}" VERBATIM)
    target_sources(${ARG_TARGET} PRIVATE ${folder}/shaders.cpp ${folder}/shaders.h)
    target_include_directories(${ARG_TARGET} PUBLIC $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/generated>)
    get_target_property(exported ${ARG_TARGET} EXPORT_NAME)
    if(exported)
        install(FILES ${folder}/shaders.h DESTINATION ${LAMPYRIS_HEADERS}/${ARG_MODULE})
    endif()
    target_link_libraries(${ARG_TARGET} PUBLIC lampyris::shaders_shared)
endfunction()
