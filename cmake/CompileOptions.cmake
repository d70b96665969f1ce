# Flags of every target of the project, and the stricter ones of kernels.

add_library(murosimf_options INTERFACE)
target_compile_options(murosimf_options INTERFACE
  -Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:${MUROSIMF_UNITY}>>:-Wshadow> -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wno-psabi
  -Wno-missing-field-initializers
  # products and sums are never fused: the same source gives the same bits on every processor
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 sees overlapping copies in the concatenation of std::string where there are none (GCC bug 105651)
  target_compile_options(murosimf_options INTERFACE -Wno-restrict)
  if(MUROSIMF_PRECOMPILE)
    # and more of that kind where the headers of the library come out of a precompiled one, so are no system headers
    target_compile_options(murosimf_options INTERFACE -Wno-stringop-overflow -Wno-array-bounds)
  endif()
endif()
if(MUROSIMF_WARNINGS_AS_ERRORS)
  target_compile_options(murosimf_options INTERFACE -Werror)
endif()
if(MUROSIMF_NATIVE)
  target_compile_options(murosimf_options INTERFACE -march=native)
endif()

# Kernels (murosimf/multibody) step one robot or eight at once and must give the same bits either way: full
# optimization, and with g++ no vectorizer, which changes last bits.
function(murosimf_kernel_flags)
  set(flags -ffp-contract=off)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    list(APPEND flags -O3)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(APPEND flags -fno-tree-vectorize)
  endif()
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "${flags}")
endfunction()
