#!/usr/bin/env bash
# A relocatable folder: no library of it is looked for outside, and it has no path of this machine.
#   relocatable.sh FOLDER SOURCE_DIR BUILD_DIR
set -euo pipefail
folder="$1" source_dir="$2" build="$3"
fail() {
  echo "FAILED: $*"
  exit 1
}
system='^(linux-vdso|ld-linux.*|lib(c|m|dl|pthread|rt|stdc\+\+|gcc_s))\.so\.'
lib="$(realpath "$folder/lib")"
count=0
for file in "$folder"/libexec/* "$folder"/lib/*.so*; do
  count=$((count + 1))
  path="$(readelf -d "$file" | sed -n 's/.*R[UN]*PATH.*\[\(.*\)\]/\1/p')"
  [[ "$path" =~ ^\$ORIGIN/(\.|\.\./lib)$ ]] || fail "$file looks for libraries in '$path'"
  while read -r name place; do
    [[ "$name" =~ $system || "$(realpath "$place")" == "$lib"/* ]] || fail "$file takes $name from $place"
  done < <(ldd "$file" | sed -n 's/^[[:space:]]*\([^ ]*\) => \([^ ]*\).*/\1 \2/p')
done
[ $count -gt 20 ] || fail "only $count programs and libraries in $folder"
# Builds with line numbers name their sources in assertions.
if grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=Release' "$build/CMakeCache.txt" && grep -rlF "$source_dir" "$folder"; then
  fail "these files have paths of this machine"
fi
[ -z "$(find "$folder" -type l -lname '/*')" ] || fail "links that are not relative"
echo "relocatable: $count programs and libraries"
