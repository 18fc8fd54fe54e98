#!/usr/bin/env bash
# Fuzzes what reads files and texts, with AddressSanitizer and UBSan: tests/fuzz/run.sh [--seconds N | --runs N] [TARGET...]
# Each target starts from tests/fuzz/corpus/TARGET and what earlier runs added in build/fuzz/corpus/TARGET, for N seconds
# (default 60) or N executions. Findings are kept in build/fuzz/findings; with one, the exit status is 1.
# tests/fuzz/run.sh --coverage [TARGET...] replays these inputs and tells how many lines of each reader they reach.
set -euo pipefail
limit=-max_total_time=60
coverage=false
chosen=()
while [ $# -gt 0 ]; do
  case $1 in
    --seconds) limit=-max_total_time=$2; shift ;;
    --runs) limit=-runs=$2; shift ;;
    --coverage) coverage=true ;;
    -*) echo "run.sh: $1 is not known" >&2; exit 2 ;;
    *) chosen+=("$1") ;;
  esac
  shift
done

extra_packages="clang llvm libclang-rt-14-dev"
targets="ixos ixos_solvers"
IXOS_PRESET=release . "$(dirname "${BASH_SOURCE[0]}")/../../drivers/common.sh"
here="$root/tests/fuzz"
work="$root/build/fuzz"
[ ${#chosen[@]} -gt 0 ] || chosen=($(ls "$here/corpus"))
(
  cd "$root"
  [ -f "$work/build.ninja" ] || cmake --preset fuzz
  cmake --build "$work" --target "${chosen[@]/#/fuzz_}"
)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=$scratch LLVM_PROFILE_FILE=$scratch/unused.profraw
[ ! -d /dev/shm ] || TMPDIR=/dev/shm
# A larger allocation fails: libraries say so, and ours ends as a finding, an exception that nobody expects.
sanitizer=detect_odr_violation=0:allocator_may_return_null=1:max_allocation_size_mb=64
export ASAN_OPTIONS=$sanitizer
export UBSAN_OPTIONS=print_stacktrace=1
export LSAN_OPTIONS=suppressions=$here/leaks.supp:print_suppressions=0
# Names and words that scenes and studies may use.
sed -nE 's/^\| ([^|]*[a-z]) \|.*/\1/p; s/^## (.*)/\1/p' "$root/docs/parameters.md" | sed 's: / :\n:g' | sort -u |
  sed 's/.*/"&"/' > "$scratch/xml.dict"

options_of() {
  case $1 in
    expression | motion) echo "-dict=$here/expression.dict -max_len=200" ;;
    scene | study | assignment | xml) echo "-dict=$scratch/xml.dict -max_len=4000" ;;
    # What distribution libraries read goes on after their crashes.
    exodus | fields | checkpoint) echo "-max_len=60000 -fork=1 -ignore_crashes=1 -ignore_ooms=1 -ignore_timeouts=1" ;;
    gmsh) echo "-max_len=20000" ;;
    *) echo "-max_len=4096" ;;
  esac
}

# Where a report's fault is: the first frame of a library or of ours in each of its stacks (where it happened, and who
# made the memory that it misused): one of ours where there is one, for a library that overruns what we gave it is our
# finding. Nothing where there is none. ccache makes our paths relative to the build folder.
place_in() {
  awk -v ours="($root|[.][.]/[.][.])/(lib|tests)/|libixos" '
    !/^ *#[0-9]+ / { taken = 0; next }
    taken || /libc\.so|libstdc\+\+|libm\.so|ld-linux|sanitizer|crtstuff|interceptor/ { next }
    $0 ~ ours { print 0, $0; taken = 1; next }
    /\.so/ { print 1, $0; taken = 1 }' "$1" | sort -s -n -k1,1 | head -1 |
    sed -E 's/^[01] *#[0-9]+ 0x[0-9a-f]+ *(in )?//; s/ \(BuildId.*//'
}

# Where a finding happens. An input that alone does no harm failed in a process whose libraries earlier inputs had
# damaged: then the reports of those processes tell, of which one of ours counts most; "alone" if there is none.
place_of() {
  local log=$scratch/finding.log report
  if ! ASAN_OPTIONS=$sanitizer "$work/tests/fuzz/fuzz_$1" -timeout=60 -rss_limit_mb=2048 "$2" > "$log" 2>&1; then
    place_in "$log"
    return
  fi
  for report in "$scratch/$1.report".*; do [ ! -f "$report" ] || place_in "$report"; done |
    awk '/libixos/ || !/\.so/ { ours = $0 } { any = $0 }
      END { print ours != "" ? ours : any != "" ? any ", after other inputs" : "alone" }'
}

if $coverage; then
  for target in "${chosen[@]}"; do
    mkdir -p "$work/corpus/$target"
    LLVM_PROFILE_FILE=$scratch/$target.profraw "$work/tests/fuzz/fuzz_$target" -runs=0 "$work/corpus/$target" \
      "$here/corpus/$target" > "$scratch/$target.log" 2>&1 || { tail -30 "$scratch/$target.log"; exit 1; }
    grep -E "INITED" "$scratch/$target.log" | sed "s/^/$target: /"
  done
  llvm-profdata merge "$scratch"/*.profraw -o "$scratch/all.profdata"
  objects=("${chosen[@]/#/-object=$work/tests/fuzz/fuzz_}")
  llvm-cov report "${objects[@]}" -instr-profile="$scratch/all.profdata" -show-region-summary=false \
    -show-branch-summary=false -ignore-filename-regex='/usr/|tests/fuzz'
  exit
fi

status=0
printf '%-12s %12s %9s\n' target executions edges
for target in "${chosen[@]}"; do
  mkdir -p "$work/corpus/$target" "$work/findings"
  mark=$scratch/$target.mark
  touch "$mark"
  # Children of -fork write what was slow where they stand.
  (cd "$scratch" && ASAN_OPTIONS=$sanitizer:log_path=$scratch/$target.report "$work/tests/fuzz/fuzz_$target" $(options_of "$target") "$limit" -timeout=60 -rss_limit_mb=2048 -print_final_stats=1 \
    -artifact_prefix="$work/findings/$target-" "$work/corpus/$target" "$here/corpus/$target" \
    > "$scratch/$target.log" 2>&1) && failed=false || failed=true
  awk -v target="$target" '
    /^#[0-9]/ { executions = substr($1, 2) + 0; for (i = 1; i < NF; ++i) if ($i == "cov:") edges = $(i + 1) }
    /number_of_executed_units/ { executions = $2 }
    END { printf "%-12s %12d %9d\n", target, executions, edges; exit executions == 0 }' "$scratch/$target.log" ||
    failed=true
  listed=0
  for finding in $(find "$work/findings" -name "$target-*" -not -name '*slow-unit*' -newer "$mark"); do
    place=$(place_of "$target" "$finding")
    case $(basename "$finding")/$place in
      # Libraries lose memory with every file that they refuse; it adds up over thousands.
      *-oom-*/alone) echo "  memory that libraries lost before: $finding" ;;
      */*libixos*) echo "  a finding: $place ($finding)"; status=1 ;;
      *.so*)
        # Outside of what a child process tries first it would end a run.
        grep -qs try_reading "$scratch/finding.log" "$scratch/$target.report".* && tried=", tried in a child first" || tried=""
        echo "  in a distribution library$tried: $place ($finding)" ;;
      *) echo "  a finding: $place ($finding)"; status=1 ;;
    esac
    listed=$((listed + 1))
  done
  if $failed && [ $listed -eq 0 ]; then
    tail -40 "$scratch/$target.log"
    status=1
  fi
done
exit $status
