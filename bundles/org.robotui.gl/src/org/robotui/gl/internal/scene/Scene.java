package org.robotui.gl.internal.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.robotui.gl.internal.draw.Camera;
import org.robotui.gl.internal.draw.Fineness;
import org.robotui.gl.internal.draw.Pass;
import org.robotui.gl.internal.draw.Tools;
import org.robotui.gl.internal.gpu.Gpu;
import org.robotui.gl.internal.pick.Picker;
import org.robotui.gl.internal.pick.Picker.Found;
import org.robotui.gl.internal.splat.Splats;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Rendered.Figures;

/** One scene in one context. On the thread of OpenGL only. */
final class Scene {
  private static final double NANOS = 1e9;
  /** Triangles that software draws in time. */
  private static final int MANY = 50_000;

  private final Gpu gpu;
  private final Tools tools;
  private final Residents residents;
  private final PixelShelf shelf;
  private final BooleanSupplier givenUp;
  private Optional<Pixels> pixels = Optional.empty();

  /**
   * An empty one.
   *
   * @param gpu the context
   * @param shelf pixels to write into
   * @param givenUp whether the picture in work is wanted no more
   */
  Scene(Gpu gpu, PixelShelf shelf, BooleanSupplier givenUp) {
    this.gpu = gpu;
    this.shelf = shelf;
    this.givenUp = givenUp;
    tools = Tools.of(gpu);
    residents = new Residents(gpu, Residents.MOST_BYTES);
  }

  /** Whether it lives in a context. */
  boolean isIn(Gpu context) {
    return gpu == context;
  }

  Rendered render(RenderRequest request) {
    long start = System.nanoTime();
    int most = gpu.limits().picture();
    if (request.width() > most || request.height() > most) {
      return new Rendered.Unavailable(
          "This graphics makes no picture of " + request.width() + " x " + request.height() + ".",
          "Ask for " + most + " pixels along an edge at most.");
    }
    List<String> problems = residents.follow(request.parts());
    Camera camera = Camera.of(request);
    Order order = Order.of(residents.all(), camera);
    Pixels target = fitting(request);
    Pass pass = new Pass(gpu, camera, tools, request.background(), target.splats(), false,
        every(order.points(), request.pointBudget()),
        fineness(order, request), givenUp);
    target.bind(request.background());
    Canvas canvas = new Canvas(gpu, pass, camera, request.selection());
    canvas.paint(order);
    if (givenUp.getAsBoolean()) {
      return new Rendered.Skipped();
    }
    boolean painted = target.isPainted() && canvas.hasPainted(order);
    if (!painted) {
      drawRest(canvas, order, target, request);
    }
    if (givenUp.getAsBoolean()) {
      return new Rendered.Skipped();
    }
    int[] rgb = shelf.take(request.width() * request.height());
    if (painted) {
      target.copy(rgb);
    } else {
      target.read(gpu, request.width(), request.height(), rgb);
    }
    gpu.check("drawing");
    return new Rendered.Picture(request.width(), request.height(), rgb, figures(start, pass), problems);
  }

  /** Draws by OpenGL what the processor has not painted, over what it has. */
  private void drawRest(Canvas canvas, Order order, Pixels target, RenderRequest request) {
    if (target.beginWithSplats(gpu)) {
      canvas.keepAlpha();
    } else {
      canvas.clear(request.background());
    }
    canvas.draw(order);
  }

  /** Finds what lies under a pixel. */
  Optional<Pick> pick(RenderRequest request, int x, int y) {
    residents.follow(request.parts());
    Camera whole = Camera.of(request);
    Camera camera = whole.around(x, y, Picker.SIDE);
    Order order = Order.of(residents.all(), camera);
    Splats splats = new Splats(Picker.SIDE, Picker.SIDE, true);
    Pass pass =
        new Pass(gpu, camera, tools, request.background(), Optional.of(splats), true, 1, Fineness.EXACT, () -> false);
    Canvas canvas = new Canvas(gpu, pass, camera, List.of());
    Picker pixelsAround = new Picker(gpu);
    pixelsAround.begin();
    canvas.drawIds(order);
    Optional<Found> found = pixelsAround.nearest(splats);
    pixelsAround.delete();
    gpu.check("picking");
    return found.flatMap(hit -> canvas.drawnAs(hit.part()).map(resident -> pick(request, whole, resident, hit, x, y)));
  }

  private static Pick pick(RenderRequest request, Camera camera, Resident resident, Found hit, int x, int y) {
    double depth = resident.onTop() ? hit.depth() / Canvas.TOP : (hit.depth() - Canvas.TOP) / (1 - Canvas.TOP);
    return new Pick(resident.display(), resident.part(), hit.element(),
        camera.place(x + hit.x(), y + hit.y(), depth, request.eye()));
  }

  private Fineness fineness(Order order, RenderRequest request) {
    boolean hurry = request.pointBudget() < Integer.MAX_VALUE && order.triangles() > MANY;
    return !gpu.limits().software() ? Fineness.EXACT : hurry ? Fineness.MOVING : Fineness.AT_REST;
  }

  /** Rows of a sensor have even lengths: an odd number takes other columns of each. */
  private static int every(long points, int budget) {
    int every = (int) Math.max(1, Math.ceilDiv(points, Math.max(1, budget)));
    return every > 2 ? every | 1 : every;
  }

  private Pixels fitting(RenderRequest request) {
    if (pixels.isEmpty() || !pixels.get().fit(request.width(), request.height())) {
      pixels.ifPresent(Pixels::delete);
      pixels = Optional.empty();
      pixels = Optional.of(new Pixels(gpu, request.width(), request.height()));
    }
    return pixels.get();
  }

  private Figures figures(long start, Pass pass) {
    return new Figures((System.nanoTime() - start) / NANOS, pass.tally().points(), pass.tally().pointsLeftOut(),
        pass.tally().triangles(), pass.tally().trianglesLeftOut(),
        residents.takeSent(), residents.bytes() + pixels.map(Pixels::bytes).orElse(0L));
  }

  void delete() {
    residents.delete();
    pixels.ifPresent(Pixels::delete);
    tools.delete();
  }
}
