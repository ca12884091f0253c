# All figures of a folder on one picture, three in a row, by gnuplot, which draws them too:
#
#   cmake -D FROM=results -D INTO=contact_sheet.png -P cmake/contact_sheet.cmake
#
# `cmake --build build/release --target contact_sheet` does that; -D GREY=ON shows them as a printer
# without colours would.
foreach(name FROM INTO)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "${name} is not set; usage: see ${CMAKE_CURRENT_LIST_FILE}")
  endif()
endforeach()
find_program(gnuplot gnuplot)
if(NOT gnuplot)
  message(FATAL_ERROR "gnuplot is not installed (Debian: gnuplot-nox): no contact sheet")
endif()

file(GLOB figures ${FROM}/*.png)
list(LENGTH figures count)
if(count EQUAL 0)
  message(FATAL_ERROR "no figure (*.png) in ${FROM}")
endif()
math(EXPR rows "(${count} + 2) / 3")
math(EXPR height "${rows} * 480")
if(GREY)
  set(light "(0.299*$1+0.587*$2+0.114*$3)")
  set(colours "using ${light}:${light}:${light}")
endif()
function(quoted path)
  string(REPLACE "'" "''" path "${path}")
  set(quoted "'${path}'" PARENT_SCOPE)
endfunction()

quoted("${INTO}")
set(script "set terminal pngcairo size 1920,${height} font 'sans,11'
set output ${quoted}
unset border
unset tics
unset key
set size ratio -1
set multiplot layout ${rows},3 margins 0.005,0.995,0.005,0.995 spacing 0.01,0.012
")
foreach(figure IN LISTS figures)
  quoted("${figure}")
  string(APPEND script "plot ${quoted} binary filetype=png ${colours} with rgbimage\n")
endforeach()
string(APPEND script "unset multiplot\n")
set(file "${INTO}.gp")
file(WRITE "${file}" "${script}")
execute_process(COMMAND ${gnuplot} -d "${file}" RESULT_VARIABLE code ERROR_VARIABLE message)
file(REMOVE "${file}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "gnuplot: ${message}")
endif()
message(STATUS "${count} figures: ${INTO}")
