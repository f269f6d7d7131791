package org.robotui.uic.scene3d.internal.render;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.robotui.gl.render.Gl;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.RenderRequest;
import org.robotui.gl.render.RenderRequest.Selected;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.render.Renderer;
import org.robotui.gl.shape.Box3;
import org.robotui.uic.scene3d.internal.camera.CameraMotion;
import org.robotui.uic.scene3d.internal.camera.CameraPose;
import org.robotui.uic.scene3d.internal.model.Stage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Asks for pictures: when something changed or the camera moves, one at a time, so that what is asked for is never old.
 * Opens the renderer with the first picture. Safe for all threads.
 */
public final class FrameScheduler implements AutoCloseable {
  /** After the camera stood still for so long, a picture is complete. */
  public static final long REST_NANOS = 300_000_000L;

  /** Who waits longer for a picture is told so. */
  static final long LONG_NANOS = 500_000_000L;

  private static final Logger LOG = LoggerFactory.getLogger(FrameScheduler.class);
  private static final String LOOK_THERE = "See the log.";
  private static final long RETRY_NANOS = 5_000_000_000L;
  private static final Rendered.Unavailable NO_BUNDLE = new Rendered.Unavailable(
      "The bundle org.robotui.gl, which draws scenes, is not there.",
      "Install it, or start it in the list of bundles.");

  private final Supplier<Optional<Gl>> graphics;
  private final CameraMotion rig;
  private final LongSupplier clock;
  private final Screen screen;
  private final Runnable arrived;
  private final Budget budget = new Budget();
  private final Meter meter = new Meter();
  private final Deque<Snapshot> snapshots = new ArrayDeque<>();
  private Optional<Open> open = Optional.empty();
  private Stage stage = Stage.NONE;
  private Optional<Box3> seen = Optional.empty();
  private PictureRequest look = PictureRequest.NONE;
  private List<Selected> selection = List.of();
  private Optional<Asked> asked = Optional.empty();
  private Optional<Rendered.Figures> figures = Optional.empty();
  private Optional<Rendered.Unavailable> unavailable = Optional.empty();
  private long movedNanos;
  private long failedNanos;
  private boolean busy;
  private long begunNanos;
  private boolean drawn;
  private boolean pumping;
  private boolean again;
  /** Whether the picture in work is one of all points for a camera that stands. */
  private boolean unhurriedly;
  private boolean complete;
  private boolean thinning = true;
  private boolean closed;

  private record Open(Gl gl, Renderer renderer) {}

  /** A picture of a stage that the model has prepared, or of none. */
  private record Asked(boolean prepared, long version, CameraPose pose, PictureRequest look,
      List<Selected> selection) {}

  private record Snapshot(int width, int height, CompletableFuture<Rendered> done) {}

  /**
   * Asks nothing yet.
   *
   * @param graphics of this machine, which may come and go
   * @param rig the camera
   * @param clock {@link System#nanoTime()}
   * @param screen is given each picture
   * @param arrived is told that a picture came, or that there is none, on any thread, and must not block
   */
  public FrameScheduler(Supplier<Optional<Gl>> graphics, CameraMotion rig, LongSupplier clock, Screen screen,
      Runnable arrived) {
    this.graphics = graphics;
    this.rig = rig;
    this.clock = clock;
    this.screen = screen;
    this.arrived = arrived;
    movedNanos = clock.getAsLong() - REST_NANOS;
  }

  /** Shows this from now on. */
  public void show(Stage next, List<Selected> selected) {
    // Thousands of parts have thousands of boxes: once a stage, not once a picture.
    Optional<Box3> box = next.version() == version() ? seen() : next.everything();
    synchronized (this) {
      stage = next;
      seen = box;
      selection = List.copyOf(selected);
    }
    pump();
  }

  private synchronized long version() {
    return stage.version();
  }

  private synchronized Optional<Box3> seen() {
    return seen;
  }

  /** Makes pictures for this from now on. */
  public void look(PictureRequest next) {
    synchronized (this) {
      look = next;
    }
    pump();
  }

  /** Whether clouds may be thinned while the camera moves; they may, at first. */
  public synchronized void thin(boolean allowed) {
    thinning = allowed;
  }

