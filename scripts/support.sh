# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# What the scripts share; sourced by them, not run.

# A Python of another origin early on PATH hides catkin_pkg from cmake.
export PATH="/usr/bin:/bin:${PATH}"

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
workspace="${root}/.workspace"

# Where the `aspects` command is built, and the command: in a workspace that the demo or the tests have built the
# library is there already; else the core alone is built.
if [ -f "${workspace}/build/build.ninja" ]; then
  command_build="${workspace}/build"
  command="${workspace}/devel/lib/parallel_aspects/aspects"
else
  command_build="${root}/build/core"  # rosrun does not look into build/
  command="${command_build}/src/tools/aspects"
fi

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    fail "packages are missing and there is no sudo; as root, run: $*"
  fi
}

# Names of the packages of these groups in debian-packages.txt that are not installed.
missing_packages() {
  local group name rest
  while read -r group name rest; do
    case " $* " in *" ${group} "*) ;; *) continue ;; esac
    [ "$(dpkg-query -W -f='${db:Status-Status}' "${name}" 2> /dev/null)" = installed ] || echo "${name}"
  done < "${root}/scripts/debian-packages.txt"
}

# install_packages GROUP...: installs what is missing, on Debian. A Noetic from packages.ros.org is taken as it is.
install_packages() {
  if [ -f /opt/ros/noetic/setup.bash ]; then
    # shellcheck disable=SC1091
    set +u && source /opt/ros/noetic/setup.bash && set -u
    return
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  command -v apt-get > /dev/null || fail "these packages are missing: ${missing[*]}"
  say "Installing ${missing[*]}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y "${missing[@]}"
}

# Options for every cmake: ccache, where it is there, which may take precompiled headers for what they were made of.
cmake_options=()
export CCACHE_SLOPPINESS=pch_defines,time_macros
if command -v ccache > /dev/null; then cmake_options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# For what is built once, rather than worked on: a room at a time takes half the processor time.
by_room=(-DPARALLEL_ASPECTS_BY_ROOM=ON)

# quietly LOG COMMAND...: shows the output only where the command fails.
quietly() {
  local log="$1"
  shift
  mkdir -p "$(dirname "${log}")"
  if ! "$@" > "${log}" 2>&1; then
    cat "${log}" >&2
    return 1
  fi
}

# A catkin workspace of its own, with links to what this package is made of. Not one link to all of it: rosrun would
# find the workspace in the package, and each program twice.
prepare_workspace() {
  local package="${workspace}/src/parallel_aspects" entry
  [ ! -L "${package}" ] || rm "${package}"
  mkdir -p "${package}"
  # Tests run in the environment of the first configuration, where a folder counts that exists by then.
  mkdir -p "${workspace}/devel/lib/python3/dist-packages"
  find "${package}" -mindepth 1 -maxdepth 1 -xtype l -delete
  for entry in "${root}"/*; do
    case "${entry##*/}" in build* | devel | install) continue ;; esac
    [ -L "${package}/${entry##*/}" ] || ln -s "${entry}" "${package}"
  done
}

# build_workspace CMAKE_OPTION...
# As many jobs as processors: by itself catkin_make starts no second one while the load is at their number, which its own
# jobs and whatever else runs keep it at.
build_workspace() {
  prepare_workspace
  (cd "${workspace}" && ROS_PARALLEL_JOBS="${ROS_PARALLEL_JOBS:--j$(nproc)}" \
    catkin_make --use-ninja -DCMAKE_BUILD_TYPE=Release "${cmake_options[@]}" "$@")
}
