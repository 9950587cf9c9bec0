# What the viewer's window is made of: GLFW, and Dear ImGui with its backends for GLFW and OpenGL 3,
# which Debian's library has inside.
find_package(glfw3 3.3 REQUIRED)
find_path(SADDLE_IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(SADDLE_IMGUI imgui REQUIRED)
find_library(SADDLE_STB NAMES libstb.a stb REQUIRED)  # which ImGui is linked against
add_library(saddle_window INTERFACE)
target_include_directories(saddle_window SYSTEM INTERFACE ${SADDLE_IMGUI_INCLUDE})
target_link_libraries(saddle_window INTERFACE ${SADDLE_IMGUI} ${SADDLE_STB} glfw)