  /** The camera was moved by hand. */
  public void moved() {
    Optional<Renderer> unhurried;
    synchronized (this) {
      movedNanos = clock.getAsLong();
      unhurried = open.map(Open::renderer).filter(r -> busy && unhurriedly && thinning);
    }
    unhurried.ifPresent(Renderer::giveUp);
    pump();
  }

  /** Whether the camera moves, or did a moment ago. */
  public boolean moves() {
    return moves(clock.getAsLong());
  }

  private synchronized boolean moves(long now) {
    return now - movedNanos < REST_NANOS || rig.travels(now);
  }

  /** Asks for a picture though nothing changed: the screen is another one. */
  public void again() {
    synchronized (this) {
      asked = Optional.empty();
    }
    pump();
  }

  /** How the newest picture was made. */
  public synchronized Optional<Rendered.Figures> figures() {
    return figures;
  }

  /** Why there are no pictures. */
  public synchronized Optional<Rendered.Unavailable> unavailable() {
    return unavailable;
  }

  /** Pictures in the last second. */
  public synchronized double rate() {
    return meter.rate(clock.getAsLong());
  }

  /** Whether no picture has come yet of what was to be shown: only of nothing at all, while the graphics began. */
  public synchronized boolean prepares() {
    return !drawn;
  }

  /** Whether the newest picture is not the one that is asked for, and that one has been drawn for long. */
  public synchronized boolean waits() {
    return busy && clock.getAsLong() - begunNanos > LONG_NANOS;
  }

  /** What lies under a pixel of the picture. */
  public CompletionStage<Optional<Pick>> pick(int x, int y) {
    Supplier<CompletionStage<Optional<Pick>>> picking;
    synchronized (this) {
      Optional<Renderer> renderer = open.map(Open::renderer).filter(r -> look.width() > 0 && unavailable.isEmpty());
      if (renderer.isEmpty()) {
        return CompletableFuture.completedFuture(Optional.empty());
      }
      RenderRequest request =
          request(look.width(), look.height(), look.scale(), rig.at(clock.getAsLong()), List.of(), Integer.MAX_VALUE);
      picking = () -> renderer.get().pick(request, x, y);
    }
    return picking.get();
  }

  /** A complete picture of any size. */
  public CompletionStage<Rendered> snapshot(int width, int height) {
    Snapshot wanted = new Snapshot(width, height, new CompletableFuture<>());
    synchronized (this) {
      snapshots.add(wanted);
    }
    pump();
    return wanted.done();
  }

  /** Asks for a picture where one is due; each tick. */
  public void pump() {
    for (boolean due = begin(); due; due = goOn()) {
      // Outside the lock: a renderer may answer at once, and then another picture may be due.
      try {
        asking().run();
      } catch (RuntimeException | Error e) {
        end();
        throw e;
      }
    }
  }

  /** One thread asks; what others find due meanwhile is asked by that one. */
  private synchronized boolean begin() {
    again = pumping;
    boolean first = !pumping;
    pumping = true;
    return first;
  }

  private synchronized boolean goOn() {
    pumping = again;
    again = false;
    return pumping;
  }

  private synchronized void end() {
    pumping = false;
  }

  private synchronized Runnable asking() {
    return busy || closed ? () -> {} : next();
  }

  private Runnable next() {
    long now = clock.getAsLong();
    if (unavailable.isPresent() && snapshots.isEmpty() && now - failedNanos < RETRY_NANOS || look.width() < 1
        || look.height() < 1) {
      return () -> {};
    }
    Optional<Renderer> renderer = renderer();
    if (renderer.isEmpty()) {
      return fail(NO_BUNDLE, now);
    }
    return snapshots.isEmpty() ? frame(renderer.get(), now) : snapshot(renderer.get(), snapshots.poll(), now);
  }

