"""ecu_on_a_pipe as a bus for simulated_bus.IsoTpConnection. Time is the ECU's: it stands while no reader waits."""

import subprocess

PHYSICAL, RESPONSE = 0x7A6, 0x7AE


class Ecu:
    """The ECU's process: frames in, cycles, frames out."""

    def __init__(self, program, folder):
        self.arguments = [program, folder]
        self.resets = 0
        self.waiting = []
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def loses_power(self):
        """And comes back."""
        self.process.kill()
        self.close()
        self.start()

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()

    def say(self, line):
        self.process.stdin.write(line + "\n")

    def send(self, identifier, data):
        self.say(f"{identifier:03X}#{bytes(data).hex()}")

    def run(self, cycles):
        """Lets so many cycles of 10 ms pass; the frames that came wait in `waiting`."""
        self.say(str(cycles))
        self.process.stdin.flush()
        for line in self.process.stdout:
            line = line.strip()
            if line == ".":
                return
            if line == "reset":
                self.resets += 1
            else:
                identifier, data = line.split("#")
                self.waiting.append((int(identifier, 16), bytes.fromhex(data)))
        raise RuntimeError("the ECU's process has ended")
