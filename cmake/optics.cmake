# The optics library alone, installed: find_package(icespar COMPONENTS optics), then icespar::optics.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(optics_folders math spectrum polarisation crystal interface)
set(optics_include ${CMAKE_INSTALL_INCLUDEDIR})
set(optics_package ${CMAKE_INSTALL_LIBDIR}/cmake/icespar)
set(optics_sources ${CMAKE_INSTALL_DATADIR}/icespar/sources)

add_library(icespar_optics INTERFACE)
add_library(icespar::optics ALIAS icespar_optics)
set_target_properties(icespar_optics PROPERTIES EXPORT_NAME optics)

# The same without the compiled library: whoever links it compiles the sources, with options of their own.
add_library(icespar_optics_headers INTERFACE)
set_target_properties(icespar_optics_headers PROPERTIES EXPORT_NAME optics_headers)
target_compile_features(icespar_optics_headers INTERFACE cxx_std_20)
target_include_directories(icespar_optics_headers INTERFACE
  $<INSTALL_INTERFACE:${optics_include}> $<INSTALL_INTERFACE:${optics_include}/icespar>)

foreach(folder IN LISTS optics_folders)
  target_link_libraries(icespar_optics INTERFACE icespar_${folder})
  set_target_properties(icespar_${folder} PROPERTIES EXPORT_NAME ${folder})
  target_compile_features(icespar_${folder} PUBLIC cxx_std_20)
  install(TARGETS icespar_${folder} EXPORT icespar_optics
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT optics)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/${folder} DESTINATION ${optics_include}/icespar
    COMPONENT optics FILES_MATCHING PATTERN "*.hpp")

  get_target_property(sources icespar_${folder} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME)
    # One file is for processors with AVX-512 and has options of its own; the library does without it.
    if(name STREQUAL "lanes_avx512.cpp")
      continue()
    endif()
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/core)
    install(FILES ${source} DESTINATION ${optics_sources}/${folder} COMPONENT optics)
    target_sources(icespar_optics_headers INTERFACE
      $<INSTALL_INTERFACE:$<INSTALL_PREFIX>/${optics_sources}/${folder}/${name}>)
  endforeach()
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/core/optics.hpp DESTINATION ${optics_include}/icespar COMPONENT optics)
install(TARGETS icespar_optics icespar_optics_headers EXPORT icespar_optics COMPONENT optics)
install(EXPORT icespar_optics NAMESPACE icespar:: FILE icespar-optics.cmake
  DESTINATION ${optics_package} COMPONENT optics)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/icespar-config.cmake.in
  ${PROJECT_BINARY_DIR}/icespar-config.cmake INSTALL_DESTINATION ${optics_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/icespar-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/icespar-config.cmake ${PROJECT_BINARY_DIR}/icespar-config-version.cmake
  DESTINATION ${optics_package} COMPONENT optics)
