package org.robotui.sim.internal.message;

import java.util.Optional;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.DepthRenderer;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.world.World;

/** Renders and publishes depth pictures, while somebody wants them. */
final class DepthPublisher implements AutoCloseable {
  private final World world;
  private final Lens lens;
  private final CameraMessages messages;
  private final MessageSink<Image> raw;
  private final Shutter shutter;
  private Optional<DepthRenderer> renderer = Optional.empty();

  DepthPublisher(MessageNode node, World world, Lens lens, Frames frames) {
    this.world = world;
    this.lens = lens;
    messages = new CameraMessages(frames, lens);
    raw = node.topic("camera/depth/image_raw", Image.class, TopicKind.LARGE);
    shutter = new Shutter("depth camera", Rate.DEPTH, messages,
        node.topic("camera/depth/camera_info", CameraInfo.class, TopicKind.SENSOR),
        () -> raw.isWanted(), this::take);
  }

  void publish(long step, RobotState state, long nanos) {
    shutter.press(step, state, nanos);
  }

  private void take(RobotState state, Stamp stamp) {
    if (renderer.isEmpty()) {
      renderer = Optional.of(new DepthRenderer(world, lens));
    }
    raw.send(messages.depth(renderer.get().render(state.truth(), state.person()), stamp));
  }

  @Override
  public void close() {
    shutter.close();
  }
}
