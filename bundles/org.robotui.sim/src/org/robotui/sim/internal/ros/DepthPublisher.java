package org.robotui.sim.internal.ros;

import java.util.Optional;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.DepthRenderer;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.world.World;

/** Renders and publishes depth pictures, while somebody wants them. */
final class DepthPublisher implements AutoCloseable {
  private static final int QUEUE = 3;

  private final World world;
  private final Lens lens;
  private final CameraMessages messages;
  private final Publisher<Image> raw;
  private final Shutter shutter;
  private Optional<DepthRenderer> renderer = Optional.empty();

  DepthPublisher(RosNode node, World world, Lens lens, Frames frames) {
    this.world = world;
    this.lens = lens;
    messages = new CameraMessages(frames, lens);
    PublisherOptions options = PublisherOptions.standard().withQueue(QUEUE);
    raw = node.publisher("camera/depth/image_raw", RecordCodec.of(Image.class), options);
    shutter = new Shutter("depth camera", Rate.DEPTH, messages,
        node.publisher("camera/depth/camera_info", RecordCodec.of(CameraInfo.class), options),
        () -> raw.numSubscribers() > 0, this::take);
  }

  void publish(long step, RobotState state, long nanos) {
    shutter.press(step, state, nanos);
  }

  private void take(RobotState state, Stamp stamp) {
    if (renderer.isEmpty()) {
      renderer = Optional.of(new DepthRenderer(world, lens));
    }
    raw.publish(messages.depth(renderer.get().render(state.truth(), state.person()), stamp));
  }

  @Override
  public void close() {
    shutter.close();
  }
}
