# The oldest and the newest Clang here, by their numbers; empty without any. Read by scripts with `source`.
mapfile -t clang_versions < <(compgen -c clang++- | sed -n 's/^clang++-\([0-9]*\)$/\1/p' | sort -nu)
oldest_clang=${clang_versions[0]-}
newest_clang=
[[ ${#clang_versions[@]} -eq 0 ]] || newest_clang=${clang_versions[-1]}
