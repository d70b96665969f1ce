# Flags of every target of the project, and the stricter ones of kernels.

include(CheckCXXCompilerFlag)
include(CheckLinkerFlag)

add_library(murosimf_options INTERFACE)
target_compile_options(murosimf_options INTERFACE
  -Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:${MUROSIMF_UNITY}>>:-Wshadow> -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-qual -Wno-psabi
  -Wno-missing-field-initializers
  # products and sums are never fused: the same source gives the same bits on every processor
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 makes fused multiply-adds of neighboring sums and differences for all that (vfmaddsub), where it has that instruction
  target_compile_options(murosimf_options INTERFACE -fno-tree-slp-vectorize)
  # g++ 12 sees overlapping copies in the concatenation of std::string where there are none (GCC bug 105651)
  target_compile_options(murosimf_options INTERFACE -Wno-restrict)
  if(CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
    # it takes every reference that a call with temporary arguments returns for one of them (GCC bug 107532)
    target_compile_options(murosimf_options INTERFACE -Wno-dangling-reference)
  endif()
  if(MUROSIMF_UNITY)
    # collects garbage less often: 6 % less processor time for a fifth to a third more memory, at most 1 GB for one compiler
    target_compile_options(murosimf_options INTERFACE --param=ggc-min-expand=1000)
  endif()
  if(MUROSIMF_PRECOMPILE)
    # and more of that kind where the headers of the library come out of a precompiled one, so are no system headers
    target_compile_options(murosimf_options INTERFACE -Wno-stringop-overflow -Wno-array-bounds)
    # g++ 13 and newer take no precompiled header from another -O, because these two differ: set, they are as with -O2 and -O3
    check_cxx_compiler_flag(-munroll-only-small-loops MUROSIMF_HAS_UNROLL_ONLY_SMALL_LOOPS)
    if(MUROSIMF_HAS_UNROLL_ONLY_SMALL_LOOPS)
      target_compile_options(murosimf_options INTERFACE -munroll-only-small-loops -mvzeroupper)
    endif()
  endif()
endif()
if(MUROSIMF_ASSERTIONS)
  target_compile_definitions(murosimf_options INTERFACE MUROSIMF_ASSERTIONS)
endif()
if(MUROSIMF_FUZZ)
  target_compile_definitions(murosimf_options INTERFACE MUROSIMF_FUZZED)
endif()
# Sanitizers under the same names with every compiler, for code that depends on them.
if(CMAKE_CXX_FLAGS MATCHES "fsanitize=address")
  target_compile_definitions(murosimf_options INTERFACE MUROSIMF_ADDRESS_SANITIZER)
elseif(CMAKE_CXX_FLAGS MATCHES "fsanitize=thread")
  target_compile_definitions(murosimf_options INTERFACE MUROSIMF_THREAD_SANITIZER)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" AND CMAKE_CXX_FLAGS MATCHES "fsanitize=address" AND NOT MUROSIMF_FUZZ)
  # the sanitizer in a library of its own, as with g++: in the program it would stand before functions that control_software/guard watches
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libclang_rt.asan-${CMAKE_SYSTEM_PROCESSOR}.so
    OUTPUT_VARIABLE sanitizer_library OUTPUT_STRIP_TRAILING_WHITESPACE)
  cmake_path(GET sanitizer_library PARENT_PATH sanitizer_folder)
  add_link_options($<$<LINK_LANGUAGE:CXX>:-shared-libsan> LINKER:-rpath,${sanitizer_folder})
  check_linker_flag(CXX -fuse-ld=lld MUROSIMF_HAS_LLD)  # links sanitized programs in a fifth of the time
  if(MUROSIMF_HAS_LLD)
    add_link_options($<$<LINK_LANGUAGE:CXX>:-fuse-ld=lld>)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  # std::stable_sort of libstdc++ 12 calls what C++17 deprecates, and clang says so where it is called
  target_compile_options(murosimf_options INTERFACE -Wno-deprecated-declarations)
endif()
if(MUROSIMF_WARNINGS_AS_ERRORS)
  target_compile_options(murosimf_options INTERFACE -Werror)
endif()
# Eigen adds in an order that depends on the width of the registers: without it sums have the same bits on every processor
target_compile_definitions(murosimf_options INTERFACE EIGEN_DONT_VECTORIZE)
# as TinyXML-2 of Ubuntu 24.04 wants it of who uses it: a precompiled header is for one set of definitions
target_compile_definitions(murosimf_options INTERFACE _FILE_OFFSET_BITS=64)
if(MUROSIMF_NATIVE)
  target_compile_options(murosimf_options INTERFACE -march=native)
endif()

# murosimf_kernel_flags(<target>): full optimization, and with g++ no vectorizer: kernels bring their own lanes.
function(murosimf_kernel_flags target)
  target_compile_options(${target} PRIVATE -ffp-contract=off $<$<CONFIG:Release>:-O3>
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-vectorize>)
endfunction()
