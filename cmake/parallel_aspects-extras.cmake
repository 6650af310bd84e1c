# Headers of the core compute with intervals, which needs this option wherever they are compiled.
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-frounding-math>)
