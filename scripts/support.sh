# shellcheck shell=bash
# SPDX-License-Identifier: BSD-3-Clause
# What the scripts share; sourced by them, not run.

# A Python of another origin early on PATH hides catkin_pkg from cmake.
export PATH="/usr/bin:/bin:${PATH}"

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"

# The one build tree of command, node, plugins, Python module and tests. rosrun does not look into build/.
build="${root}/build/release"
devel="${build}/devel"
logs="${root}/build/logs"
programs="${devel}/lib/parallel_aspects"
command="${programs}/aspects"

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
  say "Installing ${#missing[@]} packages with all that they need: ${missing[*]}"
  quietly "${logs}/install_packages" install_from_debian "${missing[@]}" ||
    fail "apt-get could not install them; what it printed is above and in ${logs}/install_packages"
}

install_from_debian() {
  as_root apt-get update -q && as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y "$@"
}

ros_is_installed() { rospack find roscpp > /dev/null 2>&1; }

# Options for every cmake: ccache, where it is there, which may take precompiled headers for what they were made of.
cmake_options=()
export CCACHE_SLOPPINESS=pch_defines,time_macros
if command -v ccache > /dev/null; then cmake_options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# For what is built once, rather than worked on: a room at a time takes half the processor time.
by_room=(-DPARALLEL_ASPECTS_BY_ROOM=ON)

# Into `release`: what decides how a source of the package is compiled. Warnings are errors with the compiler that they were
# examined with, which a bare machine has only once packages are installed.
choose_release() {
  release=(-DCMAKE_BUILD_TYPE=Release -DPARALLEL_ASPECTS_PRECOMPILED_HEADERS=tests "${by_room[@]}")
  if [ "$(g++ -dumpversion)" = 12 ]; then release+=(-DPARALLEL_ASPECTS_WERROR=ON); fi
}

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

# configure OPTION...: the build tree, with options that all scripts share, so that none compiles what another has
# compiled. What another has asked for stays on. ROS is searched for each time: the core is compiled the same with and without.
configure() {
  local ros=OFF
  choose_release
  if ros_is_installed; then
    ros=ON
    # Tests run in the environment of the first configuration, where a folder counts that exists by then.
    mkdir -p "${devel}/lib/python3/dist-packages"
  fi
  cmake -S "${root}" -B "${build}" -G Ninja "${release[@]}" -DBUILD_SHARED_LIBS=ON -DPARALLEL_ASPECTS_ROS="${ros}" \
    -DCATKIN_DEVEL_PREFIX="${devel}" -DCMAKE_RUNTIME_OUTPUT_DIRECTORY="${programs}" "${cmake_options[@]}" "$@"
}

# Reads what ninja prints, keeps it in LOG, and says now and then how far it is.
show_progress() {
  local log="$1" line done total began="${SECONDS}" pause=30 next left
  [ ! -t 2 ] || pause=2
  next=$((began + pause))
  while IFS= read -r line; do
    printf '%s\n' "${line}" >> "${log}"
    [[ "${line}" =~ ^\[([1-9][0-9]*)/([0-9]+)\] ]] && [ "${SECONDS}" -ge "${next}" ] || continue
    next=$((SECONDS + pause)) done="${BASH_REMATCH[1]}" total="${BASH_REMATCH[2]}"
    left=$(((SECONDS - began) * (total - done) / done))
    printf 'building %d of %d, about %s left\n' "${done}" "${total}" "$(duration "${left}")" >&2
  done
}

duration() {
  if [ "$1" -ge 90 ]; then echo "$((($1 + 30) / 60)) min"; else echo "$1 s"; fi
}

# build_in FOLDER LOG TARGET...: with its progress; all that is printed is added to LOG.
build_in() {
  local folder="$1" log="$2"
  shift 2
  cmake --build "${folder}" --target "$@" 2>&1 | show_progress "${log}"
}

# Whether the build tree is configured with all these options.
is_configured() {
  local option
  [ -f "${build}/build.ninja" ] || return 1
  for option in "$@"; do
    option="${option#-D}"
    grep -q "^${option%%=*}:[A-Z]*=${option#*=}\$" "${build}/CMakeCache.txt" || return 1
  done
}

# build_targets NAME TARGET...: in the build tree, one script at a time, with what `build_options` has for cmake. NAME is that
# of the log.
build_options=()
build_targets() {
  local log="${logs}/$1" status=0
  shift
  mkdir -p "${build}" "${logs}"
  exec 9> "${build}/lock"
  flock -n 9 || { echo "waiting for another script that builds" >&2 && flock 9; }
  : > "${log}"
  is_configured "${build_options[@]}" || configure "${build_options[@]}" >> "${log}" 2>&1 || status=1
  [ "${status}" -ne 0 ] || build_in "${build}" "${log}" "$@" || status=1
  exec 9>&-
  [ "${status}" -eq 0 ] || grep -v '^\[' "${log}" | tail -n 200 >&2
  return "${status}"
}

# build_aside COMMIT TARGET...: the core of another commit, its source in ${aside}/source and its build in ${aside}/build, as
# `configure` builds this tree, but for warnings; with what `build_options` has besides.
aside="${root}/build/compare"
build_aside() {
  local commit="$1"
  shift
  if [ ! -d "${aside}/source" ]; then git -C "${root}" worktree add --detach "${aside}/source" "${commit}" >&2; fi
  git -C "${aside}/source" checkout -q --detach "${commit}"
  cmake -S "${aside}/source" -B "${aside}/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPARALLEL_ASPECTS_ROS=OFF \
    -DBUILD_SHARED_LIBS=ON -DPARALLEL_ASPECTS_PRECOMPILED_HEADERS=tests "${cmake_options[@]}" "${by_room[@]}" \
    "${build_options[@]}" >&2
  cmake --build "${aside}/build" --target "$@" >&2
}

# build_benchmark NAME: a program of benchmark/, with what `build_options` has besides.
build_benchmark() {
  build_options+=(-DPARALLEL_ASPECTS_BENCHMARKS=ON)
  install_packages core benchmark >&2
  build_targets "build_$1" "$1" || fail "the build failed; its output is above and in ${logs}/build_$1"
}

# The environment of the tree's devel space. Nodes are reached as localhost, also where the machine's name is not known.
use_devel_space() {
  set +u
  # shellcheck disable=SC1091
  source "${devel}/setup.bash"
  set -u
  export ROS_HOSTNAME=localhost
  unset ROS_IP
}

# What programs that use libraries with sanitizers are started with, by LD_PRELOAD.
sanitizer_runtime() { clang++-14 -print-file-name=libclang_rt.asan-x86_64.so; }

free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'
}
