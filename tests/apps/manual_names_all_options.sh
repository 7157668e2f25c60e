# The manual page and the completion name all commands and options that the help names.
. "$(dirname "$0")/common.sh"
bash "$source_dir/apps/roomgraph/write_manual.sh" "$roomgraph" manual
. manual/roomgraph

# completed WORD...: what bash offers for the last word, one a line.
completed() {
  COMP_WORDS=(roomgraph "$@") COMP_CWORD=$#
  _roomgraph
  [ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\n' "${COMPREPLY[@]}"
}
[ "$(completed ext)" = extract ] || fail "'ext' is not completed"
[ "$(completed extract --res)" = --resolution ] || fail "'--res' is not completed"
[ -z "$(completed extract map)" ] || fail "words are offered in place of files"

mapfile -t commands < <("$roomgraph" --help | sed -n '/^Subcommands:/,$ s/^  \([a-z-]*\) .*/\1/p')
[ "${#commands[@]}" -ge 6 ] || fail "the help has ${#commands[@]} commands"
for command in "${commands[@]}"; do
  grep -q "^\.SS ${command//-/\\\\-}$" manual/roomgraph.1 || fail "$command is not in the manual"
  "$roomgraph" "$command" --help > help
  for sub in $(sed -n '/^Subcommands:/,$ s/^  \([a-z-]*\) .*/\1/p' help); do
    "$roomgraph" "$command" FILE "$sub" --help >> help
  done
  sed -n 's/^  \(-[a-z],\)\?\(--[a-z0-9-]*\).*/\2/p' help | sort -u > named
  completed "$command" -- | sort -u | diff named - || fail "options of $command are not completed"
  while read -r option; do
    grep -q "from $command' -l ${option#--} .*-d '[A-Z].*'" manual/roomgraph.fish ||
      fail "fish has no sentence for $command $option"
  done < named
done
if command -v man > /dev/null; then
  man -l --warnings manual/roomgraph.1 > /dev/null 2> warnings
  [ ! -s warnings ] || { cat warnings >&2; fail "the manual is not well formed"; }
fi
if command -v zsh > /dev/null; then zsh -n manual/_roomgraph; fi
