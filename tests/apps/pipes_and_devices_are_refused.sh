# What has no end, or never answers, is refused at once, wherever a file is read.
. "$(dirname "$0")/common.sh"
rooms a.pgm
mkfifo pipe pipe.yaml
ln -s /dev/zero zero.yaml

# refused CODE TEXT ARGUMENTS...
refused() {
  local code=$1 text=$2
  shift 2
  expect "$code" timeout 60 "$roomgraph" "$@"
  one_line err "$text"
}
for file in pipe pipe.yaml zero.yaml; do
  refused 1 $file extract $file -o o
  refused 1 $file info $file
  refused 1 $file score-rooms a.pgm $file
  refused 1 $file stability $file -o o
  refused 1 $file compare a.pgm a.pgm --names $file -o o
  refused 2 $file extract a.pgm --config $file -o o
done
refused 1 'pipe: is not a regular file' archive pipe list
refused 1 'pipe: is not a regular file' archive pipe add a.pgm
printf 'image: pipe\nresolution: 0.05\norigin: [0, 0, 0]\noccupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n' > b.yaml
refused 1 pipe extract b.yaml -o o
refused 1 "''" extract '' -o o

# Whatever lies in the cache's folder.
expect 0 "$roomgraph" compare a.pgm a.pgm -o o --cache cache
cp -r o before
for pair in cache/*.pair; do
  rm "$pair"
  mkfifo "$pair"
done
expect 0 timeout 60 "$roomgraph" compare a.pgm a.pgm -o o --cache cache
diff -r o before