  private Runnable frame(Renderer renderer, long now) {
    boolean hurry = thinning && moves(now);
    Asked due = new Asked(stage != Stage.NONE, stage.version(), rig.at(now), look, selection);
    if (unavailable.isEmpty() && asked.equals(Optional.of(due)) && (hurry || complete)) {
      return () -> {};
    }
    asked = Optional.of(due);
    busy = true;
    begunNanos = now;
    unhurriedly = !hurry;
    RenderRequest request = request(look.width(), look.height(), look.scale(), due.pose(), selection,
        hurry ? budget.points() : Integer.MAX_VALUE);
    return () -> renderer.render(request)
        .whenComplete((rendered, error) -> made(renderer, due, rendered, error));
  }

  private Runnable snapshot(Renderer renderer, Snapshot wanted, long now) {
    busy = true;
    begunNanos = now;
    unhurriedly = false;
    float scale = Math.max(1, look.scale() * wanted.height() / look.height());
    RenderRequest request = request(wanted.width(), wanted.height(), scale, rig.at(now), List.of(), Integer.MAX_VALUE);
    return () -> renderer.render(request).whenComplete((rendered, error) -> {
      synchronized (this) {
        busy = false;
      }
      wanted.done().complete(
          error == null ? rendered : new Rendered.Unavailable("The picture failed: " + error.getMessage(), ""));
      pump();
    });
  }

  private RenderRequest request(int width, int height, float scale, CameraPose pose, List<Selected> selected,
      int points) {
    return new RenderRequest(stage.parts(), pose.toEye(seen), width, height, scale, look.background(), points,
        selected);
  }

  /** The next picture is drawn while this one is brought to the screen. */
  private void made(Renderer renderer, Asked due, Rendered rendered, Throwable error) {
    Rendered outcome =
        error == null ? rendered : new Rendered.Unavailable("Drawing failed: " + error.getMessage(), LOOK_THERE);
    synchronized (this) {
      busy = false;
      take(outcome);
    }
    pump();
    if (outcome instanceof Rendered.Picture picture) {
      show(renderer, due.pose(), picture);
      came(due.prepared());
    }
    arrived.run();
  }

  private synchronized void came(boolean prepared) {
    drawn |= prepared;
  }

  /** A screen that fails must not end all pictures. */
  private void show(Renderer renderer, CameraPose pose, Rendered.Picture picture) {
    try {
      screen.take(picture, pose);
      renderer.recycle(picture);
    } catch (RuntimeException e) {
      LOG.warn("A picture cannot be shown", e);
      synchronized (this) {
        take(new Rendered.Unavailable("The picture cannot be shown: " + e.getMessage(), LOOK_THERE));
      }
    }
  }

  private void take(Rendered rendered) {
    switch (rendered) {
      case Rendered.Picture made -> {
        figures = Optional.of(made.figures());
        complete = made.figures().complete();
        unavailable = Optional.empty();
        budget.learn(made.figures());
        meter.count(clock.getAsLong());
      }
      case Rendered.Skipped skipped -> asked = Optional.empty();
      case Rendered.Unavailable none when open.isEmpty() -> asked = Optional.empty();
      case Rendered.Unavailable none -> {
        unavailable = Optional.of(none);
        failedNanos = clock.getAsLong();
      }
    }
  }

  private Runnable fail(Rendered.Unavailable why, long now) {
    boolean news = !unavailable.equals(Optional.of(why));
    unavailable = Optional.of(why);
    failedNanos = now;
    snapshots.forEach(s -> s.done().complete(why));
    snapshots.clear();
    return news ? arrived : () -> {};
  }

  private Optional<Renderer> renderer() {
    Optional<Gl> gl = graphics.get();
    if (open.isPresent() && !gl.equals(open.map(Open::gl))) {
      open.get().renderer().close();
      open = Optional.empty();
    }
    if (open.isEmpty()) {
      open = gl.map(g -> new Open(g, g.open("scene")));
    }
    return open.map(Open::renderer);
  }

  /** Gives up the renderer, until there is something to look at again. */
  public synchronized void rest() {
    open.ifPresent(o -> o.renderer().close());
    open = Optional.empty();
    asked = Optional.empty();
    look = PictureRequest.NONE;
  }

  @Override
  public synchronized void close() {
    closed = true;
    rest();
    snapshots.forEach(s -> s.done().complete(new Rendered.Skipped()));
    snapshots.clear();
  }
}
