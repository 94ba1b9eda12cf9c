# Warnings are errors, for our own code only (system headers are included as SYSTEM).
add_compile_options(-Wall -Wextra -Wpedantic -Werror -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wunused)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports overlaps, overreads and unset members of std::string and std::optional that cannot happen
  # (PR105651, PR105329, PR105593).
  add_compile_options(-Wno-restrict -Wno-stringop-overread -Wno-array-bounds -Wno-stringop-overflow
                      -Wno-maybe-uninitialized)
endif()
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-Wno-subobject-linkage)  # meant for headers, but a unity build includes .cpp files as well
elseif(CMAKE_UNITY_BUILD)
  add_compile_options(-Wno-shadow)  # names of other .cpp files in the same batch; the preset `dev` still warns
endif()
# What asserts print names no folder of the machine that built it, and a checkout elsewhere finds its objects in the cache.
add_compile_options(-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
# Keeps results the same, bit for bit: the optimiser must not choose whether to fuse multiplications and additions.
add_compile_options(-ffp-contract=off)
# All builds target one x86-64 level, so that a log gives the same bits on one kind of CPU.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  add_compile_options(-march=x86-64-v2)
endif()
if(PELAGE_SANITIZE)
  add_compile_options(-fsanitize=${PELAGE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${PELAGE_SANITIZE})
endif()
