package org.robotui.entity.grid.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;

class AxesDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new AxesType());

  @Test
  void theFixedFrameIsShownWhereNoneIsNamed() {
    List<Part> parts = probe.parts();
    assertEquals("map", ((Label) parts.get(1).shape()).text());
    assertSame(parts.getFirst().shape(), probe.parts().getFirst().shape());
    assertEquals(1, probe.set("label", false).parts().size());
  }

  @Test
  void aFrameIsFollowedAndSaysWhereItIs() {
    assertInstanceOf(DisplayStatus.NoFrame.class, probe.set("frame", "base").tick().status());
    probe.places().put("base", RigidTransform.planar(1, 2, Math.PI / 2));
    Part part = probe.parts().getFirst();
    assertTrue(part.describer().describe(0, Vector3.ZERO).toString().contains("90.0\u00b0"));
    assertEquals(2, part.fixedFromShape().translation().y());
    assertEquals(2, probe.set("frame", "robot/base").parts().getFirst().fixedFromShape().translation().y());
    assertEquals(2, probe.set("frame", "robot:base").parts().getFirst().fixedFromShape().translation().y());
    assertInstanceOf(DisplayStatus.NoFrame.class, probe.set("frame", "other/base").tick().status());
    probe.close();
  }
}
