"""A browser without a window, driven over its DevTools protocol."""
import asyncio
import base64
import contextlib
import http.client
import itertools
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import time

import websockets

START_LIMIT_S = 60
ANSWER_LIMIT_S = 60


class PageError(Exception):
    """A script failed, or an answer did not come."""


class Browser:
    """One tab. Exceptions and errors of the page's scripts are kept in `complaints`."""

    def __init__(self, socket, loop):
        self._socket = socket
        self._loop = loop
        self._numbers = itertools.count(1)
        self.complaints = []
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")

    def call(self, method, **parameters):
        """The result of one command."""
        return self._loop.run_until_complete(asyncio.wait_for(self._call(method, parameters), ANSWER_LIMIT_S))

    async def _call(self, method, parameters):
        number = next(self._numbers)
        await self._socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            message = json.loads(await self._socket.recv())
            self._note(message)
            if message.get("id") == number:
                if "error" in message:
                    raise PageError(f"{method}: {message['error']['message']}")
                return message["result"]

    def _note(self, message):
        if message.get("method") == "Runtime.exceptionThrown":
            details = message["params"]["exceptionDetails"]
            self.complaints.append(details.get("exception", {}).get("description", details["text"]))
        if message.get("method") == "Log.entryAdded" and message["params"]["entry"]["level"] == "error":
            self.complaints.append(message["params"]["entry"]["text"])

    def run(self, script):
        """The value of an expression, awaited if it is a promise."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise PageError(f"{script}: {details.get('exception', {}).get('description', details['text'])}")
        return answer["result"].get("value")

    def wait_for(self, condition, limit_s=ANSWER_LIMIT_S):
        """Until the expression is true."""
        deadline = time.monotonic() + limit_s
        while not self.run(f"Boolean({condition})"):
            if time.monotonic() > deadline:
                raise PageError(f"after {limit_s} s not true: {condition}; {self.complaints}")
            time.sleep(0.01)

    def open(self, address, is_ready="document.body?.dataset.ready === 'yes'"):
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=str(address))
        self.wait_for(f"location.href.startsWith({json.dumps(str(address))}) && {is_ready}")

    def size(self, width, height, phone=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=2 if phone else 1,
                  mobile=phone)

    def theme(self, name):
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def key(self, key, kind="press", code=None, modifiers=0):
        """Presses, holds ("down") or releases ("up") a key as the keyboard would."""
        kinds = ["keyDown", "keyUp"] if kind == "press" else ["keyDown" if kind == "down" else "keyUp"]
        for each in kinds:
            text = {"text": key} if each == "keyDown" and len(key) == 1 else {}
            if key == "Enter":
                text = {"text": "\r"} if each == "keyDown" else {}
            self.call("Input.dispatchKeyEvent", type=each, key=key, code=code or key, modifiers=modifiers,
                      windowsVirtualKeyCode={"Tab": 9, "Enter": 13, " ": 32}.get(key, 0), **text)

    def picture(self, file, whole=False):
        options = {"captureBeyondViewport": True} if whole else {}
        if whole:
            content = self.call("Page.getLayoutMetrics")["cssContentSize"]
            options["clip"] = {"x": 0, "y": 0, "width": content["width"], "height": content["height"], "scale": 1}
        data = self.call("Page.captureScreenshot", format="png", **options)["data"]
        pathlib.Path(file).write_bytes(base64.b64decode(data))


def _endpoint(folder, process):
    """Port of the browser: it writes that into its folder."""
    file = pathlib.Path(folder, "DevToolsActivePort")
    deadline = time.monotonic() + START_LIMIT_S
    while time.monotonic() < deadline and process.poll() is None:
        with contextlib.suppress(OSError, ValueError):
            port, _ = file.read_text().split("\n", 1)
            return int(port)
        time.sleep(0.05)
    raise PageError("chromium did not start; cmake/environment/set_up --browser installs it")


@contextlib.contextmanager
def browser():
    """A fresh browser, ended with all its processes at the end."""
    program = shutil.which("chromium")
    if program is None:
        raise PageError("there is no chromium; cmake/environment/set_up --browser installs it")
    folder = tempfile.mkdtemp()
    # As root, and in containers, chromium has no sandbox. It reads what the tests made and nothing else.
    process = subprocess.Popen(
        [program, "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
         "--remote-debugging-port=0", f"--user-data-dir={folder}", "--hide-scrollbars", "about:blank"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
        env={**os.environ, "HOME": folder})
    loop = asyncio.new_event_loop()
    try:
        port = _endpoint(folder, process)
        socket = loop.run_until_complete(_connect(port))
        yield Browser(socket, loop)
        loop.run_until_complete(socket.close())
    finally:
        process.terminate()
        try:
            process.wait(20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        loop.close()
        shutil.rmtree(folder, ignore_errors=True)


async def _connect(port):
    """The first tab."""
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=ANSWER_LIMIT_S)
    connection.request("GET", "/json/list")
    tabs = json.loads(connection.getresponse().read())
    connection.close()
    tab = next(each for each in tabs if each["type"] == "page")
    return await asyncio.wait_for(websockets.connect(tab["webSocketDebuggerUrl"], max_size=None), ANSWER_LIMIT_S)
