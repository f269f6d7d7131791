package org.robotui.message.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.api.Test;
import org.robotui.data.ClockKind;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.array.Bytes;
import org.robotui.data.array.Doubles;
import org.robotui.data.array.Floats;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.PoseArray;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.GridMap;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.Path;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.data.sensor.LaserScan;
import org.robotui.data.sensor.PointCloud;
import org.robotui.data.sensor.PointField;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.message.CdrWriter;
import org.robotui.message.DynamicMessage;
import org.robotui.message.FieldWriter;
import org.robotui.message.Generation;
import org.robotui.message.MessageWriter;

/** What becomes of data as messages is what adapters make of those messages. */
class DataMessagesTest {
  private static final long STAMP = 1_700_000_000_123_456_789L;
  private static final FrameNames NAMES = new FrameNames("robby", ClockKind.ROBOT);
  private static final FrameId MAP = NAMES.frame("map");
  private static final RigidTransform POSE = new RigidTransform(new Vector3(1, 2, 0.5), Quaternion.IDENTITY);
  private static final Doubles COVARIANCE = Doubles.wrap(new double[Odometry.COVARIANCE_SIZE]);

  private final DataMessages messages = new DataMessages();

  static List<Data> values() {
    return List.of(
        new LaserScan(MAP, -1, 0.5, 0.125, 10, 0.25, Floats.of(1, 2, Float.POSITIVE_INFINITY), Floats.of(9, 8, 7)),
        new RawImage(MAP, 2, 2, PixelEncoding.RGB8, false, 6,
            Bytes.of(new byte[]{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})),
        new CompressedImage(MAP, "png", Bytes.of(new byte[]{1, -2, 3})),
        new PointCloud(MAP, 2, 1, List.of(new PointField("x", 0, PointField.Format.FLOAT32, 1)), 4, 8,
            ByteOrder.BIG_ENDIAN, true, Bytes.of(new byte[8])),
        new Imu(MAP, Optional.empty(), Optional.of(new Vector3(1, 2, 3)), Optional.of(new Vector3(0, 0, 9.81))),
        new GpsFix(MAP, GpsFix.Quality.SATELLITE_AUGMENTED, 0.5, 0.25, 400, 1.5),
        new Odometry(MAP, NAMES.frame("base"), POSE, COVARIANCE, new Vector3(1, 0, 0), Vector3.ZERO, COVARIANCE),
        new StampedPose(MAP, POSE), new PoseEstimate(MAP, POSE, COVARIANCE), new Path(MAP, List.of(POSE, POSE)),
        new PoseArray(MAP, List.of(POSE)), new GridMap(MAP, 0.5, 2, 1, POSE, Bytes.of(new byte[]{-1, 100})),
        new Battery(24, -1.5, 0.75, Battery.Status.DISCHARGING),
        new JointState(List.of(new JointState.Joint("lift", 0.5, Double.NaN, Double.NaN))),
        new TransformSet(List.of(
            new FrameTransform(MAP, NAMES.frame("base"), new Stamp(STAMP, ClockKind.ROBOT), POSE, false))),
        new VelocityCommand(new Vector3(0.5, 0, 0), new Vector3(0, 0, 0.25)));
  }

  @ParameterizedTest
  @MethodSource("values")
  void aValueComesBackFromItsMessageInBothGenerations(Data value) throws Exception {
    String type = messages.usualType(value).orElseThrow();
    DynamicRecord record = messages.message(value, type, STAMP).orElseThrow();
    for (Generation generation : Generation.values()) {
      DynamicMessage message = new MessageByNames(EncodingsTest.schema(type, generation)).of(record);
      assertEquals(Optional.of(value), back(new Adapters().of(type), message, generation), generation.name());
    }
  }

  private static <M, D extends Data> Optional<D> back(Adapter<M, D> adapter, DynamicMessage message,
      Generation generation)
      throws Exception {
    FieldWriter out = generation == Generation.ROS1 ? new MessageWriter() : new CdrWriter();
    message.write(out);
    M read = EncodingsTest.message(adapter, out.view(), generation);
    return adapter.convert().apply(read, NAMES);
  }

  @ParameterizedTest
  @EnumSource(Generation.class)
  void theStampIsThatOfTheHeader(Generation generation) {
    DynamicRecord record =
        messages.message(new StampedPose(MAP, POSE), "geometry_msgs/PoseStamped", STAMP).orElseThrow();
    DynamicMessage message =
        new MessageByNames(EncodingsTest.schema("geometry_msgs/PoseStamped", generation)).of(record);
    assertEquals(Optional.of(new FieldValue.Time(STAMP)),
        new MessageRecord(message).at(FieldPath.parse("header.stamp")));
  }

  @Test
  void whatHasNoNameInCommonIsRefusedWithItsNames() {
    MapRecord other = new MapRecord("demo/Note", Map.of("text", new FieldValue.Text("hello")));
    MessageByNames pose = new MessageByNames(EncodingsTest.schema("geometry_msgs/PoseStamped", Generation.ROS2));
    String message = assertThrows(IllegalArgumentException.class, () -> pose.of(other)).getMessage();
    assertEquals("geometry_msgs/PoseStamped has no field in common with demo/Note, which has text", message);
  }

  @Test
  void whatDoesNotFitAFieldIsRefusedWithItsName() {
    MapRecord other = new MapRecord("demo/Pose", Map.of("pose", new FieldValue.Text("here")));
    MessageByNames pose = new MessageByNames(EncodingsTest.schema("geometry_msgs/PoseStamped", Generation.ROS1));
    String message = assertThrows(IllegalArgumentException.class, () -> pose.of(other)).getMessage();
    assertTrue(message.contains("pose"), message);
  }

  @Test
  void aTypeThatDoesNotCarryAValueMakesNoMessage() {
    assertEquals(Optional.empty(), messages.message(new StampedPose(MAP, POSE), "sensor_msgs/LaserScan", STAMP));
    assertEquals(Optional.empty(), messages.usualType(new MapRecord("demo/Note", Map.of())));
  }
}
