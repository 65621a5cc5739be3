#!/usr/bin/env python3
"""The viewer as a user has it, on a display without a screen: tests/viewer/window.py PROGRAM BACKEND NAME"""
import base64
import json
import shlex
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path

from desk import PATIENCE, Desk, Viewer, distance, option, vector

SOURCE = Path(__file__).resolve().parents[2]
SCENE = str(SOURCE / "assets/scenes/slabs-0.2.glb")
SMALL = ["--samples", "2", "--fps", "5"]
PLAIN = ["--method", "standard", "--env", "0.5,0.6,0.7"] # fewer shaders, and no environment to prefilter: most tests need neither
PROGRAM, BACKEND = "", ""
RECENT_SECOND = 46 # below the list of recent files, its second entry
ALPHA_ROW = 199  # of the slider, in a window with the panel as it begins
SECOND_ROW, CAMERA_ROW = 380, 428 # of a list and a header, there


def moving(path, half=1.0, cameras=0):
    """A glTF file of a square of gold that an animation moves for a second, of `half` metres to each side, and so many cameras."""
    floats = [half * f for f in (-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0)] + [0, 1, 0, 0, 0, 2, 0, 0]
    data = struct.pack("<20f6H", *floats, 0, 1, 2, 0, 2, 3)
    view = lambda at, length: {"buffer": 0, "byteOffset": at, "byteLength": length}
    accessor = lambda at, component, count, kind, **rest: {
        "bufferView": at, "componentType": component, "count": count, "type": kind, **rest}
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(1 + cameras))}],
        "nodes": [{"mesh": 0}] + [{"camera": i, "translation": [0, 0, 4 + i]} for i in range(cameras)],
        **({"cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}] * cameras} if cameras else {}),
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 3, "material": 0}]}],
        "materials": [{"extras": {"groundglass": {"preset": "gold", "alpha": 0.3}}}],
        "animations": [{"samplers": [{"input": 1, "output": 2}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [view(0, 48), view(48, 8), view(56, 24), view(80, 12)],
        "accessors": [accessor(0, 5126, 4, "VEC3", min=[-half, -half, 0], max=[half, half, 0]),
                      accessor(1, 5126, 2, "SCALAR", min=[0], max=[1]), accessor(2, 5126, 2, "VEC3"),
                      accessor(3, 5123, 6, "SCALAR")]}))


def viewer(desk, *arguments, scene=SCENE, plain=True, **rest):
    return Viewer(desk, PROGRAM, [scene, "--backend", BACKEND, *SMALL, *(PLAIN if plain else []), *arguments], **rest)


def with_square(desk, *arguments, **rest):
    """The simplest scene, where what is shown does not matter."""
    moving(desk.path / "square.gltf")
    return viewer(desk, *arguments, scene=str(desk.path / "square.gltf"), **rest)


def capture(v, line):
    """Runs a copied line; the viewer's compiled shaders serve it too."""
    words = shlex.split(line)
    subprocess.run([PROGRAM, *words[1:]], cwd=v.desk.path, check=True, stdout=subprocess.DEVNULL, env=v.environment)


def colours(desk, left, top, right, bottom):
    return {pixel for row in desk.screen()[top:bottom] for pixel in row[left:right]}


def dragging_orbits_and_the_wheel_comes_closer():
    with Desk() as desk, with_square(desk, "--no-panel", size=(320, 240)).open() as v:
        assert not option(v.copied(), "--eye")
        v.drag((150, 150), (200, 165))
        before = v.copied_when(lambda line: option(line, "--eye"), "dragging did not move the camera")
        v.drag((150, 150), (200, 165))
        after = v.copied()
        assert vector(before, "--target") == vector(after, "--target")
        assert abs(distance(before) / distance(after) - 1) < 1e-4
        assert vector(before, "--eye") != vector(after, "--eye")
        v.click(150, 150, button=4)
        v.copied_when(lambda line: distance(line) < 0.95 * distance(after), "the wheel did not come closer")
        v.drag((150, 150), (200, 165), button=3)
        panned = v.copied()
        assert vector(panned, "--target") != vector(after, "--target")
        v.key("5")
        line = v.copied_when(lambda line: option(line, "--ortho"), "the camera stayed perspective")
        assert float(option(line, "--ortho")[0]) > 0 and not option(line, "--fovy")
        capture(v, line)
        v.key("5")
        v.copied_when(lambda line: not option(line, "--ortho"), "the camera stayed orthographic")
        assert v.close() == 0, v.errors()


