# SPDX-License-Identifier: GPL-3.0-or-later
# The serial C library of HDF5. Not CMake's own FindHDF5: that compiles with h5cc and is slow.
find_package(PkgConfig QUIET)
pkg_check_modules(PC_HDF5 QUIET hdf5-serial)
find_path(HDF5C_INCLUDE_DIR hdf5.h HINTS ${PC_HDF5_INCLUDE_DIRS} PATH_SUFFIXES hdf5/serial)
find_library(HDF5C_LIBRARY NAMES hdf5_serial hdf5 HINTS ${PC_HDF5_LIBRARY_DIRS})
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Hdf5C REQUIRED_VARS HDF5C_INCLUDE_DIR HDF5C_LIBRARY)
if(Hdf5C_FOUND AND NOT TARGET Hdf5C::hdf5)
  add_library(Hdf5C::hdf5 INTERFACE IMPORTED)
  target_include_directories(Hdf5C::hdf5 SYSTEM INTERFACE ${HDF5C_INCLUDE_DIR})
  target_link_libraries(Hdf5C::hdf5 INTERFACE ${HDF5C_LIBRARY})
endif()
