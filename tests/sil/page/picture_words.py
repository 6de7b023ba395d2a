"""Words below README's first picture, held against the drive that the picture shows."""
import json
import re

IN_THE_AIR_M = 0.1         # a gap that is seen
LARGEST_EMPTY_SHARE = 0.1  # of the time axis
SAME_ANGLE_DEG = 1.0
FACTS = """JSON.stringify((() => {
    const { recording, view, strips } = page;
    const value = (name) => recording.value(name, view.row);
    return {
        gaps_m: { left: Math.min(value("gap_front_left"), value("gap_rear_left")),
                  right: Math.min(value("gap_front_right"), value("gap_rear_right")) },
        state: recording.raw("state", view.row), side: recording.raw("side", view.row),
        lead_s: recording.judgement.lead_time_s ?? null,
        roof_load_kg: recording.head.vehicle.roof_load_kg,
        slider_deg: -Number(document.getElementById("steering").value), steering_deg: value("steering"),
        empty_share: (view.to - recording.lastTime) / (view.to - view.from),
    };
})())"""


def facts(tab):
    """Those of a live page."""
    return json.loads(tab.run(FACTS))


def words(readme):
    """Those of the first picture and of the paragraph that follows it."""
    return re.search(r"!\[(.*?)\]\(.*?\)\n\n(.*?)\n\n", readme, re.DOTALL).expand(r"\1 \2")


def contradictions(text, seen):
    """A sentence for each."""
    found = []
    if "two wheels in the air" in text and max(seen["gaps_m"].values()) < IN_THE_AIR_M:
        found.append(f"two wheels in the air: the gaps are {seen['gaps_m']}")
    if "warning lamp with its side" in text and (seen["state"] != "warning" or seen["side"] not in ("left", "right")):
        found.append(f"warning lamp with its side: it shows {seen['state']}, {seen['side']}")
    for lead in re.findall(r"([\d.]+) s before", text):
        if seen["lead_s"] is None or f"{seen['lead_s']:.{len(lead.partition('.')[2])}f}" != lead:
            found.append(f"{lead} s before: the lead is {seen['lead_s']} s")
    if "load the roof (as here" in text and not seen["roof_load_kg"]:
        found.append("load the roof (as here): there is none")
    if abs(seen["slider_deg"] - seen["steering_deg"]) > SAME_ANGLE_DEG:
        found.append(f"the slider is at {seen['slider_deg']} deg, the steering wheel at {seen['steering_deg']} deg")
    if seen["empty_share"] > LARGEST_EMPTY_SHARE:
        found.append(f"{100 * seen['empty_share']:.0f} % of the time axis are empty")
    return found
