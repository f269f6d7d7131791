package org.robotui.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Bytes;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.Pose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.geometry.Twist;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.record.FieldPath;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.status.LogEntry;
import org.robotui.geometry.RigidTransform;

class DeliveryTest {
  @Test
  void typesSayHowTheyAreDelivered() {
    assertEquals(new DataType(LaserScan.class, Conflation.SAMPLE, Late.LAST, true), DataType.of(LaserScan.class));
    assertEquals(new DataType(GridMap.class, Conflation.SAMPLE, Late.LAST, false), DataType.of(GridMap.class));
    assertEquals(new DataType(RobotDescription.class, Conflation.SAMPLE, Late.LAST, false),
        DataType.of(RobotDescription.class));
    assertEquals(Conflation.KEYED, DataType.of(TransformSet.class).conflation());
    assertEquals(Conflation.EVENT, DataType.of(LogEntry.class).conflation());
    assertEquals(Late.NONE, DataType.of(VelocityCommand.class).late());
  }

  @Test
  void typesThatExtendAreAccepted() {
    assertTrue(DataType.of(Pose.class).accepts(DataType.of(Odometry.class)));
    assertTrue(DataType.of(Twist.class).accepts(DataType.of(Odometry.class)));
    assertTrue(DataType.of(Image.class).accepts(DataType.of(CompressedImage.class)));
    assertTrue(DataType.of(Data.class).accepts(DataType.of(LogEntry.class)));
    assertFalse(DataType.of(Odometry.class).accepts(DataType.of(Pose.class)));
    assertFalse(DataType.of(LaserScan.class).accepts(DataType.of(GridMap.class)));
  }

  @Test
  void keyedTypesMergeTheNewestPerKeyAndKeepTheOrder() {
    JointState older = new JointState(List.of(new Joint("a", 1, 0, 0), new Joint("b", 2, 0, 0)));
    JointState newer = new JointState(List.of(new Joint("c", 5, 0, 0), new Joint("a", 4, 0, 0)));
    JointState merged = newer.over(older);
    assertEquals(List.of("a", "b", "c"), merged.joints().stream().map(Joint::name).toList());
    assertEquals(List.of(4.0, 2.0, 5.0), merged.joints().stream().map(Joint::position).toList());
  }

  @Test
  void transformsMergePerParentAndChild() {
    TransformSet merged = set(edge("odom", "base", 2)).over(set(edge("odom", "base", 1), edge("map", "odom", 1)));
    assertEquals(set(edge("odom", "base", 2), edge("map", "odom", 1)), merged);
  }

  @Test
  void pathsFollowFieldsAndElements() {
    assertEquals("ranges[3].x", FieldPath.parse("ranges[3].x").toString());
    String message = org.junit.jupiter.api.Assertions.assertThrows(
        IllegalArgumentException.class, () -> FieldPath.parse("a..b")).getMessage();
    assertTrue(message.contains("'' is no field name"), message);
  }

  @Test
  void bytesAreASliceWithoutACopy() {
    byte[] frame = {1, 2, 3, 4, 5};
    Bytes slice = Bytes.wrap(frame, 1, 3);
    assertEquals(3, slice.size());
    assertEquals(2, slice.get(0));
    assertEquals(slice, Bytes.of((byte) 2, (byte) 3, (byte) 4));
    byte[] copy = new byte[4];
    slice.copyTo(1, copy, 2, 2);
    assertEquals(List.of((byte) 0, (byte) 0, (byte) 3, (byte) 4), List.of(copy[0], copy[1], copy[2], copy[3]));
    assertEquals(255, Bytes.of((byte) -1).unsigned(0));
  }

  private static TransformSet set(FrameTransform... transforms) {
    return new TransformSet(List.of(transforms));
  }

  private static FrameTransform edge(String parent, String child, long nanos) {
    return new FrameTransform(new FrameId("r", parent), new FrameId("r", child), new Stamp(nanos, ClockKind.ROBOT),
        RigidTransform.planar(nanos, 0, 0), false);
  }
}
