# SPDX-License-Identifier: MIT
# Finds e-antic and what it stands on (FLINT, antic, Arb, GMP); Debian ships them without CMake or pkg-config files.
# Targets: EAntic::gmpxx (rationals in public headers), EAntic::eanticxx (number fields, private to algebra/).
find_path(EAntic_INCLUDE_DIR NAMES e-antic/renf_elem_class.hpp)
find_path(EAntic_GMPXX_INCLUDE_DIR NAMES gmpxx.h)
foreach(library eanticxx eantic flint-arb antic flint gmpxx gmp)
  find_library(EAntic_${library}_LIBRARY NAMES ${library})
  list(APPEND EAntic_library_variables EAntic_${library}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(EAntic REQUIRED_VARS EAntic_INCLUDE_DIR EAntic_GMPXX_INCLUDE_DIR ${EAntic_library_variables})
mark_as_advanced(EAntic_INCLUDE_DIR EAntic_GMPXX_INCLUDE_DIR ${EAntic_library_variables})

if(EAntic_FOUND AND NOT TARGET EAntic::eanticxx)
  add_library(EAntic::gmpxx INTERFACE IMPORTED)
  target_include_directories(EAntic::gmpxx SYSTEM INTERFACE ${EAntic_GMPXX_INCLUDE_DIR})
  target_link_libraries(EAntic::gmpxx INTERFACE ${EAntic_gmpxx_LIBRARY} ${EAntic_gmp_LIBRARY})
  add_library(EAntic::eanticxx INTERFACE IMPORTED)
  target_include_directories(EAntic::eanticxx SYSTEM INTERFACE ${EAntic_INCLUDE_DIR})
  target_link_libraries(EAntic::eanticxx INTERFACE ${EAntic_eanticxx_LIBRARY} ${EAntic_eantic_LIBRARY}
    ${EAntic_flint-arb_LIBRARY} ${EAntic_antic_LIBRARY} ${EAntic_flint_LIBRARY} EAntic::gmpxx)
endif()
