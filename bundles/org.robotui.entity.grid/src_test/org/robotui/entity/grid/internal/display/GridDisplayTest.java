package org.robotui.entity.grid.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;

class GridDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new GridType());

  @Test
  void linesBoundCellsAroundTheMiddle() {
    Part part = probe.set("cells", 4L).set("cell", 0.5).set("x", 2.0).parts().getFirst();
    assertEquals(10, part.shape().elements());
    assertEquals(3, part.bounds().orElseThrow().high().x(), 1e-6);
    assertEquals(-1, part.bounds().orElseThrow().low().y(), 1e-6);
  }

  @Test
  void planesStandUpright() {
    assertEquals(10, probe.set("plane", "xz").parts().getFirst().bounds().orElseThrow().high().z(), 1e-4);
    assertEquals(0, probe.parts().getFirst().bounds().orElseThrow().high().y(), 1e-4);
    assertEquals(0, probe.set("plane", "yz").parts().getFirst().bounds().orElseThrow().high().x(), 1e-4);
  }

  @Test
  void theSameLinesStayUntilASettingChanges() {
    Object first = probe.parts().getFirst().shape();
    assertSame(first, probe.set("z", 1.0).set("color", "#ffffff").parts().getFirst().shape());
    assertNotSame(first, probe.set("cells", 1000L).parts().getFirst().shape());
    probe.close();
  }

  @Test
  void itLiesInAFrameOrSaysThatThereIsNone() {
    assertInstanceOf(DisplayStatus.NoFrame.class, probe.set("frame", "odom").tick().status());
    probe.places().put("odom", RigidTransform.planar(5, 0, 0));
    assertEquals(5, probe.parts().getFirst().fixedFromShape().translation().x());
    assertEquals(5, probe.set("frame", "robot:odom").parts().getFirst().fixedFromShape().translation().x());
  }

  @Test
  void aColourThatIsNoneIsSaid() {
    assertTrue(probe.set("color", "grey").tick().status().words().contains("no colour"));
  }
}
