"""The course of a staircase of a study and its threshold: python3 plot_study.py ANSWERS.csv [PLOT.png]"""
import csv
import statistics
import sys

with open(sys.argv[1], newline="", encoding="utf-8") as file:
    rows = [row for row in csv.DictReader(file) if row["procedure"] == "staircase"]
if not rows:
    sys.exit(f"{sys.argv[1]}: has no trial of a staircase; choose another log")

levels = [float(row["level"]) for row in rows]
turned = [i for i, row in enumerate(rows) if row["reversal"] == "1"]
last = [levels[i] for i in turned[-8:]]  # as many as the study uses
what = f"{rows[0]['parameter']} ({rows[0]['unit']})"
print(f"{len(rows)} trials, {len(turned)} reversals")
if last:
    print(f"threshold {statistics.mean(last):.4g} {rows[0]['unit']} above the reference, of {len(last)} reversals")

if len(sys.argv) > 2:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    trials = [int(row["trial"]) for row in rows]
    plt.plot(trials, levels, color="0.6")
    for right, mark in (("1", "o"), ("0", "x")):
        chosen = [i for i, row in enumerate(rows) if row["correct"] == right]
        plt.plot([trials[i] for i in chosen], [levels[i] for i in chosen], mark, label=("wrong", "right")[right == "1"])
    if last:
        plt.axhline(statistics.mean(last), linestyle="--", label="threshold")
    plt.xlabel("trial")
    plt.ylabel(f"difference in {what}")
    plt.legend()
    plt.savefig(sys.argv[2], dpi=150)
