# The game logs of tests/data/league are what their script writes.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${PYTHON} ${SOURCE}/write_game_logs.py ${WORK} COMMAND_ERROR_IS_FATAL ANY)
foreach(name game fields soccer)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/${name}.gamelog ${SOURCE}/${name}.gamelog
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
