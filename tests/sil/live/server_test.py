"""The server of a live drive: who is answered, who is refused, and what does not disturb the drive.

Use: server_test.py RSI_SIL
"""
import asyncio
import http.client
import json
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest

import websockets

from live_program import LIMIT_S, PROJECT, live_drive

PROGRAM = sys.argv.pop(1)


class Server(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.port = cls.enterClassContext(live_drive(PROGRAM, cls.scratch))
        cls.own = f"127.0.0.1:{cls.port}"

    def ask(self, method="GET", target="/", body=None, **headers):
        """Status, text and headers of the answer."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=LIMIT_S)
        connection.putrequest(method, target, skip_host=True, skip_accept_encoding=True)
        for name, value in {"Host": self.own, **headers}.items():
            connection.putheader(name, value)
        if body is not None:
            connection.putheader("Content-Length", str(len(body)))
        connection.endheaders(body)
        answer = connection.getresponse()
        text = answer.read().decode()
        connection.close()
        return answer.status, text, answer.headers

    def drive(self, conversation, origin=None, host=None):
        """The result of conversation(socket), which is a coroutine."""
        async def whole():
            address = f"ws://{host or self.own}/drive"
            async with websockets.connect(address, origin=origin or f"http://{self.own}", max_size=None) as page:
                return await asyncio.wait_for(conversation(page), LIMIT_S)
        return asyncio.run(whole())

    @staticmethod
    async def _rows(page, count):
        rows = []
        while len(rows) < count:
            rows += json.loads(await page.recv()).get("rows", [])
        return rows

    def test_the_page_loads_nothing_from_elsewhere(self):
        for host in (self.own, f"localhost:{self.port}"):
            status, text, headers = self.ask(Host=host)
            self.assertEqual(status, 200)
            self.assertIn('type="application/json">null<', text)
            self.assertIn("default-src 'none'", headers["Content-Security-Policy"])
            self.assertNotIn("unsafe", headers["Content-Security-Policy"])
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertEqual(headers["X-Frame-Options"], "DENY")
            self.assertNotIn("Access-Control-Allow-Origin", headers)
        self.assertEqual(self.ask("HEAD")[:2], (200, ""))

    def test_another_host_name_is_refused(self):
        for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1", f"127.0.0.1:{self.port + 1}", f"{self.own}.evil.example"):
            status, text, _ = self.ask(Host=host)
            self.assertEqual((status, text), (403, "This page is for 127.0.0.1 and localhost only."), host)

    def test_there_is_one_page_and_nothing_to_change(self):
        for target in ("/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//", "/drive", "/signals.csv", "/?", "http://x/", "*"):
            status, text, _ = self.ask(target=target)
            self.assertEqual((status, text), (404, f"There is one page here: http://{self.own}/"), target)
        for method in ("POST", "PUT", "DELETE", "OPTIONS", "TRACE"):
            self.assertEqual(self.ask(method)[0], 405, method)

    def test_long_messages_are_refused(self):
        self.assertEqual(self.ask(Long="x" * 9000)[0], 413)
        self.assertEqual(self.ask(target="/" + "x" * 9000)[0], 413)
        self.assertEqual(self.ask("POST", body=b"x")[0], 413)

    def test_other_than_http_is_answered_or_cut_off(self):
        for nonsense in (b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", b"GET\r\n\r\n", b"\0" * 100 + b"\r\n\r\n"):
            with socket.create_connection(("127.0.0.1", self.port), LIMIT_S) as connection:
                connection.sendall(nonsense)
                connection.shutdown(socket.SHUT_WR)
                answer = b""
                while part := connection.recv(4096):
                    answer += part
            self.assertTrue(answer == b"" or answer.startswith(b"HTTP/1.1 400"), answer[:40])
        self.assertEqual(self.ask()[0], 200)

    def test_a_page_from_elsewhere_does_not_drive(self):
        for origin in ("http://evil.example", f"https://{self.own}", f"http://127.0.0.1:{self.port + 1}", "null",
                       f"http://{self.own}.evil.example"):
            with self.assertRaises(websockets.InvalidStatusCode) as refused:
                self.drive(None, origin=origin)
            self.assertEqual(refused.exception.status_code, 403, origin)

    def test_the_drive_goes_on_in_order_and_obeys(self):
        async def conversation(page):
            first = json.loads(await page.recv())
            await page.send(json.dumps({"again": True, "speed_kmh": 60}))
            while json.loads(await page.recv()).get("drive", {}).get("input", {}).get("speed_kmh") != 60:
                pass
            await page.send(json.dumps({"steering_deg": 40}))
            return first["drive"]["columns"], await self._rows(page, 300)
        columns, rows = self.drive(conversation)
        times = [row[columns.index("time_s")] for row in rows]
        for before, after in zip(times, times[1:]):
            self.assertAlmostEqual(after - before, 0.01, places=6)
        self.assertAlmostEqual(rows[-1][columns.index("true_steering_wheel_angle_deg")], 40.0, places=3)

    def test_nonsense_ends_the_connection_with_a_sentence(self):
        async def conversation(page):
            await page.send("nonsense")
            while True:
                await page.recv()
        with self.assertRaises(websockets.ConnectionClosed) as closed:
            self.drive(conversation)
        self.assertIn("not understood", closed.exception.rcvd.reason)

        async def too_long(page):
            await page.send("x" * 2000)
            while True:
                await page.recv()
        with self.assertRaises(websockets.ConnectionClosed):
            self.drive(too_long)
        self.assertEqual(self.ask()[0], 200)

    def test_the_last_page_drives(self):
        async def conversation(page):
            await page.recv()
            async with websockets.connect(f"ws://{self.own}/drive", origin=f"http://{self.own}", max_size=None) as other:
                await self._rows(other, 20)
                while True:
                    await page.recv()
        with self.assertRaises(websockets.ConnectionClosed) as closed:
            self.drive(conversation)
        self.assertIn("Another page drives now", closed.exception.rcvd.reason)

    def test_a_thousand_connections_do_not_stop_the_drive(self):
        async def conversation(page):
            await self._rows(page, 20)
            opened = []
            for _ in range(1000):
                connection = socket.socket()
                connection.setblocking(False)
                connection.connect_ex(("127.0.0.1", self.port))
                opened.append(connection)
                if len(opened) % 100 == 0:
                    await self._rows(page, 4)
            rows = await self._rows(page, 200)
            for connection in opened:
                connection.close()
            return rows
        rows = self.drive(conversation)
        for before, after in zip(rows, rows[1:]):
            self.assertAlmostEqual(after[0] - before[0], 0.01, places=6)
        # Those that say nothing have gone, or go when their five seconds are over.
        while True:
            try:
                self.assertEqual(self.ask()[0], 200)
                break
            except (ConnectionError, http.client.HTTPException):
                pass

    def test_nothing_listens_elsewhere(self):
        lines = pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]
        places = {line.split()[1] for line in lines if line.split()[3] == "0A" and line.split()[1].endswith(f":{self.port:04X}")}
        self.assertEqual(places, {f"0100007F:{self.port:04X}"})
        six = pathlib.Path("/proc/net/tcp6")
        if six.exists():
            self.assertFalse([line for line in six.read_text().splitlines()[1:]
                              if line.split()[3] == "0A" and line.split()[1].endswith(f":{self.port:04X}")])

    def test_a_port_that_is_taken_is_told(self):
        with tempfile.TemporaryDirectory() as other:
            failed = subprocess.run(
                [PROGRAM, "watch", "--vehicle", PROJECT / "sil/vehicles/van.toml", "--parameters",
                 PROJECT / "firmware/calibrations/van.toml", "--output", other, "--port", str(self.port)],
                capture_output=True, text=True)
        self.assertEqual(failed.returncode, 1)
        self.assertIn(f"127.0.0.1:{self.port} cannot be listened on", failed.stderr)
        self.assertIn("--port", failed.stderr)


if __name__ == "__main__":
    unittest.main()
