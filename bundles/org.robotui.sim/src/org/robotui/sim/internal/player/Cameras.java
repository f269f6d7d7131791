package org.robotui.sim.internal.player;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.player.interfaces.Camera;
import org.robotui.player.server.ServedDevice;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.CameraRenderer;
import org.robotui.sim.internal.camera.Lens;

/**
 * The camera: pixels as {@code camera:0}, JPEG as {@code camera:1}. Pictures are only made while somebody has one of
 * them open.
 */
final class Cameras implements Part {
  private static final Rate RATE = new Rate(10);
  private static final int BITS = 24;
  private static final int RGB888 = 5;
  private static final int RAW = 0;
  private static final int JPEG = 1;

  private final CameraRenderer studio;
  private final Eye raw;
  private final Eye jpeg;

  Cameras(Bench bench) {
    studio = new CameraRenderer(bench.robot().simulation().world(), bench.robot().model().lens());
    raw = new Eye(bench, 0);
    jpeg = new Eye(bench, 1);
  }

  /** One of the devices, and the picture that it sent last. */
  private static final class Eye {
    private final AtomicReference<Optional<Camera.Image>> last = new AtomicReference<>(Optional.empty());
    private final ServedDevice device;

    Eye(Bench bench, int index) {
      device = bench.add("camera", index, bench.handler().on(Camera.GET_IMAGE, none -> last.get()));
    }

    boolean isOpen() {
      return device.clients() > 0;
    }

    void show(Lens lens, int compression, byte[] data, double stamp) {
      Camera.Image image = new Camera.Image(lens.width(), lens.height(), BITS, RGB888, 1, compression, data);
      last.set(Optional.of(image));
      device.publish(Camera.IMAGE, image, stamp);
    }
  }

  @Override
  public void step(long step, RobotState state, double stamp) {
    if (RATE.isDue(step) && (raw.isOpen() || jpeg.isOpen())) {
      studio.offer(state, shot -> show(shot, stamp));
    }
  }

  private void show(CameraRenderer.Shot shot, double stamp) {
    if (raw.isOpen()) {
      raw.show(studio.lens(), RAW, shot.rgb(), stamp);
    }
    if (jpeg.isOpen()) {
      jpeg.show(studio.lens(), JPEG, shot.jpeg(), stamp);
    }
  }

  @Override
  public void close() {
    studio.close();
  }
}
