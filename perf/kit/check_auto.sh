# Compares the choice of `auto` with what was measured: sourced by run.sh. Uses kit, out, work, hardware, minutes, say.
# shellcheck shell=bash disable=SC2154

columns=(1K 15K 150K 1.5M)
declare -A taken expected  # by "kind column": a source; by "kind column source": milliseconds

trim() { local text="${1#"${1%%[![:space:]]*}"}"; echo "${text%"${text##*[![:space:]]}"}"; }
is_less() { [ "$1" != "$2" ] && [ "$(printf '%s\n%s\n' "$1" "$2" | sort -g | head -n 1)" = "$1" ]; }  # of numbers

# The tables of `trivet backends`: cells of 18 characters, after two spaces.
read_table() {
  local line kind="" name i
  while IFS= read -r line; do
    case "$line" in
      "expected milliseconds of a query, fall"*) kind=fall; continue ;;
      "expected milliseconds of a query, turn"*) kind=turn; continue ;;
      "") kind=""; continue ;;
    esac
    name="$(trim "${line:2:18}")"
    if [ -z "$kind" ] || [ -z "$name" ]; then continue; fi
    for i in 0 1 2 3; do
      if [ "$name" = "auto takes" ]; then
        taken["$kind ${columns[i]}"]="$(trim "${line:$((20 + 18 * i)):18}")"
      else
        expected["$kind ${columns[i]} $name"]="$(trim "${line:$((20 + 18 * i)):18}")"
      fi
    done
  done <"$out/backends.txt"
}

# Every choice is of the fastest source but software, also where that is the GPU; without hardware never of a GPU.
check_table() {
  local key choice other wrong=0 on_gpu=0
  read_table
  [ ${#taken[@]} = 8 ] || { say "FAILED: trivet backends names ${#taken[@]} choices, not 8"; return 1; }
  for key in "${!taken[@]}"; do
    choice="${taken[$key]}"
    case "$choice" in gpu*) on_gpu=$((on_gpu + 1)) ;; esac
    for other in "${!expected[@]}"; do
      if [ "${other#"$key "}" = software ]; then continue; fi
      if [[ "$other" == "$key "* ]] && is_less "${expected[$other]}" "${expected["$key $choice"]}"; then
        say "FAILED: auto takes $choice (${expected["$key $choice"]} ms) for $key, where ${other#"$key "} takes ${expected[$other]} ms"
        wrong=1
      fi
    done
  done
  say "auto takes the GPU in $on_gpu of 8 cases, the fastest in each: $([ $wrong = 0 ] && echo yes || echo no)"
  if [ "$hardware" = 0 ] && [ $on_gpu != 0 ]; then say "FAILED: auto takes a GPU without hardware"; wrong=1; fi
  return $wrong
}

# A closed slab of 4 n^2 + 8 n triangles, bumpy above; integers, as a scale follows.
slab_obj() {  # N
  local n="$1" i j a b row=$(($1 + 1))
  local below=$((row * row))
  for ((i = 0; i <= n; ++i)); do for ((j = 0; j <= n; ++j)); do echo "v $i $j $((n / 8 + (i * i + 3 * j * j) / n % 9))"; done; done
  for ((i = 0; i <= n; ++i)); do for ((j = 0; j <= n; ++j)); do echo "v $i $j 0"; done; done
  for ((i = 0; i < n; ++i)); do for ((j = 0; j < n; ++j)); do
    a=$((i * row + j + 1)) b=$((a + below))
    echo "f $a $((a + row)) $((a + row + 1))"; echo "f $a $((a + row + 1)) $((a + 1))"
    echo "f $b $((b + row + 1)) $((b + row))"; echo "f $b $((b + 1)) $((b + row + 1))"
  done; done
  side() { echo "f $1 $2 $(($2 + below))"; echo "f $1 $(($2 + below)) $(($1 + below))"; }
  for ((i = 0; i < n; ++i)); do
    side $((i * row + row + 1)) $((i * row + 1)); side $((i * row + row)) $((i * row + 2 * row))
    side $((i + 1)) $((i + 2)); side $((n * row + i + 2)) $((n * row + i + 1))
  done
}

# Two slabs of N x N, the upper one put onto the lower one again and again.
slab_layout() {  # FOLDER N PUTS
  local i scale
  scale="$(printf '0.%05d' $((30000 / $2)))"
  mkdir -p "$1" && slab_obj "$2" >"$1/slab.obj"
  {
    echo '{"trivet": 1, "floor": true, "objects": ['
    echo " {\"name\": \"below\", \"model\": \"slab.obj\", \"scale\": $scale, \"fixed\": true, \"position\": [0, 0, 0.01]},"
    echo " {\"name\": \"above\", \"model\": \"slab.obj\", \"scale\": $scale}],"
    echo ' "operations": ['
    for ((i = 1; i <= $3; ++i)); do
      printf ' {"op": "put", "object": "above", "position": [0.0%d, 0.0%d, 0.2], "rotation": [1, 0.0%d, 0.02, 0.0%d]}%s\n' \
        $((i % 9)) $((i * 3 % 9)) $((i % 7)) $((i % 5)) "$([ "$i" = "$3" ] || echo ,)"
    done
    echo ']}'
  } >"$1/layout.json"
}

# True if the GPU is twice as fast as BVHs.
gpu_wins() {  # COLUMN
  local kind name half
  for kind in fall turn; do
    name="${taken["$kind $1"]}"
    case "$name" in gpu*) ;; *) return 1 ;; esac
    half="$(printf '%s\n%s\n' "${expected["$kind $1 $name"]}" "${expected["$kind $1 bvh"]}" | {
      read -r a; read -r b; a="$(printf '%.0f' "${a}e4")" b="$(printf '%.0f' "${b}e4")"; echo $((2 * a <= b)); })"
    [ "$half" = 1 ] || return 1
  done
}

