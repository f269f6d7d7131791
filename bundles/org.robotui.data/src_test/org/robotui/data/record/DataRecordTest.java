package org.robotui.data.record;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Floats;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.sensor.Bumper;
import org.robotui.data.sensor.Bumpers;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.Diagnostics;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

class DataRecordTest {
  private static final FrameId FRAME = new FrameId("keira", "laser");

  private static Optional<FieldValue> at(Data value, String path) {
    Optional<FieldValue> found = DataRecord.of(value).at(FieldPath.parse(path));
    assertEquals(found.stream().filter(FieldValue.Num.class::isInstance).mapToDouble(v -> ((FieldValue.Num) v).value())
        .findFirst(), new NumberPath(FieldPath.parse(path)).in(DataRecord.of(value)), path);
    return found;
  }

  @Test
  void theInsideOfStampsAndFramesIsNoField() {
    LaserScan scan = new LaserScan(FRAME, -1.5, 0.1, 0, 10, 0, Floats.of(1, 2.5f), Floats.EMPTY);
    assertEquals(Optional.empty(), at(scan, "frame.robot"));
    assertEquals(Optional.empty(), at(scan, "ranges[1].x"));
    assertEquals(Optional.empty(), at(scan, "angleMin[0]"));
    StampedPose pose = new StampedPose(FRAME, RigidTransform.IDENTITY);
    assertEquals(Optional.of(new FieldValue.Num(1, "1.0")), at(pose, "pose.rotation.w"));
    assertTrue(at(pose, "pose.rotation.roll").isPresent());
    assertTrue(at(pose, "pose.rotation").isPresent());
  }

  @Test
  void numbersOfARecordAreFoundByTheNamesOfItsComponents() {
    LaserScan scan = new LaserScan(FRAME, -1.5, 0.1, 0, 10, 0, Floats.of(1, 2.5f), Floats.EMPTY);
    assertEquals(Optional.of(new FieldValue.Num(-1.5, "-1.5")), at(scan, "angleMin"));
    assertEquals(Optional.of(new FieldValue.Num(2.5, "2.5")), at(scan, "ranges[1]"));
    assertEquals(Optional.of(new FieldValue.Text("keira:laser")), at(scan, "frame"));
    assertEquals(Optional.empty(), at(scan, "ranges[2]"));
    assertEquals(Optional.empty(), at(scan, "no_such_field"));
  }

  @Test
  void aRotationHasItsAnglesToo() {
    RigidTransform turned = new RigidTransform(new Vector3(1, 2, 0), Quaternion.fromYaw(0.5));
    StampedPose pose = new StampedPose(FRAME, turned);
    FieldValue.Num yaw = (FieldValue.Num) at(pose, "pose.rotation.yaw").orElseThrow();
    assertEquals(0.5, yaw.value(), 1e-12);
    assertEquals(Optional.of(new FieldValue.Num(2, "2.0")), at(pose, "pose.translation.y"));
  }

  @Test
  void listsMapsAndWordsAreFields() {
    Diagnostics.Item item =
        new Diagnostics.Item("motor", "m1", Diagnostics.Level.WARNING, "warm", Map.of("temperature", "61"));
    Diagnostics all = new Diagnostics(List.of(item));
    assertEquals(Optional.of(new FieldValue.Text("WARNING")), at(all, "items[0].level"));
    assertEquals(Optional.of(new FieldValue.Text("61")), at(all, "items[0].values.temperature"));
  }

  @Test
  void whatIsPressedIsAField() {
    Bumpers bumpers = new Bumpers(FRAME, List.of(new Bumper(RigidTransform.planar(0.2, 0, 0.5), 0.3, 0.2, false),
        new Bumper(RigidTransform.IDENTITY, 0.3, 0.2, true)));
    assertEquals(Optional.of(new FieldValue.Flag(false)), at(bumpers, "bumpers[0].pressed"));
    assertEquals(Optional.of(new FieldValue.Flag(true)), at(bumpers, "bumpers[1].pressed"));
    assertEquals(Optional.of(new FieldValue.Num(0.3, "0.3")), at(bumpers, "bumpers[0].length"));
    assertEquals(1, bumpers.pressed());
  }

  @Test
  void anAbsentOptionalHasNoValueButItsName() {
    Imu imu = new Imu(FRAME, Optional.empty(), Optional.of(new Vector3(0, 0, 1)), Optional.empty());
    assertEquals(Optional.empty(), at(imu, "orientation.x"));
    assertTrue(DataRecord.of(imu).fields().contains("orientation"));
    assertEquals(Optional.of(new FieldValue.Num(1, "1.0")), at(imu, "angularVelocity.z"));
  }

  @Test
  void aDynamicRecordStandsForItself() {
    DynamicRecord record = new MapRecord("a/B", Map.of("x", new FieldValue.Flag(true)));
    assertSame(record, DataRecord.of(record));
  }

  @Test
  void onePathReadsValuesOfOneTypeAfterAnother() {
    NumberPath path = new NumberPath(FieldPath.parse("pose.rotation.yaw"));
    StampedPose pose = new StampedPose(FRAME, new RigidTransform(Vector3.ZERO, Quaternion.fromYaw(0.5)));
    Seen seen = new Seen(Optional.of(new Turned(new Angles(7))));
    DynamicRecord robots = new MapRecord("a/B",
        Map.of("pose", new FieldValue.Nested(new MapRecord("a/C", Map.of("x", new FieldValue.Flag(true))))));
    for (int i = 0; i < 2; i++) {
      assertEquals(0.5, path.in(DataRecord.of(pose)).orElseThrow(), 1e-12);
      assertEquals(OptionalDouble.of(7), path.in(DataRecord.of(seen)));
      assertEquals(OptionalDouble.empty(), path.in(DataRecord.of(new Seen(Optional.empty()))));
      assertEquals(OptionalDouble.empty(), path.in(robots));
    }
  }

  @Test
  void whatCannotBeReadIsSaid() {
    DynamicRecord broken = DataRecord.of(new Broken(1));
    assertEquals(OptionalDouble.empty(), new NumberPath(FieldPath.parse("x")).in(broken));
    assertEquals(Optional.of(new FieldValue.Text("(x cannot be read: not today)")), broken.field("x"));
  }

  /** A pose that may be absent. */
  public record Seen(Optional<Turned> pose) implements Data {}

  /** A field of the same name as that of a pose. */
  public record Turned(Angles rotation) {}

  /** A number that is no double. */
  public record Angles(Integer yaw) {}

  /** Gives away nothing. */
  public record Broken(double x) implements Data {
    @Override
    public double x() {
      throw new IllegalStateException("not today");
    }
  }
}
