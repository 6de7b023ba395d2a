"""A live drive against an ECU that runs by itself, on a CAN interface."""

import asyncio
import json
import re
import signal
import subprocess
import tempfile
import unittest

import websockets

import programs

WATCH = ("--vehicle", programs.VEHICLE, "--parameters", programs.CALIBRATION, "--interface", programs.INTERFACE)


class Page:
    """Messages to the page of a live drive, the latest of each kind, and its requests."""

    def __init__(self, socket):
        self._socket = socket
        self.told = {}

    async def until(self, is_over):
        while not is_over(self.told):
            self.told |= json.loads(await self._socket.recv())

    async def ask(self, **what):
        await self._socket.send(json.dumps(what))


class LiveDrive(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def watch(self, conversation, *options):
        """Messages to the page when conversation(page), a coroutine, had ended."""
        async def whole(port):
            own = f"127.0.0.1:{port}"
            async with websockets.connect(f"ws://{own}/drive", origin=f"http://{own}", max_size=None) as socket:
                page = Page(socket)
                await asyncio.wait_for(conversation(page), programs.LONGEST_S)
                return page.told

        command = [programs.PROGRAMS / "rsi-sil", "watch", *options, *WATCH, "--output", self.folder]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
            try:
                return asyncio.run(whole(re.search(r":(\d+)/", process.stdout.readline()).group(1)))
            finally:
                process.send_signal(signal.SIGINT)
                process.communicate(timeout=programs.LONGEST_S)

    def test_the_ecu_on_the_bus_warns_of_the_rollover_before_two_wheels_lift(self):
        async def conversation(page):
            await page.until(lambda told: "two_wheel_lift" in told.get("events", {}))

        with programs.Ecu():
            told = self.watch(conversation, "j-turn-110")
        self.assertIn(f"the ECU on {programs.INTERFACE}", json.dumps(told["drive"]))
        self.assertLess(told["events"]["warning"]["time_s"], told["events"]["two_wheel_lift"]["time_s"])

    def test_a_sensor_that_breaks_on_the_page_is_lost_to_the_ecu_on_the_bus(self):
        async def conversation(page):
            await page.until(lambda told: "drive" in told)
            faults = page.told["drive"]["faults"]
            place = [each["place"] for each in faults].index("roll angle")
            await page.ask(fault={"place": place, "kind": faults[place]["kinds"].index("not available")})
            await page.until(lambda told: told.get("diagnosis", {}).get("degradation") == "roll sensor lost")

        with programs.Ecu():
            told = self.watch(conversation)
        self.assertEqual(told["fault"], "roll angle: not available")

    def test_without_an_ecu_it_says_how_to_start_one(self):
        finished = programs.run("rsi-sil", "watch", *WATCH, "--output", self.folder)
        self.assertEqual(finished.returncode, 1)
        self.assertIn(f"no ECU responds on {programs.INTERFACE}. Start one first", finished.stderr)


if __name__ == "__main__":
    unittest.main()
