# SPDX-License-Identifier: GPL-3.0-or-later
# Optional: without it JR3 PCI cards cannot be opened.
find_path(COMEDI_INCLUDE_DIR comedilib.h)
find_library(COMEDI_LIBRARY comedi)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Comedi REQUIRED_VARS COMEDI_INCLUDE_DIR COMEDI_LIBRARY)
if(Comedi_FOUND AND NOT TARGET Comedi::comedi)
  add_library(Comedi::comedi INTERFACE IMPORTED)
  target_include_directories(Comedi::comedi SYSTEM INTERFACE ${COMEDI_INCLUDE_DIR})
  target_link_libraries(Comedi::comedi INTERFACE ${COMEDI_LIBRARY})
endif()