def a_key_is_answered_within_two_frames():
    with Desk(320, 240) as desk, with_square(desk, "--no-panel", size=(320, 240)).open() as v:
        picture = lambda screen: screen[:200] # above the status line, which changes with each frame
        for _ in range(2):
            v.rest()
            before = seen = desk.screen()
            frames = 0
            v.key("Right", pause=0.0)
            while picture(seen) == picture(before):
                now = desk.screen()
                while now.data != (again := desk.screen()).data: # it is being written
                    now = again
                frames += now.data != seen.data
                seen = now
                assert frames <= 2, "two frames passed without an answer"
        assert v.close() == 0, v.errors()


def a_slider_changes_what_is_picked_and_undo_takes_it_back():
    # Layers are set, not drawn: that would compile them.
    with Desk() as desk, with_square(desk, "--without", "clearcoat,iridescence,anisotropy", size=(500, 400)).open() as v:
        v.click(80, 200)
        # Below the name: the first control is the preset, then alpha. A click into a slider sets it.
        for row, key in ((0, "alpha"), (4, "clearcoat"), (5, "iridescence"), (6, "anisotropy")):
            v.click(240, ALPHA_ROW + 24 * row)
            changed = v.copied_when(lambda line: option(line, "--material"), "nothing set " + key)
            spec, = option(changed, "--material")
            assert spec.startswith("#") and key + "=" in spec, spec
            v.key("z", "Control_L")
            v.copied_when(lambda line: not option(line, "--material"), "undo left " + key)
        v.key("y", "Control_L")
        v.copied_when(lambda line: option(line, "--material") == [spec], "redo did not bring it back")
        assert v.close() == 0, v.errors()


def a_typed_number_stays_in_its_range():
    with Desk() as desk, with_square(desk, size=(500, 400)).open() as v:
        v.click(80, 200)
        # The last is infinity times 0; then a field that was emptied, and words.
        for text, alpha in (("1e9", 1), ("-1", 0), ("*1e39", 0), ("0.25", 0.25), ("", 0.25), ("nan", 0.25)):
            v.type_into(240, ALPHA_ROW, text)
            v.copied_when(lambda line: f"alpha={alpha:g}" in str(option(line, "--material")), f"'{text}' did not set {alpha}")
        assert v.close() == 0, v.errors()


def assert_saved_is_copied(desk, v):
    """The picture that the window saves is that of the line which it prints."""
    v.key("s", "Control_L")
    line = v.read_line()
    saved = (desk.path / "groundglass.png").read_bytes()
    (desk.path / "groundglass.png").unlink()
    capture(v, line)
    assert (desk.path / "groundglass.png").read_bytes() == saved


def the_copied_line_reproduces_the_saved_picture():
    with Desk() as desk, viewer(desk, "--exposure", "0.5", "--material", "*=,alpha=0.2", "--background", "blurred",
                                "--without", "neighbours", scene=str(SOURCE / "assets/scenes/panes.glb"), plain=False,
                                size=(600, 240)).open() as v:
        assert "panes.glb" in v.title()
        v.wait_for(lambda: len(colours(desk, 50, 50, 250, 200)) > 100, "a picture")
        v.drag((100, 150), (140, 160))
        assert_saved_is_copied(desk, v)
        assert v.close() == 0, v.errors()


