# cmake -D build=... -D config=... -D source=... -D work=... -D generator=... -D compiler=...
#       -D flags=... -P run.cmake
# Everything is made anew: a file that an earlier install left behind must not make this pass.
file(REMOVE_RECURSE ${work})

function(step)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

step(${CMAKE_COMMAND} --install ${build} --config ${config} --prefix ${work}/prefix)
# Moved: the package must not remember where it was installed.
file(RENAME ${work}/prefix ${work}/moved)
step(${CMAKE_COMMAND} -S ${source} -B ${work}/build -G ${generator}
  -D CMAKE_PREFIX_PATH=${work}/moved
  -D CMAKE_EXPORT_COMPILE_COMMANDS=ON
  -D CMAKE_BUILD_TYPE=${config}
  -D CMAKE_CXX_COMPILER=${compiler}
  -D CMAKE_CXX_FLAGS=${flags})
step(${CMAKE_COMMAND} --build ${work}/build --config ${config})
find_program(consumer consumer PATHS ${work}/build ${work}/build/${config} NO_DEFAULT_PATH REQUIRED)
find_program(mechanics consumer_mechanics PATHS ${work}/build ${work}/build/${config}
  NO_DEFAULT_PATH REQUIRED)
find_program(reference consumer_reference PATHS ${work}/build ${work}/build/${config}
  NO_DEFAULT_PATH REQUIRED)
step(${consumer})
step(${mechanics})
step(${reference})

# Flags that a header relies on must have reached the consumer.
file(READ ${work}/build/compile_commands.json commands)
string(FIND "${commands}" "-ffp-contract=off" found)
if(found EQUAL -1)
  message(FATAL_ERROR "-ffp-contract=off did not reach the consumer")
endif()
