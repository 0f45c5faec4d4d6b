# Outside libraries that come without a CMake package of their own, as targets lampyris::NAME; read by our
# build and by the installed package alike. LAMPYRIS_MISSING names those that are not there.
set(LAMPYRIS_MISSING)
foreach(name stb tinyexr)
    find_library(LAMPYRIS_${name} NAMES lib${name}.a ${name})
    mark_as_advanced(LAMPYRIS_${name})
    if(NOT LAMPYRIS_${name})
        list(APPEND LAMPYRIS_MISSING ${name})
    elseif(NOT TARGET lampyris::${name})
        add_library(lampyris::${name} UNKNOWN IMPORTED)
        set_target_properties(lampyris::${name} PROPERTIES IMPORTED_LOCATION ${LAMPYRIS_${name}})
    endif()
endforeach()
