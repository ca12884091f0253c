# The tables of every case, made with the C library's fused multiply-adds and without them, are the same
# bytes: none of its elementary functions reaches a table. `probe` calls those functions themselves; where
# it says the same with and without, nothing can be told.
set(without ${CMAKE_COMMAND} -E env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA)
execute_process(COMMAND ${probe} OUTPUT_VARIABLE fused COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${without} ${probe} OUTPUT_VARIABLE plain COMMAND_ERROR_IS_FATAL ANY)
if(fused STREQUAL plain)
  message("skipped: this C library rounds alike with and without GLIBC_TUNABLES")
  return()
endif()

file(REMOVE_RECURSE ${work})
foreach(run fused plain)
  set(how "")
  if(run STREQUAL "plain")
    set(how ${without})
  endif()
  execute_process(
    COMMAND ${how} ${CMAKE_COMMAND} -D PROGRAM=${program} -D INTO=${work}/${run} -D TABLES_ONLY=ON -P cmake/results.cmake
    WORKING_DIRECTORY ${source} OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB tables RELATIVE ${work}/fused ${work}/fused/*)
list(LENGTH tables count)
if(count LESS 40)
  message(FATAL_ERROR "only ${count} tables")
endif()
set(other "")
foreach(table IN LISTS tables)
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${work}/fused/${table} ${work}/plain/${table}
    RESULT_VARIABLE differ OUTPUT_QUIET ERROR_QUIET)
  if(differ)
    list(APPEND other ${table})
  endif()
endforeach()
if(other)
  message(FATAL_ERROR "other bytes without the C library's fused multiply-adds: ${other}")
endif()
