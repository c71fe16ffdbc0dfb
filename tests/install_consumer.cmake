# Installs the build to a fresh prefix, builds tests/consumer against it as an outsider would, and runs it.
# Run: cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCXX=... -P tests/install_consumer.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "exit code ${code}: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/build/own_odemark run --quiet --methods my_ralston3,rk4 --problems my_logistic --dt 0.1,0.05 -o ${WORK}/out)
file(STRINGS ${WORK}/out/results.jsonl rows REGEX "\"my_logistic\".*\"my_ralston3\"")
if(NOT rows)
  message(FATAL_ERROR "no row of the own method on the own problem in ${WORK}/out/results.jsonl")
endif()

file(GLOB_RECURSE exports ${WORK}/prefix/*odemarkTargets*.cmake)
foreach(file ${exports})
  file(READ ${file} text)
  if(text MATCHES "-W(all|error|conversion)|odemark_warnings")
    message(FATAL_ERROR "${file} passes our warnings on to those who use us")
  endif()
endforeach()
