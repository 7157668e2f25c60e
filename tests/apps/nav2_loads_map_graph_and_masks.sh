# What share/roomgraph/nav2 launches finds the files that `roomgraph extract` writes, as nav2 reads them.
. "$(dirname "$0")/common.sh"
nav2=$source_dir/share/roomgraph/nav2
expect 0 "$roomgraph" convert "$source_dir/share/roomgraph/maps/office.gridmap.gz" -o . --format ros
expect 0 "$roomgraph" extract office.yaml --format geojson,keepout,speed --keep-out R0 -o results

# Stand-ins for ROS: they keep what is started.
mkdir -p ros/launch ros/launch_ros
cat > ros/launch/__init__.py <<'P'
def LaunchDescription(actions): return actions
P
cat > ros/launch/actions.py <<'P'
def DeclareLaunchArgument(name, **about): return name
def OpaqueFunction(function): return function
P
cat > ros/launch/substitutions.py <<'P'
class LaunchConfiguration:
  def __init__(self, name): self.name = name
  def perform(self, context): return context[self.name]
P
: > ros/launch_ros/__init__.py
cat > ros/launch_ros/actions.py <<'P'
def Node(**about): return about
P
PYTHONPATH=ros python3 - "$nav2" <<'P' || fail "nav2 would not load it"
import os, re, runpy, sys
folder = sys.argv[1]
actions = runpy.run_path(folder + "/roomgraph.launch.py")["generate_launch_description"]()
nodes = actions[-1]({"map": "office.yaml", "results": "results"})
manager = nodes.pop()
assert manager["parameters"][0]["node_names"] == [node["name"] for node in nodes]
assert len(nodes) == 6
for node in nodes:
  for parameters in node["parameters"]:
    if isinstance(parameters, str):  # of the node by its name
      assert re.search("^" + node["name"] + ":$", open(parameters).read(), re.M), node["name"]
    else:
      for path in parameters.values(): assert os.path.isabs(path) and os.path.getsize(path), path
# What each server says of its mask is where the other one publishes it.
masks = open(folder + "/masks.yaml").read()
for kind in ("keepout", "speed"):
  assert masks.count('mask_topic: "%s_mask"' % kind) == 1
  assert masks.count('topic_name: "%s_mask"' % kind) == 1
P
cat results/office.keepout.yaml results/office.speed.yaml > yamls
for line in 'image: "office.keepout.png"' 'mode: trinary' 'image: "office.speed.png"' 'mode: scale' \
  'occupied_thresh: 1.0' 'free_thresh: 0.0'; do
  grep -qx "$line" yamls || fail "no '$line'"
done
cmp <(grep -E '^(resolution|origin)' office.yaml) \
  <(grep -E '^(resolution|origin)' results/office.keepout.yaml) || fail "the mask lies elsewhere"

# Rooms that are not there, and what is no room.
expect 1 "$roomgraph" extract office.yaml --format keepout --keep-out R99 -o results
one_line err office.yaml R99
expect 2 "$roomgraph" extract office.yaml --format keepout --keep-out kitchen -o results
one_line err kitchen
expect 2 "$roomgraph" extract office.yaml --format json --keep-out R0 -o results
one_line err keepout
