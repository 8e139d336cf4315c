#!/usr/bin/env bash
# Packs what measures Trivet on a machine with a GPU: program, tests of the GPU, benchmarks, and their libraries.
#   perf/kit/pack.sh BUILD OUT.tar.gz
# BUILD: configured as perf/README.md says, without the libraries that are only compared with; trivet, trivet-import, trivet_perf and
# test_gpu_* are built.
# Programs and libraries are in payload.tar.xz, which gzip alone would not bring below 64 MiB; run.sh unpacks it by the xz that is beside it,
# so that the machine needs none.
# Left out: glibc with its loader, and the drivers of EGL and OpenGL; both must be those of the machine. In lib/machine are
# libraries that its drivers may use, too, and GLVND's loaders: they are taken only where the machine has none (or an older libstdc++).
set -euo pipefail
build="$1" out="$(realpath -m "$2")"
here="$(dirname "$(readlink -f "$0")")"
case "$out" in
  *.tar.gz) ;;
  *) echo "pack.sh: $out is not accepted; accepted: a name that ends in .tar.gz" >&2; exit 2 ;;
esac
xz="$(command -v xz)" || { echo "xz is missing: install xz-utils" >&2; exit 2; }
most_bytes=$((64 << 20))
work="$(mktemp -d)"; trap 'rm -rf "$work"' EXIT
root="$work/trivet-kit"; mkdir -p "$root/bin" "$root/lib/machine"

glibc='^(ld-linux.*|libc|libm|libdl|libpthread|librt|libresolv|libutil|libanl|libmvec|libnsl)\.so'
driver='^(libEGL|libGL|libgbm|libdrm|libX|libxcb|libwayland|libLLVM)'
shared='^(libstdc\+\+|libgcc_s|libz|libzstd|liblzma|libbz2|libexpat|libxml2|libffi|libedit|libtinfo|libicu.*|libbsd|libmd)\.so'
glvnd="libEGL.so.1 libOpenGL.so.0 libGLdispatch.so.0"

for program in apps/trivet apps/trivet-import perf/trivet_perf; do
  [ -x "$build/$program" ] || { echo "$build/$program is missing: build it with -DTRIVET_PERF=ON" >&2; exit 2; }
  install -s -m 755 "$build/$program" "$root/bin/"
done
found=0
for test in "$build"/tests/test_gpu_*; do
  if [ -f "$test" ] && [ -x "$test" ]; then install -s -m 755 "$test" "$root/bin/"; found=1; fi
done
[ $found = 1 ] || { echo "$build/tests/test_gpu_* are missing: build them" >&2; exit 2; }

{ ldd "$root"/bin/*; ldd "$build"/apps/python/trivet/*.so 2>/dev/null || true; } | sed -n 's/^[[:space:]]*\([^ ]*\) => \(\/[^ ]*\) .*/\1 \2/p' | sort -u | while read -r name path; do
  if [[ $name =~ $glibc || $name =~ $driver ]]; then continue; fi
  folder=lib; if [[ $name =~ $shared ]]; then folder=lib/machine; fi
  install -m 644 "$(readlink -f "$path")" "$root/$folder/$name"
done
for name in $glvnd; do
  path="$(ldconfig -p | sed -n "s/^[[:space:]]*$name (libc6,x86-64.*) => //p" | head -n 1)"
  [ -n "$path" ] || { echo "$name is missing: install libegl1 and libopengl0" >&2; exit 2; }
  install -m 644 "$(readlink -f "$path")" "$root/lib/machine/$name"
done
find "$root/lib" -type f -exec strip --strip-unneeded {} +
# The newest symbols that are needed, for a clear message on older systems.
newest() { objdump -T "$root"/bin/* "$root"/lib/*.so* "$root"/lib/machine/* 2>/dev/null | grep -o "$1[0-9.]*[0-9]" | sort -uV | tail -n 1; }
printf '%s\n%s\n' "$(newest GLIBC_2)" "$(newest GLIBCXX_3)" >"$root/NEEDS"
git -C "$here" describe --always --dirty >"$root/COMMIT" 2>/dev/null || echo unknown >"$root/COMMIT"
install -m 755 "$here/run.sh" "$root/run.sh"
install -m 644 "$here/check_auto.sh" "$here/ways.sh" "$here/../../apps/farm/examples/breakfast.json" "$root/"
if [ -f "$build/apps/python/trivet/__init__.py" ]; then  # configured with Python's package
  mkdir -p "$root/python" && cp -r "$build/apps/python/trivet" "$root/python/"
  printf '"""Programs of the kit."""\nIMPORTER = "../../bin/trivet-import"\n' >"$root/python/trivet/_paths.py"
  find "$root/python" -name '*.so' -exec strip --strip-unneeded {} +
fi

unpacked="$(du -sk "$root" | cut -f1)"
in_order() { tar --sort=name --owner=0 --group=0 --numeric-owner --mtime=@0 "$@"; }
in_order -C "$root" -cf - bin lib $(cd "$root" && ls -d python 2>/dev/null) | "$xz" -6 >"$root/payload.tar.xz"
rm -rf "$root/bin" "$root/lib" "$root/python"
mkdir "$root/unpack"
install -m 755 "$(readlink -f "$xz")" "$root/unpack/xz"
install -m 644 "$(readlink -f "$(ldd "$xz" | sed -n 's/^.*liblzma.* => \(\/[^ ]*\) .*/\1/p')")" "$root/unpack/liblzma.so.5"
in_order -C "$work" -cf - trivet-kit | gzip -9n >"$out.part"
bytes="$(stat -c %s "$out.part")"
[ "$bytes" -lt $most_bytes ] || { rm "$out.part"; echo "$((bytes >> 10)) KiB, larger than 64 MiB: leave out libraries (see docs/measurements/zlists.md)" >&2; exit 1; }
mv "$out.part" "$out"
echo "$out: $((bytes >> 10)) KiB packed, $unpacked KiB unpacked; needs $(tr '\n' ' ' <"$root/NEEDS")"
