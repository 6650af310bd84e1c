#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A sweep as a Slurm array, a shard a job, and a job that merges them: slurm_sweep.sh SHARDS FILE SWEEP_ARGUMENT...
#
#     slurm_sweep.sh 4 designs.csv five_bar --vary "crank_1=6:8:100 rod_2=7:9:100" --report count,measures
#
# Parts are FILE.part_1 and so on, in a folder that all nodes see. A job that was killed goes on where its part ends, once
# the same line is submitted anew. Options of sbatch, as a partition or a time, go into the variable SBATCH_OPTIONS, and the
# command, where it is not on PATH, into ASPECTS.
set -euo pipefail

if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then  # a job of the array
  file="$1"
  shift
  exec "${ASPECTS:-aspects}" sweep "$@" --shard "${SLURM_ARRAY_TASK_ID}/${SLURM_ARRAY_TASK_COUNT}" \
    --threads "${SLURM_CPUS_PER_TASK:-1}" -o "${file}.part_${SLURM_ARRAY_TASK_ID}"
fi

[ $# -ge 3 ] || { echo "usage: slurm_sweep.sh SHARDS FILE SWEEP_ARGUMENT..." >&2; exit 2; }
shards="$1"
file="$(readlink -f "$2")"
shift 2
read -r -a options <<< "${SBATCH_OPTIONS:-}"
array="$(sbatch --parsable "${options[@]}" --array="1-${shards}" --output="${file}.log_%a" "$0" "${file}" "$@")"
parts="$(seq -f "${file}.part_%.0f" "${shards}")"
sbatch "${options[@]}" --dependency="afterok:${array}" --output="${file}.log" \
  --wrap "'${ASPECTS:-aspects}' merge '${parts//$'\n'/ }' -o '${file}'"