# A layout by each backend: the same bytes; auto asks the GPU where it is twice as fast, and none without hardware.
gpu_ways=("framebuffer" "compute")
ways=("bvh" "auto" "software" "${gpu_ways[@]}")
check_layout() {  # NAME COLUMN COMMAND...
  local name="$1" column="$2" way hashes="" failed=0 found from count
  shift 2
  for way in "${ways[@]}"; do
    from="$(now_ms)"
    # shellcheck disable=SC2086
    if ! timeout "$((12 * minutes))" "$kit/bin/trivet" "$@" -o "$work/s.glb" --report "$work/r.json" --detector $way >/dev/null 2>"$work/why"; then
      say "FAILED: $name by $way: $(tail -n 1 "$work/why")"; failed=1; continue
    fi
    cell["$name, ms|$way"]=$(($(now_ms) - from))
    for count in queries early_queries draws read_backs; do
      if [ "$(number_in draws "$work/r.json")" -gt 0 ]; then cell["$name, ${count//_/ }|$way"]="$(number_in $count "$work/r.json")"; fi
    done
    hashes+="$(sha256sum <"$work/s.glb")"$'\n'
    found="$(sed -n 's/^ *"backend": "\(.*\)".*/\1/p' "$work/r.json")"
    echo "$name by $way: $found, $(sha256sum <"$work/s.glb" | cut -c 1-16)" >>"$out/auto.txt"
    if [ "$way" = auto ]; then
      case "$found" in
        *gpu*) if [ "$hardware" = 0 ]; then say "FAILED: $name by auto: $found"; failed=1; fi ;;
        *) if gpu_wins "$column"; then say "FAILED: $name by auto: $found, where the GPU is twice as fast"; failed=1; fi ;;
      esac
      say "$name by auto: $found"
    fi
  done
  [ "$(printf '%s' "$hashes" | sort -u | wc -l)" = 1 ] || { say "FAILED: $name: scenes differ, see auto.txt"; failed=1; }
  return $failed
}

check_layouts() {
  local failed=0 n
  : >"$out/auto.txt"
  check_layout "SPOON-SAUCER" 1K demo spoon-saucer || failed=1
  check_layout "BREAKFAST" 1K demo breakfast || failed=1
  for n in "60 15K" "193 150K"; do
    slab_layout "$work/slabs" "${n% *}" 8
    if [ "${n#* }" = 150K ]; then  # minutes without hardware
      ways=("bvh" "auto")
      if [ "$hardware" = 1 ]; then ways+=("${gpu_ways[@]}"); fi
    fi
    check_layout "slabs of ${n#* } triangles" "${n#* }" run "$work/slabs/layout.json" || failed=1
  done
  return $failed
}
