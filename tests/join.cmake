# cmake -D OUTPUT=<file> -D SOURCES=<files> -P join.cmake: writes several sources of tests as one, so that the compiler reads
# and instantiates what they share once. Every anonymous namespace gets one more inside, with the name of its file: files may
# have parallel_for of the same name, as they do alone. Messages of compiler and tests name the file itself.
set(joined "")
foreach(source IN LISTS SOURCES)
  get_filename_component(name "${source}" NAME_WE)
  file(READ "${source}" text)
  string(REPLACE "\nnamespace {\n" "\nnamespace { namespace ${name} {\n" text "${text}")
  string(REPLACE "\n}  // namespace\n" "\n}}  // namespace\n" text "${text}")
  string(APPEND joined "#line 1 \"${source}\"\n${text}")
endforeach()
file(WRITE "${OUTPUT}" "${joined}")
