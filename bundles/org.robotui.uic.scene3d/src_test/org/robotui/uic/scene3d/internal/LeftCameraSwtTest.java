package org.robotui.uic.scene3d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.FrameId;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.model.Edits;
import org.robotui.uic.scene3d.internal.model.Followed;
import org.robotui.uic.scene3d.internal.render.FakeGl;

/** A scene begins where its camera was left. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LeftCameraSwtTest {
  private static final FrameId MAP = new FrameId("a", "map");
  private static final FrameId BASE = new FrameId("a", "base_link");

  private final Display display = TestDisplay.get();
  private final FakeGl gl = new FakeGl();
  private Theme theme;
  private SceneWindow window;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    gl.atOnce = true;
    window = new SceneWindow(display, theme, 800, 500, List.of(), () -> Optional.of(gl));
    window.frames.fix(MAP, BASE, RigidTransform.planar(7, 2, 0));
    window.tick();
    window.hands().settle();
  }

  @AfterEach
  void close() {
    window.close();
    theme.dispose();
  }

  @Test
  void whereHandsLeaveItIsKeptUnlessAViewIsNamedStart() {
    assertFalse(window.context.settings().current().has(SceneOptions.CAMERA), "nobody moved it");
    window.hands().wheel(3, 300, 200);
    Vector3 left = gl.requests.getLast().eye().fixedFromEye().translation();
    window.canvas().getShell().dispose();
    Edits edits = new Edits(window.context.settings(), List::of);
    assertEquals(0, edits.left().orElseThrow().eye().minus(left).norm(), 1e-6);
    edits.keep(Edits.START, CameraPose.START);
    assertEquals(Optional.empty(), edits.left());
  }

  @Test
  void whatIsFollowedIsInTheMiddleThoughItHasMovedMeanwhile() {
    window.context.settings().set(SceneOptions.FOLLOW, "base_link");
    CameraPose left = CameraPose.START.at(new Vector3(50, 60, 0)).from(3);
    CameraMotion rig = new CameraMotion(left);
    Followed followed = new Followed(window.frames, rig, true);
    followed.tick(window.context.settings().current(), Optional.of(MAP));
    assertEquals(left.at(new Vector3(7, 2, 0)), rig.aim());
    rig.move(pose -> pose.at(new Vector3(8, 2, 0)));
    followed.tick(window.context.settings().current(), Optional.of(MAP));
    assertEquals(new Vector3(8, 2, 0), rig.aim().focus(), "hands move it from there");
  }
}
