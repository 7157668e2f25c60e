#!/bin/bash
# write_manual.sh PROGRAM FOLDER: the manual page, and completion for bash, zsh and fish, from the
# program's own help, into FOLDER: roomgraph.1, roomgraph, _roomgraph and roomgraph.fish.
set -euo pipefail
program=$1 folder=$2
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

help() { "$program" "$@" --help; }
version=$("$program" --version)
help > "$work/all"
# "  extract    Read maps ..." below "Subcommands:".
sed -n '/^Subcommands:/,$ s/^  \([a-z-]*\)  *\(.*\)$/\1\t\2/p' "$work/all" > "$work/commands"
cut -f 1 "$work/commands" > "$work/names"
# subcommands FILE: the names in a help, a line each.
subcommands() { sed -n '/^Subcommands:/,$ s/^  \([a-z-]*\) .*/\1/p' "$1"; }
# The help of a command, and those of its own commands, which follow a file: archive FILE add.
while read -r command; do
  help "$command" > "$work/$command.help"
  for sub in $(subcommands "$work/$command.help"); do
    { echo; help "$command" FILE "$sub"; } >> "$work/$command.help"
  done
done < "$work/names"

# options FILE: a line for each option: long name, letter or nothing, sentence, between tabs. The
# sentence stands behind the option from column 31 on, or on the next line.
options() {
  awk '
    function put() {
      sub(/[;.:] .*/, "", sentence); sub(/\.$/, "", sentence)
      if (name != "") print name "\t" letter "\t" sentence
      name = ""
    }
    /^  -/ {
      put()
      letter = $1 ~ /^-[A-Za-z],/ ? substr($1, 2, 1) : ""
      name = $1; sub(/^-[A-Za-z],/, "", name); sub(/^--/, "", name)
      sentence = substr($0, 31)
      next
    }
    substr($0, 1, 30) ~ /^ +$/ { sentence = substr($0, 31) }
    END { put() }' "$1"
}

manual() {
  local command sentence
  printf '.TH ROOMGRAPH 1 "" "roomgraph %s" "User Commands"\n' "$version"
  printf '.SH NAME\nroomgraph \\- rooms and paths of 2D grid maps\n'
  printf '.SH SYNOPSIS\n.B roomgraph\n.I COMMAND\n[\n.I OPTIONS\n]\n.I FILE...\n'
  printf '.SH DESCRIPTION\n%s\n' "$(head -n 1 "$work/all")"
  printf 'Each command tells its options with\n.BR \\-\\-help .\n'
  printf '.SH COMMANDS\n'
  while IFS=$'\t' read -r command sentence; do
    printf '.SS %s\n%s\n.PP\n.nf\n' "${command//-/\\-}" "$sentence"
    tail -n +2 "$work/$command.help" | fold -s -w 76 |
      sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"
    printf '.fi\n'
  done < "$work/commands"
  printf '.SH EXIT STATUS\n0: done. 1: data that cannot be used. 2: a call that makes no sense.\n'
  printf '3: a gate of compare strikes.\n'
}

# case_of_options COMMAND-VARIABLE: sets `words` to what may follow, in bash and zsh.
case_of_options() {
  local command
  printf '  case %s in\n' "$1"
  while read -r command; do
    printf "    %s) words='%s' ;;\n" "$command" \
      "$(options "$work/$command.help" | cut -f 1 | sed 's/^/--/' | tr '\n' ' ')"
  done < "$work/names"
  printf "    *) words='%s --help --version' ;;\n  esac\n" "$(tr '\n' ' ' < "$work/names")"
}

bash_completion() {
  printf '# bash completion for roomgraph\n_roomgraph() {\n'
  printf "  local current=\${COMP_WORDS[COMP_CWORD]} words\n"
  case_of_options "\"\${COMP_WORDS[1]}\""
  cat <<'END'
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ] || [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}
complete -o default -F _roomgraph roomgraph
END
}

zsh_completion() {
  printf '#compdef roomgraph\nlocal words\n'
  # shellcheck disable=SC2016
  printf 'local first=${(Q)${(z)BUFFER}[2]}\n'
  case_of_options '"$first"'
  cat <<'END'
if (( CURRENT == 2 )) || [[ $PREFIX == -* ]]; then
  compadd -- ${=words}
else
  _files
fi
END
}

fish_completion() {
  local command sentence name letter
  printf '# fish completion for roomgraph\n'
  while IFS=$'\t' read -r command sentence; do
    printf "complete -c roomgraph -n __fish_use_subcommand -a %s -d '%s'\n" "$command" \
      "${sentence//\'/\\\'}"
    options "$work/$command.help" | tr '\t' '|' | while IFS='|' read -r name letter sentence; do
      printf "complete -c roomgraph -n '__fish_seen_subcommand_from %s' -l %s %s-d '%s'\n" \
        "$command" "$name" "${letter:+-s $letter }" "${sentence//\'/\\\'}"
    done
  done < "$work/commands"
}

manual > "$folder/roomgraph.1"
bash_completion > "$folder/roomgraph"
zsh_completion > "$folder/_roomgraph"
fish_completion > "$folder/roomgraph.fish"
