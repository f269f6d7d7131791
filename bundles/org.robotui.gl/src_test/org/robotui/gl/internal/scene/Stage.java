package org.robotui.gl.internal.scene;

import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.internal.context.GlThread;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Eye.Projection.Parallel;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Rendered.Picture;
import org.robotui.gl.render.Renderer;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Material;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.PointSet.Unit;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.TriangleMesh;

/** A renderer of a test, which looks along x at 100 x 100 pixels of 1 cm: y is to the left, z up. */
final class Stage implements AutoCloseable {
  static final int SIDE = 100;
  static final int BLACK = 0;

  private static final long SECONDS = 60;

  private final GlThread thread = new GlThread();
  private final Renderer renderer = open();

  GlThread thread() {
    return thread;
  }

  Renderer renderer() {
    return renderer;
  }

  Renderer open() {
    return new SceneRenderer(thread, "test");
  }

  static Part part(Object key, Shape shape, Material material) {
    return new Part(key, shape, RigidTransform.IDENTITY, material, Describer.of("test"));
  }

  static Part flat(Object key, Shape shape, int rgb) {
    return part(key, shape, Material.flat(Rgba.of(rgb)));
  }

  static PointSet points(float size, float... xyz) {
    return PointSet.of(FloatBuffer.wrap(xyz), Optional.empty(), size, Unit.PIXELS);
  }

  /** A square that faces the eye, of two triangles: the second is the upper left one. */
  static TriangleMesh square(float x, float half) {
    float[] xyz = {x, half, -half, x, -half, -half, x, -half, half, x, half, half};
    return TriangleMesh.of(FloatBuffer.wrap(xyz), Optional.empty(), IntBuffer.wrap(new int[]{0, 1, 2, 0, 2, 3}));
  }

  static RenderRequest request(Part... parts) {
    return request(Integer.MAX_VALUE, List.of(), parts);
  }

  static RenderRequest request(int budget, List<RenderRequest.Selected> selection, Part... parts) {
    Eye eye = new Eye(new RigidTransform(new Vector3(-5, 0, 0), Quaternion.IDENTITY), new Parallel(1), 0.1, 50);
    return new RenderRequest(Map.of("display", List.of(parts)), eye, SIDE, SIDE, 1, Rgba.of(BLACK), budget, selection);
  }

  Rendered rendered(RenderRequest request) throws Exception {
    return renderer.render(request).toCompletableFuture().get(SECONDS, TimeUnit.SECONDS);
  }

  Picture picture(RenderRequest request) throws Exception {
    return switch (rendered(request)) {
      case Picture picture -> picture;
      case Rendered other -> throw new AssertionError("no picture: " + other);
    };
  }

  Optional<Pick> pick(RenderRequest request, int x, int y) throws Exception {
    return renderer.pick(request, x, y).toCompletableFuture().get(SECONDS, TimeUnit.SECONDS);
  }

  static int at(Picture picture, int x, int y) {
    return picture.rgb()[y * picture.width() + x];
  }

  static long colored(Picture picture) {
    return Arrays.stream(picture.rgb()).filter(pixel -> pixel != BLACK).count();
  }

  /** Does something on the thread of OpenGL. */
  <T> T there(Supplier<T> work) throws Exception {
    CompletableFuture<T> answer = new CompletableFuture<>();
    thread.execute(() -> answer.complete(work.get()));
    return answer.get(SECONDS, TimeUnit.SECONDS);
  }

  @Override
  public void close() throws InterruptedException {
    renderer.close();
    thread.close();
    if (!thread.awaitEnd(Duration.ofSeconds(SECONDS))) {
      throw new AssertionError("the thread of OpenGL does not end");
    }
  }
}
