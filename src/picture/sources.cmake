# The sources of the pictures, relative to this folder. They need libpng.
set(HTL_PICTURE_SOURCES
  ambient_occlusion.cpp
  Camera.cpp
  Corner_normals.cpp
  lights.cpp
  Line_layer.cpp
  picture.cpp
  Surface_layer.cpp
  encode_png.cpp)
