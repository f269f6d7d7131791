package org.robotui.sim.internal.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.message.ros.sensor_msgs.PointCloud2;
import org.robotui.message.ros.sensor_msgs.PointField;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.PictureWorker;
import org.robotui.sim.internal.sensor.Lidar;
import org.robotui.sim.internal.world.World;

/** Scans and publishes clouds of points, while somebody wants them. */
final class LidarPublisher implements AutoCloseable {
  private static final int FLOAT32 = 7;
  private static final int STEP = Lidar.NUMBERS * Float.BYTES;
  private static final List<PointField> FIELDS =
      List.of(field("x", 0), field("y", 1), field("z", 2), field("intensity", 3));

  private final Lidar lidar;
  private final String frame;
  private final MessageSink<PointCloud2> points;
  private final PictureWorker darkroom = new PictureWorker("lidar");
  private long sequence;

  LidarPublisher(MessageNode node, Lidar lidar, Frames frames) {
    this.lidar = lidar;
    frame = frames.lidar();
    points =
        node.topic("lidar/points", PointCloud2.class, TopicKind.LARGE);
  }

  /** @param world with everybody in it at this moment */
  void publish(long step, World world, RobotState state, long nanos) {
    if (Rate.LIDAR.isDue(step) && points.isWanted()) {
      Stamp stamp = new Stamp(++sequence, nanos);
      darkroom.offer(() -> points.send(message(lidar.scan(world, state.truth()), stamp)));
    }
  }

  private PointCloud2 message(float[] numbers, Stamp stamp) {
    ByteBuffer bytes = ByteBuffer.allocate(numbers.length * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asFloatBuffer().put(numbers);
    int count = numbers.length / Lidar.NUMBERS;
    return new PointCloud2(stamp.header(frame), 1, count, FIELDS, false, STEP, (long) STEP * count, bytes, true);
  }

  private static PointField field(String name, int index) {
    return new PointField(name, (long) index * Float.BYTES, FLOAT32, 1);
  }

  @Override
  public void close() {
    darkroom.close();
  }
}
