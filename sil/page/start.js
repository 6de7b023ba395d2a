// Start: a file with a recording in it shows that; one without drives live.
const page = new Page();
const given = JSON.parse(byId("recording").textContent);
if (given) {
  page.show(new Recording(given), false);
  if (location.hash.length > 1) { // report.html#2.004
    page.goTo(Number(location.hash.slice(1)) || 0);
  } else {
    page.goToHeart();
  }
} else {
  page.driver = new Driver(page);
}