def a_dropped_scene_is_shown_and_a_broken_one_leaves_it():
    with Desk() as desk, with_square(desk, "--no-panel", size=(480, 300)).open() as v:
        broken = desk.path / "broken.glb"
        broken.write_bytes(Path(SCENE).read_bytes()[:500])
        good = desk.path / "panes.glb"
        shutil.copy(SOURCE / "assets/scenes/panes.glb", good)
        v.drop(good)
        v.wait_for(lambda: "panes.glb" in v.title(), "the dropped scene")
        v.drop(broken)
        # The message lies over the top of the picture, on the panels' dark ground.
        v.wait_for(lambda: (15, 15, 15) in {tuple(min(c, 15) for c in p) for p in colours(desk, 250, 20, 350, 22)}, "a message")
        assert "panes.glb" in v.copied()
        v.drop(SOURCE / "assets/environments/studio_small_03_1k.hdr")
        v.wait_for(lambda: "studio_small_03_1k.hdr" in v.copied(), "the dropped environment")
        assert v.close() == 0, v.errors()


def the_truth_is_shown_beside_the_picture_and_the_wipe_is_dragged():
    # A truth that ends: the screen comes to rest, which the hand waits for.
    with Desk() as desk, viewer(desk, "--no-panel", "--truth", "8", size=(320, 240)).open() as v:
        def bar():
            screen = desk.screen() # above the status line
            return [x for x in range(5, 315) if screen[20][x] == screen[180][x] == (255, 255, 255)]
        v.wait_for(lambda: any(155 < x < 165 for x in bar()), "the bar between picture and truth")
        v.key("t")
        v.wait_for(lambda: not bar(), "the picture alone")
        v.key("t")
        v.wait_for(lambda: any(155 < x < 165 for x in bar()), "the bar again")
        v.drag((160, 120), (80, 120))
        v.wait_for(lambda: any(72 < x < 88 for x in bar()), "the bar where it was dragged to")
        assert v.close() == 0, v.errors()


def a_second_method_stands_in_the_truths_place():
    with Desk() as desk, viewer(desk, "--no-panel", "--second", "lobes1", scene=str(SOURCE / "assets/scenes/panes.glb"),
                                size=(320, 240)).open() as v:
        def bar():
            screen = desk.screen()
            return any(screen[20][x] == screen[180][x] == (255, 255, 255) for x in range(155, 166))
        v.wait_for(bar, "the bar between two methods")
        v.rest()
        both = desk.screen()
        v.key("t")
        v.wait_for(lambda: not bar(), "the first alone")
        first = desk.screen()
        right = lambda rows: [row[170:315] for row in rows[60:180]]
        left = lambda rows: [row[5:150] for row in rows[60:180]]
        assert left(both) == left(first) and right(both) != right(first), "the second is not beside the first"
        assert v.close() == 0, v.errors()


def the_files_cameras_and_a_second_method_are_chosen_in_the_panel():
    with Desk() as desk:
        scene = desk.path / "square.gltf"
        moving(scene, cameras=2)
        with viewer(desk, scene=str(scene), size=(960, 600)).open() as v:
            def choose(row, entry):
                v.click(720, row)
                v.click(720, row + 25 + 18 * entry)
            v.click(720, CAMERA_ROW)
            choose(CAMERA_ROW + 24, 2) # after the first of the file and number 0
            v.copied_when(lambda line: option(line, "--camera") == ["1"], "the second camera was not chosen")
            choose(SECOND_ROW, 1) # after the truth
            white = (255, 255, 255)
            v.wait_for(lambda: any(desk.screen()[20][x] == desk.screen()[500][x] == white for x in range(305, 316)),
                       "the bar between two methods")
            assert v.close() == 0, v.errors()


def a_hundred_sizes_are_survived():
    with Desk() as desk, with_square(desk, "--no-panel", size=(320, 240)).open() as v:
        for i in range(100):
            v.window.configure(width=330 + 61 * i % 600, height=250 + 37 * i % 400)
            desk.display.sync()
            time.sleep(0.02)
        v.window.configure(width=400, height=300)
        desk.display.sync()
        v.copied_when(lambda line: option(line, "--size") == ["400x300"], "the last size")
        assert v.close() == 0, v.errors()


