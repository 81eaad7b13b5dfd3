cmake -S . -B build -G Ninja %CMAKE_ARGS% -DCMAKE_BUILD_TYPE=Release ^
  -DCMAKE_INSTALL_PREFIX="%LIBRARY_PREFIX%" -DPython_EXECUTABLE="%PYTHON%" ^
  -DHTL_PYTHON_DIR="../Lib/site-packages" -DHTL_CUDA=OFF ^
  -DHTL_BUILD_TESTS=OFF -DHTL_BUILD_EXAMPLES=OFF -DHTL_BUILD_BENCHMARKS=OFF
if errorlevel 1 exit 1
cmake --build build --parallel %CPU_COUNT%
if errorlevel 1 exit 1
cmake --install build
if errorlevel 1 exit 1
