package org.robotui.sim.internal.camera;

import java.util.Optional;
import java.util.function.Consumer;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.world.World;

/** Takes pictures on a thread of its own, one at a time: what is asked for meanwhile is left out. */
public final class CameraRenderer implements AutoCloseable {
  private final World world;
  private final Lens lens;
  private final PictureWorker darkroom;
  private Optional<Equipment> equipment = Optional.empty();

  /** What is costly to have, and made with the first picture only. */
  private record Equipment(Renderer renderer, JpegEncoder encoder) {}

  public CameraRenderer(World world, Lens lens) {
    this.world = world;
    this.lens = lens;
    darkroom = new PictureWorker("camera");
  }

  /** A picture, valid until the next one is taken. */
  public static final class Shot {
    private final int[] pixels;
    private final JpegEncoder encoder;

    private Shot(int[] pixels, JpegEncoder encoder) {
      this.pixels = pixels;
      this.encoder = encoder;
    }

    /** Red, green and blue of each pixel, row by row from the top. */
    public byte[] rgb() {
      byte[] bytes = new byte[3 * pixels.length];
      for (int i = 0; i < pixels.length; i++) {
        bytes[3 * i] = (byte) (pixels[i] >> 16);
        bytes[3 * i + 1] = (byte) (pixels[i] >> 8);
        bytes[3 * i + 2] = (byte) pixels[i];
      }
      return bytes;
    }

    /** The picture as a file. */
    public byte[] jpeg() {
      return encoder.encode(pixels);
    }
  }

  public Lens lens() {
    return lens;
  }

  /**
   * Takes a picture of what the robot sees, unless one is being taken; {@code taken} is called on the studio's thread.
   */
  public void offer(RobotState state, Consumer<Shot> taken) {
    darkroom.offer(() -> taken.accept(take(state)));
  }

  private Shot take(RobotState state) {
    if (equipment.isEmpty()) {
      equipment = Optional.of(new Equipment(new Renderer(world, lens), new JpegEncoder(lens.width(), lens.height())));
    }
    Equipment ready = equipment.get();
    return new Shot(ready.renderer().render(state.truth(), state.goal(), state.person()), ready.encoder());
  }

  @Override
  public void close() {
    darkroom.close();
  }
}