def the_end_of_the_display_ends_it_with_a_message():
    with Desk() as desk, with_square(desk, "--no-panel", "--truth", "100000", size=(320, 240)).open() as v:
        desk.end()
        assert v.process.wait(PATIENCE) == 6, v.errors()
        assert "the display has ended" in v.errors().splitlines()[-1], v.errors()


def closing_while_loading_ends_it():
    with Desk() as desk, viewer(desk, scene=str(SOURCE / "assets/scenes/GlassVaseFlowers.glb")) as v:
        assert v.close() == 0, v.errors()


def closing_while_tracing_ends_it():
    with Desk() as desk, viewer(desk, "--no-panel", "--truth", "100000", size=(320, 240)).open() as v:
        v.wait_for(lambda: desk.screen()[20][160] == desk.screen()[180][160] == (255, 255, 255), "the bar beside a truth")
        assert v.close() == 0, v.errors()


def a_file_that_changes_is_read_again():
    with Desk() as desk:
        scene = desk.path / "changing.glb"
        shutil.copy(SOURCE / "assets/scenes/panes.glb", scene)
        with viewer(desk, "--no-panel", scene=str(scene), size=(320, 240)).open() as v:
            v.rest()
            before = colours(desk, 10, 10, 310, 200)
            shutil.copy(SOURCE / "assets/scenes/slabs-2.glb", scene)
            v.wait_for(lambda: len(colours(desk, 10, 10, 310, 200) ^ before) > 50, "the new picture")
            assert v.close() == 0, v.errors()


def a_saved_shader_is_compiled_and_its_error_shown():
    # Of a copy of the program's own files: shaders are found beside assets.
    with Desk() as desk:
        home = desk.path / "home"
        shutil.copytree(SOURCE / "shaders", home / "shaders")
        (home / "assets").symlink_to(SOURCE / "assets")
        with with_square(desk, "--no-panel", "--tonemap", "none", size=(320, 240), home=home).open() as v:
            v.rest()
            stage = home / "shaders/stages/display.frag"
            text = stage.read_text()
            before = colours(desk, 10, 10, 310, 60)
            stage.write_text(text.replace("outColor = vec4(color, 1.0);", "outColor = vec4(colour, 1.0);"))
            # The message lies over the middle of the picture, on the panels' dark ground; the picture stays.
            dark = lambda: any(max(p) < 40 for p in colours(desk, 30, 118, 290, 122))
            v.wait_for(dark, "the compiler's message")
            assert colours(desk, 10, 10, 310, 60) == before
            stage.write_text(text.replace("outColor = vec4(color, 1.0);", "outColor = vec4(1.0, 0.0, 1.0, 1.0);"))
            v.wait_for(lambda: colours(desk, 10, 10, 310, 60) == {(255, 0, 255)}, "the new shader")
            assert v.close() == 0, v.errors()


def the_lobes_under_the_cursor_are_shown():
    with Desk() as desk, with_square(desk, "--no-panel", size=(640, 480)).open() as v:
        v.rest()
        before = desk.screen()
        v.move(320, 240)
        v.key("i")
        # Its panel lies at the top left, with the colours of its curves.
        v.wait_for(lambda: (255, 170, 60) in colours(desk, 8, 8, 250, 400), "the reflected lobe")
        v.key("i")
        v.wait_for(lambda: desk.screen()[100][100] == before[100][100], "the picture alone")
        assert v.close() == 0, v.errors()


