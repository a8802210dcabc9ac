# What every image for the AVR is made of. Included only when configured with toolchain.cmake.
set(MCU atmega1284p)
set(CLOCK 8000000)

# avr-gcc's own checks for overflow, shifts and bounds, ending in a stop: for the tests' second image, which is
# optimised harder so that it still answers in time.
option(PILOTFISH_OVERFLOW_TRAPS "Stop on signed overflow, bad shifts and bad indices" OFF)

add_compile_options(
  -mmcu=${MCU} $<IF:$<BOOL:${PILOTFISH_OVERFLOW_TRAPS}>,-O3,-O2> -g -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections
  $<$<BOOL:${PILOTFISH_OVERFLOW_TRAPS}>:-fsanitize=signed-integer-overflow,shift,bounds,integer-divide-by-zero>
  $<$<BOOL:${PILOTFISH_OVERFLOW_TRAPS}>:-fsanitize-undefined-trap-on-error>)
add_compile_definitions(F_CPU=${CLOCK}UL $<$<BOOL:${PILOTFISH_OVERFLOW_TRAPS}>:PILOTFISH_OVERFLOW_TRAPS>)
add_link_options(-mmcu=${MCU} -Wl,--gc-sections)

set(CMAKE_CXX_STANDARD 14)

# Puts the checksum over the flash into the image (H-27). The simulator loads that ELF, the .hex is made from it.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(CHECKSUM_TOOL ${CMAKE_SOURCE_DIR}/drivers/avr/checksum)

# add_image(NAME [CHECKED] SOURCE...) makes NAME.elf and, beside it, NAME.hex (flash) and NAME.eep (EEPROM).
#
# All sources are compiled as one, which the compiler is told is the whole program. That saves a third of the run time
# against separate files; avr-gcc's link-time optimiser would do the same, but it loses the line numbers and crashes on
# the overflow checks.
#
# CHECKED: it tests its own flash, so the checksum is put in after linking.
function(add_image name)
  cmake_parse_arguments(PARSE_ARGV 1 image "CHECKED" "" "")
  add_executable(${name} ${image_UNPARSED_ARGUMENTS})
  set_target_properties(${name} PROPERTIES SUFFIX .elf UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  target_compile_options(${name} PRIVATE -fwhole-program)
  target_link_options(${name} PRIVATE -Wl,-Map=$<TARGET_FILE_DIR:${name}>/${name}.map)
  if(image_CHECKED)
    set_target_properties(${name} PROPERTIES LINK_DEPENDS ${CHECKSUM_TOOL})
    add_custom_command(TARGET ${name} POST_BUILD COMMAND ${Python3_EXECUTABLE} ${CHECKSUM_TOOL} $<TARGET_FILE:${name}>
                       VERBATIM)
  endif()
  add_custom_command(
    TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_OBJCOPY} -O ihex -j .text -j .data $<TARGET_FILE:${name}> ${name}.hex
    COMMAND ${CMAKE_OBJCOPY} -O ihex -j .eeprom --set-section-flags=.eeprom=alloc,load --no-change-warnings
            --change-section-lma .eeprom=0 $<TARGET_FILE:${name}> ${name}.eep
    WORKING_DIRECTORY $<TARGET_FILE_DIR:${name}> VERBATIM)
endfunction()

file(GLOB avr_driver_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/drivers/avr/*.cpp)
add_library(pilotfish_core STATIC ${core_sources})  # for the tests' programs; and each file must compile by itself
add_image(spm CHECKED ${CMAKE_SOURCE_DIR}/spm/main.cpp ${CMAKE_SOURCE_DIR}/spm/eeprom_image.cpp ${core_sources}
          ${avr_driver_sources})
