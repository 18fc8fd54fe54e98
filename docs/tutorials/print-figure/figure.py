#!/usr/bin/python3
import json
import sys

import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({"font.size": 8, "pdf.fonttype": 42, "lines.linewidth": 1})  # 42: text stays text
figure, axes = plt.subplots(figsize=(86 / 25.4, 60 / 25.4), layout="constrained")  # inches
for folder, style in zip(sys.argv[1:], ("k-", "k--", "k:")):
    rows = np.genfromtxt(folder + "/history.csv", delimiter=",", names=True)
    units = json.load(open(folder + "/summary.json", encoding="utf-8"))["units"]
    time = rows["time"][1:] - rows["time_step"][1:] / 2  # the scheme's forces are means over the steps
    axes.plot(time * units["time"]["si"], rows["reaction_end_y"][1:] * units["force"]["si"], style, label=folder)
axes.set(xscale="log", xlabel="time [s]", ylabel=f"peel force [{units['force']['unit']}]", ylim=0)
axes.legend(frameon=False)
figure.savefig("figure.pdf")
figure.savefig("figure.png", dpi=300)
