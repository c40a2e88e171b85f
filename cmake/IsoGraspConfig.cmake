# SPDX-License-Identifier: GPL-3.0-or-later
# find_package(IsoGrasp): isograsp::core, isograsp::kinematics, isograsp::device, isograsp::grasp_model.
include(CMakeFindDependencyMacro)
set(isograsp_module_path ${CMAKE_MODULE_PATH})
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Threads)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(Boost 1.74)
find_dependency(Glpk)
find_dependency(Qhull)
find_package(Comedi QUIET)
set(CMAKE_MODULE_PATH ${isograsp_module_path})
unset(isograsp_module_path)
include(${CMAKE_CURRENT_LIST_DIR}/IsoGraspTargets.cmake)