def debug_views_are_shown():
    # The slabs face the camera; their front is 5.9 m away and 0.12 m thick.
    with Desk() as desk, viewer(desk, "--no-panel", "--debug-view", "normals", size=(640, 480)).open() as v:
        near = lambda p, q: all(abs(a - b) <= 2 for a, b in zip(p, q))
        facing = lambda: near(desk.screen()[240][100], (128, 128, 255))
        v.wait_for(facing, "the normal of what faces the camera")
        for _ in range(3): # depth, layers, length inside
            v.key("v")
        glass_alone = lambda: desk.screen()[20][320] == (0, 0, 0) != desk.screen()[240][300]
        v.wait_for(glass_alone, "the length in solids alone")
        v.key("v") # sigma of the lobe that passes
        v.wait_for(glass_alone, "the width of what passes glass")
        v.key("v") # share of the screen: between blue and orange
        def mixed():
            red, green, blue = desk.screen()[240][300]
            t = (red / 255 - 0.13) / 0.87
            return -0.02 < t < 1.02 and abs(green / 255 - (0.33 + 0.32 * t)) < 0.02 and abs(blue / 255 - (0.8 - 0.6 * t)) < 0.02
        v.wait_for(mixed, "the share of the screen")
        v.key("v") # lookups: everything that is drawn makes some
        v.wait_for(lambda: desk.screen()[240][300] != (0, 0, 0) and not mixed(), "the lookups")
        v.key("v")
        v.wait_for(lambda: len(colours(desk, 10, 10, 600, 200)) > 100, "the picture")
        assert v.close() == 0, v.errors()


def the_first_turn_and_the_first_slider_compile_nothing():
    # So many frames a second that the size is the smallest from the start. What is made is told by features, not by methods.
    with Desk() as desk, Viewer(desk, PROGRAM, [SCENE, "--backend", BACKEND, "--samples", "1", "--no-panel", *PLAIN, "--bench-orbit",
                                                "8", "--fps", "1000", "--json", "times.json"], size=(160, 120)) as v:
        assert v.process.wait(PATIENCE) == 0, v.errors()
        times = json.loads((desk.path / "times.json").read_text())
        for part in ("full", "paced", "slider"):
            assert times[part]["resources_created"] == 0, times
            assert times[part]["frame_ms"]["worst"] >= times[part]["frame_ms"]["p95"] > 0, times
        for part in ("paced", "slider"):
            assert times[part]["first_time"]["compiled"] == 0, times


def at_twice_the_scale_the_panel_fits():
    with Desk(960, 600) as desk:
        desk.set_scale(2)
        with with_square(desk, size=(480, 300)).open() as v: # of the desktop's units: two pixels each
            assert v.window.get_geometry().width == 960, "the window does not take the display's scale"
            v.rest()
            # The button beside the path ends at the panel's padding, 16 pixels from its scroll bar; one that is cut ends at 8.
            row = desk.screen()[84]
            panel, button = row[925], row[912]
            assert set(row[918:930]) == {panel} and button != panel, row[900:960]
            assert v.close() == 0, v.errors()


def an_animation_plays_and_stands_still():
    with Desk() as desk:
        scene = desk.path / "moving.gltf"
        moving(scene)
        with viewer(desk, "--no-panel", scene=str(scene), size=(320, 240)).open() as v:
            assert not option(v.copied(), "--time")
            v.key("p")
            v.copied_when(lambda line: option(line, "--time") and float(option(line, "--time")[0]) > 0.1, "it does not play")
            v.key("p")
            v.rest()
            line = v.copied()
            time.sleep(0.1)
            assert v.copied() == line and option(line, "--eye"), line
            assert_saved_is_copied(desk, v)
            assert v.close() == 0, v.errors()


