package org.robotui.testkit;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Eye.Projection.Perspective;
import org.robotui.gl.render.OpenGl;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;
import org.robotui.gl.shape.Box3;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Meshes;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Placings;
import org.robotui.gl.shape.Rgba;

/**
 * Makes pictures of parts with the real renderer, and compares them with golden ones: PNG files beside the class of the
 * test, as resources. Needs a display:
 * {@code @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)}. A picture that is not as the golden
 * one is written to {@code target/pictures}. With {@code -Drobotui.pictures=FOLDER}, where the folder is the root of
 * the test's sources, golden pictures are written there and not compared.
 */
public final class ScenePictures implements AutoCloseable {
  /** The background in the dark theme. */
  public static final Rgba DARK = Rgba.of(0x1b1e23);
  /** The background in the light theme. */
  public static final Rgba LIGHT = Rgba.of(0xf4f5f7);
  /** Pixels a row. */
  public static final int WIDTH = 320;
  /** Rows. */
  public static final int HEIGHT = 240;

  private static final String FOLDER = "robotui.pictures";
  private static final int CHANNEL_TOLERANCE = 24;
  private static final double PIXEL_TOLERANCE = 0.01;
  private static final double DRAWN_TOLERANCE = 0.1;
  private static final long SECONDS = 60;
  private static final int SEEN = 20;
  private static final double NEAR = 0.05;
  private static final double FAR = 200;

  private final OpenGl gl = new OpenGl();
  private final Renderer renderer = gl.open("test");

  /** Starts the renderer; closed by the test. */
  public ScenePictures() {
    // The thread of OpenGL starts with the first picture.
  }

  /**
   * An eye that looks at a place, with its picture upright.
   *
   * @param from where the eye is
   * @param to what is in the middle
   * @return the eye, 60 degrees from bottom to top
   */
  public static Eye eye(Vector3 from, Vector3 to) {
    Vector3 ahead = to.minus(from);
    double yaw = Math.atan2(ahead.y(), ahead.x());
    double pitch = Math.atan2(-ahead.z(), Math.hypot(ahead.x(), ahead.y()));
    return new Eye(new RigidTransform(from, Quaternion.fromRollPitchYaw(0, pitch, yaw)),
        new Perspective(Math.toRadians(60)), NEAR, FAR);
  }

  /**
   * An eye that sees everything, from behind and above.
   *
   * @param parts what is drawn
   * @return the eye, for a picture that is wider than high
   */
  public static Eye overview(List<Part> parts) {
    Box3 box = parts.stream().flatMap(part -> part.bounds().stream()).reduce(Box3::union)
        .orElse(new Box3(Vector3.ZERO, Vector3.ZERO));
    double away = 2 * Math.max(box.radius(), NEAR);
    Eye near = eye(box.center().plus(new Vector3(-0.6 * away, -0.3 * away, 0.74 * away)), box.center());
    return new Eye(near.fixedFromEye(), near.projection(), away / 1000, 2 * away);
  }

  /**
   * Fails where nothing is seen.
   *
   * @param what it is, for the message
   * @param parts what is drawn
   */
  public void assertSeen(String what, List<Part> parts) {
    SceneImage image = picture(request(parts, overview(parts)));
    int seen = image.rgb().length - image.count(DARK.packed() >>> Byte.SIZE, 2);
    if (seen < SEEN) {
      throw new AssertionError("only " + seen + " pixels are seen of " + what);
    }
  }

  /**
   * What a display draws, and a coordinate system where the fixed frame is: x red, y green, z blue, so that a picture
   * shows what lies where.
   *
   * @param parts what is drawn
   * @param length of its axes, metres
   * @return both
   */
  public static List<Part> withAxes(List<Part> parts, double length) {
    Placings axes = new Placings(1);
    axes.add(RigidTransform.IDENTITY, new Vector3(length, length, length));
    Part part = new Part("axes of the test", axes.of(Meshes.axes()), RigidTransform.IDENTITY, Material.lit(Rgba.WHITE),
        Describer.of("axes"));
    return Stream.concat(Stream.of(part), parts.stream()).toList();
  }

