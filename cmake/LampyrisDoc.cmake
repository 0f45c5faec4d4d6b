# Target `doc`: the API reference, build/<preset>/doc/html/index.html. A comment that does not resolve fails it.
find_program(LAMPYRIS_DOXYGEN doxygen)
if(LAMPYRIS_DOXYGEN)
    configure_file(${CMAKE_SOURCE_DIR}/cmake/Doxyfile.in ${CMAKE_BINARY_DIR}/Doxyfile @ONLY)
    add_custom_target(doc COMMAND ${LAMPYRIS_DOXYGEN} ${CMAKE_BINARY_DIR}/Doxyfile
        WORKING_DIRECTORY ${CMAKE_SOURCE_DIR} COMMENT "API reference in ${CMAKE_BINARY_DIR}/doc/html" VERBATIM)
endif()
