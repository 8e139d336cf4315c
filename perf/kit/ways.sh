# Batches and Python by each detector, and the tables of all ways: sourced by run.sh. Uses kit, out, work, hardware, minutes, say, left.
# shellcheck shell=bash disable=SC2154

all_ways=(bvh software framebuffer compute auto)
declare -A cell  # by "work|detector": what the table says

now_ms() { echo $(($(date +%s%N) / 1000000)); }
number_in() { sed -n "s/.*\"$1\": *\([0-9]*\).*/\1/p" "$2" | head -n 1; }  # KEY FILE

# Scenes like BREAKFAST, two workers, and one without hardware: the same units by all; queries share draws.
check_batch() {
  local way count="$1" hashes="" failed=0 from found draws asked
  "$kit/bin/trivet" demo breakfast -o "$work/b.glb" --export "$work/models" --quiet >/dev/null 2>&1 || { say "FAILED: no models for a batch"; return 1; }
  cp "$kit/breakfast.json" "$work/models/"
  for way in "${all_ways[@]}"; do
    from="$(now_ms)"
    if ! timeout "$(($(left) < 20 * minutes ? $(left) : 20 * minutes))" "$kit/bin/trivet" batch "$work/models/breakfast.json" --count "$count" --per-tar "$count" \
      --jobs $((1 + hardware)) --out "$work/batch-$way" --detector "$way" --json --quiet >"$work/batch.json" 2>"$work/why"; then
      say "FAILED: a batch by $way: $(tail -n 1 "$work/why")"; failed=1; continue
    fi
    found=$(($(now_ms) - from)) draws="$(number_in draws "$work/batch.json")"
    cell["batch, ms a scene|$way"]=$((found / count))
    if [ "${draws:-0}" -gt 0 ]; then
      asked=$((10 * ($(number_in queries "$work/batch.json") + $(number_in early_queries "$work/batch.json")) / draws))
      cell["batch, queries a draw|$way"]="$((asked / 10)).$((asked % 10))"
      cell["batch, read-backs a scene|$way"]="$(($(number_in read_backs "$work/batch.json") / count))"
    fi
    hashes+="$(cd "$work/batch-$way" && cat 0000/*.tar | sha256sum)"$'\n'
  done
  [ "$(printf '%s' "$hashes" | sort -u | wc -l)" = 1 ] || { say "FAILED: units of batches differ"; failed=1; }
  say "batch of $count scenes by ${all_ways[*]}: $([ $failed = 0 ] && echo "the same bytes" || echo FAILED)"
  return $failed
}

# The module in the machine's own Python, where that loads it.
check_python() {
  local way from hashes="" failed=0
  if [ ! -d "$kit/python" ] || ! PYTHONPATH="$kit/python" python3 -c "import trivet" 2>"$work/why"; then
    say "Python: left out, $([ -d "$kit/python" ] && tail -n 1 "$work/why" || echo "the kit has no module")"
    return 0
  fi
  for way in "${all_ways[@]}"; do
    from="$(now_ms)"
    hashes+="$(PYTHONPATH="$kit/python" timeout "$((10 * minutes))" python3 - "$way" "$work/models" 2>"$work/why" <<'END' || echo "$way: $(tail -n 1 "$work/why")"
import hashlib, sys, trivet
scene = trivet.Scene(detector=sys.argv[1])
for i, name in enumerate(("plate", "bowl", "apple", "cup", "toast")):
    scene.add(name, trivet.Shape.load(f"{sys.argv[2]}/{name}.glb")).put([0.01 * i, 0.02 * i, 0.3 + 0.2 * i])
print(hashlib.sha256(b"".join(one.pose.tobytes() for one in scene)).hexdigest())
END
)"$'\n'
    cell["Python, ms|$way"]=$(($(now_ms) - from))
  done
  [ "$(printf '%s' "$hashes" | sort -u | wc -l)" = 1 ] || { say "FAILED: Python: $(printf '%s' "$hashes" | sort -u | tr '\n' ' ')"; failed=1; }
  say "Python by ${all_ways[*]}: $([ $failed = 0 ] && echo "the same poses" || echo FAILED)"
  return $failed
}

# The table of all work, a column for each detector.
write_table() {
  local work_name way line
  {
    echo "| $(sed -n 's/^hardware: //p;s/^no hardware renderer, allowed: //p' "$out/summary.txt" | head -n 1) | $(printf '%s | ' "${all_ways[@]}")"
    echo "|---|$(printf -- '---|%.0s' "${all_ways[@]}")"
    for work_name in "${!cell[@]}"; do echo "${work_name%%|*}"; done | sort -u | while read -r work_name; do
      line="| $work_name |"
      for way in "${all_ways[@]}"; do line+=" ${cell["$work_name|$way"]:-} |"; done
      echo "$line"
    done
  } >"$out/table.md"
  cat "$out/table.md"
}

# For people: of each work the detector that was fastest here, and how many times as long the others took.
write_which() {
  local work_name way best best_ms ms line
  {
    echo "| work, on this machine | use | $(printf '%s takes | ' "${all_ways[@]}")"
    echo "|---|---|$(printf -- '--:|%.0s' "${all_ways[@]}")"
    for work_name in "${!cell[@]}"; do echo "${work_name%%|*}"; done | grep -E ', ms( a scene)?$' | sort -u | while read -r work_name; do
      best="" best_ms=0 line=""
      for way in "${all_ways[@]}"; do
        ms="${cell["$work_name|$way"]:-}"
        if [ -n "$ms" ] && { [ -z "$best" ] || [ "$ms" -lt "$best_ms" ]; }; then best="$way" best_ms=$((ms > 0 ? ms : 1)); fi
      done
      for way in "${all_ways[@]}"; do
        ms="${cell["$work_name|$way"]:-}"
        line+=" $([ -z "$ms" ] || echo "$((ms / best_ms)).$((10 * ms / best_ms % 10)) x") |"
      done
      # `auto` where nothing is clearly faster.
      ms="${cell["$work_name|auto"]:-}"
      if [ -n "$ms" ] && [ "$ms" -le $((best_ms * 5 / 4)) ]; then best=auto; fi
      echo "| ${work_name%, ms*} | $best |$line"
    done
  } >"$out/which.md"
  cat "$out/which.md"
}
