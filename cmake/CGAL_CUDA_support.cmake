# Looks for a CUDA compiler, enables the language CUDA where there is one, and sets
# CGAL_CUDA_support_FOUND. To be included from the top folder of the project.
#
# CMAKE_CUDA_ARCHITECTURES, if not set: code for compute capability 9.0, and intermediate code that
# the driver compiles for any device from the oldest one on that the compiler knows.
include(CheckLanguage)

set(CGAL_CUDA_support_FOUND FALSE)
if(NOT DEFINED CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX})
  # Often it is installed without being in the PATH.
  find_program(_cgal_nvcc nvcc HINTS "$ENV{CUDA_PATH}/bin" /usr/local/cuda/bin NO_CACHE)
  if(_cgal_nvcc)
    set(CMAKE_CUDA_COMPILER "${_cgal_nvcc}")
  endif()
  unset(_cgal_nvcc)
endif()
check_language(CUDA)

if(CMAKE_CUDA_COMPILER)
  if(NOT DEFINED CMAKE_CUDA_ARCHITECTURES)
    # Without a value CMake would compile for one device, and warn. Set for good below.
    set(CMAKE_CUDA_ARCHITECTURES 90)
    set(_cgal_choose_architectures TRUE)
  endif()
  enable_language(CUDA)
  if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 12.4)
    message(STATUS "CUDA ${CMAKE_CUDA_COMPILER_VERSION} was found, 12.4 or later is needed")
  else()
    set(CGAL_CUDA_support_FOUND TRUE)
    find_package(CUDAToolkit REQUIRED)
  endif()
  if(_cgal_choose_architectures)
    if(CMAKE_CUDA_COMPILER_VERSION VERSION_LESS 13)
      set(CMAKE_CUDA_ARCHITECTURES 70-virtual 90-real)
    else()
      set(CMAKE_CUDA_ARCHITECTURES 75-virtual 90-real)
    endif()
  endif()
  unset(_cgal_choose_architectures)
endif()
