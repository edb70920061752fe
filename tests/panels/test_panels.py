"""What the sidebar shows in every state of the armature. Draw code runs as in the window, on a recording layout."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest

from tests.harness import add, import_human, module, select
from tests.panels.recorder import Recorder, draw
from tests.panels.scenario import ARM, edit_by_hand, jumping_human, missing_source

stack = module("stack")
stack_panel, entry, combine, filters, files = (
    module(f"panels.{name}") for name in ("stack", "entry", "combine", "filters", "files")
)

PANELS = (
    stack_panel.MOTION_THEATER_PT_stack,
    entry.MOTION_THEATER_PT_entry,
    combine.MOTION_THEATER_PT_combine,
    filters.MOTION_THEATER_PT_filters,
    stack_panel.MOTION_THEATER_MT_stack_specials,
)


def draw_list_row(index: int) -> Recorder:
    """Draw one row of the list."""
    motion = stack.of(bpy.context.object)
    layout = Recorder()
    row = stack_panel.MOTION_THEATER_UL_entries.draw_item
    row(SimpleNamespace(), bpy.context, layout, motion, motion.entries[index], 0, motion, "active", index, 0)
    return layout


def draw_all() -> None:
    """Draw everything that can be seen; the recorder refuses every name that Blender does not know."""
    for panel in PANELS:
        poll = getattr(panel, "poll", None)
        if poll is None or panel is stack_panel.MOTION_THEATER_MT_stack_specials or panel.poll(bpy.context):
            draw(panel, bpy.context)
            draw(panel, bpy.context, open_panels=False)
    for index in range(len(stack.of(bpy.context.object).entries) if bpy.context.object else 0):
        draw_list_row(index)


def test_a_newcomer_is_told_to_begin_with_a_skeleton() -> None:
    layout = draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context)
    assert "Begin with a skeleton" in layout.texts().replace("\n", " ")
    assert "motion_theater.import_skeleton" in draw(combine.MOTION_THEATER_PT_combine, bpy.context).names("operator")
    draw_all()


def test_with_an_armature_at_hand_the_user_is_told_to_select_it() -> None:
    import_human()
    bpy.context.view_layer.objects.active = None
    assert "Select an armature" in draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context).texts()
    draw_all()


def test_an_object_that_is_no_armature_shows_no_list() -> None:
    mesh = bpy.data.objects.new("mesh", bpy.data.meshes.new("mesh"))
    bpy.context.collection.objects.link(mesh)
    bpy.context.view_layer.objects.active = mesh
    assert not draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context).names("template_list")
    assert not entry.MOTION_THEATER_PT_entry.poll(bpy.context)
    draw_all()


def test_an_empty_stack_says_what_comes_next() -> None:
    import_human()
    layout = draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context)
    assert layout.names("template_list") == ["MOTION_THEATER_UL_entries"]
    assert "Select bones in Pose Mode" in layout.texts()
    assert "Base: rest pose" in layout.texts()
    assert not entry.MOTION_THEATER_PT_entry.poll(bpy.context)
    draw_all()


def test_the_base_is_named_by_its_action() -> None:
    ob = import_human()
    ob.animation_data_create().action = bpy.data.actions.new("Idle")
    add("step_and_jump.amc")
    assert "Base: Idle" in draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context).texts()


def test_a_track_shows_its_file_bones_and_settings() -> None:
    jumping_human()
    layout = draw(entry.MOTION_THEATER_PT_entry, bpy.context)
    shown = set(layout.names("prop"))
    settings = {"source", "all_bones", "cut_start", "cut_end", "scale_start", "scale_end", "blend_depth"}
    details = {"preserve", "preserve_rotation", "preserve_height", "discard", "blend", "sampling", "keys", "rate_hz"}
    assert settings | details <= shown
    assert "Frames 1-113" in layout.texts()
    draw_all()


def test_the_list_shows_frames_depth_and_whether_an_entry_is_on() -> None:
    ob = jumping_human()
    bpy.ops.motion_theater.filter(kind="WEIGHTED", depth=7, selected_only=False)
    assert "7" in draw_list_row(1).texts()
    assert draw_list_row(0).find("enabled").icon == "HIDE_OFF"
    stack.of(ob).entries[0].enabled = False
    row = draw_list_row(0)
    assert row.find("enabled").icon == "HIDE_ON"
    assert not row.find("name").active
    draw_all()


def test_bones_of_an_entry_can_be_selected_and_replaced_where_they_are_not_all() -> None:
    ob = import_human()
    select(ob, ARM)
    add("wave.amc", selected_only=True)
    layout = draw(entry.MOTION_THEATER_PT_entry, bpy.context)
    assert "3 bones" in layout.texts()
    assert {"motion_theater.entry_select_bones", "motion_theater.entry_set_bones"} <= set(layout.names("operator"))


def test_preserving_greys_out_the_blend_depth() -> None:
    ob = jumping_human()
    assert draw(entry.MOTION_THEATER_PT_entry, bpy.context).find("blend_depth").active
    stack.of(ob).entries[0].preserve = True
    assert not draw(entry.MOTION_THEATER_PT_entry, bpy.context).find("blend_depth").active


def test_a_filter_shows_kind_depth_and_bones() -> None:
    jumping_human()
    bpy.ops.motion_theater.filter(kind="MEDIAN", depth=5, selected_only=False)
    layout = draw(entry.MOTION_THEATER_PT_entry, bpy.context)
    assert layout.names("prop") == ["filter_kind", "depth", "filter_channels", "all_bones"]
    draw_all()


def test_a_missing_source_is_said_with_a_way_to_find_it(tmp_path: Path) -> None:
    ob = jumping_human()
    missing_source(ob, tmp_path)
    layout = draw(entry.MOTION_THEATER_PT_entry, bpy.context)
    assert "motion_theater.relink_source" in layout.names("operator")
    assert any(shown.alert and shown.text for shown in layout.shown)
    assert "ERROR" in {shown.icon for shown in draw_list_row(0).shown}
    assert "INFO" not in {shown.icon for shown in draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context).shown}
    draw_all()


def test_hand_edits_raise_an_alert_with_both_ways_out() -> None:
    ob = jumping_human()
    edit_by_hand(ob, "lhumerus")
    layout = draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context)
    assert any(shown.alert and "lhumerus" in shown.text for shown in layout.shown)
    assert "motion_theater.keep_edits" in layout.names("operator")
    assert layout.find("motion_theater.rebuild", over_edits=True).text == "Rebuild Over Them"
    draw_all()


def test_kept_edits_show_their_action_and_bones() -> None:
    ob = jumping_human()
    edit_by_hand(ob, "lhumerus")
    bpy.ops.motion_theater.keep_edits()
    layout = draw(entry.MOTION_THEATER_PT_entry, bpy.context)
    assert "action" in layout.names("prop")
    assert "1 bone" in layout.texts()
    draw_all()


def test_a_notice_is_shown_with_its_entry() -> None:
    ob = jumping_human()
    add("wave.amc", scale_start=3, scale_end=20, blend_depth=10)
    assert stack.of(ob).entries[1].notices, "the blend depth cannot be supplied there, which is said"
    assert "INFO" in {shown.icon for shown in draw(entry.MOTION_THEATER_PT_entry, bpy.context).shown}
    assert "INFO" in {shown.icon for shown in draw_list_row(1).shown}


def test_the_last_message_stays_in_the_panel() -> None:
    ob = jumping_human()
    assert stack.of(ob).message
    shown = draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context).texts().replace("\n", " ")
    assert stack.of(ob).message in shown


def test_an_armature_that_cannot_be_edited_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    jumping_human()
    monkeypatch.setattr(stack_panel.rig, "writable_reason", lambda ob: "The armature is linked from another file")
    layout = draw(stack_panel.MOTION_THEATER_PT_stack, bpy.context)
    assert "linked from another file" in layout.texts().replace("\n", " ")
    assert "LOCKED" in {shown.icon for shown in layout.shown}


def test_selected_bones_only_with_none_selected_greys_the_button_and_says_why() -> None:
    ob = import_human()
    options = bpy.context.window_manager.motion_theater
    options.selected_only = True
    select(ob, ())
    layout = draw(combine.MOTION_THEATER_PT_combine, bpy.context)
    assert not layout.find("motion_theater.add_track").enabled
    assert "No bones are selected" in layout.texts()
    select(ob, ARM)
    layout = draw(combine.MOTION_THEATER_PT_combine, bpy.context)
    assert layout.find("motion_theater.add_track").enabled
    assert "No bones are selected" not in layout.texts()


def test_the_button_gives_the_operator_what_the_form_holds() -> None:
    import_human()
    options = bpy.context.window_manager.motion_theater
    options.cut_start, options.cut_end, options.blend_depth = 67, 113, 10
    button = draw(combine.MOTION_THEATER_PT_combine, bpy.context).find("motion_theater.add_track")
    assert button.properties["cut_start"] == 67
    assert button.properties["cut_end"] == 113
    assert button.properties["blend_depth"] == 10
    assert button.properties["scale_start"] == 0


def test_the_button_gives_the_operator_what_is_remembered_as_preferences(monkeypatch: pytest.MonkeyPatch) -> None:
    import_human()
    remembered = SimpleNamespace(
        rate="SAMPLES", scene_range="FIT", bl_rna=module("preferences").MotionTheaterPreferences.bl_rna
    )
    monkeypatch.setattr(combine.preferences, "get", lambda context: remembered)
    layout = draw(combine.MOTION_THEATER_PT_combine, bpy.context)
    button = layout.find("motion_theater.add_track")
    assert (button.properties["rate"], button.properties["scene_range"]) == ("SAMPLES", "FIT")
    assert {"rate", "scene_range"} <= set(layout.names("prop"))


@pytest.mark.parametrize(("choice", "depth"), [("3", 3), ("7", 7), ("CUSTOM", 11)])
def test_the_filter_buttons_give_kind_depth_and_bones(choice: str, depth: int) -> None:
    import_human()
    options = bpy.context.window_manager.motion_theater
    options.filter_kind, options.depth, options.custom_depth = "AVERAGE", choice, 11
    layout = draw(filters.MOTION_THEATER_PT_filters, bpy.context)
    for selected_only in (True, False):
        button = layout.find("motion_theater.filter", selected_only=selected_only)
        assert button.properties["kind"] == "AVERAGE"
        assert button.properties["depth"] == depth
    assert ("custom_depth" in layout.names("prop")) == (choice == "CUSTOM")


def test_the_menus_of_file_offer_every_kind_of_file() -> None:
    layout = Recorder()
    files.draw_import_menu(SimpleNamespace(layout=layout), bpy.context)
    files.draw_export_menu(SimpleNamespace(layout=layout), bpy.context)
    assert [(shown.name, shown.text) for shown in layout.shown] == [
        ("motion_theater.import_motion_capture", "Motion Capture (.bvh/.asf/.amc/.c3d/.csm/.trc)"),
        ("motion_theater.export_bvh", "Motion Capture as BVH (.bvh)"),
        ("motion_theater.export_acclaim", "Motion Capture as Acclaim (.asf + .amc)"),
        ("motion_theater.export_c3d", "Markers as C3D (.c3d)"),
        ("motion_theater.export_csm", "Markers as CSM (.csm)"),
        ("motion_theater.export_trc", "Markers as TRC (.trc)"),
    ]


def test_drawing_changes_nothing(tmp_path: Path) -> None:
    ob = jumping_human()
    missing_source(ob, tmp_path)
    before = [(prop, str(getattr(one, prop))) for one in stack.of(ob).entries for prop in one.bl_rna.properties.keys()]  # noqa: SIM118
    draw_all()
    after = [(prop, str(getattr(one, prop))) for one in stack.of(ob).entries for prop in one.bl_rna.properties.keys()]  # noqa: SIM118
    assert before == after
