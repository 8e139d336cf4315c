# CPack's configuration: a Debian package for every component of the installation.
set(TRIVET_MAINTAINER "The Trivet authors <authors@trivet.invalid>" CACHE STRING
  "Maintainer of packages, with an address that answers: NAME <ADDRESS>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME trivet)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${TRIVET_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Copyright and changelogs, as Debian wants them, in every package.
file(STRINGS ${PROJECT_SOURCE_DIR}/LICENSE lines ENCODING UTF-8)
list(FILTER lines INCLUDE REGEX "^Copyright")
string(REGEX REPLACE "^Copyright \\(c\\) " "" copyright "${lines}")
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^.*Copyright[^\n]*\n\n" "" licence "${licence}")
string(REGEX REPLACE "\n$" "" licence "${licence}")
string(REPLACE "\n\n" "\n.\n" licence "${licence}")
string(REPLACE "\n" "\n " licence " ${licence}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(debian/copyright.in copyright @ONLY)
configure_file(debian/changelog.in changelog.Debian @ONLY)
gzipped(${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz)
gzipped(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)

# debian_package(COMPONENT NAME SECTION DEPENDS DESCRIPTION): the first line of DESCRIPTION is the summary.
macro(debian_package component name section depends description)
  string(TOUPPER ${component} upper)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}")
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/copyright ${CMAKE_CURRENT_BINARY_DIR}/changelog.Debian.gz
    ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endmacro()

set(same "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(CPACK_COMPONENTS_ALL "")
debian_package(trivet trivet graphics ""
  "lays out 3D objects at rest, without interpenetration
Takes triangle meshes as they are (concave, open, self-crossing), lets
each fall to its first contact, settles it, and proves that nothing
interpenetrates and that contact forces hold it. Exact geometry, no time
steps, the same bits on every run. Batches of random scenes, pictures and
labelled images, export for simulators.")
# Opened at run time, for pictures by OpenGL; else they are drawn by rays.
set(CPACK_DEBIAN_TRIVET_PACKAGE_RECOMMENDS "libegl1, libopengl0")
set(suggests trivet-edit trivet-cad python3-trivet)
if(TRIVET_MUJOCO_VERSION)  # so is this, for trivet export --simulate
  list(PREPEND suggests libmujoco${TRIVET_MUJOCO_VERSION})
endif()
list(JOIN suggests ", " CPACK_DEBIAN_TRIVET_PACKAGE_SUGGESTS)
if(TARGET trivet-edit)
  debian_package(edit trivet-edit graphics "trivet ${same}"
    "editor of 3D layouts at rest, without interpenetration
Lays out 3D objects by mouse: put, push, turn, lift. Every move is settled
and proved as by the program trivet, and can be undone.")
  set(CPACK_DEBIAN_EDIT_PACKAGE_RECOMMENDS "libegl1, libopengl0, libgl1-mesa-dri")
endif()
if(TARGET trivet-import-cad)
  debian_package(cad trivet-cad graphics "trivet ${same}"
    "lays out 3D objects at rest: STEP, IGES and BREP
Reads curved surfaces by Open CASCADE for trivet, its editor and its
Python package.")
endif()
if(TARGET trivet_python)
  execute_process(COMMAND ${TRIVET_PYTHON_EXECUTABLE} -c
    "import sys; print(*sys.version_info[:2], sys.version_info[1] + 1, sep=';')"
    OUTPUT_VARIABLE python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  list(GET python 2 next)
  list(REMOVE_AT python 2)
  list(JOIN python . python)
  debian_package(python python3-trivet python
    "python3 (>= ${python}~), python3 (<< 3.${next}), python3-numpy, trivet ${same}"
    "lays out 3D objects at rest: Python 3 package
Scenes from NumPy arrays and meshes, all operations of the program trivet,
with the same bits; contacts and supports as arrays.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_SOURCE_DIR}/debian/postinst ${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm)
endif()
# Libraries that TrivetConfig.cmake looks for: static ones need them.
set(needs libeigen3-dev libembree-dev libqhull-dev libtbb-dev libassimp-dev libpng-dev libjpeg-dev libwebp-dev
  nlohmann-json3-dev coinor-libclp-dev libtinyxml2-dev libccd-dev libarchive-dev libexpat1-dev pkg-config)
foreach(pair HACD=libbullet-extras-dev EXR=libopenexr-dev MESHOPT=libmeshoptimizer-dev DRACO=libdraco-dev)
  string(REPLACE "=" ";" pair ${pair})
  list(GET pair 0 use)
  list(GET pair 1 package)
  if(TRIVET_USES_${use})
    list(APPEND needs ${package})
  endif()
endforeach()
if(TARGET trivet_gpu)
  list(APPEND needs libepoxy-dev)
endif()
list(JOIN needs ", " needs)
# Its name has what programs are linked with: see SOVERSION in apps/library.
set(library libtrivet${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
debian_package(lib ${library} libs ""
  "lays out 3D objects at rest: shared library
For programs that were built with libtrivet-dev. Reading models needs the
importer of trivet.")
set(CPACK_DEBIAN_LIB_PACKAGE_RECOMMENDS "trivet ${same}")
set(CPACK_DEBIAN_LIB_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/triggers)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
debian_package(dev libtrivet-dev libdevel "${library} ${same}, ${needs}"
  "lays out 3D objects at rest: C++ library and headers
For find_package(Trivet), shared and static: exact first contact, PUT and the
other operations of the program trivet, scenes, pictures, export.")

include(CPack)
