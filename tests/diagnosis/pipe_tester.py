"""A tester of other authors, udsoncan over can-isotp, against ecu_on_a_pipe. Time is the ECU's: it stands while no reader
waits."""

import subprocess

import isotp
import udsoncan
from udsoncan.connections import BaseConnection

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


class PipeConnection(BaseConnection):
    """can-isotp between udsoncan and the pipe; a second passes in a hundred cycles."""

    def __init__(self, ecu, **parameters):
        super().__init__("pipe")
        self.ecu = ecu
        address = isotp.Address(isotp.AddressingMode.Normal_11bits, rxid=RESPONSE, txid=PHYSICAL)
        self.stack = isotp.TransportLayerLogic(rxfn=self.receive_frame, txfn=self.send_frame, address=address,
                                               params={"blocking_send": False, **parameters})

    def receive_frame(self, timeout):
        del timeout
        if not self.ecu.waiting:
            return None
        identifier, data = self.ecu.waiting.pop(0)
        return isotp.CanMessage(arbitration_id=identifier, data=data, dlc=len(data))

    def send_frame(self, message):
        self.ecu.send(message.arbitration_id, message.data)

    def open(self):
        return self

    def close(self):
        pass

    def is_open(self):
        return True

    def empty_rxqueue(self):
        while self.stack.available():
            self.stack.recv()

    def specific_send(self, payload, timeout=None):
        del timeout
        self.stack.send(payload)
        self.stack.process(rx_timeout=0)

    def specific_wait_frame(self, timeout=2):
        """The first frame within the time-out, the whole answer within two seconds."""
        cycles = round(timeout * 100)
        while cycles >= 0:
            if self.ecu.waiting:
                cycles = 200
            self.stack.process(rx_timeout=0)
            if self.stack.available():
                return bytes(self.stack.recv())
            self.ecu.run(1)
            cycles -= 1
        raise udsoncan.exceptions.TimeoutException("no answer")