def the_view_is_framed_turned_and_shown_on_the_full_screen():
    with Desk() as desk:
        scene = desk.path / "square.gltf"
        moving(scene, cameras=2)
        with viewer(desk, "--no-panel", scene=str(scene), size=(320, 240)).open() as v:
            seen = lambda: len(colours(desk, 150, 110, 170, 130) - colours(desk, 0, 0, 4, 100))
            for _ in range(12):
                v.key("minus")
            far = v.copied_when(lambda line: option(line, "--eye") and distance(line) > 10, "the key moved nothing away")
            v.key("f")
            framed = v.copied_when(lambda line: distance(line) < 0.6 * distance(far), "not all was framed")
            v.key("minus")
            v.rest()
            v.click(160, 120)
            v.key("period")
            v.copied_when(lambda line: abs(distance(line) / distance(framed) - 1) < 0.01, "what is picked was not framed")
            v.key("r")
            v.copied_when(lambda line: abs(vector(line, "--eye")[0]) > 0.2, "the turntable stands")
            v.key("r")
            v.rest()
            line = v.copied()
            time.sleep(0.3)
            assert v.copied() == line, "the turntable goes on"
            v.key("F11")
            v.wait_for(lambda: v.window.get_geometry().width == 980, "the full screen")
            v.copied_when(lambda line: option(line, "--size") == ["980x660"], "the picture of the full screen")
            v.key("F11")
            v.copied_when(lambda line: option(line, "--size") == ["320x240"], "the window again")
            v.window.unmap() # as window managers hide it
            desk.display.sync()
            time.sleep(0.3)
            v.window.map()
            desk.display.sync()
            v.rest()
            assert seen(), "the window is empty after it was hidden"
            assert v.close() == 0, v.errors()


def a_typed_path_is_opened_and_a_recent_one_chosen():
    with Desk() as desk:
        moving(desk.path / "a.gltf")
        moving(desk.path / "b.gltf")
        with viewer(desk, scene=str(desk.path / "b.gltf"), size=(500, 400), own_lists=True).open() as v:
            v.click(240, 42)
            for key in ("a", "period", "g", "l", "t", "f", "Return"):
                v.key(key)
            v.wait_for(lambda: "a.gltf" in v.title(), "the scene whose path was typed")
            recent = (Path(v.environment["XDG_CACHE_HOME"]) / "groundglass/recent-scenes").read_text().splitlines()
            assert [Path(line).name for line in recent[:2]] == ["a.gltf", "b.gltf"], recent
            v.click(240, 66)
            v.click(240, 66 + RECENT_SECOND)
            v.wait_for(lambda: "b.gltf" in v.title(), "the recent file")
            assert v.close() == 0, v.errors()


def what_is_millimetres_wide_or_a_hundred_metres_is_seen():
    with Desk() as desk, with_square(desk, "--no-panel", size=(320, 240)).open() as v:
        for name, half in (("narrow", 0.00375), ("wide", 50.0)):
            moving(desk.path / f"{name}.gltf", half=half)
            v.drop(desk.path / f"{name}.gltf")
            v.wait_for(lambda: name in v.title(), "the square")
            v.drag((100, 100), (130, 110))
            line = v.copied_when(lambda line: option(line, "--eye"), "it does not turn")
            assert 2 * half < distance(line) < 10 * half, line
            assert desk.screen()[120][160] != desk.screen()[4][4], "nothing is seen in the middle"
            assert_saved_is_copied(desk, v)
        assert v.close() == 0, v.errors()


def validation_is_silent():
    # The layer speaks on standard output where nobody listens to it.
    # What is drawn with is looked at by the tests that need no window; here it is windows, panels and what is shown beside a picture.
    with Desk() as desk, viewer(desk, "--truth", "4", size=(560, 240), layers="VK_LAYER_KHRONOS_validation").open() as v:
        for width in (620, 500, 560):
            v.window.configure(width=width, height=240)
            desk.display.sync()
            v.rest()
        v.click(80, 120)
        for key in ("t", "m", "t", "i", "v"):
            v.key(key)
            v.rest()
        line = v.copied()
        assert line.startswith("groundglass capture"), line
        assert v.close() == 0, v.errors()
        said = v.buffer + v.process.stdout.read().decode()
        assert "alidation" not in said + v.errors(), said + v.errors()


def without_a_display_it_says_what_to_do():
    finished = subprocess.run([PROGRAM, "view", "--backend", BACKEND], env={"PATH": "/usr/bin"}, capture_output=True, text=True)
    assert finished.returncode == 6, finished
    assert "capture" in finished.stderr


if __name__ == "__main__":
    PROGRAM = str(Path(sys.argv[1]).resolve())
    BACKEND = sys.argv[2]
    globals()[sys.argv[3]]()
