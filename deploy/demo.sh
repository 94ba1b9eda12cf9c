#!/usr/bin/env bash
# Builds Pelage, starts the server on a free port of this machine, grooms the built-in creature and a real model, and
# leaves pictures in out/. usage: deploy/demo.sh [--keep] [--model FILE [--up AXIS] [--front AXIS]]
set -euo pipefail
cd "$(dirname "$0")/.."

keep=no model=/usr/share/glmark2/models/horse.3ds up=y front=z
while [ $# -gt 0 ]; do
  case "$1" in
    --keep) keep=yes ;;
    --model) model=${2:?--model needs a file}; up=y; front=z; shift ;;
    --up) up=${2:?--up needs an axis}; shift ;;
    --front) front=${2:?--front needs an axis}; shift ;;
    *) echo "usage: $0 [--keep] [--model FILE [--up AXIS] [--front AXIS]]" >&2; exit 2 ;;
  esac
  shift
done

say() { echo "[$SECONDS s] $*"; }
say "1/4 packages"
deploy/packages.sh demo
say "2/4 build (a few minutes the first time)"
cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset release -j "$(nproc)" --target pelaged pelage pelage-import
bin=build/release/bin
out=out
mkdir -p $out
rm -rf $out/*.png $out/*.jsonl $out/*.json $out/data $out/port $out/server.log

say "3/4 server"
$bin/pelaged --listen 127.0.0.1:0 --port-file $out/port --data $out/data >$out/server.log 2>&1 &
server=$!
stop() { kill "$server" 2>/dev/null || true; wait "$server" 2>/dev/null || true; }
[ $keep = yes ] || trap stop EXIT
for _ in $(seq 100); do [ -s $out/port ] && break; sleep 0.1; done
if [ ! -s $out/port ]; then echo "the server did not start:" >&2; cat $out/server.log >&2; exit 1; fi
export PELAGE_SERVER=http://127.0.0.1:$(cat $out/port)
cat $out/server.log

groom() {  # NAME: draws a picture of the scene, then one after each step
  local name=$1
  $bin/pelage --json info "$name" >$out/$name.json
  python3 deploy/demo_groom.py $out/$name.json $out
  $bin/pelage frame "$name" -o "$out/$name-0-before.png" >/dev/null
  for step in 1-comb 2-blow 3-attract; do
    $bin/pelage run "$name" "$out/$step.jsonl" >/dev/null
    $bin/pelage frame "$name" -o "$out/$name-$step.png" >/dev/null
    say "    $name: $step"
  done
  $bin/pelage frame "$name" -o "$out/$name-4-detailed.png" --quality detailed >/dev/null
  $bin/pelage log "$name" --lines >"$out/$name.jsonl"
}

cat >$out/studio.jsonl <<'EOF'
{"op": "set_ground", "ground": {"visible": true}}
{"op": "set_environment", "environment": {"horizon": [0.8, 0.82, 0.85], "ground": [0.5, 0.48, 0.45], "intensity": 1.15}}
EOF
say "4/4 grooming"
$bin/pelage new --name creature >/dev/null
$bin/pelage run creature $out/studio.jsonl >/dev/null
groom creature
$bin/pelage new --name model >/dev/null
$bin/pelage load model "$model" --up="$up" --front="$front" --length 0.014 --inclination 0.75 >/dev/null
cat >$out/coat.jsonl <<'EOF'
{"op": "set_coat", "coat": {"root_share": 0.55, "clump": 0.25, "clump_size": 0.008, "ramp": [{"at": 0, "colour": "#5a3822"}, {"at": 0.6, "colour": "#a8703f"}, {"at": 1, "colour": "#c08a58"}]}}
EOF
$bin/pelage run model $out/coat.jsonl >/dev/null
$bin/pelage run model $out/studio.jsonl >/dev/null
groom model

oiiotool --nosoftwareattrib $out/{creature,model}-{0-before,1-comb,2-blow,3-attract,4-detailed}.png --mosaic:pad=8 5x2 -o $out/contact-sheet.png
rm -f $out/studio.jsonl $out/coat.jsonl $out/1-comb.jsonl $out/2-blow.jsonl $out/3-attract.jsonl
say "done. Look at out/contact-sheet.png; each picture is beside it, and out/creature.jsonl is the groom as a log."
if [ $keep = yes ]; then
  echo "The server runs on (process $server). Groom the creature in a browser:"
  echo "  $PELAGE_SERVER/?scene=creature"
  echo "or on the command line:"
  echo "  export PELAGE_SERVER=$PELAGE_SERVER"
  echo "  $bin/pelage list; $bin/pelage undo creature; $bin/pelage frame creature -o undone.png"
else
  echo "Run it again with --keep to leave the server running, or with --model FILE for a model of yours."
fi
