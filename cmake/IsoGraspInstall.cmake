# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` copies, in two components:
#   application: the executable, and the shipped library in share/isograsp;
#   development: core, hand, kinematics, device and grasp_model with headers and a package for find_package(IsoGrasp).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/IsoGrasp)
foreach(name core hand kinematics device grasp_model)
  set_target_properties(isograsp_${name} PROPERTIES EXPORT_NAME ${name})
  # How Eigen aligns is part of the binary interface: a program compiled for AVX must not differ.
  target_compile_definitions(isograsp_${name} INTERFACE
    $<INSTALL_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>)
  install(TARGETS isograsp_${name} EXPORT IsoGraspTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${name} DESTINATION include/isograsp
    COMPONENT development FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(EXPORT IsoGraspTargets NAMESPACE isograsp:: DESTINATION ${package} COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/IsoGraspConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/IsoGraspConfig.cmake
  ${PROJECT_BINARY_DIR}/IsoGraspConfigVersion.cmake ${PROJECT_SOURCE_DIR}/cmake/FindGlpk.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindComedi.cmake
  DESTINATION ${package} COMPONENT development)

if(ISOGRASP_APPLICATION)
  install(TARGETS isograsp RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT application)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/library/ DESTINATION share/isograsp
    COMPONENT application)
endif()
