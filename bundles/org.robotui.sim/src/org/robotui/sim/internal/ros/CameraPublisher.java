package org.robotui.sim.internal.ros;

import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.msgs.sensor_msgs.CameraInfo;
import org.robotui.ros.msgs.sensor_msgs.CompressedImage;
import org.robotui.ros.msgs.sensor_msgs.Image;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.JpegEncoder;
import org.robotui.sim.internal.camera.Lens;
import org.robotui.sim.internal.camera.Renderer;
import org.robotui.sim.internal.world.World;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Renders and publishes pictures on a thread of its own, while somebody wants them. */
final class CameraPublisher implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(CameraPublisher.class);
  private static final int QUEUE = 3;

  private final World world;
  private final Lens lens;
  private final CameraMessages messages;
  private final Publisher<Image> raw;
  private final Publisher<CompressedImage> compressed;
  private final Publisher<CameraInfo> info;
  private final ExecutorService worker = Executors.newSingleThreadExecutor(
      task -> Thread.ofPlatform().name("camera").daemon().unstarted(task));
  private final AtomicBoolean busy = new AtomicBoolean();
  private long sequence;
  private Optional<Studio> studio = Optional.empty();

  CameraPublisher(RosNode node, World world, Lens lens, Frames frames) {
    this.world = world;
    this.lens = lens;
    messages = new CameraMessages(frames, lens);
    PublisherOptions options = PublisherOptions.standard().withQueue(QUEUE);
    raw = node.publisher("camera/image_raw", Image.CODEC, options);
    compressed = node.publisher("camera/image_raw/compressed", CompressedImage.CODEC, options);
    info = node.publisher("camera/camera_info", CameraInfo.CODEC, options);
  }

  /** What is costly to have, and made with the first picture only. */
  private record Studio(Renderer renderer, JpegEncoder encoder) {}

  void publish(long step, RobotState state, long nanos) {
    if (!Rate.CAMERA.isDue(step)) {
      return;
    }
    Stamp stamp = new Stamp(++sequence, nanos);
    info.publish(messages.info(stamp));
    boolean wanted = raw.numSubscribers() + compressed.numSubscribers() > 0;
    if (wanted && busy.compareAndSet(false, true)) {
      start(state, stamp);
    }
  }

  private void start(RobotState state, Stamp stamp) {
    try {
      worker.execute(() -> {
        try {
          take(state, stamp);
        } catch (RuntimeException e) {
          LOG.error("the camera cannot take a picture", e);
        } finally {
          busy.set(false);
        }
      });
    } catch (RejectedExecutionException e) {
      LOG.debug("no picture while the camera closes");
    }
  }

  private void take(RobotState state, Stamp stamp) {
    if (studio.isEmpty()) {
      studio = Optional.of(new Studio(new Renderer(world, lens), new JpegEncoder(lens.width(), lens.height())));
    }
    Studio camera = studio.get();
    int[] pixels = camera.renderer().render(state.truth(), state.goal());
    if (raw.numSubscribers() > 0) {
      raw.publish(messages.raw(pixels, stamp));
    }
    if (compressed.numSubscribers() > 0) {
      compressed.publish(messages.compressed(camera.encoder().encode(pixels), stamp));
    }
  }

  @Override
  public void close() {
    worker.shutdownNow();
  }
}