  /**
   * A request for a small picture in the dark theme.
   *
   * @param parts what is drawn
   * @param eye from where
   * @return the request
   */
  public static RenderRequest request(List<Part> parts, Eye eye) {
    return request(parts, eye, DARK);
  }

  /**
   * A request for a small picture.
   *
   * @param parts what is drawn
   * @param eye from where
   * @param background behind everything
   * @return the request
   */
  public static RenderRequest request(List<Part> parts, Eye eye, Rgba background) {
    return new RenderRequest(Map.of("test", parts), eye, WIDTH, HEIGHT, 1, background, Integer.MAX_VALUE, List.of());
  }

  /**
   * Draws.
   *
   * @param request what
   * @return what became of it
   */
  public Rendered render(RenderRequest request) {
    return wait(renderer.render(request));
  }

  /**
   * Draws, and fails where there is no picture.
   *
   * @param request what
   * @return the picture
   */
  public SceneImage picture(RenderRequest request) {
    return switch (render(request)) {
      case Rendered.Picture picture -> new SceneImage(picture.width(), picture.height(), picture.rgb());
      case Rendered other -> throw new AssertionError("no picture: " + other);
    };
  }

  /**
   * Finds what lies under a pixel.
   *
   * @param request what is drawn
   * @param x from the left
   * @param y from the top
   * @return what was hit
   */
  public Optional<Pick> pick(RenderRequest request, int x, int y) {
    return wait(renderer.pick(request, x, y));
  }

  /**
   * Fails where parts do not look as in the golden picture: by more than a tenth of a channel may differ one pixel in a
   * hundred, and of those that are not background in one of the pictures, one in ten, so that something small cannot
   * get lost.
   *
   * @param test beside whose class the picture lies
   * @param name of the picture, without its ending
   * @param request what is drawn
   */
  public void assertLike(Class<?> test, String name, RenderRequest request) {
    SceneImage actual = picture(request);
    String folder = System.getProperty(FOLDER);
    if (folder != null) {
      write(Path.of(folder, test.getPackageName().replace('.', '/'), name + ".png"), actual);
      return;
    }
    SceneImage golden = golden(test, name);
    int background = request.background().packed() >>> Byte.SIZE;
    int differ = actual.differences(golden, CHANNEL_TOLERANCE);
    int drawn = golden.rgb().length - Math.min(golden.count(background, 2), actual.count(background, 2));
    if (differ > Math.min(PIXEL_TOLERANCE * actual.rgb().length, DRAWN_TOLERANCE * drawn)) {
      Path written = write(Path.of("target", "pictures", name + ".png"), actual);
      throw new AssertionError(differ + " of " + actual.rgb().length + " pixels differ from " + name + ".png: see "
          + written.toAbsolutePath());
    }
  }

  private static SceneImage golden(Class<?> test, String name) {
    try (InputStream in = test.getResourceAsStream(name + ".png")) {
      if (in == null) {
        throw new AssertionError(
            "there is no " + name + ".png beside " + test.getName() + "; -D" + FOLDER + "=... writes it");
      }
      return Png.read(in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(name + ".png", e);
    }
  }

  /**
   * Writes a picture, to be looked at.
   *
   * @param file a PNG file
   * @param image the picture
   * @return the file
   */
  public static Path write(Path file, SceneImage image) {
    try {
      Png.write(file, image);
      return file;
    } catch (IOException e) {
      throw new UncheckedIOException(file.toString(), e);
    }
  }

  private static <T> T wait(CompletionStage<T> stage) {
    try {
      return stage.toCompletableFuture().get(SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("interrupted", e);
    } catch (Exception e) {
      throw new AssertionError("nothing came from the renderer", e);
    }
  }

  @Override
  public void close() {
    renderer.close();
    gl.close();
  }
}
