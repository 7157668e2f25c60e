# The installed ini file shows the program's real defaults, and the program reads it.
. "$(dirname "$0")/common.sh"
"$roomgraph" config > default.ini
cmp default.ini "$source_dir/share/roomgraph/config_files/default.ini" ||
  fail "run scripts/generate to bring share/roomgraph/config_files/default.ini up to date"
"$roomgraph" config --config default.ini | cmp - default.ini
if "$roomgraph" config --preset paper | cmp -s - default.ini; then
  fail "the presets do not differ"
fi
