package org.robotui.sim.internal.ros;

import java.util.Optional;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.JpegEncoder;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.camera.Renderer;
import org.robotui.sim.internal.world.World;

/** Renders and publishes pictures, while somebody wants them. */
final class CameraPublisher implements AutoCloseable {
  private static final int QUEUE = 3;

  private final World world;
  private final Lens lens;
  private final CameraMessages messages;
  private final Publisher<Image> raw;
  private final Publisher<CompressedImage> compressed;
  private final Shutter shutter;
  private Optional<Studio> studio = Optional.empty();

  CameraPublisher(RosNode node, World world, Lens lens, Frames frames) {
    this.world = world;
    this.lens = lens;
    messages = new CameraMessages(frames, lens);
    PublisherOptions options = PublisherOptions.standard().withQueue(QUEUE);
    raw = node.publisher("camera/image_raw", RecordCodec.of(Image.class), options);
    compressed = node.publisher("camera/image_raw/compressed", RecordCodec.of(CompressedImage.class), options);
    shutter = new Shutter("camera", Rate.CAMERA, messages,
        node.publisher("camera/camera_info", RecordCodec.of(CameraInfo.class), options),
        () -> raw.numSubscribers() + compressed.numSubscribers() > 0, this::take);
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
    if (raw.numSubscribers() > 0) {
      raw.publish(messages.raw(pixels, stamp));
    }
    if (compressed.numSubscribers() > 0) {
      compressed.publish(messages.compressed(camera.encoder().encode(pixels), stamp));
    }
  }

  @Override
  public void close() {
    shutter.close();
  }
}
