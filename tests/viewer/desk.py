"""A display without a screen (Xvfb), the viewer on it, and a user's hands: events by XTEST and by the drag-and-drop protocol."""
import os
import re
import select
import shlex
import struct
import subprocess
import tempfile
import time
from pathlib import Path

from Xlib import X, XK, Xatom, display, error, protocol
from Xlib.ext import xtest

# The machine may do other things: what takes a second alone may take a minute.
PATIENCE = 240.0


class Desk:
    def __init__(self, width=980, height=660):
        self.folder = tempfile.TemporaryDirectory(prefix="groundglass-desk-", ignore_cleanup_errors=True)
        self.path = Path(self.folder.name)
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp", "-fbdir",
             self.folder.name], pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.name = ":" + pipe.readline().strip()
        self.display = display.Display(self.name)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.server.poll() is None:
            self.display.close()
            self.end()
        self.folder.cleanup()

    def end(self):
        """Of the X server, for all that are connected."""
        self.server.terminate()
        self.server.wait()

    def set_scale(self, scale):
        """Of letters and controls, as a desktop says it to windows that open from now on."""
        root = self.display.screen().root
        root.change_property(Xatom.RESOURCE_MANAGER, Xatom.STRING, 8, f"Xft.dpi:\t{96 * scale}\n".encode())
        self.display.sync()

    def screen(self):
        """Rows of (r, g, b), as the X server keeps them."""
        return Screen((self.path / "Xvfb_screen0").read_bytes())


class Screen:
    """An XWD file, which the X server maps into memory; rows are made when they are asked for."""
    def __init__(self, data):
        self.data = data
        header = struct.unpack(">25I", data[:100])
        self.width, self.height, self.stride = header[4], header[5], header[12]
        self.at = header[0] + 12 * header[19]

    def __getitem__(self, y):
        if isinstance(y, slice):
            return [self[i] for i in range(*y.indices(self.height))]
        if not 0 <= y < self.height:
            raise IndexError(y)
        start = self.at + y * self.stride
        row = self.data[start:start + 4 * self.width]
        return list(zip(row[2::4], row[1::4], row[0::4]))


