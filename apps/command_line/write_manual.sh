#!/bin/bash
# write_manual.sh PROGRAM FOLDER: the manual page, and completion for bash, zsh and fish, from the
# program's own help, into FOLDER: NAME.1, NAME, _NAME and NAME.fish.
set -euo pipefail
program=$1 folder=$2
name=$(basename "$program")
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

help() { "$program" "$@" --help; }
version=$("$program" --version)
help > "$work/all"

# entries FILE: what a help lists, an entry a line: the heading it stands under, the term and its
# sentence, between tabs. Sentences begin in the column where that of --help does; in a line of their
# own behind a long term.
entries() {
  awk '
    function put() {
      if (term != "") print heading "\t" term "\t" sentence
      term = ""
    }
    /^[A-Z][a-z]*:$/ { put(); heading = substr($0, 1, length($0) - 1); next }
    /^  [^ ]/ {
      put()
      term = $0; sentence = ""
      if (substr(term, column - 1) ~ /^ [A-Z]/) {
        sentence = substr(term, column); term = substr(term, 1, column - 1)
      }
      gsub(/^ +| +$/, "", term)
      next
    }
    term != "" && /^   / { gsub(/^ +/, ""); sentence = sentence (sentence == "" ? "" : " ") $0 }
    END { put() }' column="$(awk '/^  -h,--help / { print index($0, "Print") }' "$1")" "$1"
}

# commands FILE: the commands that a help lists: name and sentence, between tabs.
commands() { entries "$1" | awk -F '\t' '$1 == "Subcommands" { print $2 "\t" $3 }'; }

# options FILE: the options that helps list: long name, letter or nothing, the first sentence.
options() {
  entries "$1" | awk -F '\t' '
    $2 ~ /^-/ {
      letter = $2 ~ /^-[A-Za-z],/ ? substr($2, 2, 1) : ""
      name = $2; sub(/^-[A-Za-z],/, "", name); sub(/^--/, "", name); sub(/ .*/, "", name)
      sentence = $3; sub(/[;.:] .*/, "", sentence); sub(/\.$/, "", sentence)
      print name "\t" letter "\t" sentence
    }'
}

commands "$work/all" > "$work/commands"
cut -f 1 "$work/commands" > "$work/names"
# The help of a command, and those of its own commands, which follow a file: archive FILE add.
while read -r command; do
  help "$command" > "$work/$command.help"
  for sub in $(commands "$work/$command.help" | cut -f 1); do
    help "$command" FILE "$sub" > "$work/$command.$sub.help"
  done
done < "$work/names"

# helps_of COMMAND: the files of its help and of those of its own commands.
helps_of() { printf '%s\n' "$work/$1.help" "$work/$1".*.help | sort -u | grep -v '\*' || true; }
options_of() { helps_of "$1" | while read -r file; do options "$file"; done | awk '!seen[$1]++'; }

# Text as roff takes it.
escaped() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"; }

# manual_of FILE: what a help tells of one command: its usage and its entries.
manual_of() {
  local heading term sentence last=
  printf '.PP\n.B %s\n' "$(sed -n 's/^Usage: //p' "$1" | escaped)"
  entries "$1" | escaped | while IFS=$'\t' read -r heading term sentence; do
    [ "$heading" != Subcommands ] || continue
    [ "$heading" = "$last" ] || printf '.PP\n%s:\n' "$heading"
    last=$heading
    printf '.TP\n.B %s\n%s\n' "$term" "$sentence"
  done
}

manual_of_commands() {
  local command sentence file
  printf '.SH COMMANDS\n'
  while IFS=$'\t' read -r command sentence; do
    printf '.SS %s\n%s\n' "${command//-/\\-}" "$(escaped <<< "$sentence")"
    helps_of "$command" | while read -r file; do manual_of "$file"; done
  done < "$work/commands"
}

