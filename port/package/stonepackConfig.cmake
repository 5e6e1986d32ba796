# What `make install` puts beside the library, found from where it lies: stonepack::stonepack.
get_filename_component(_stonepack_root "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET stonepack::stonepack)
    add_library(stonepack::stonepack STATIC IMPORTED)
    set_target_properties(stonepack::stonepack PROPERTIES IMPORTED_LOCATION "${_stonepack_root}/lib/libstonepack.a"
        INTERFACE_INCLUDE_DIRECTORIES "${_stonepack_root}/include" INTERFACE_LINK_LIBRARIES m)
endif()
set(stonepack_VERSION @VERSION@)
