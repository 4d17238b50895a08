"""The script of docs/examples that draws a staircase of a study, over a log whose threshold is known."""
import subprocess
import sys
import tempfile
from pathlib import Path

script = sys.argv[1]
header = "format,study,procedure,parameter,unit,trial,level,reversal,correct,device"
levels = [(200, 0, 1), (100, 0, 1), (50, 1, 0), (100, 1, 1), (50, 1, 0), (100, 1, 1)]

with tempfile.TemporaryDirectory() as folder:
    log, plot = Path(folder) / "a.csv", Path(folder) / "a.png"
    rows = [f'1.0,"a, ""b""",staircase,stiffness,N/m,{i + 1},{level},{turned},{right},hand'
            for i, (level, turned, right) in enumerate(levels)]
    log.write_text("\n".join([header, *rows, ""]))
    done = subprocess.run([sys.executable, script, str(log), str(plot)], capture_output=True, text=True, check=True)
    assert "6 trials, 4 reversals" in done.stdout, done.stdout
    assert "threshold 75 N/m above the reference, of 4 reversals" in done.stdout, done.stdout
    assert plot.read_bytes().startswith(b"\x89PNG"), "no picture"
    log.write_text(header + "\n")
    refused = subprocess.run([sys.executable, script, str(log)], capture_output=True, text=True)
    assert refused.returncode == 1 and "no trial of a staircase" in refused.stderr, refused.stderr