manual() {
  local sentence
  sentence=$(head -n 1 "$work/all" | sed 's/\.$//')
  printf '.TH %s 1 "" "roomgraph %s" "User Commands"\n' "${name^^}" "$version"
  printf '.SH NAME\n%s \\- %s\n' "${name//-/\\-}" "$(escaped <<< "${sentence,}")"
  printf '.SH SYNOPSIS\n.B %s\n' "$(sed -n 's/^Usage: //p' "$work/all" | escaped)"
  printf '.SH DESCRIPTION\n%s.\n' "$(escaped <<< "$sentence")"
  if [ -s "$work/names" ]; then
    printf 'Each command tells its options with\n.BR \\-\\-help .\n'
    manual_of_commands
  else
    printf '.SH OPTIONS\n'
    manual_of "$work/all"
  fi
  printf '.SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\ndata that cannot be used\n.TP\n2\na wrong command line\n'
  ! grep -qs 'Exit with 3' "$work"/*.help || printf '.TP\n3\na gate fails, or an alarm is raised\n'
}

# words: the options of stdin as a completion offers them.
words() { cut -f 1 | sed 's/^/--/' | tr '\n' ' '; }

# set_words COMMAND-VARIABLE: sets `words` to what may follow, in bash and zsh.
set_words() {
  local command
  if [ ! -s "$work/names" ]; then
    printf "  words='%s'\n" "$(options "$work/all" | words)"
    return
  fi
  printf '  case %s in\n' "$1"
  while read -r command; do
    printf "    %s) words='%s' ;;\n" "$command" "$(options_of "$command" | words)"
  done < "$work/names"
  printf "    *) words='%s --help --version' ;;\n  esac\n" "$(tr '\n' ' ' < "$work/names")"
}

# The first word may be a command; all others are files unless they begin with a dash.
bash_completion() {
  local function=_${name//-/_} first=
  # shellcheck disable=SC2016
  [ ! -s "$work/names" ] || first='$COMP_CWORD -eq 1 || '
  printf '# bash completion for %s\n%s() {\n' "$name" "$function"
  printf "  local current=\${COMP_WORDS[COMP_CWORD]} words\n"
  set_words "\"\${COMP_WORDS[1]}\""
  printf '  COMPREPLY=()\n  if [[ %s$current == -* ]]; then\n' "$first"
  cat <<'END'
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
  fi
}
END
  printf 'complete -o default -F %s %s\n' "$function" "$name"
}

zsh_completion() {
  local first=
  [ ! -s "$work/names" ] || first='(( CURRENT == 2 )) || '
  printf '#compdef %s\nlocal words\n' "$name"
  # shellcheck disable=SC2016
  set_words '"${(Q)${(z)BUFFER}[2]}"'
  # shellcheck disable=SC2016
  printf 'if %s[[ $PREFIX == -* ]]; then\n' "$first"
  cat <<'END'
  compadd -- ${=words}
else
  _files
fi
END
}

# fish_options CONDITION: a line for each option that stands in stdin.
fish_options() {
  local long letter sentence
  tr '\t' '|' | while IFS='|' read -r long letter sentence; do
    printf "complete -c %s %s-l %s %s-d '%s'\n" "$name" "$1" "$long" "${letter:+-s $letter }" \
      "${sentence//\'/\\\'}"
  done
}

fish_completion() {
  local command sentence
  printf '# fish completion for %s\n' "$name"
  [ -s "$work/names" ] || options "$work/all" | fish_options ''
  while IFS=$'\t' read -r command sentence; do
    printf "complete -c %s -n __fish_use_subcommand -a %s -d '%s'\n" "$name" "$command" \
      "${sentence//\'/\\\'}"
    options_of "$command" | fish_options "-n '__fish_seen_subcommand_from $command' "
  done < "$work/commands"
}

manual > "$folder/$name.1"
bash_completion > "$folder/$name"
zsh_completion > "$folder/_$name"
fish_completion > "$folder/$name.fish"
