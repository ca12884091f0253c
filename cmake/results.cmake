# What results/ holds, made from every case in cases/: the bifurcation table and its figure where the
# case says over which range, else the table of its one solution (without rows where there is none),
# with the figure of its map where it has one. Beside each table stand its metadata, without what depends
# on the run: with them the figure is drawn again as it is.
# From the project's directory, so that the metadata name files relative to it:
#
#   cmake -D PROGRAM=build/release/solver/cli/stationary -D INTO=results -P cmake/results.cmake
#
# `cmake --build build/release --target results` does that; the target contact_sheet shows all figures on
# one picture. With -D TABLES_ONLY=ON no figures and no pages are made: what is left needs neither gnuplot
# nor HDF5. PROGRAM may be a list, an emulator before the program.
foreach(name PROGRAM INTO)
  if(NOT DEFINED ${name})
    message(FATAL_ERROR "${name} is not set; usage: see ${CMAKE_CURRENT_LIST_FILE}")
  endif()
endforeach()

function(run_program)
  execute_process(COMMAND ${PROGRAM} ${ARGV} RESULT_VARIABLE code ERROR_VARIABLE message)
  set(code ${code} PARENT_SCOPE)
  if(NOT code EQUAL 0 AND NOT code EQUAL 3) # 3: there is no solution, as a case may show
    message(FATAL_ERROR "${ARGV}: exit code ${code}\n${message}")
  endif()
endfunction()

# The figures of a table, NAME.svg and NAME.png.
function(plot_table table name)
  if(TABLES_ONLY)
    return()
  endif()
  foreach(format svg png)
    run_program(plot ${table} ${ARGN} -o ${INTO}/${name}.${format} --quiet)
  endforeach()
endfunction()

# A table's metadata without the key `run`, whose lines are no others' business and differ each time.
function(keep_metadata table)
  set(path ${INTO}/${table}.meta.json)
  if(NOT EXISTS ${path})
    return()
  endif()
  file(READ ${path} text)
  string(REGEX REPLACE "\n  \"run\": {(\n    [^\n]*)*\n  }," "" kept "${text}")
  if(kept STREQUAL text)
    message(FATAL_ERROR "${path} has no key `run`")
  endif()
  file(WRITE ${path} "${kept}")
endfunction()

file(MAKE_DIRECTORY ${INTO})
file(GLOB old ${INTO}/*.csv ${INTO}/*.meta.json ${INTO}/*.svg ${INTO}/*.png ${INTO}/*.html)
list(FILTER old EXCLUDE REGEX "/(work_precision\\.|completeness\\.|event_curves\\.|stress|explorer\\.|riemann\\.|spin_eccentricity\\.)[^/]*$") # of targets of their own
if(old)
  file(REMOVE ${old})
endif()
file(GLOB cases RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} cases/*.toml)
foreach(case IN LISTS cases)
  get_filename_component(name ${case} NAME_WE)
  file(STRINGS ${case} continued REGEX "^\\[continuation\\]")
  if(continued)
    run_program(continue ${case} -o ${INTO}/${name}.csv --quiet)
    if(code EQUAL 0)
      plot_table(${INTO}/${name}.csv ${name})
    endif()
  else()
    run_program(solve ${case} -o ${INTO}/${name}.csv --quiet)
  endif()
  keep_metadata(${name})
  file(STRINGS ${case} mapped REGEX "^\\[map\\]")
  if(mapped AND NOT TABLES_ONLY) # the table itself is large
    run_program(map ${case} -o ${INTO}/${name}_map.h5 --quiet)
    plot_table(${INTO}/${name}_map.h5 ${name})
    file(REMOVE ${INTO}/${name}_map.h5 ${INTO}/${name}_map.meta.json)
  endif()
  message(STATUS "${name}")
endforeach()

foreach(name neo_hookean apart near_degenerate circle double_well two_wells fibre heavy_plate) # every sheet of these bodies
  run_program(atlas cases/${name}.toml -o ${INTO}/${name}_atlas.csv --quiet)
  keep_metadata(${name}_atlas)
  plot_table(${INTO}/${name}_atlas.csv ${name}_atlas)
  message(STATUS "${name}_atlas")
endforeach()

# How the classical points of a fluid move with the shear modulus.
set(curves "")
foreach(event ellipse fold-nu hamiltonian-hopf)
  string(REPLACE "-" "_" name elastic_sphere_${event})
  run_program(curve cases/elastic_sphere.toml --set curve.event=${event} -o ${INTO}/${name}.csv --quiet)
  keep_metadata(${name})
  list(APPEND curves ${INTO}/${name}.csv)
endforeach()
plot_table("${curves}" elastic_sphere_curves)

# Two families of one body by energy and momentum.
plot_table(${INTO}/maclaurin.csv maclaurin_jacobi ${INTO}/jacobi.csv --diagram energy-momentum)

if(TABLES_ONLY)
  return()
endif()
# Pages to open, where the program was built with the page. Without the solver: its megabytes are not kept with the sources.
foreach(name fold neo_hookean_atlas)
  execute_process(COMMAND ${PROGRAM} explore ${INTO}/${name}.csv -o ${INTO}/${name}.html --no-live --quiet
    RESULT_VARIABLE code ERROR_VARIABLE message)
  if(NOT code EQUAL 0)
    message(STATUS "no page of ${name}: ${message}")
  endif()
endforeach()
