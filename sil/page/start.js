// Start: a file with a recording in it shows that; one without drives live.
const page = new Page();
const given = JSON.parse(byId("recording").textContent);
if (given) {
  page.show(new Recording(given), false);
  const moment = Number(location.hash.slice(1)); // report.html#2.004
  if (moment > 0) {
    page.goTo(moment);
  }
} else {
  page.driver = new Driver(page);
}