class Viewer:
    def __init__(self, desk, program, arguments, size=(960, 600), home=None, layers=None, own_lists=False):
        self.desk, self.program = desk, program
        # Not the user's caches, but kept: compiled shaders serve the next test.
        cache = Path(program).parent / "tests/viewer/cache"
        if own_lists: # which tests that run beside this one do not write to
            shaders = cache / "groundglass/shaders"
            shaders.mkdir(parents=True, exist_ok=True)
            cache = desk.path / "cache"
            (cache / "groundglass").mkdir(parents=True)
            (cache / "groundglass/shaders").symlink_to(shaders)
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(cache))
        environment = dict(self.environment, DISPLAY=desk.name)
        if "VIEWER_PRELOAD" in environment: # of the viewer alone, not of this
            environment["LD_PRELOAD"] = environment["VIEWER_PRELOAD"]
        if home:
            environment["GROUNDGLASS_HOME"] = str(home)
        if layers:
            environment["VK_INSTANCE_LAYERS"] = layers
        self.process = subprocess.Popen(
            [program, "view", *arguments, "--size", f"{size[0]}x{size[1]}"], cwd=desk.path, env=environment,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=(desk.path / "stderr").open("w"))
        self.buffer = ""
        self.window = self.wait_for(self.find_window, "the window")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def errors(self):
        return (self.desk.path / "stderr").read_text()

    def wait_for(self, found, what):
        start = time.monotonic()
        while time.monotonic() - start < PATIENCE:
            if self.process.poll() is not None:
                raise AssertionError(f"the viewer ended with {self.process.returncode}: {self.errors()}")
            result = found()
            if result:
                return result
            time.sleep(0.05)
        raise AssertionError(f"waited {PATIENCE} s for {what}; {self.errors()}")

    def find_window(self):
        for window in self.desk.display.screen().root.query_tree().children:
            try:
                if window.get_wm_name() and window.get_attributes().map_state == X.IsViewable:
                    return window
            except error.BadWindow:
                pass
        return None

    def title(self):
        return self.window.get_wm_name() or ""

    def open(self):
        """Waits for the scene, and gives the window the keyboard, as a window manager would."""
        self.wait_for(lambda: " - Groundglass" in self.title(), "the scene")
        self.window.set_input_focus(X.RevertToParent, X.CurrentTime)
        self.desk.display.sync()
        self.copied()  # the first picture, which is long, is over
        return self

    # Hands.
    def fake(self, kind, detail=0, pause=0.03, **where):
        xtest.fake_input(self.desk.display, kind, detail, **where)
        self.desk.display.sync()
        time.sleep(pause)

    def move(self, x, y):
        self.fake(X.MotionNotify, x=int(x), y=int(y))

    def work(self):
        """Nanoseconds of processor time that its threads have had; none if one of them wants more at once."""
        total = 0
        for task in Path(f"/proc/{self.process.pid}/task").iterdir():
            try:
                if (task / "stat").read_text().rsplit(") ", 1)[1][0] == "R":
                    return None
                total += int((task / "schedstat").read_text().split()[0])
            except OSError: # it has ended
                pass
        return total

    def rest(self):
        """Until it has nothing to do, as the window then costs nothing: the picture is finished, and what is likely next is made."""
        awake = 2_000_000 # of a look at its files or the clock
        quiet = 0.25 # longer than the window waits for the next movement of a hand
        start = since = time.monotonic()
        before = self.work()
        while time.monotonic() - since < quiet and time.monotonic() - start < PATIENCE and self.process.poll() is None:
            time.sleep(0.03)
            now = self.work()
            if now is None or before is None or now - before > awake:
                since = time.monotonic()
            before = now

    def drag(self, start, end, button=1, steps=5):
        self.rest()
        self.move(*start)
        self.rest() # the window knows where the mouse is
        self.fake(X.ButtonPress, button)
        for i in range(1, steps + 1):
            self.move(start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps)
        self.fake(X.ButtonRelease, button)
        self.rest()

    def click(self, x, y, button=1):
        self.drag((x, y), (x, y), button, steps=0)

    def key(self, name, *modifiers, pause=0.03):
        codes = [self.desk.display.keysym_to_keycode(XK.string_to_keysym(k)) for k in (*modifiers, name)]
        for code in codes:
            self.fake(X.KeyPress, code, pause)
        for code in reversed(codes):
            self.fake(X.KeyRelease, code, pause)

    def type_into(self, x, y, text):
        """In place of a slider's value, as Ctrl and a click let one."""
        names = {"-": ("minus",), ".": ("period",), "*": ("8", "Shift_L")}
        control = self.desk.display.keysym_to_keycode(XK.string_to_keysym("Control_L"))
        self.rest()
        self.move(x, y)
        self.fake(X.KeyPress, control)
        self.click(x, y)
        self.fake(X.KeyRelease, control)
        held = 0.3 # longer than a frame: Dear ImGui 1.86 misses keys that are released within the frame of their press
        self.key("BackSpace", pause=held) # of what is there, which is selected
        for letter in text:
            self.key(*names.get(letter, (letter,)))
        self.key("Return", pause=held)
        self.rest()

    def close(self):
        atom = self.desk.display.intern_atom
        event = protocol.event.ClientMessage(window=self.window, client_type=atom("WM_PROTOCOLS"),
                                             data=(32, [atom("WM_DELETE_WINDOW"), X.CurrentTime, 0, 0, 0]))
        self.window.send_event(event)
        self.desk.display.sync()
        return self.process.wait(PATIENCE)

    def drop(self, path):
        """The source's side of XDND, version 5."""
        d = self.desk.display
        atom = d.intern_atom
        source = d.screen().root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        source.set_selection_owner(atom("XdndSelection"), X.CurrentTime)

        def tell(kind, *data):
            self.window.send_event(protocol.event.ClientMessage(
                window=self.window, client_type=atom(kind), data=(32, [source.id, *data, 0, 0, 0, 0][:5])))
            d.sync()

        tell("XdndEnter", 5 << 24, atom("text/uri-list"), 0, 0)
        tell("XdndPosition", 0, (100 << 16) | 100, X.CurrentTime, atom("XdndActionCopy"))
        tell("XdndDrop", 0, X.CurrentTime)
        start = time.monotonic()
        while time.monotonic() - start < PATIENCE:
            while d.pending_events():
                event = d.next_event()
                if event.type != X.SelectionRequest:
                    continue
                event.requestor.change_property(event.property, event.target, 8, f"file://{path}\r\n".encode())
                event.requestor.send_event(protocol.event.SelectionNotify(
                    time=event.time, requestor=event.requestor, selection=event.selection, target=event.target,
                    property=event.property))
                d.sync()
                return
            time.sleep(0.02)
        raise AssertionError("the window did not ask for what was dropped")

    # What it says.
    def read_line(self):
        start = time.monotonic()
        while "\n" not in self.buffer:
            if time.monotonic() - start > PATIENCE or self.process.poll() is not None:
                raise AssertionError(f"no line came; {self.errors()}")
            if select.select([self.process.stdout], [], [], 0.1)[0]:
                self.buffer += os.read(self.process.stdout.fileno(), 65536).decode()
        line, self.buffer = self.buffer.split("\n", 1)
        return line

    def copied(self):
        """The capture line, as Ctrl+C puts it on stdout."""
        self.key("c", "Control_L")
        return self.read_line()

    def copied_when(self, holds, what):
        start = time.monotonic()
        while time.monotonic() - start < PATIENCE:
            line = self.copied()
            if holds(line):
                return line
        raise AssertionError(f"{what}: {line}")


def option(line, name):
    """The values of an option on a command line."""
    words = shlex.split(line)
    return [words[i + 1] for i, word in enumerate(words[:-1]) if word == name]


def vector(line, name):
    return [float(v) for v in option(line, name)[0].split(",")]


def distance(line):
    return sum((a - b) ** 2 for a, b in zip(vector(line, "--eye"), vector(line, "--target"))) ** 0.5
