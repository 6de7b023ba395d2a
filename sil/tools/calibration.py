"""The commands of sil/tools/calibrate."""

import argparse
import pathlib
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / folder) for folder in ("cmake/environment", "sil/results")]

import a2l_objects
import file_io
import key_file
import picture
import simulated_bus
from log_error import LogError

A2L = HERE.parents[1] / "build/release/sil/rsi-ecu.a2l"
CYCLE_S = 0.01


def positive(text):
    value = float(text)
    if not 0.0 < value < 1e6:
        raise ValueError
    return value


def parse(arguments):
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--interface", default="can0", metavar="NAME")
    common.add_argument("--a2l", default=A2L, type=pathlib.Path, metavar="FILE")
    common.add_argument("--key", default=key_file.TEST, type=pathlib.Path, metavar="FILE")
    simulated_bus.add_options(common, after=1.0)
    parser = argparse.ArgumentParser(prog="sil/tools/calibrate", epilog="More: sil/tools/calibrate --help", add_help=False)
    commands = parser.add_subparsers(dest="command", required=True)
    for name in ("compare", "reset", "store"):
        commands.add_parser(name, add_help=False, parents=[common])
    read = commands.add_parser("read", add_help=False, parents=[common])
    read.add_argument("names", nargs="*", metavar="NAME")
    write = commands.add_parser("write", add_help=False, parents=[common])
    write.add_argument("changes", nargs="+", metavar="NAME=VALUE")
    use = commands.add_parser("use", add_help=False, parents=[common])
    use.add_argument("page", choices=("working", "reference"))
    measure = commands.add_parser("measure", add_help=False, parents=[common])
    measure.add_argument("names", nargs="+", metavar="NAME")
    measure.add_argument("--seconds", required=True, type=positive, metavar="N")
    measure.add_argument("--output", required=True, type=pathlib.Path, metavar="FILE")
    options = parser.parse_args(arguments)
    if not 0.0 <= options.after <= 3600.0:
        parser.error("--after wants 0 to 3600 seconds")
    if options.command == "write" and any("=" not in change for change in options.changes):
        parser.error("write wants NAME=VALUE")
    if options.command == "measure" and options.output.suffix not in WRITERS:
        parser.error(f"--output wants a name that ends in {', '.join(WRITERS)}")
    return options


def shown(value, entry):
    text = f"{value:.7g}" if isinstance(value, float) else str(value)
    return f"{text} {entry.unit}".rstrip()


def write_csv(path, times, columns, _objects):
    rows = [",".join(["time_s", *columns])]
    for place, at in enumerate(times):
        rows.append(",".join([f"{at:.4f}", *(f"{column[place]:.9g}" for column in columns.values())]))
    file_io.write(str(path), "\n".join(rows) + "\n")


def write_mf4(path, times, columns, objects):
    import asammdf  # large; installed where such a file is wanted
    import numpy

    with asammdf.MDF(version="4.10") as measured:
        measured.append([asammdf.Signal(samples=numpy.array(column), timestamps=numpy.array(times), name=name,
                                        unit=objects[name].unit, comment=objects[name].text)
                         for name, column in columns.items()])
        saved = measured.save(path.with_name(path.name + ".new.mf4"), overwrite=True)
    pathlib.Path(saved).replace(path)


def write_png(path, times, columns, objects):
    words = {}
    for number, name in enumerate(columns, 1):
        choices = " ".join(choice.replace(" ", "_") for choice in objects[name].choices)
        words |= {f"name_{number}": name, f"unit_{number}": objects[name].unit, f"choices_{number}": choices}
    with tempfile.TemporaryDirectory() as folder:
        data = pathlib.Path(folder) / "measured.csv"
        write_csv(data, times, columns, objects)
        drawn = picture.draw(path, HERE / "measurement.gp", words | {"measured": str(data), "panels": len(columns)})
    if drawn.returncode != 0:
        raise LogError(f"{path} was not drawn; is gnuplot installed? {drawn.stderr.strip()}")


WRITERS = {".csv": write_csv, ".mf4": write_mf4, ".png": write_png}


def wait(seconds):
    end = time.monotonic() + seconds
    while (left := end - time.monotonic()) > 0.0:
        print(f"\r{seconds - left:6.1f} s of {seconds:g} s", end="", file=sys.stderr, flush=True)
        time.sleep(min(left, 0.5))
    print(file=sys.stderr)


def measure(session, options, wait_for):
    times, columns = session.measure(options.names, lambda: wait_for(options.seconds))
    if not times:
        raise LogError("no sample has come; does the ECU run?")
    WRITERS[options.output.suffix](options.output, times, columns, session.a2l.objects)
    missing = round(times[-1] / CYCLE_S) + 1 - len(times)
    print(f"{options.output}: {len(times)} samples, {missing} missing, overload reported {session.samples.overloads} times")


def run(session, options, wait_for):
    objects = session.a2l.objects
    if options.command == "read":
        names = options.names or [name for name, entry in objects.items() if entry.is_parameter]
        for name in names:
            print(f"{name} = {shown(session.read(name), session.object(name))}")
        return
    if options.command == "compare":
        session.unlock()
        for name, (reference, working) in session.differences().items():
            print(f"{name} = {shown(working, objects[name])}, reference {shown(reference, objects[name])}")
        return
    session.unlock()
    if options.command == "write":
        changes = dict(change.split("=", 1) for change in options.changes)
        for name, before in session.write(changes).items():
            print(f"{name} = {shown(session.read(name), objects[name])}, was {shown(before, objects[name])}")
    elif options.command == "use":
        session.use(options.page)
    elif options.command == "reset":
        session.reset()
    elif options.command == "store":
        session.store()
    else:
        measure(session, options, wait_for)


def main(arguments):
    options = parse(arguments)
    try:
        a2l = a2l_objects.read(options.a2l)
        key = key_file.read(options.key, "calibration")
        import xcp_session  # takes a second

        with simulated_bus.driven(options) as bus:
            interface = options.interface if bus is None else simulated_bus.Interface(bus)
            with xcp_session.Session(a2l, interface, key) as session:
                run(session, options, wait if bus is None else lambda seconds: bus.run(round(seconds / CYCLE_S)))
    except LogError as error:
        sys.exit(f"sil/tools/calibrate: {error}")
    except OSError as error:
        sys.exit(f"sil/tools/calibrate: {error}")
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main(sys.argv[1:])
