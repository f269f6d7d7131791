package org.robotui.entity.pointcloud.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.api.port.InputState;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Properties;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class PointCloudDisplayTest {
  private static final int FIRST = 0x30123bff;
  private static final int LAST = 0x7a0403ff;

  private final DisplayProbe probe = new DisplayProbe(new PointCloudType());

  @BeforeEach
  void placeTheLidar() {
    probe.places().put("lidar", new RigidTransform(new Vector3(1, 2, 3), Quaternion.IDENTITY));
  }

  @Test
  void allPointsComeOnceEachInTheFrameOfTheCloud() {
    Part part = probe.parts(Clouds.line(1000)).getFirst();
    PointSet set = (PointSet) part.shape();
    Set<Float> seen = new TreeSet<>();
    for (int i = 0; i < 1000; i++) {
      seen.add(set.xyz().get(3 * i));
      assertEquals(0 - set.xyz().get(3 * i), set.xyz().get(3 * i + 2), 0.0);
    }
    assertEquals(1000, seen.size());
    assertEquals(1, part.fixedFromShape().translation().x());
    assertEquals(999, set.bounds().orElseThrow().high().x());
  }

  @Test
  void ofTheMostThatAreWantedEveryNthIsSpreadEvenlyOverTheCloud() {
    probe.set("most_points", 10_000L);
    PointSet set = points(Clouds.line(20_000));
    assertEquals(10_000, set.elements());
    for (int nth : new int[]{1, 2, 3, 7, 10, 16}) {
      int[] tenths = new int[10];
      int taken = 0;
      for (int i = 0; i < 10_000 && taken < 600; i += nth, taken++) {
        tenths[(int) (set.xyz().get(3 * i) / 2000)]++;
      }
      for (int count : tenths) {
        assertTrue(count >= 48 && count <= 72, "every " + nth + "th: " + List.of(tenths[0], tenths[5], count));
      }
    }
  }

  @Test
  void theSameShapeStaysWhileNothingChanged() {
    PointSet first = points(Clouds.line(10));
    assertSame(first, probe.parts().getFirst().shape());
    probe.places().put("lidar", RigidTransform.planar(5, 0, 0));
    assertSame(first, probe.parts().getFirst().shape());
    assertNotSame(first, probe.set("size", 3.0).parts().getFirst().shape());
  }

  @ParameterizedTest
  @EnumSource(PointField.Format.class)
  void everyFormatOfCoordinatesAndBothByteOrdersAreRead(PointField.Format format) {
    for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
      int size = format.size();
      ByteBuffer bytes = ByteBuffer.allocate(2 * 40).order(order);
      for (int row = 0; row < 2; row++) {
        for (int axis = 0; axis < 3; axis++) {
          put(bytes, row * 40 + 1 + axis * size, format, 10 * row + axis);
        }
      }
      PointCloud cloud = new PointCloud(FakePlaces.frame("lidar"), 1, 2, List.of(Clouds.field("x", 1, format),
          Clouds.field("y", 1 + size, format), Clouds.field("z", 1 + 2 * size, format)), 30, 40, order, true,
          Bytes.of(bytes.array()));
      PointSet set = points(cloud);
      assertEquals(2, set.elements());
      assertEquals(12, set.bounds().orElseThrow().high().z());
      assertEquals(0, set.bounds().orElseThrow().low().x());
    }
  }

  @Test
  void intensityColoursFromItsLeastToItsGreatest() {
    PointSet set = points(Clouds.line(5));
    assertEquals(Set.of(FIRST, LAST), Set.of(colorAt(set, 0), colorAt(set, 4)));
    probe.set("max", 1e6);
    assertEquals(FIRST, colorAt((PointSet) probe.parts().getFirst().shape(), 4));
    probe.set("max", 40.0).set("reverse", true);
    assertEquals(LAST, colorAt((PointSet) probe.parts().getFirst().shape(), 0));
  }

  @Test
  void anAxisColoursInTheFixedFrameOrItsOwn() {
    probe.places().put("lidar", new RigidTransform(Vector3.ZERO, Quaternion.fromRollPitchYaw(0, Math.PI, 0)));
    probe.set("color_by", "axis").set("axis", "z");
    assertEquals(FIRST, colorAt(points(Clouds.line(5)), 0));
    probe.set("axis_frame", "own");
    assertEquals(LAST, colorAt((PointSet) probe.parts().getFirst().shape(), 0));
  }

  @Test
  void coloursOfItsOwnAreUnpacked() {
    ByteBuffer bytes = ByteBuffer.allocate(16).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putFloat(1).putFloat(2).putFloat(3).putInt(0x40102030);
    assertEquals(0x102030ff, colorAt(points(Clouds.plain(1, bytes, "rgb")), 1));
    assertEquals(0x10203040, colorAt(points(Clouds.plain(1, bytes, "rgba")), 1));
  }

  @Test
  void oneColourAndOpacityAreTheMaterials() {
    probe.set("color_by", "flat").set("color", "#ff000080").set("opacity", 0.5);
    Part part = probe.parts(Clouds.line(3)).getFirst();
    assertTrue(((PointSet) part.shape()).rgba().isEmpty());
    assertEquals(0xff000040, part.material().color().packed());
  }

  @Test
  void aMissingFieldIsSaidAndThePointsAreShown() {
    probe.set("color_by", "field").set("field", "ring");
    DisplayResult result = probe.tick(Clouds.line(3));
    assertEquals(3, result.parts().getFirst().shape().elements());
    assertTrue(result.status().words().contains("no field ring to colour by; there are x, y, z, intensity"),
        result.status().words());
    assertTrue(probe.set("color_by", "rgb").tick().status() instanceof DisplayStatus.Partly);
  }

  @Test
  void aCloudWithoutCoordinatesIsUnfit() {
    PointCloud cloud = new PointCloud(FakePlaces.frame("lidar"), 0, 0, List.of(), 16, 0, ByteOrder.BIG_ENDIAN, true,
        Bytes.EMPTY);
    DisplayResult result = probe.tick(cloud);
    assertInstanceOf(DisplayStatus.Unfit.class, result.status());
    assertTrue(result.status().words().contains("no fields x, y and z"));
  }

  @Test
  void anEmptyCloudIsShownAsNothing() {
    DisplayResult result = probe.tick(Clouds.line(0));
    assertEquals(new DisplayStatus.Shown("0 points"), result.status());
    assertTrue(result.parts().getFirst().bounds().isEmpty());
  }

  @Test
  void pointsThatAreNoNumbersDoNotSpoilBoundsAndColours() {
    ByteBuffer bytes = ByteBuffer.allocate(64).order(ByteOrder.LITTLE_ENDIAN);
    bytes.putFloat(Float.NaN).putFloat(0).putFloat(0).putFloat(Float.NaN);
    bytes.putFloat(1).putFloat(1).putFloat(1).putFloat(Float.POSITIVE_INFINITY);
    bytes.putFloat(2).putFloat(2).putFloat(2).putFloat(5);
    bytes.putFloat(3).putFloat(3).putFloat(3).putFloat(7);
    PointSet set = points(Clouds.plain(4, bytes, "intensity"));
    assertEquals(3, set.bounds().orElseThrow().high().x());
    assertEquals(LAST, colorAt(set, 1));
    assertEquals(FIRST, colorAt(set, 2));
    assertEquals(LAST, colorAt(set, 3));
  }

  @Test
  void cloudsOfTheLastSecondsStayAndAreBoundedByTheirPoints() {
    probe.set("decay", 10.0).set("most_points", 2500L);
    PointSet first = points(Clouds.line(1000));
    DisplayResult two = probe.tick(Clouds.line(1000));
    assertEquals(2, two.parts().size());
    assertSame(first, two.parts().getFirst().shape());
    DisplayResult three = probe.tick(Clouds.line(1000));
    assertEquals(2, three.parts().size());
    assertEquals(1, three.dropped());
    assertEquals("2,000 points of 2 clouds", three.status().words());
  }

  @Test
  void ofACloudThatIsTooLargeAnEvenPartIsShown() {
    probe.set("most_points", 1000L);
    DisplayResult result = probe.tick(Clouds.line(100_000));
    assertEquals(1000, result.parts().getFirst().shape().elements());
    assertInstanceOf(DisplayStatus.Partly.class, result.status());
    assertTrue(result.parts().getFirst().shape().bounds().orElseThrow().high().x() > 99_000);
  }

  @Test
  void cloudsThatMoveStayWhereTheyWereMeasured() {
    probe.set("decay", 10.0).tick(Clouds.line(2));
    probe.places().put("lidar", RigidTransform.planar(9, 0, 0));
    List<Double> places = probe.parts(Clouds.line(2)).stream().map(p -> p.fixedFromShape().translation().x()).toList();
    assertEquals(List.of(1.0, 9.0), places);
  }

  @Test
  void aSelectedPointSaysItsFields() {
    Part part = probe.parts(Clouds.line(100)).getFirst();
    PointSet set = (PointSet) part.shape();
    Properties text = part.describer().describe(17, Vector3.ZERO);
    int source = (int) set.xyz().get(3 * 17);
    assertEquals("point " + source + " of 100", text.title());
    assertTrue(text.entries().contains(new Properties.Entry("x", source + ".000 m")), text.toString());
    assertTrue(text.entries().stream().anyMatch(e -> e.name().equals("intensity")));
    assertEquals("point cloud", part.describer().describe(100, Vector3.ZERO).title());
  }

  @Test
  void withoutAFrameTheMissingLinkIsNamed() {
    probe.places().fix("elsewhere");
    PointCloud cloud = Clouds.line(1);
    PointCloud lost =
        new PointCloud(FakePlaces.frame("lost"), 1, 1, cloud.fields(), 16, 16, cloud.order(), true, cloud.points());
    DisplayResult result = probe.tick(lost);
    assertInstanceOf(DisplayStatus.NoFrame.class, result.status());
    assertTrue(result.status().words().contains("lost to elsewhere"));
    assertTrue(result.parts().isEmpty());
  }

  @Test
  void withoutDataTheReasonIsThatOfTheInput() {
    probe.state(new InputState.Unconnected("nothing offers a cloud"));
    assertEquals(new DisplayStatus.NoData("nothing offers a cloud"), probe.tick().status());
  }

  private PointSet points(PointCloud cloud) {
    return (PointSet) probe.parts(cloud).getLast().shape();
  }

  /** The colour of the point whose x is near a number. */
  private static int colorAt(PointSet set, float x) {
    for (int i = 0; i < set.elements(); i++) {
      if (set.xyz().get(3 * i) == x) {
        return set.rgba().orElseThrow().getInt(4 * i);
      }
    }
    throw new AssertionError("no point at " + x);
  }

  private static void put(ByteBuffer bytes, int at, PointField.Format format, int number) {
    switch (format) {
      case INT8, UINT8 -> bytes.put(at, (byte) number);
      case INT16, UINT16 -> bytes.putShort(at, (short) number);
      case INT32, UINT32 -> bytes.putInt(at, number);
      case FLOAT32 -> bytes.putFloat(at, number);
      case FLOAT64 -> bytes.putDouble(at, number);
    }
  }

  @Test
  void allSettingsAreAppliedToAnyCloudWithoutAnError() {
    List<Integer> seen = new ArrayList<>();
    for (String colorBy : List.of("auto", "axis", "field", "rgb", "flat")) {
      for (int count : new int[]{0, 1, 2, 3, 4, 5, 8, 13, 100}) {
        seen.add(probe.set("color_by", colorBy).set("unit", "metres").set("style", "disc").parts(Clouds.line(count))
            .getFirst().shape().elements());
      }
    }
    assertEquals(45, seen.size());
    probe.close();
  }
}
