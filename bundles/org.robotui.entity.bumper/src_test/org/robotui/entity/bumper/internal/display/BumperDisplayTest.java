package org.robotui.entity.bumper.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class BumperDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new BumperType());

  @BeforeEach
  void placeTheRobot() {
    probe.places().put("base_link", RigidTransform.planar(2, 0, 0));
  }

  @Test
  void bumpersGoWithTheRobotAndSayTheirState() {
    Part part = probe.parts(bumpers(true)).getFirst();
    assertEquals(2, part.fixedFromShape().translation().x());
    assertEquals("bumper 0", part.describer().describe(0, Vector3.ZERO).title());
    assertTrue(part.describer().describe(1, Vector3.ZERO).toString().contains("pressed"));
    assertEquals("1 of 2 pressed", probe.tick().status().words());
    probe.places().put("base_link", RigidTransform.planar(3, 0, 0));
    assertEquals(3, probe.parts().getFirst().fixedFromShape().translation().x());
  }

  @Test
  void aPressedOneIsOfAnotherColorAndThicker() {
    Instances free = (Instances) probe.parts(bumpers(false)).getFirst().shape();
    Instances pressed = (Instances) probe.parts(bumpers(true)).getFirst().shape();
    assertNotEquals(free.rgba(), pressed.rgba());
    int thick = 10 + 8; // place, turn and scale of each box; y of the scale of the second
    assertTrue(pressed.placings().get(thick) > free.placings().get(thick));
  }

  @Test
  void whatDidNotChangeIsTheSameObject() {
    Object shape = probe.parts(bumpers(false)).getFirst().shape();
    assertSame(shape, probe.parts().getFirst().shape());
  }

  @Test
  void aPlaceThatIsNotToldIsSaid() {
    DisplayResult result = probe
        .tick(new Bumpers(FakePlaces.frame("base_link"), List.of(new Bumper(RigidTransform.IDENTITY, 0, 0, true))));
    assertTrue(result.parts().isEmpty());
    assertEquals("1 of 1 pressed; the robot does not tell where 1 of them are", result.status().words());
  }

  @Test
  void anUnknownFrameIsNamedAndBumpersAreBounded() {
    assertInstanceOf(DisplayStatus.NoFrame.class,
        probe.tick(new Bumpers(FakePlaces.frame("lost"), bumpers(true).bumpers())).status());
    Bumper one = new Bumper(RigidTransform.IDENTITY, 0.1, 0, false);
    DisplayResult many = probe.tick(new Bumpers(FakePlaces.frame("base_link"), Collections.nCopies(1000, one)));
    assertEquals(256, ((Instances) many.parts().getFirst().shape()).placings().remaining() / Instances.PLACING);
    assertTrue(many.status().words().contains("the first 256"), many.status().words());
  }

  @Test
  void withoutBumpersItSaysWhy() {
    probe.state(new InputState.Waiting("no state yet"));
    assertEquals("no state yet", probe.tick().status().words());
    assertInstanceOf(DisplayStatus.NoData.class, probe.reset().status());
    probe.close();
  }

  private static Bumpers bumpers(boolean pressed) {
    return new Bumpers(FakePlaces.frame("base_link"),
        List.of(new Bumper(RigidTransform.planar(0.2, 0.1, 0), 0.2, 0, false),
            new Bumper(RigidTransform.planar(0.2, -0.1, 0), 0.2, 0, pressed)));
  }
}
