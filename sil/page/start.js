// Start: the recording that is in the file. "report.html#2.004" opens at that time.
const page = new Page(new Recording(JSON.parse(byId("recording").textContent)));
const moment = Number(location.hash.slice(1));
if (moment > 0) {
  page.goTo(moment);
}
