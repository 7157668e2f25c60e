# A fleet's plan gives the same bytes one task after the other, with GNU parallel and on a Slurm
# cluster one node of which dies at work; a damaged map costs itself alone, and the next night only
# what is new. Needs GNU parallel and, for Slurm, root: what cannot be run is skipped with 77.
. "$(dirname "$0")/common.sh"
share=$source_dir/share/roomgraph
command -v parallel > /dev/null || { echo "skipped: there is no GNU parallel"; exit 77; }

# Forty sites of three runs each: two rooms as three drives have drawn them, another width for each site.
mkdir maps bin
echo site,file,robot,time > list.csv
for site in $(seq 40); do
  for night in 1 2 3; do
    rooms room.pgm $((160 + site)) "$site$night"
    { printf 'P5\n# site %d night %d\n' "$site" "$night"; tail -n +2 room.pgm; } \
      > "maps/s$site-$night.pgm"
    echo "site$site,maps/s$site-$night.pgm,anna,2026-11-0$night" >> list.csv
  done
done
# Of the last site, one file ends in the middle.
head -c 3000 maps/s40-3.pgm > cut.pgm
mv cut.pgm maps/s40-3.pgm
results() { (cd "$1/results" && find . -name '*.json' | sort | xargs sha256sum); }
runs() { sqlite3 "$1" 'SELECT site, sha256, robot, time, state, reason FROM run ORDER BY 1, 2'; }
damage() { grep -q "site40: .*s40-3.pgm: .*cut short" "$1" || { cat "$1"; fail "no damage in $1"; }; }

# One after the other.
expect 0 "$roomgraph" plan list.csv --archive serial.db -o serial --resolution 0.05
grep -qx '40 tasks for 120 new runs (of 120 listed)' out || { cat out; fail "another plan"; }
expect 1 "$roomgraph" task serial 1 40
one_line err s40-3.pgm
expect 2 "$roomgraph" task serial 41
results serial > serial.results
[ "$(wc -l < serial.results)" = 40 ] || fail "not forty results"
expect 1 "$roomgraph" collect serial --archive serial.db
grep -qx '39 of 40 tasks are done, 119 runs are new in the archive' out || { cat out; fail "collected"; }
damage err
runs serial.db > serial.runs
# What is done is not done again, and collected once.
touch -d 2001-01-01 serial/results/*/comparison.json
expect 1 "$roomgraph" task serial 1 40
[ "$(find serial/results -name comparison.json -newermt 2001-01-02 | wc -l)" = 0 ] || fail "done twice"
expect 1 "$roomgraph" collect serial --archive serial.db
runs serial.db | cmp - serial.runs
# But a result that was cut since is.
result=$(find serial/results -name comparison.json | sort | head -1)
cp "$result" whole.json
head -c 300 whole.json > "$result"
expect 1 "$roomgraph" task serial 1 40
cmp "$result" whole.json || fail "a result that was cut stays so"
# Options of one's own are not replaced.
mkdir own
"$roomgraph" config > own/options.ini
cp own/options.ini own.ini
for config in "" "--config own/options.ini"; do
  expect 2 "$roomgraph" plan list.csv --archive own.db -o own $config
  one_line err "own/options.ini: would replace a file"
  cmp own/options.ini own.ini
done

# The next night: one new run is one task, for its site alone, and the map that was mended another.
{ printf 'P5\n# site 3 night 4\n'; rooms room.pgm 163 34; tail -n +2 room.pgm; } > maps/s3-4.pgm
echo "site3,maps/s3-4.pgm,anna,2026-11-04" >> list.csv
expect 0 "$roomgraph" plan list.csv --archive serial.db -o second --resolution 0.05
grep -qx '2 tasks for 2 new runs (of 121 listed)' out || { cat out; fail "another plan"; }
grep -q '"site":"site3".*"new":1.*s3-4.*s3-1.*s3-2.*s3-3' second/tasks.jsonl || fail "another task"
sed -i '$d' list.csv
# A plan of other options, or of files that have changed since, is not done.
sed -i 's/^resolution = .*/resolution = 0.06/' second/options.ini
expect 1 "$roomgraph" task second 1
one_line err "other options"

ln -s "$roomgraph" bin/roomgraph
PATH=$PWD/bin:$PATH

# A file that cannot even be read is in no task: what ends the night names it, and does the rest. Its
# name comes back each night until the file is there or off the list.
head -n 4 list.csv > short.csv
for night in 4 5; do
  { printf 'P5\n# site 1 night %d\n' $night; rooms room.pgm 161 "1$night"; tail -n +2 room.pgm; } > maps/s1-$night.pgm
  echo "site1,maps/s1-$night.pgm,anna,2026-11-0$night" >> short.csv
