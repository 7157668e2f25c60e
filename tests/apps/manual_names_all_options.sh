# The manual page and the completion of a program name all commands and options that its help names.
. "$(dirname "$0")/common.sh"
program=$roomgraph name=$(basename "$roomgraph")
bash "$source_dir/apps/command_line/write_manual.sh" "$program" manual
. "manual/$name"

# completed WORD...: what bash offers for the last word, one a line.
completed() {
  COMP_WORDS=("$name" "$@") COMP_CWORD=$#
  "_${name//-/_}"
  [ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\n' "${COMPREPLY[@]}"
}
# named_in FILE: the options that a help names; commands_in FILE: the commands.
named_in() { sed -n 's/^  \(-[a-z],\)\?\(--[a-z0-9-]*\).*/\2/p' "$1" | sort -u; }
commands_in() { sed -n '/^Subcommands:/,$ s/^  \([a-z][a-z-]*\) .*/\1/p' "$1"; }

# check_options FISH WORD...: those in `help` are completed behind the words, and told of in the page.
check_options() {
  local fish=$1 option
  shift
  named_in help > named
  [ -s named ] || fail "the help of $* names no option"
  completed "$@" -- | sort -u | diff named - || fail "options of $* are not completed"
  while read -r option; do
    grep -q -- "$fish-l ${option#--} .*-d '[A-Z].*'" "manual/$name.fish" ||
      fail "fish has no sentence for $* $option"
    grep -A 1 -- "^\.B .*${option//-/\\\\-}\( \|$\)" "manual/$name.1" | grep -q '^[A-Z]' ||
      fail "the manual has no sentence for $* $option"
  done < named
}

"$program" --help > all
mapfile -t commands < <(commands_in all)
if [ "$name" = roomgraph ]; then
  [ "$(completed ext)" = extract ] || fail "'ext' is not completed"
  [ "$(completed extract --res)" = --resolution ] || fail "'--res' is not completed"
  [ -z "$(completed extract map)" ] || fail "words are offered in place of files"
  [ "${#commands[@]}" -ge 6 ] || fail "the help has ${#commands[@]} commands"
else
  cp all help
  check_options "-c $name "
fi
for command in "${commands[@]}"; do
  grep -q "^\.SS ${command//-/\\\\-}$" "manual/$name.1" || fail "$command is not in the manual"
  "$program" "$command" --help > help
  for sub in $(commands_in help); do "$program" "$command" FILE "$sub" --help >> help; done
  check_options "from $command' " "$command"
done
if command -v man > /dev/null; then
  man -l --warnings "manual/$name.1" > /dev/null 2> warnings
  [ ! -s warnings ] || { cat warnings >&2; fail "the manual is not well formed"; }
fi
if command -v zsh > /dev/null; then zsh -n "manual/_$name"; fi
