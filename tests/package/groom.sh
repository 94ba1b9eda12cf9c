# Tests the installed package, on a system with nothing else of Pelage.
set -euo pipefail
cd /tmp
for program in pelaged pelage pelage-render; do $program --version; done
pelage farm --help >/dev/null
pelage-trade --help >/dev/null
python3 -c 'import pelage; print("python", pelage.__version__)'
for file in bash-completion/completions/pelage zsh/vendor-completions/_pelage man/man1/pelage.1; do test -s /usr/share/$file; done

pelaged --listen 127.0.0.1:0 --port-file port --data data 2>server.log &
server=$!
for _ in $(seq 200); do [ -s port ] && break; sleep 0.1; done
export PELAGE_SERVER=http://127.0.0.1:$(cat port)
pelage wait
python3 - <<'END'  # the studio
import os, urllib.request
page = urllib.request.urlopen(os.environ["PELAGE_SERVER"] + "/").read()
assert b"<title>Pelage" in page, page[:200]
END
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >fox.obj
pelage new --name box --file fox.obj  # imported by the confined worker
pelage new --name fox
pelage run fox /usr/share/pelage/recipes/portrait_light.json
pelage frame fox -o fox.png --width 640 --height 640 --quality detailed
pelage export fox -o fox.usda --every 50
cp fox.png again.png
pelage compare fox.png again.png
cat >job.json <<END
{"scene": "fox.pelage", "frames": "1-1", "output": "frame.####.png", "frame": {"width": 64, "height": 64, "quality": "draft"}}
END
pelage export fox -o fox.pelage
pelage-render job.json
test -s frame.0001.png
kill $server
wait $server