done
echo site1,maps/none.pgm,anna,2026-11-06 >> short.csv
expect 1 "$roomgraph" plan short.csv --archive short.db -o short --resolution 0.05
grep -qx '1 task for 5 new runs (of 6 listed)' out || { cat out; fail "another plan"; }
one_line err "site1: " maps/none.pgm "no such file"
cp err plan.err
expect 0 "$roomgraph" task short 1
expect 1 "$roomgraph" collect short --archive short.db
grep -qx '1 of 1 task is done, 5 runs are new in the archive' out || { cat out; fail "collected"; }
cmp err plan.err
expect 1 "$share/parallel/night" short.csv short.db short --resolution 0.05
grep -q "site1: .*maps/none.pgm: " err || { cat err; fail "the night does not name the file"; }
sed -i '$d' short.csv
expect 0 "$share/parallel/night" short.csv short.db short --resolution 0.05
[ ! -s err ] || { cat err; fail "a good night complains"; }
# An alarm ends the night with another code: here by hand, as if five nights had been bad.
sqlite3 short.db "UPDATE figure SET value = 2 WHERE name = 'map_error_m'"
expect 3 "$share/parallel/night" short.csv short.db short --resolution 0.05
one_line err "above the limit of 0.30 m"

# With GNU parallel.
expect 1 "$share/parallel/night" list.csv parallel.db parallel --resolution 0.05
damage err
results parallel | cmp - serial.results
grep -q '<p class="counts">40 sites, 40 robots, 119 runs' parallel/fleet.html || fail "no page"
runs parallel.db | cmp - serial.runs
echo place,map > no_columns.csv
expect 1 "$share/parallel/night" no_columns.csv parallel.db parallel
one_line err no_columns.csv "columns"

# On Slurm, two nodes on this machine.
missing=
for program in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v $program > /dev/null || missing="$missing $program"
done
[ -z "$missing" ] || { echo "skipped: there is no$missing"; exit 77; }
[ "$(id -u)" = 0 ] || { echo "skipped: only root can start Slurm"; exit 77; }
PATH=$PATH:/usr/sbin
mkdir slurm
cd slurm
started=()
stop() {
  [ ${#started[@]} -eq 0 ] || kill -KILL "${started[@]}" 2> /dev/null || true
  rm -rf "$work"
}
trap stop EXIT
# free COUNT: ports of this machine that nobody listens on.
free() {
  python3 -c "
import socket
sockets = [socket.socket() for _ in range($1)]
for one in sockets: one.bind(('127.0.0.1', 0))
print(*(one.getsockname()[1] for one in sockets))"
}
read -r control first second < <(free 3)
host=$(hostname -s)
head -c 1024 /dev/urandom > key
chmod 400 key
cat > slurm.conf <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$control
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$PWD/munge.socket
CredType=cred/munge
StateSaveLocation=$PWD/state
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmctldLogFile=$PWD/slurmctld.log
SlurmdPidFile=$PWD/%n.pid
SlurmdSpoolDir=$PWD/%n
SlurmdLogFile=$PWD/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MinJobAge=300
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$first CPUs=2 RealMemory=500
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$second CPUs=2 RealMemory=500
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=10 State=UP
END
echo CgroupPlugin=cgroup/v1 > cgroup.conf
mkdir state
export SLURM_CONF=$PWD/slurm.conf
# start PROGRAM...: in the background, to be stopped at the end.
start() { "$@" > "$(basename "$1").out" 2>&1 & started+=($!); }
start munged --foreground --force --key-file="$PWD/key" --socket="$PWD/munge.socket" \
  --pid-file="$PWD/munged.pid" --log-file="$PWD/munged.log" --seed-file="$PWD/munged.seed"
# until_true COMMAND...: two minutes at most.
until_true() {
  timeout 120 bash -c 'until "$@" > /dev/null 2>&1; do sleep 0.2; done' - "$@" || {
    tail -n 5 ./*.log ./*.out >&2
    fail "waited in vain for: $*"
  }
}
until_true test -S munge.socket
start slurmctld -D
start slurmd -D -N n1
start slurmd -D -N n2
second_node=${started[-1]}
until_true bash -c '[ "$(sinfo -h -t idle -o %D)" = 2 ]'
cd ..
# The second node takes tasks and never ends them: its machine is about to die.
rm bin/roomgraph
cat > bin/roomgraph <<END
#!/bin/bash
if [ "\${SLURMD_NODENAME-}" = n2 ]; then
  echo \$PPID \$\$ >> "$work/hanging"
  exec sleep 10000
fi
exec "$roomgraph" "\$@"
END
chmod +x bin/roomgraph
{ code=0
  WAIT=1 "$share/slurm/night" list.csv slurm.db slurm-run --resolution 0.05 > night.out 2>&1 || code=$?
  echo $code > night.code; } &
night=$!
cd slurm
until_true test -s ../hanging
kill -KILL "$second_node"
while read -r watcher task; do kill -KILL "$watcher" "$task" 2> /dev/null || true; done < ../hanging
scontrol update nodename=n2 state=down reason=died
cd ..
# Slurm lets such tasks wait for two minutes before it starts them again.
until_true bash -c "
  for task in \$(squeue -h -r -t PD -n roomgraph -o %i); do
    scontrol update jobid=\$task starttime=now
  done
  [ -s night.code ]"
wait $night
[ "$(cat night.code)" = 1 ] || { cat night.out slurm-run/log/*; fail "night ended with $(cat night.code)"; }
damage slurm-run/log/collect.txt
results slurm-run | cmp - serial.results
runs slurm.db | cmp - serial.runs
cmp slurm-run/fleet.html parallel/fleet.html
# A night without a new run has its page and its alarm, too, in a folder that is not there yet.
expect 3 env WAIT=1 "$share/slurm/night" short.csv short.db new/quiet --resolution 0.05
[ -s new/quiet/fleet.html ] || fail "a night without news has no page"
