# The AVR images, seen from the host project: built by the same tree under the other toolchain, and brought to a chip.
include(ExternalProject)

set(PILOTFISH_FIRMWARE_DIR ${CMAKE_BINARY_DIR}/firmware)
set(PILOTFISH_TRAPS_DIR ${CMAKE_BINARY_DIR}/firmware-traps)

# build/firmware/spm.elf, .hex, .eep: what is flashed, and what the simulator runs.
ExternalProject_Add(
  firmware
  SOURCE_DIR ${CMAKE_SOURCE_DIR}
  BINARY_DIR ${PILOTFISH_FIRMWARE_DIR}
  PREFIX ${CMAKE_BINARY_DIR}/firmware-project
  CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/drivers/avr/toolchain.cmake
  BUILD_ALWAYS ON
  USES_TERMINAL_BUILD ON
  INSTALL_COMMAND "")

# The same, stopping at every signed overflow: only for tests.
ExternalProject_Add(
  firmware_traps
  SOURCE_DIR ${CMAKE_SOURCE_DIR}
  BINARY_DIR ${PILOTFISH_TRAPS_DIR}
  PREFIX ${CMAKE_BINARY_DIR}/firmware-traps-project
  CMAKE_ARGS -DCMAKE_TOOLCHAIN_FILE=${CMAKE_SOURCE_DIR}/drivers/avr/toolchain.cmake -DPILOTFISH_OVERFLOW_TRAPS=ON
  BUILD_ALWAYS ON
  USES_TERMINAL_BUILD ON
  INSTALL_COMMAND "")

# ---- to a chip and back. `flash` writes flash and nothing else; `fuses` wants to be told twice; see docs/hardware.md.
find_program(AVRDUDE avrdude DOC "Talks to the programmer")
set(PILOTFISH_PROGRAMMER usbasp CACHE STRING "avrdude's name of the programmer (avrdude -c '?')")
set(PILOTFISH_PORT "" CACHE STRING "avrdude's port of the programmer, where it needs one")

foreach(action flash eeprom fuses read-fuses)
  add_custom_target(
    ${action}
    COMMAND ${CMAKE_COMMAND} -DACTION=${action} -DAVRDUDE=${AVRDUDE} -DPROGRAMMER=${PILOTFISH_PROGRAMMER}
            -DPORT=${PILOTFISH_PORT} -DIMAGE=${PILOTFISH_FIRMWARE_DIR}/spm -P
            ${CMAKE_SOURCE_DIR}/drivers/avr/program.cmake
    USES_TERMINAL VERBATIM)
  add_dependencies(${action} firmware)
endforeach()

add_custom_target(
  size COMMAND avr-size --format=avr --mcu=atmega1284p ${PILOTFISH_FIRMWARE_DIR}/spm.elf
  USES_TERMINAL VERBATIM)
add_custom_target(
  disasm
  COMMAND avr-objdump -d -S ${PILOTFISH_FIRMWARE_DIR}/spm.elf > ${PILOTFISH_FIRMWARE_DIR}/spm.lst
  COMMAND ${CMAKE_COMMAND} -E echo "wrote ${PILOTFISH_FIRMWARE_DIR}/spm.lst"
  USES_TERMINAL VERBATIM)
add_dependencies(size firmware)
add_dependencies(disasm firmware)
