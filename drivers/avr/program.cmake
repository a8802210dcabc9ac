# Brings an image to a chip, one kind of memory at a time:
#   cmake -DACTION=flash|eeprom|fuses|read-fuses -DAVRDUDE=... -DPROGRAMMER=... -DPORT=... -DIMAGE=path/without/suffix
#         -P program.cmake
# Normally called by the targets of the same names.
cmake_minimum_required(VERSION 3.25)

# What is wrong, and what to do about it. (A line that begins with a space is shown as it is.)
function(refuse problem remedy)
  message(FATAL_ERROR " ${problem}\n  ${remedy}")
endfunction()

if(NOT AVRDUDE OR AVRDUDE MATCHES "NOTFOUND")
  refuse("avrdude is not installed" "apt-get install avrdude, then configure again")
endif()

set(dude ${AVRDUDE} -p m1284p -c ${PROGRAMMER})
if(PORT)
  list(APPEND dude -P ${PORT})
endif()

function(call)
  execute_process(COMMAND ${dude} ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    refuse("avrdude failed. Is '${PROGRAMMER}' the right programmer?"
           "cmake -DPILOTFISH_PROGRAMMER=name -DPILOTFISH_PORT=port build")
  endif()
endfunction()

# Sets `out` to one fuse byte of the chip, as a number.
function(read_fuse name out)
  execute_process(COMMAND ${dude} -q -q -U ${name}:r:-:h RESULT_VARIABLE result OUTPUT_VARIABLE text)
  if(NOT result EQUAL 0 OR NOT text MATCHES "0x[0-9a-fA-F]+")
    refuse("cannot read ${name} of the chip: is it connected and powered?" "programmer: ${PROGRAMMER} ${PORT}")
  endif()
  math(EXPR value "${CMAKE_MATCH_0}")
  set(${out} ${value} PARENT_SCOPE)
endfunction()

# The fuse values stand once, in the image (drivers/avr/fuses_spm.cpp).
function(wanted_fuses out)
  execute_process(COMMAND avr-objcopy -O binary -j .fuse ${IMAGE}.elf ${IMAGE}.fuses COMMAND_ERROR_IS_FATAL ANY)
  file(READ ${IMAGE}.fuses hex HEX)
  string(REGEX MATCHALL ".." bytes "${hex}")
  set(${out} ${bytes} PARENT_SCOPE)
endfunction()

if(ACTION STREQUAL "flash")
  # Writing flash erases the chip first, and that keeps the EEPROM only under the fuse EESAVE.
  read_fuse(hfuse high)
  math(EXPR eesave "${high} & 0x08")
  if(NOT eesave EQUAL 0)
    refuse("this chip would lose its EEPROM (settings, event log): its fuse EESAVE is not programmed."
           "write the fuses first: PILOTFISH_CONFIRM=fuses cmake --build build --target fuses")
  endif()
  call(-U flash:w:${IMAGE}.hex:i)
elseif(ACTION STREQUAL "eeprom")
  call(-U eeprom:w:${IMAGE}.eep:i)
elseif(ACTION STREQUAL "read-fuses")
  wanted_fuses(wanted)
  foreach(name lfuse hfuse efuse)
    list(POP_FRONT wanted should_be)
    read_fuse(${name} value)
    math(EXPR value "${value}" OUTPUT_FORMAT HEXADECIMAL)
    message("${name}  ${value}, should be 0x${should_be}")
  endforeach()
elseif(ACTION STREQUAL "fuses")
  wanted_fuses(wanted)
  if(NOT "$ENV{PILOTFISH_CONFIRM}" STREQUAL "fuses")
    refuse("would write low, high, extended fuse = ${wanted} (hex); wrong fuses can make a chip unreachable."
           "if the crystal is fitted: PILOTFISH_CONFIRM=fuses cmake --build build --target fuses")
  endif()
  list(GET wanted 0 low)
  list(GET wanted 1 high)
  list(GET wanted 2 extended)
  call(-U lfuse:w:0x${low}:m -U hfuse:w:0x${high}:m -U efuse:w:0x${extended}:m)
else()
  refuse("unknown ACTION '${ACTION}'" "flash, eeprom, fuses or read-fuses")
endif()
