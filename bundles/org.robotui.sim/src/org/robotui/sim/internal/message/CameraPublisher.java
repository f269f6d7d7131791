package org.robotui.sim.internal.message;

import java.util.Optional;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.JpegEncoder;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.camera.Renderer;
import org.robotui.sim.internal.world.World;

/** Renders and publishes pictures, while somebody wants them. */
final class CameraPublisher implements AutoCloseable {
  private final World world;
  private final Lens lens;
  private final CameraMessages messages;
  private final MessageSink<Image> raw;
  private final MessageSink<CompressedImage> compressed;
  private final Shutter shutter;
  private Optional<Studio> studio = Optional.empty();

  CameraPublisher(MessageNode node, World world, Lens lens, Frames frames) {
    this.world = world;
    this.lens = lens;
    messages = new CameraMessages(frames, lens);
    raw = node.topic("camera/image_raw", Image.class, TopicKind.LARGE);
    compressed = node.topic("camera/image_raw/compressed", CompressedImage.class, TopicKind.LARGE);
    shutter = new Shutter("camera", Rate.CAMERA, messages,
        node.topic("camera/camera_info", CameraInfo.class, TopicKind.SENSOR),
        () -> raw.isWanted() || compressed.isWanted(), this::take);
  }

  /** What is costly to have, and made with the first picture only. */
  private record Studio(Renderer renderer, JpegEncoder encoder) {}

  void publish(long step, RobotState state, long nanos) {
    shutter.press(step, state, nanos);
  }

  private void take(RobotState state, Stamp stamp) {
    if (studio.isEmpty()) {
      studio = Optional.of(new Studio(new Renderer(world, lens), new JpegEncoder(lens.width(), lens.height())));
    }
    Studio camera = studio.get();
    int[] pixels = camera.renderer().render(state.truth(), state.goal(), state.person());
    if (raw.isWanted()) {
      raw.send(messages.raw(pixels, stamp));
    }
    if (compressed.isWanted()) {
      compressed.send(messages.compressed(camera.encoder().encode(pixels), stamp));
    }
  }

  @Override
  public void close() {
    shutter.close();
  }
}
