package org.robotui.rfic.player.internal.convert;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.sensor.Bumpers;
import org.robotui.player.interfaces.Bumper;
import org.robotui.player.interfaces.Pose3d;

class BumperPartsTest {
  private static final FrameId BASE = new FrameId("r", "base_link");
  private static final List<Bumper.Part> PARTS = List.of(new Bumper.Part(new Pose3d(0.25, 0.1, 0.05, 0, 0, 0), 0.2f, 0),
      new Bumper.Part(new Pose3d(-0.25, 0, 0.05, 0, 0, Math.PI), 0.4f, 0.25f));

  @Test
  void theyAreWhereTheGeometrySaysAndPressedAsTheStateSays() {
    Bumpers bumpers = BumperParts.of(PARTS, new byte[]{0, 3}, BASE);
    assertEquals(BASE, bumpers.frame());
    assertEquals(0.1, bumpers.bumpers().get(0).pose().translation().y(), 1e-9);
    assertEquals(0.05, bumpers.bumpers().get(0).pose().translation().z(), 1e-9);
    assertEquals(0.2, bumpers.bumpers().get(0).length(), 1e-6);
    assertFalse(bumpers.bumpers().get(0).pressed());
    assertEquals(Math.PI, Math.abs(bumpers.bumpers().get(1).pose().rotation().yaw()), 1e-9);
    assertEquals(0.25, bumpers.bumpers().get(1).radius(), 1e-6);
    assertTrue(bumpers.bumpers().get(1).pressed(), "some devices tell the corner");
  }

  @Test
  void whatOneOfThemDoesNotTellIsNotInvented() {
    Bumpers more = BumperParts.of(PARTS, new byte[]{0, 0, 1}, BASE);
    assertEquals(0, more.bumpers().get(2).length());
    assertTrue(more.bumpers().get(2).pressed());
    assertEquals(0, BumperParts.of(PARTS, new byte[0], BASE).pressed());
    assertEquals(2, BumperParts.of(PARTS, new byte[0], BASE).bumpers().size());
  }

  @Test
  void whatCannotBeIsRefusedOrLeftOut() {
    assertThrows(IllegalArgumentException.class, () -> BumperParts.of(List.of(), new byte[257], BASE));
    Bumper.Part mad = new Bumper.Part(new Pose3d(Double.NaN, 0, 0, 0, 0, 0), Float.POSITIVE_INFINITY, Float.NaN);
    assertEquals(0, BumperParts.of(List.of(mad), new byte[1], BASE).bumpers().getFirst().length());
  }
}
