# find_package(tree): the targets tree::tree (shared) and tree::tree_static.
# This file lies in PREFIX/lib/cmake/tree.
get_filename_component(_tree_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

if(NOT TARGET tree::tree)
    add_library(tree::tree SHARED IMPORTED)
    set_target_properties(tree::tree PROPERTIES
        IMPORTED_LOCATION "${_tree_prefix}/lib/libtree_ffi${CMAKE_SHARED_LIBRARY_SUFFIX}"
        INTERFACE_INCLUDE_DIRECTORIES "${_tree_prefix}/include")
    if(NOT APPLE)
        set_target_properties(tree::tree PROPERTIES IMPORTED_SONAME libtree_ffi.so)
    endif()
    add_library(tree::tree_static STATIC IMPORTED)
    set_target_properties(tree::tree_static PROPERTIES
        IMPORTED_LOCATION "${_tree_prefix}/lib/libtree_ffi.a"
        INTERFACE_INCLUDE_DIRECTORIES "${_tree_prefix}/include")
    if(UNIX AND NOT APPLE)
        # What Rust's standard library needs.
        set_target_properties(tree::tree_static PROPERTIES
            INTERFACE_LINK_LIBRARIES "gcc_s;util;rt;pthread;m;dl;c")
    endif()
endif()
unset(_tree_prefix)
